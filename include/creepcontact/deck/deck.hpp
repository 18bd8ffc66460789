#pragma once
/// What a deck says, card by card, before it becomes a model. Names of sets are those of the deck in upper case.

#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <unordered_map>
#include <vector>

#include "creepcontact/base/tensor.hpp"
#include "creepcontact/deck/cards.hpp"
#include "creepcontact/deck/elements.hpp"
#include "creepcontact/deck/number_map.hpp"

namespace creepcontact::deck {

using Numbers = std::vector<std::int64_t>;

/// Elements of one type; `nodes` are numbers of the deck, element by element, in its order.
struct ElementBlock {
  ElementType type;
  Numbers numbers, nodes;
  std::vector<std::pair<std::size_t, Place>> cards = {};  ///< *ELEMENT: where each begins in `numbers`

  /// Returns where the card of an element is. @param element  index in `numbers`
  Place place(std::size_t element) const;
};

/// Elements of lines and faces that programs write next to the bodies for groups of a mesh.
struct SkinElements {
  std::string type;
  std::size_t n_nodes = 0;
  Numbers numbers, nodes;
  Place place;
};

/// An element of *SPRING.
struct SpringElement {
  std::string type;  ///< SPRINGA, SPRING1 or SPRING2
  std::int64_t number = 0;
  Numbers nodes;  ///< two; one of SPRING1, whose other end is the ground
  Place place;
};

/// A mass at a node.
struct MassElement {
  std::int64_t number = 0, node = 0;
  Place place;
};

/// An element of a gasket: the corners of its lower side (SNEG) and its upper one (SPOS).
struct GasketElement {
  std::int64_t number = 0;
  std::array<Numbers, 2> sides;
  bool shears = true;
  Place place;
};

struct Set {
  std::string name;  ///< as written
  Numbers members;   ///< in the order of the deck; those listed one by one may repeat
  Place place = {};  ///< of its first *NSET or *ELSET, if it has one
};

/// "set, S3" or "12, S3"; of a surface of nodes without a face.
struct SurfaceEntry {
  std::string target;
  int face = 0;
  Place place;
  std::string side = {};  ///< SPOS or SNEG, instead of a face
};
struct Surface {
  std::string name;  ///< as written
  bool of_nodes = false;
  std::vector<SurfaceEntry> entries;
};

/// A property over the temperature: rows of values, the last of which is the temperature where the card has one.
struct Table {
  Place place;
  std::vector<std::vector<double>> rows;
};
enum class Elasticity { isotropic, stiffness_matrix, engineering_constants };
struct Material {
  std::string name;  ///< as written
  Place place;
  std::optional<Table> elastic, expansion, density, creep;
  std::optional<Table> conductivity, specific_heat;
  std::optional<Table> plastic;
  std::string hardening = "ISOTROPIC";    ///< of *PLASTIC
  std::size_t back_stresses = 1;          ///< of HARDENING=COMBINED
  bool by_table = true;                   ///< *PLASTIC: stresses over plastic strains; else constants of back stresses
  std::optional<Table> cyclic_hardening;  ///< yield stress over the plastic strain, next to back stresses
  std::optional<Table> potential;         ///< ratios of Hill's stress: R11, R22, R33, R12, R13, R23
  Elasticity elasticity = Elasticity::isotropic;
  bool expands_along_axes = false, conducts_along_axes = false;
  double expansion_zero = 0;
  std::string creep_law = "NORTON";
  bool creep_time_only = false;  ///< the time of the law does not run in *STATIC steps

  bool has_axes() const {
    return elasticity != Elasticity::isotropic || expands_along_axes || conducts_along_axes || potential;
  }
};

/// *ORIENTATION: axes of a material.
struct Orientation {
  bool is_cylindrical = false;  ///< a, b: points of the axis; else of the directions of axis 1 and of the plane of 1, 2
  Vector3 a = Vector3::Zero(), b = Vector3::Zero();
  int turned_about = 0;      ///< local axis 1, 2 or 3; 0: not turned
  double turned_by = 0;      ///< degrees
  std::string problem = {};  ///< why it says no axes; empty: it does
  Place place;
};

struct Section {
  std::string elements, material;  ///< names in upper case
  double thickness = 1;
  Place place;
  std::string orientation = {};  ///< in upper case; empty: none
};

/// *GASKET BEHAVIOR
struct GasketBehavior {
  Material material;  ///< its name, expansion and creep
  bool is_damage = false;
  std::optional<Table> loading;    ///< pressure, closure, temperature
  std::optional<Table> unloading;  ///< pressure, closure, residual or largest closure, temperature
  double slope_drop = 0.1;         ///< where plasticity begins, of the largest slope so far
  std::optional<double> yield_onset;
};

/// *GASKET SECTION
struct GasketSection {
  std::string elements, behavior;   ///< names in upper case
  std::optional<double> thickness;  ///< nullopt: that of the mesh
  double gap = 0, space = 0;        ///< of the thickness: open at the start, and without material
  std::optional<double> width;      ///< out of the plane
  Place place;
};

struct Amplitude {
  std::string name;
  bool total_time = false;
  double shift_time = 0, shift_factor = 0;
  std::vector<std::pair<double, double>> points;  ///< time, factor
};

/// A card that comes with its data as they are: what becomes of it depends on the rest of the deck.
struct RawCard {
  Card card;
  std::vector<std::vector<std::string>> data;
  std::vector<Place> places;  ///< of the data
};

/// *STEP to *END STEP.
struct Step {
  Place place;
  bool has_procedure = false;
  bool is_creep = false;   ///< *VISCO, and those of temperatures with displacements: materials creep
  bool conducts = false;   ///< the temperature is computed
  bool is_steady = false;  ///< if it conducts: STEADY STATE
  bool deforms = true;     ///< displacements are computed
  std::string ramps = {};  ///< AMPLITUDE: RAMP, STEP or empty, the default of the procedure
  bool nonlinear_geometry = false;
  double period = 1;
  std::vector<RawCard> cards;  ///< supports, loads, temperatures, output

  /// Whether the temperature changes by itself.
  bool is_transient() const { return conducts && !is_steady; }
  /// Whether what happens depends on how long the step takes.
  bool takes_time() const { return is_creep || is_transient(); }
};

/// A card that leaves no trace in the model, or makes it impossible.
struct Note {
  Place place;
  std::string card, consequence;
};

/// What is added to the numbers of an instance's nodes and elements in the model.
struct InstanceOffsets {
  std::int64_t node = 0, element = 0;
};

struct Deck {
  Numbers node_numbers;
  std::vector<Vector3> positions;  ///< by node_numbers
  std::vector<ElementBlock> elements;
  std::vector<SkinElements> skins;
  std::vector<SpringElement> springs;
  std::vector<MassElement> masses;
  std::vector<GasketElement> gaskets;
  std::vector<GasketSection> gasket_sections;
  std::map<std::string, GasketBehavior> gasket_behaviors;
  std::map<std::string, Set> node_sets, element_sets;  ///< by name in upper case
  std::map<std::string, Surface> surfaces;
  std::map<std::string, Material> materials;
  std::map<std::string, Orientation> orientations;
  std::map<std::string, Amplitude> amplitudes;
  std::vector<Section> sections;
  double absolute_zero = 0;  ///< in the deck's unit of temperature
  std::optional<double> stefan_boltzmann;
  std::vector<RawCard> cards;  ///< before the steps: supports, contacts, ties, initial conditions, constraints
  std::vector<Step> steps;
  std::vector<Note> left_out, impossible;
  std::map<std::string, InstanceOffsets> instances;  ///< by name in upper case
  std::int64_t assembly_offset = 0;  ///< of the numbers of nodes that the assembly itself defines; 0: there are none

  /// Whether there is nothing but nodes, elements, sets and surfaces.
  bool is_only_mesh() const;
  /// Returns the number of "INSTANCE.5" in the model; nullopt if a name is none of this kind. @param is_node  else an
  /// element
  std::optional<std::int64_t> number_in_instance(const std::string& name, bool is_node) const;
  /// Whether temperatures are computed.
  bool conducts() const;
  /// Whether displacements are.
  bool deforms() const;

  std::unordered_map<std::int64_t, std::int64_t> same_as;  ///< nodes that became one with another: that one
  std::map<std::int64_t, std::int64_t> copies;             ///< nodes that a cut has added: what each is a copy of
  NumberMap<std::uint32_t> node_of_number;                 ///< index into positions
  struct ElementPlace {
    std::uint32_t block = 0, element = 0;
  };
  NumberMap<ElementPlace> element_of_number;
};

/// Reads a deck and the files that it includes. Parts and instances of Abaqus are made one model: each instance has its
/// own nodes and elements, moved as it says, and its sets are named "INSTANCE.SET".
/// @throws ConfigError with one line per mistake, "file:line: *CARD: what". Mistakes are fields that are not numbers,
/// nodes and sets that do not exist, elements without all their nodes, a deck that is cut off or has no elements.
/// Cost: linear in the size of the text. Memory: the nodes and elements, twice where instances are made of parts.
Deck read_deck(const std::filesystem::path& path);
/// Reads a text instead of a file. @param name  for messages; the directory of this name is that of the files it
/// includes
Deck read_deck(std::istream& text, const std::filesystem::path& name);

}  // namespace creepcontact::deck
