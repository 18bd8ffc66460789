/// Lines of decks as cards and data.

#include "creepcontact/deck/cards.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <fstream>
#include <sstream>

#include "creepcontact/base/error.hpp"
#include "support/says.hpp"
#include "unit/io/temporary_directory.hpp"

namespace creepcontact::deck {
namespace {

/// Cards and data as one text: "NAME KEY=value;" and "[a|b|]" with a bar after the last field of a line that goes on.
std::string seen(const std::string& text, const std::string& name = "deck.inp") {
  std::string result;
  std::istringstream stream(text);
  read_cards(stream, name,
             {[&](const Card& card) {
                result += card.name;
                for (const auto& [key, value] : card.parameters) result += fmt::format(" {}={}", key, value);
                result += ";";
              },
              [&](const DataLine& line) {
                result += "[";
                for (std::size_t i = 0; i < line.fields.size(); ++i)
                  result += (i > 0 ? "|" : "") + std::string(line.fields[i]);
                result += line.goes_on ? "|]" : "]";
              }});
  return result;
}

TEST(Cards, CaseBlanksCommentsAndLineEnds) {
  EXPECT_EQ(
      seen("*Node, nset = All Nodes ,  SYSTEM=R\r\n1, 0.,0.\r\n** a comment, with \xC3\xA9 and \xFF\n\n  2 ,1.,\t2.\n"),
      "NODE NSET=All Nodes SYSTEM=R;[1|0.|0.][2|1.|2.]");
  EXPECT_EQ(seen("* solid   section ,elset=E,\nMATERIAL = \"My, steel\" ,\n*END STEP"),
            "SOLID SECTION ELSET=E MATERIAL=My, steel;END STEP;");
  EXPECT_EQ(seen("*ELEMENT, TYPE=C3D8   ,\n1, 2, 3\n*DLOAD,\nEall, P3\n"), "ELEMENT TYPE=C3D8;[1|2|3]DLOAD;[Eall|P3]");
  EXPECT_EQ(seen("*Contact Pair, SMALL SLIDING\nA ,B"), "CONTACT PAIR SMALLSLIDING=;[A|B]");
  EXPECT_EQ(seen("\xEF\xBB\xBF*HEADING\n"), "HEADING;");
}

TEST(Cards, EmptyFieldsAndLinesThatGoOn) {
  EXPECT_EQ(seen("*BOUNDARY\n1,2,,0.0\n1,\n,,\n"), "BOUNDARY;[1|2||0.0][1|][|]");
}

TEST(Cards, NumbersOfFortran) {
  for (const auto& [text, value] : std::initializer_list<std::pair<const char*, double>>{{"210000", 210000},
                                                                                         {"1.", 1},
                                                                                         {".5", 0.5},
                                                                                         {"+2", 2},
                                                                                         {"-2.5E+3", -2500},
                                                                                         {"1.57d0", 1.57},
                                                                                         {"0.d0", 0},
                                                                                         {"1.D-3", 1e-3},
                                                                                         {"1.5-3", 1.5e-3},
                                                                                         {"-1.+2", -100},
                                                                                         {"1e05", 1e5}})
    EXPECT_DOUBLE_EQ(number(text).value_or(-1), value) << text;
  for (const char* text : {"", "a", "1.0.0", "1,", "--1", "+-1", "1e", "nan(", "0x10", "e5"})
    EXPECT_FALSE(number(text).has_value()) << text;
  EXPECT_EQ(whole_number("+12"), 12);
  for (const char* text : {"", "1.0", "1e3", "12a", "99999999999999999999"})
    EXPECT_FALSE(whole_number(text).has_value()) << text;
}

TEST(Cards, FilesThatAreIncluded) {
  const io::test::TemporaryDirectory directory;
  std::filesystem::create_directory(directory / "mesh");
  std::ofstream(directory / "deck.inp") << "*HEADING\n*INCLUDE, INPUT=mesh/nodes.inp\n*STEP\n";
  std::ofstream(directory / "mesh" / "nodes.inp") << "*NODE\n*INCLUDE,INPUT=\"more.inp\"\n2\n";
  std::ofstream(directory / "mesh" / "more.inp") << "1\n";
  std::string places;
  read_cards(directory / "deck.inp",
             {[&](const Card& card) { places += card.name + std::to_string(card.place.line) + " "; },
              [&](const DataLine& line) {
                places += std::string(line.field(0)) + ":" +
                          std::filesystem::path(line.place.file).filename().string() + std::to_string(line.place.line) +
                          " ";
              }});
  EXPECT_EQ(places, "HEADING1 NODE1 1:more.inp1 2:nodes.inp3 STEP3 ");

  std::ofstream(directory / "mesh" / "more.inp") << "*INCLUDE,INPUT=../deck.inp\n";
  const auto nothing = [](const auto&) {};
  const auto read = [&] { read_cards(directory / "deck.inp", {nothing, nothing}); };
  EXPECT_TRUE(creepcontact::test::says(creepcontact::test::message_of<ConfigError>(read),
                                       {"more.inp:1: *INCLUDE: ", "deck.inp'", "itself"}));
  std::filesystem::remove(directory / "mesh" / "more.inp");
  EXPECT_TRUE(creepcontact::test::says(creepcontact::test::message_of<ConfigError>(read),
                                       {"nodes.inp:2: *INCLUDE: ", "more.inp'"}));
}

TEST(Cards, WhatIsNoDeck) {
  const auto refusal = [](const std::string& text) {
    return creepcontact::test::message_of<ConfigError>([&] { seen(text); });
  };
  EXPECT_TRUE(creepcontact::test::says(refusal("1, 2\n"), {"deck.inp: ", "no cards", "*NODE", "*ELEMENT"}));
  EXPECT_EQ(seen("A title\n*NODE\n"), "NODE;");
  EXPECT_TRUE(creepcontact::test::says(refusal(std::string("*NODE\n\0\n", 8)), {"deck.inp:2: ", "not text"}));
}

/// CalculiX does not read the lines below a card that it does not know.
TEST(Cards, LinesOfOneStarDivideDecks) {
  const auto read = [](const std::string& text) {
    return creepcontact::test::message_of<ConfigError>([&] { seen(text); });
  };
  EXPECT_EQ(seen("*\n*NODE\n1\n*\n*-----\n* ,\n*STEP\n*"), seen("*NODE\n1\n*STEP\n"));
  EXPECT_TRUE(creepcontact::test::says(read("*NODE\n1\n*\n2\n"), {"deck.inp:4: data", "deck.inp:3", "**"}));
}

}  // namespace
}  // namespace creepcontact::deck
