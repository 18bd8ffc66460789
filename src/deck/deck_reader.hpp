#pragma once
/// Cards of a deck, one after the other, into a Deck.

#include <functional>
#include <map>
#include <string>
#include <vector>

#include "creepcontact/deck/deck.hpp"

namespace creepcontact::deck {

class DeckReader {
 public:
  DeckReader();

  void card(const Card& card);
  void data(const DataLine& line);
  /// What was read. @throws ConfigError with all mistakes
  Deck finish();

  /// Where a card is allowed.
  enum class Where { anywhere, model, step };

  /// What becomes of a card.
  struct Rule {
    enum class Kind {
      read,               ///< by `handler`
      kept,               ///< with its data, for what makes the model
      silent,             ///< a frame of other cards
      without_influence,  ///< it changes no result; a line names it
      left_out,           ///< with a consequence
      impossible,         ///< with a reason
      of_heat,            ///< impossible, with a reason, if temperatures are computed; else left out
    };
    Kind kind = Kind::kept;
    std::string text = {};  ///< consequence or reason
    void (DeckReader::*handler)(const Card&) = nullptr;
    Where where = Where::anywhere;
    std::size_t most_fields = 0;  ///< in a line of data that is kept; 0: any number
  };
  static const std::map<std::string, Rule>& rules();
  /// Returns the rule of a card with its name as it is usually written; null: the card is not known.
  static const std::pair<const std::string, Rule>* rule_or_null(const std::string& name);

 private:
  // Geometry
  void node(const Card& card);
  void element(const Card& card);
  void node_set(const Card& card);
  void element_set(const Card& card);
  void surface(const Card& card);
  void solid_section(const Card& card);
  void gasket_section(const Card& card);
  // Materials
  void material(const Card& card);
  void elastic(const Card& card);
  void expansion(const Card& card);
  void potential(const Card& card);
  void orientation(const Card& card);
  void density(const Card& card);
  void conductivity(const Card& card);
  void specific_heat(const Card& card);
  void creep(const Card& card);
  void plastic(const Card& card);
  void cyclic_hardening(const Card& card);
  void physical_constants(const Card& card);
  void gasket_behavior(const Card& card);
  void gasket_thickness_behavior(const Card& card);
  void amplitude(const Card& card);
  // Steps
  void step(const Card& card);
  void end_step(const Card& card);
  void statics(const Card& card);
  void visco(const Card& card);
  void no_analysis(const Card& card);
  void heat_transfer(const Card& card);
  void temperature_displacement(const Card& card);
  // Parts
  void part(const Card& card);
  void end_part(const Card& card);
  void instance(const Card& card);
  void end_instance(const Card& card);

  void procedure(const Card& card, bool is_creep);
  void conducting_procedure(const Card& card, bool deforms);
  /// Whether a card that is read or kept is allowed at its place.
  bool is_in_place(const Card& card, const Rule& rule);
  /// What each parameter of a card means; those that are not known may change the results.
  void check_parameters(const Card& card);
  void keep(const Card& card, const Rule& rule);
  /// The model is impossible with a property of this type.
  void refuse_type(const Card& card, const std::string& property, const std::string& known);
  bool is_short_enough(const DataLine& line, std::size_t most);
  /// @param columns  without the temperature: those that are missing are 0; @param most  with it
  void table(std::optional<Table> Material::*property, const Card& card, std::size_t columns, std::size_t most);
  /// @param owner  "material 'steel'"
  void table(std::optional<Table>& table, const Card& card, const std::string& owner, std::size_t columns,
             std::size_t most);
  /// A table whose rows are longer than a line.
  void table_of_long_rows(std::optional<Table> Material::*property, const Card& card, std::size_t columns);
  void read_set(const Card& card, const std::string& key, std::map<std::string, Set> Deck::*sets);
  void add_members(Set& set, const DataLine& line, bool generate, const std::string& scope,
                   std::map<std::string, Set> Deck::*sets, std::int64_t offset);
  void add_node(const DataLine& line, Set* set);
  void add_mass(const DataLine& line);
  void add_spring(const std::string& type, const DataLine& line);
  void add_to_element(const DataLine& line);
  /// How many nodes the element that is read has.
  std::size_t n_element_nodes() const;
  /// Adds an element that is complete. @param own  its number and nodes
  void add_solid(const Numbers& own, const Place& place);
  void add_gasket(const GasketShape& shape, const Numbers& own, const Place& place);
  void finish_card();
  /// Takes elements of lower dimension that have no section out of the blocks.
  void set_skins_apart();
  /// Takes numbers that no node or element has out of the sets, with a note for each of them: in an instance they would
  /// become those of another one.
  void drop_missing_members(Deck& of);
  /// Makes a new set of the nodes of the elements in another one.
  void nodes_of_elements(const Card& card);
  /// Adds members to the sets of `into_` that were named before they were defined.
  void add_late_members();
  void merge_instance();
  std::string required(const Card& card, const std::string& parameter);
  std::optional<double> real(const DataLine& line, std::size_t field);
  /// Number of a node or an element; nullopt, with a mistake, if it is none.
  std::optional<std::int64_t> label(const DataLine& line, std::string_view field, const char* what);
  /// @param card  empty: the present one
  void mistake(const Place& place, const std::string& what, const std::string& card = {});
  void refuse_missing_nodes();
  bool in_step() const { return step_open_; }

  Deck deck_;
  std::map<std::string, Deck> parts_;
  Deck* into_ = &deck_;  // or a part, or the instance that is being made
  Deck instance_deck_;
  std::string instance_name_;  // as written
  std::vector<std::vector<double>> instance_moves_;

  /// A set that another one names before there is a card of it.
  struct LateMembers {
    const Deck* of;
    std::map<std::string, Set> Deck::*sets;
    std::string into, from;  // names in upper case
    std::string card;
    Place place;
  };
  std::vector<LateMembers> late_members_;
  std::vector<std::string> without_influence_;
  Place first_without_influence_;
  std::vector<Note> of_heat_;

  Card current_;
  std::function<void(const DataLine&)> on_data_;
  Material* material_ = nullptr;
  GasketBehavior* behavior_ = nullptr;  // to which *GASKET THICKNESS BEHAVIOR belongs
  bool step_open_ = false;
  ElementBlock* block_ = nullptr;
  std::optional<GasketShape> gasket_;  // of the elements that are read, instead of a block
  bool reads_skin_ = false;            // they are the last of `skins`
  Set* element_set_ = nullptr;
  Numbers pending_;  // number and nodes of an element that goes on in the next line
  Place pending_place_;
  std::vector<Note> mistakes_;
};

}  // namespace creepcontact::deck
