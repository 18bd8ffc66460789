/// Parameters of cards: each is taken, left out with a line, or refused.

#include "../../../src/deck/card_parameters.hpp"

#include <gtest/gtest.h>

#include <sstream>

#include "../../../src/deck/deck_reader.hpp"
#include "creepcontact/base/error.hpp"
#include "support/says.hpp"

namespace creepcontact::deck {
namespace {

using creepcontact::test::message_of;
using creepcontact::test::says;
using Kind = DeckReader::Rule::Kind;

const std::string plate =
    "*NODE, NSET=Nall\n1, 0, 0\n2, 1, 0\n3, 1, 1\n4, 0, 1\n*ELEMENT, TYPE=CPE4, ELSET=Eall\n7, 1, 2, 3, 4\n";

Deck deck_of(const std::string& text) {
  std::istringstream stream(plate + text);
  return read_deck(stream, "deck.inp");
}

std::string consequences(const std::vector<Note>& notes) {
  std::string all;
  for (const Note& note : notes) all += "*" + note.card + ": " + note.consequence + "\n";
  return all;
}

TEST(CardParameters, EveryCardThatIsReadHasAList) {
  for (const auto& [name, rule] : DeckReader::rules()) {
    if (rule.kind == Kind::read || rule.kind == Kind::kept) {
      EXPECT_NE(parameters_of(name), nullptr) << name;
    }
    if (rule.kind == Kind::impossible || rule.kind == Kind::left_out || rule.kind == Kind::of_heat) {
      EXPECT_FALSE(rule.text.empty()) << name;
      EXPECT_EQ(parameters_of(name), nullptr) << name;
    }
  }
  for (const auto& [name, rule] : DeckReader::rules()) {
    const auto* parameters = parameters_of(name);
    if (parameters == nullptr) continue;
    for (const auto& [letters, parameter] : *parameters) {
      const bool needs_text = parameter.use == Parameter::Use::left_out || parameter.use == Parameter::Use::impossible;
      EXPECT_EQ(needs_text, !parameter.text.empty()) << name << ", " << parameter.name;
    }
  }
}

/// Whatever the card, what is not in its list may change the results.
TEST(CardParameters, UnknownOnesAreRefusedForEveryCard) {
  for (const auto& [name, rule] : DeckReader::rules()) {
    if (parameters_of(name) == nullptr || name == "INSTANCE" || name.starts_with("END ")) continue;
    std::string card = "*" + name + ", NOVELTY=3";
    for (const auto& [letters, parameter] : *parameters_of(name))
      if (parameter.use == Parameter::Use::taken && letters != "INSTANCE")
        card += ", " + letters + "=" +
                (letters == "ELSET"         ? "Eall"
                 : parameter.values.empty() ? "1"
                                            : parameter.values[0]);
    const bool in_step = rule.where == DeckReader::Where::step || name == "STATIC" || name == "VISCO" ||
                         name == "NO ANALYSIS" || name == "HEAT TRANSFER" || name.ends_with("TEMPERATURE-DISPLACEMENT");
    const std::string end = in_step || name == "STEP" ? "\n*END STEP" : name == "PART" ? "\n*END PART" : "";
    const Deck deck = deck_of("*MATERIAL, NAME=M\n*GASKET BEHAVIOR, NAME=G\n" + std::string(in_step ? "*STEP\n" : "") +
                              card + end + "\n");
    EXPECT_TRUE(says(consequences(deck.impossible), {"NOVELTY: ", "unknown"})) << name;
  }
}

TEST(CardParameters, WhatChangesTheResultsIsRefused) {
  const auto refuse = [](const std::string& card, std::initializer_list<std::string_view> facts) {
    EXPECT_TRUE(says(consequences(deck_of(card + "\n").impossible), facts)) << card;
  };
  refuse("*CONTACT PAIR, INTERACTION=I, TYPE=MASSLESS", {"*CONTACT PAIR: TYPE=MASSLESS", "SURFACE TO SURFACE"});
  refuse("*CONTACT PAIR, INTERACTION=I, CPSET=a", {"*CONTACT PAIR: CPSET: "});
  refuse("*FRICTION, ROUGH", {"*FRICTION: ROUGH: "});
  refuse("*FRICTION, TAUMAX=3", {"*FRICTION: TAUMAX: "});
  refuse("*SURFACE BEHAVIOR, NO SEPARATION", {"*SURFACE BEHAVIOR: NO SEPARATION: "});
  refuse("*SURFACE BEHAVIOR, PRESSURE-OVERCLOSURE=PERFECT",
         {"*SURFACE BEHAVIOR: PRESSURE-OVERCLOSURE=PERFECT", "HARD"});
  refuse("*CONTACT EXCLUSIONS, OP=NEW", {"*CONTACT EXCLUSIONS: OP: "});
  refuse("*STEP\n*MODEL CHANGE, TYPE=ELEMENT, REMOVE\n*END STEP", {"*MODEL CHANGE: TYPE=ELEMENT", "CONTACT PAIR"});
  refuse("*AMPLITUDE, NAME=A, DEFINITION=PERIODIC", {"*AMPLITUDE: DEFINITION=PERIODIC", "TABULAR"});
  refuse("*AMPLITUDE, NAME=A, SMOOTH=0.1", {"*AMPLITUDE: SMOOTH=0.1"});
  refuse("*AMPLITUDE, NAME=A, TIME=FREQUENCY", {"*AMPLITUDE: TIME=FREQUENCY", "STEP TIME, TOTAL TIME"});
  refuse("*NODE, SYSTEM=C", {"*NODE: SYSTEM=C", "R"});
  refuse("*ELSET, ELSET=x, SORTD", {"*ELSET: SORTD: ", "unknown"});
  refuse("*BOUNDARY, AMPLITUD=A", {"*BOUNDARY: AMPLITUD: ", "unknown", "'AMPLITUDE'"});
  refuse("*BOUNDARY, TYPE=VELOCITY", {"*BOUNDARY: TYPE=VELOCITY", "DISPLACEMENT"});
  refuse("*MATERIAL, NAME=M\n*ELASTIC, DEPENDENCIES=1\n1, 0", {"*ELASTIC: DEPENDENCIES=1", "0"});
  refuse("*SYSTEM\n0, 0, 0", {"*SYSTEM: ", "unknown card"});
  refuse("*CLOAD\n1, 1, 2.", {"*CLOAD: ", "*STEP", "*END STEP"});
  refuse("*STEP\n*INITIAL CONDITIONS, TYPE=TEMPERATURE\n1, 3.\n*END STEP", {"*INITIAL CONDITIONS: ", "first *STEP"});
  refuse("*STEP\n*STATIC, RIKS\n*END STEP", {"*STATIC: RIKS: "});
  refuse("*STEP\n*VISCO, TOTAL TIME AT START=3\n*END STEP", {"*VISCO: TOTAL TIME AT START: "});
  refuse("*STEP, AMPLITUDE=SINE\n*STATIC\n*END STEP", {"*STEP: AMPLITUDE=SINE", "RAMP, STEP"});
  refuse("*STEP\n*END STEP", {"*STEP: ", "procedure"});
  refuse("*STEP\n*STATIC\n*END STEP\n*BOUNDARY\n1, 1", {"*BOUNDARY: ", "between two steps"});
  refuse("*PART, NAME=P\n*EQUATION\n1\n1, 1, 1.\n*END PART", {"*EQUATION: ", "part", "instance"});
}

TEST(CardParameters, WhatIsLeftOutHasALine) {
  const Deck deck = deck_of(
      "*HEADING\n*NODE FILE\nU\n*NSET, NSET=A, FREQUENCY=3\n1\n*CONTACT CONTROLS, STABILIZE\n*HEADING\n*STEP, INC=9\n"
      "*STATIC, STABILIZE\n*CLOAD, FOLLOWER\n1, 1, 2.\n*END STEP\n");
  EXPECT_TRUE(deck.impossible.empty()) << consequences(deck.impossible);
  EXPECT_TRUE(says(consequences(deck.left_out), {"*NSET: FREQUENCY: ", "*CONTACT CONTROLS: ", "*STATIC: STABILIZE: ",
                                                 "*CLOAD: FOLLOWER: ", "*HEADING, *NODE FILE: "}));
}

/// Cards of heat never go without a word.
TEST(CardParameters, OfHeat) {
  const auto refuse = [](const std::string& card, std::initializer_list<std::string_view> facts) {
    EXPECT_TRUE(says(consequences(deck_of(card + "\n").impossible), facts)) << card;
  };
  refuse("*STEP\n*HEAT TRANSFER, MODAL DYNAMIC\n*END STEP", {"*HEAT TRANSFER: MODAL DYNAMIC: "});
  refuse("*STEP\n*HEAT TRANSFER, END=SS\n*END STEP", {"*HEAT TRANSFER: END=SS", "PERIOD"});
  refuse("*STEP\n*HEAT TRANSFER\n*END STEP\n*STEP\n*HEAT TRANSFER, TIME RESET\n*END STEP", {"TIME RESET: "});
  refuse("*STEP\n*FILM, FORCED CONVECTION\n7, F1, 1., 2.\n*END STEP", {"*FILM: FORCED CONVECTION: "});
  refuse("*STEP\n*FILM, FILM TIME DELAY=1.\n7, F1, 1., 2.\n*END STEP", {"*FILM: FILM TIME DELAY: "});
  refuse("*STEP\n*RADIATE, CAVITY=C\n7, R1, 1., 2.\n*END STEP", {"*RADIATE: CAVITY: "});
  refuse("*MATERIAL, NAME=M\n*CONDUCTIVITY, TYPE=ANISO\n1.", {"*CONDUCTIVITY: ", "ANISO", "ISO and ORTHO"});
  refuse("*GAP CONDUCTANCE, MASS FLOW RATE\n1.", {"*GAP CONDUCTANCE: MASS FLOW RATE: "});
  refuse("*LATENT HEAT\n1., 2., 3.\n*STEP\n*HEAT TRANSFER\n*END STEP", {"*LATENT HEAT: "});
  const Deck cold = deck_of("*LATENT HEAT\n1., 2., 3.\n*STEP\n*STATIC\n*END STEP\n");
  EXPECT_TRUE(cold.impossible.empty()) << consequences(cold.impossible);
  EXPECT_TRUE(says(consequences(cold.left_out), {"*LATENT HEAT: it does not act"}));
}

/// What steps do with temperatures and displacements.
TEST(CardParameters, ProceduresOfHeat) {
  const auto step = [](const std::string& procedure) {
    const Deck deck =
        deck_of("*MATERIAL, NAME=M\n*CREEP\n1., 2., 0.\n*PHYSICAL CONSTANTS, STEFAN BOLTZMANN=3.\n*STEP\n*" +
                procedure + "\n0.1, 4.\n*END STEP\n");
    EXPECT_TRUE(deck.impossible.empty()) << consequences(deck.impossible);
    EXPECT_EQ(deck.stefan_boltzmann, 3);
    EXPECT_EQ(deck.steps.at(0).period, 4);
    return deck.steps.at(0);
  };
  const Step heat = step("HEAT TRANSFER, DIRECT"), steady = step("HEAT TRANSFER, STEADY STATE");
  EXPECT_TRUE(heat.is_transient() && heat.takes_time() && !heat.deforms && !heat.is_creep);
  EXPECT_TRUE(steady.conducts && steady.is_steady && !steady.takes_time());
  const Step coupled = step("UNCOUPLED TEMPERATURE-DISPLACEMENT, STEADY STATE");
  EXPECT_TRUE(coupled.deforms && coupled.is_creep && coupled.is_steady && !coupled.is_transient());
}

TEST(CardParameters, AmplitudesAreShifted) {
  const Deck deck = deck_of("*AMPLITUDE, NAME=A, SHIFTX=0.5, SHIFTY=1.\n0, 0, 1, 1\n");
  EXPECT_EQ(deck.amplitudes.at("A").points, (std::vector<std::pair<double, double>>{{0.5, 1}, {1.5, 2}}));
  EXPECT_TRUE(says(message_of<ConfigError>([] { deck_of("*AMPLITUDE, NAME=A, SHIFTX=x\n0, 0\n"); }),
                   {"deck.inp:8: *AMPLITUDE: SHIFTX: ", "'x'"}));
  EXPECT_TRUE(says(message_of<ConfigError>([] { deck_of("*AMPLITUDE, NAME=A\n0, 0\n*AMPLITUDE, NAME=a\n0, 0\n"); }),
                   {"deck.inp:10: *AMPLITUDE: ", "'a'"}));
}

/// Sections and sets may come before the sets that they name.
TEST(CardParameters, OrderOfSetsDoesNotCount) {
  const Deck deck =
      deck_of("*SOLID SECTION, ELSET=Later, MATERIAL=M\n*ELSET, ELSET=Later\nOwn\n*ELSET, ELSET=Own\n7\n");
  EXPECT_EQ(deck.element_sets.at("LATER").members, Numbers{7});
  const auto refusal = [](const std::string& text) { return message_of<ConfigError>([&] { deck_of(text); }); };
  EXPECT_TRUE(says(refusal("*SOLID SECTION, ELSET=None, MATERIAL=M\n"), {"deck.inp:8: *SOLID SECTION: ", "'NONE'"}));
  EXPECT_TRUE(says(refusal("*NSET, NSET=A\nB\n*NSET, NSET=B\nC\n*NSET, NSET=C\n1\n"), {"deck.inp:9: *NSET: ", "'B'"}));
}

TEST(CardParameters, NumbersThatAreNone) {
  const auto refusal = [](const std::string& text) { return message_of<ConfigError>([&] { deck_of(text); }); };
  EXPECT_TRUE(says(refusal("*NODE\n9, nan, 0\n8, inf, 0\n"),
                   {"deck.inp:9: *NODE: ", "'nan'", "deck.inp:10: *NODE: ", "'inf'"}));
  for (const char* number : {"-9", "0", "1000000000", "9223372036854775807", "99999999999999999999"}) {
    EXPECT_TRUE(says(refusal(std::string("*NODE\n") + number + ", 0, 0\n"),
                     {"deck.inp:9: *NODE: ", std::string("'") + number + "'"}))
        << number;
    EXPECT_TRUE(says(refusal(std::string("*NSET, NSET=A\n") + number + "\n"), {"deck.inp:9: *NSET"})) << number;
  }
  EXPECT_TRUE(says(refusal("*MATERIAL, NAME=M\n*ELASTIC\n1, 0, 20, 3\n"), {"deck.inp:10: *ELASTIC: ", "4", "3"}));
  EXPECT_TRUE(says(refusal("*MATERIAL, NAME=M\n*ELASTIC\n1, 0\n*ELASTIC\n2, 0\n"), {"deck.inp:11: *ELASTIC: ", "'M'"}));
}

/// A comma at the end of a card may stand before parameters without values, which are not data.
TEST(CardParameters, ParametersInTheNextLine) {
  const auto refusal = [](const std::string& text) { return message_of<ConfigError>([&] { deck_of(text); }); };
  EXPECT_TRUE(says(refusal("*STEP, INC=9,\nNLGEOM\n*STATIC\n*END STEP\n"), {"deck.inp:9: *STEP: 'NLGEOM'"}));
  EXPECT_TRUE(says(refusal("*SURFACE INTERACTION, NAME=I\n*SURFACE BEHAVIOR,\nno separation\n"),
                   {"deck.inp:10: *SURFACE BEHAVIOR: 'no separation'"}));
  EXPECT_TRUE(deck_of("*STEP,\nA title\n*STATIC\n*END STEP\n").impossible.empty());
}

/// Names are UTF-8, whatever the encoding of the deck.
TEST(CardParameters, NamesInLatin1) {
  const Deck deck = deck_of(
      "*NSET, NSET=Fl\xE4"
      "che\n1\n*NSET, NSET=Fl\xC3\xA4ge\n1\n");
  EXPECT_TRUE(
      deck.node_sets.contains("FL\xC3\xA4"
                              "CHE"));
  EXPECT_TRUE(deck.node_sets.contains("FL\xC3\xA4GE"));
  EXPECT_TRUE(says(message_of<ConfigError>([] {
                     deck_of(
                         "*NSET, NSET=a\x01"
                         "b\n1\n");
                   }),
                   {"deck.inp:8: ", "0x01"}));
  EXPECT_TRUE(deck_of("** a comment with \x01\n*NSET, NSET=last\n1\n\x1A").node_sets.contains("LAST"));
}

}  // namespace
}  // namespace creepcontact::deck
