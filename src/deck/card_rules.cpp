/// The cards of decks, and what becomes of each.

#include <initializer_list>
#include <utility>

#include "card_parameters.hpp"
#include "deck_reader.hpp"

namespace creepcontact::deck {
const std::pair<const std::string, DeckReader::Rule>* DeckReader::rule_or_null(const std::string& name) {
  // Blanks in names count for nothing: *ENDSTEP is *END STEP.
  using Named = std::pair<const std::string, Rule>;
  static const std::map<std::string, const Named*> by_letters = [] {
    std::map<std::string, const Named*> all;
    for (const Named& rule : rules()) all[letters_of(rule.first)] = &rule;
    return all;
  }();
  const auto found = by_letters.find(letters_of(name));
  return found == by_letters.end() ? nullptr : found->second;
}

const std::map<std::string, DeckReader::Rule>& DeckReader::rules() {
  using Kind = Rule::Kind;
  static const std::map<std::string, Rule> all = [] {
    std::map<std::string, Rule> result;
    const auto read = [&](const char* name, void (DeckReader::*handler)(const Card&)) {
      result[name] = {Kind::read, {}, handler};
    };
    const auto add = [&](Kind kind, const std::string& text, std::initializer_list<const char*> names) {
      for (const char* name : names) result[name] = {kind, text, nullptr};
    };

    const auto keep = [&](Where where, std::size_t most_fields, std::initializer_list<const char*> names) {
      for (const char* name : names) result[name] = {Kind::kept, {}, nullptr, where, most_fields};
    };

    read("NODE", &DeckReader::node);
    read("ELEMENT", &DeckReader::element);
    read("NSET", &DeckReader::node_set);
    read("ELSET", &DeckReader::element_set);
    read("SURFACE", &DeckReader::surface);
    read("SOLID SECTION", &DeckReader::solid_section);
    read("GASKET SECTION", &DeckReader::gasket_section);
    read("GASKET BEHAVIOR", &DeckReader::gasket_behavior);
    read("GASKET THICKNESS BEHAVIOR", &DeckReader::gasket_thickness_behavior);
    read("MATERIAL", &DeckReader::material);
    read("ELASTIC", &DeckReader::elastic);
    read("EXPANSION", &DeckReader::expansion);
    read("POTENTIAL", &DeckReader::potential);
    read("ORIENTATION", &DeckReader::orientation);
    read("DENSITY", &DeckReader::density);
    read("CONDUCTIVITY", &DeckReader::conductivity);
    read("SPECIFIC HEAT", &DeckReader::specific_heat);
    read("CREEP", &DeckReader::creep);
    read("PLASTIC", &DeckReader::plastic);
    read("CYCLIC HARDENING", &DeckReader::cyclic_hardening);
    read("PHYSICAL CONSTANTS", &DeckReader::physical_constants);
    read("AMPLITUDE", &DeckReader::amplitude);
    read("STEP", &DeckReader::step);
    read("END STEP", &DeckReader::end_step);
    read("STATIC", &DeckReader::statics);
    read("VISCO", &DeckReader::visco);
    read("NO ANALYSIS", &DeckReader::no_analysis);
    read("HEAT TRANSFER", &DeckReader::heat_transfer);
    read("COUPLED TEMPERATURE-DISPLACEMENT", &DeckReader::temperature_displacement);
    read("UNCOUPLED TEMPERATURE-DISPLACEMENT", &DeckReader::temperature_displacement);
    read("PART", &DeckReader::part);
    read("END PART", &DeckReader::end_part);
    read("INSTANCE", &DeckReader::instance);
    read("END INSTANCE", &DeckReader::end_instance);

    keep(Where::anywhere, 4, {"BOUNDARY"});
    keep(Where::step, 3, {"CLOAD", "DSLOAD"});
    keep(Where::step, 9, {"DLOAD"});
    keep(Where::step, 2, {"TEMPERATURE"});
    keep(Where::step, 3, {"CFLUX", "DFLUX", "DSFLUX"});
    keep(Where::step, 4, {"FILM", "SFILM", "RADIATE", "SRADIATE"});
    keep(Where::step, 0, {"CHANGE FRICTION"});
    keep(Where::step, 2, {"MODEL CHANGE"});
    keep(Where::anywhere, 0, {"FRICTION", "NODE PRINT", "EL PRINT", "EQUATION", "MPC"});
    keep(Where::anywhere, 6, {"TRANSFORM"});
    keep(Where::model, 2, {"CONTACT PAIR", "TIE", "CONTACT INCLUSIONS", "CONTACT EXCLUSIONS"});
    keep(Where::model, 3, {"CONTACT PROPERTY ASSIGNMENT", "PRE-TENSION SECTION"});
    keep(Where::model, 6, {"CYCLIC SYMMETRY MODEL"});
    keep(Where::model, 0,
         {"INITIAL CONDITIONS", "SURFACE INTERACTION", "SURFACE BEHAVIOR", "CLEARANCE", "RIGID BODY", "CONTACT",
          "SPRING", "MASS", "KINEMATIC COUPLING", "GAP CONDUCTANCE", "COUPLING"});
    keep(Where::model, 2, {"KINEMATIC", "DISTRIBUTING"});
    add(Kind::impossible, "contact that changes from step to step is not known", {"CHANGE SURFACE BEHAVIOR"});
    const std::string general =
        "a setting of general *CONTACT that is not known; *CONTACT PAIR with the surfaces that may touch is";
    add(Kind::impossible, general,
        {"CONTACT INITIALIZATION DATA", "CONTACT INITIALIZATION ASSIGNMENT", "SURFACE PROPERTY ASSIGNMENT",
         "CONTACT STABILIZATION", "CONTACT CLEARANCE", "CONTACT CLEARANCE ASSIGNMENT", "CONTACT INTERFERENCE"});
    add(Kind::silent, "", {"ASSEMBLY", "END ASSEMBLY", "RESTART"});
    add(Kind::without_influence, "",
        {"HEADING",
         "PREPRINT",
         "NODE FILE",
         "EL FILE",
         "NODE OUTPUT",
         "ELEMENT OUTPUT",
         "CONTACT OUTPUT",
         "ENERGY OUTPUT",
         "CONTACT FILE",
         "CONTACT PRINT",
         "FACE PRINT",
         "OUTPUT",
         "SECTION PRINT",
         "SECTION FILE",
         "ENERGY FILE",
         "ENERGY PRINT",
         "SURFACE OUTPUT",
         "INTEGRATED OUTPUT",
         "INTEGRATED OUTPUT SECTION",
         "INCREMENTATION OUTPUT",
         "FILE OUTPUT",
         "FILTER",
         "NORMAL",
         "CONTROLS",
         "SOLUTION TECHNIQUE",
         "SOLVER CONTROLS",
         "TIME POINTS",
         "MONITOR",
         "PRINT",
         "FILE FORMAT",
         "DIAGNOSTICS",
         "NODE RESPONSE",
         "ELEMENT RESPONSE",
         "CONTACT RESPONSE",
         "OBJECTIVE",
         "DESIGN VARIABLES",
         "SECTION CONTROLS",
         "HOURGLASS STIFFNESS",
         "ELECTRICAL CONDUCTIVITY",
         "MAGNETIC PERMEABILITY",
         "VIEWFACTOR"});
    add(Kind::left_out, "damping does not act in static and creep steps",
        {"DAMPING", "MODAL DAMPING", "CONTACT DAMPING"});
    add(Kind::left_out, "contact is solved without tolerances and stabilisation of its own",
        {"CONTACT CONTROLS", "CONTACT CONTROLS ASSIGNMENT"});
    add(Kind::left_out,
        "a gasket has no stiffness in its plane and in shear; give the contact 'friction' where it holds",
        {"GASKET ELASTICITY"});
    add(Kind::left_out, "it counts for output only", {"GASKET CONTACT AREA"});
    add(Kind::left_out, "the first surface of a pair is the slave", {"CONTACT FORMULATION"});
    add(Kind::impossible, "this kind of coupling is not known; *COUPLING with *KINEMATIC or *DISTRIBUTING is",
        {"DISTRIBUTING COUPLING", "EMBEDDED ELEMENT", "SHELL TO SOLID COUPLING"});
    add(Kind::impossible,
        "this card of stresses or strains at the start is not known; *INITIAL CONDITIONS, TYPE=STRESS is",
        {"INITIAL STRESS", "INITIAL STRAIN INCREASE"});
    add(Kind::impossible, "materials that change from step to step are not known",
        {"CHANGE SOLID SECTION", "CHANGE MATERIAL", "CHANGE PLASTIC"});
    add(Kind::of_heat, "films and radiation of nodes are not known; *FILM, *SFILM, *RADIATE and *SRADIATE of faces are",
        {"CFILM", "CRADIATE", "FILM PROPERTY", "RADIATION FILE"});
    add(Kind::of_heat,
        "radiation between surfaces is not known, only to surroundings; a film with a coefficient "
        "that depends on the temperature does nearly the same",
        {"EMISSIVITY", "GAP RADIATION", "CAVITY DEFINITION", "RADIATION VIEWFACTOR"});
    add(Kind::of_heat, "heat of deformation, of friction and of currents is not known",
        {"GAP HEAT GENERATION", "INELASTIC HEAT FRACTION", "JOULE HEAT FRACTION"});
    add(Kind::of_heat, "latent heat is not known; *SPECIFIC HEAT with a peak over the temperature does nearly the same",
        {"LATENT HEAT"});

    add(Kind::impossible, "shells and membranes are not known",
        {"SHELL SECTION", "MEMBRANE SECTION", "MEMBRANE", "SHELL GENERAL SECTION", "NODAL THICKNESS"});
    add(Kind::impossible, "beams and trusses are not known", {"BEAM SECTION", "BEAM GENERAL SECTION", "TRUSS SECTION"});
    add(Kind::impossible, "dashpots, rotary inertia and gap elements are not known",
        {"DASHPOT", "DASHPOTA", "GAP", "ROTARY INERTIA", "CONNECTOR SECTION"});
    add(Kind::impossible, "this kind of plasticity is not known",
        {"DEFORMATION PLASTICITY", "DRUCKER PRAGER", "MOHR COULOMB", "CONCRETE"});
    add(Kind::impossible, "large elastic strains are not known", {"HYPERELASTIC", "HYPERFOAM", "HYPO ELASTIC"});
    add(Kind::impossible, "user materials and elements are not known",
        {"USER MATERIAL", "DEPVAR", "USER ELEMENT", "SUBSTRUCTURE GENERATE"});
    add(Kind::impossible,
        "viscoelasticity by *VISCOELASTIC is not known; the laws 'maxwell', 'hereditary' and others are",
        {"VISCOELASTIC"});
    add(Kind::impossible,
        "only *STATIC, *VISCO and *HEAT TRANSFER steps, and those of temperatures with displacements, are known",
        {"DYNAMIC", "FREQUENCY", "COMPLEX FREQUENCY", "MODAL DYNAMIC", "STEADY STATE DYNAMICS", "BUCKLE",
         "ELECTROMAGNETICS", "CFD", "GREEN", "SENSITIVITY", "FEASIBLE DIRECTION", "CRACK PROPAGATION", "SUBMODEL"});
    add(Kind::impossible, "fluid networks are not known",
        {"FLUID SECTION", "FLUID CONSTANTS", "SPECIFIC GAS CONSTANT", "VALUES AT INFINITY"});
    return result;
  }();
  return all;
}

}  // namespace creepcontact::deck
