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
    if (rule.kind == Kind::impossible || rule.kind == Kind::left_out) {
      EXPECT_FALSE(rule.text.empty()) << name;
    }
    if (rule.kind == Kind::impossible || rule.kind == Kind::left_out) {
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
    const bool in_step =
        rule.where == DeckReader::Where::step || name == "STATIC" || name == "VISCO" || name == "NO ANALYSIS";
    const std::string end = in_step || name == "STEP" ? "\n*END STEP" : name == "PART" ? "\n*END PART" : "";
    const Deck deck = deck_of("*MATERIAL, NAME=M\n" + std::string(in_step ? "*STEP\n" : "") + card + end + "\n");
    EXPECT_TRUE(says(consequences(deck.impossible), {"NOVELTY: an unknown parameter, which may change the results"}))
        << name;
  }
}

TEST(CardParameters, WhatChangesTheResultsIsRefused) {
  for (const auto& [card, reason] : std::initializer_list<std::pair<const char*, const char*>>{
           {"*CONTACT PAIR, INTERACTION=I, TYPE=MASSLESS", "TYPE=MASSLESS is not known; SURFACE TO SURFACE"},
           {"*CONTACT PAIR, INTERACTION=I, CPSET=a", "CPSET: properties in sets"},
           {"*FRICTION, ROUGH", "ROUGH: friction without a limit"},
           {"*FRICTION, TAUMAX=3", "TAUMAX: friction with a largest traction"},
           {"*SURFACE BEHAVIOR, NO SEPARATION", "NO SEPARATION: surfaces that hold each other"},
           {"*SURFACE BEHAVIOR, PRESSURE-OVERCLOSURE=PERFECT", "PRESSURE-OVERCLOSURE=PERFECT is not known; HARD"},
           {"*CONTACT INCLUSIONS, ALL EXTERIOR", "ALL EXTERIOR: contact of all surfaces with each other"},
           {"*CONTACT EXCLUSIONS", "a setting of general *CONTACT"},
           {"*AMPLITUDE, NAME=A, DEFINITION=PERIODIC", "DEFINITION=PERIODIC is not known; TABULAR is"},
           {"*AMPLITUDE, NAME=A, SMOOTH=0.1", "SMOOTH=0.1 is not known"},
           {"*AMPLITUDE, NAME=A, TIME=FREQUENCY", "TIME=FREQUENCY is not known; STEP TIME, TOTAL TIME are"},
           {"*NODE, SYSTEM=C", "SYSTEM=C is not known; R is"},
           {"*ELSET, ELSET=x, SORTD", "SORTD: an unknown parameter"},
           {"*BOUNDARY, AMPLITUD=A",
            "AMPLITUD: an unknown parameter, which may change the results; did you mean 'AMPLITUDE'?"},
           {"*BOUNDARY, TYPE=VELOCITY", "TYPE=VELOCITY is not known; DISPLACEMENT is"},
           {"*MATERIAL, NAME=M\n*ELASTIC, DEPENDENCIES=1\n1, 0", "DEPENDENCIES=1 is not known; 0 is"},
           {"*SYSTEM\n0, 0, 0", "an unknown card, which may change the results"},
           {"*CLOAD\n1, 1, 2.", "it belongs between *STEP and *END STEP"},
           {"*STEP\n*INITIAL CONDITIONS, TYPE=TEMPERATURE\n1, 3.\n*END STEP", "it belongs before the first *STEP"},
           {"*STEP\n*STATIC, RIKS\n*END STEP", "RIKS: this procedure is not known"},
           {"*STEP\n*VISCO, TOTAL TIME AT START=3\n*END STEP", "TOTAL TIME AT START: a total time"},
           {"*STEP, AMPLITUDE=SINE\n*STATIC\n*END STEP", "AMPLITUDE=SINE is not known; RAMP, STEP are"},
           {"*STEP\n*END STEP", "it has no procedure"},
           {"*STEP\n*STATIC\n*END STEP\n*BOUNDARY\n1, 1", "it is between two steps"},
           {"*PART, NAME=P\n*EQUATION\n1\n1, 1, 1.\n*END PART", "within a part or an instance it is not known"}})
    EXPECT_TRUE(says(consequences(deck_of(std::string(card) + "\n").impossible), {reason})) << card;
}

TEST(CardParameters, WhatIsLeftOutHasALine) {
  const Deck deck = deck_of(
      "*HEADING\n*NODE FILE\nU\n*NSET, NSET=A, FREQUENCY=3\n1\n*CONTACT CONTROLS, STABILIZE\n*HEADING\n*STEP, INC=9\n"
      "*STATIC, STABILIZE\n*CLOAD, FOLLOWER\n1, 1, 2.\n*END STEP\n");
  EXPECT_TRUE(deck.impossible.empty()) << consequences(deck.impossible);
  EXPECT_TRUE(says(consequences(deck.left_out),
                   {"*NSET: FREQUENCY: it counts for output only", "*CONTACT CONTROLS: contact is solved without",
                    "*STATIC: STABILIZE: there is no artificial damping", "*CLOAD: FOLLOWER: directions of loads",
                    "*HEADING, *NODE FILE: without influence on the results"}));
}

TEST(CardParameters, AmplitudesAreShifted) {
  const Deck deck = deck_of("*AMPLITUDE, NAME=A, SHIFTX=0.5, SHIFTY=1.\n0, 0, 1, 1\n");
  EXPECT_EQ(deck.amplitudes.at("A").points, (std::vector<std::pair<double, double>>{{0.5, 1}, {1.5, 2}}));
  EXPECT_TRUE(says(message_of<ConfigError>([] { deck_of("*AMPLITUDE, NAME=A, SHIFTX=x\n0, 0\n"); }),
                   {"SHIFTX: 'x' is not a number"}));
  EXPECT_TRUE(says(message_of<ConfigError>([] { deck_of("*AMPLITUDE, NAME=A\n0, 0\n*AMPLITUDE, NAME=a\n0, 0\n"); }),
                   {"the amplitude 'a' exists already"}));
}

/// Sections and sets may come before the sets that they name.
TEST(CardParameters, OrderOfSetsDoesNotCount) {
  const Deck deck =
      deck_of("*SOLID SECTION, ELSET=Later, MATERIAL=M\n*ELSET, ELSET=Later\nOwn\n*ELSET, ELSET=Own\n7\n");
  EXPECT_EQ(deck.element_sets.at("LATER").members, Numbers{7});
  const auto refusal = [](const std::string& text) { return message_of<ConfigError>([&] { deck_of(text); }); };
  EXPECT_TRUE(says(refusal("*SOLID SECTION, ELSET=None, MATERIAL=M\n"),
                   {"deck.inp:8: *SOLID SECTION: there is no element set 'NONE'"}));
  EXPECT_TRUE(says(refusal("*NSET, NSET=A\nB\n*NSET, NSET=B\nC\n*NSET, NSET=C\n1\n"),
                   {"deck.inp:9: *NSET: the set 'B' comes later and names such sets itself"}));
}

TEST(CardParameters, NumbersThatAreNone) {
  const auto refusal = [](const std::string& text) { return message_of<ConfigError>([&] { deck_of(text); }); };
  EXPECT_TRUE(says(refusal("*NODE\n9, nan, 0\n8, inf, 0\n"), {"'nan' is not a number", "'inf' is not a number"}));
  for (const char* number : {"-9", "0", "1000000000", "9223372036854775807", "99999999999999999999"}) {
    EXPECT_TRUE(says(refusal(std::string("*NODE\n") + number + ", 0, 0\n"), {"is not a node number"})) << number;
    EXPECT_TRUE(says(refusal(std::string("*NSET, NSET=A\n") + number + "\n"), {"deck.inp:9: *NSET"})) << number;
  }
  EXPECT_TRUE(says(refusal("*MATERIAL, NAME=M\n*ELASTIC\n1, 0, 20, 3\n"), {"4 values; at most 3 are known"}));
  EXPECT_TRUE(
      says(refusal("*MATERIAL, NAME=M\n*ELASTIC\n1, 0\n*ELASTIC\n2, 0\n"), {"the material 'M' has one already"}));
}

/// A comma at the end of a card may stand before parameters without values, which are not data.
TEST(CardParameters, ParametersInTheNextLine) {
  const auto refusal = [](const std::string& text) { return message_of<ConfigError>([&] { deck_of(text); }); };
  EXPECT_TRUE(says(refusal("*STEP, INC=9,\nNLGEOM\n*STATIC\n*END STEP\n"),
                   {"deck.inp:9: *STEP: 'NLGEOM' is a parameter of the card"}));
  EXPECT_TRUE(says(refusal("*SURFACE INTERACTION, NAME=I\n*SURFACE BEHAVIOR,\nno separation\n"),
                   {"deck.inp:10: *SURFACE BEHAVIOR: 'no separation' is a parameter of the card"}));
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
                   {"deck.inp:8: a control character (0x01)"}));
  EXPECT_TRUE(deck_of("** a comment with \x01\n*NSET, NSET=last\n1\n\x1A").node_sets.contains("LAST"));
}

}  // namespace
}  // namespace creepcontact::deck
