/// Decks: what is read of them, and what is refused.

#include "creepcontact/deck/deck.hpp"

#include <gtest/gtest.h>

#include <sstream>

#include "creepcontact/base/error.hpp"
#include "support/says.hpp"

namespace creepcontact::deck {
namespace {

using creepcontact::test::message_of;
using creepcontact::test::says;

Deck read(const std::string& text) {
  std::istringstream stream(text);
  return read_deck(stream, "deck.inp");
}

std::string refusal(const std::string& text) {
  return message_of<ConfigError>([&] { read(text); });
}

const std::string square =
    "*NODE, NSET=Nall\n1, 0, 0\n2, 1, 0\n3, 1, 1\n4, 0, 1\n*ELEMENT, TYPE=CPE4, ELSET=Eall\n7, 1, 2, 3, 4\n";

TEST(Deck, NodesElementsAndSets) {
  const Deck deck = read(square +
                         "*NSET, NSET=Left\n1, 4,\n*NSET, NSET=few, GENERATE\n1, 3, 2\n2\n*NSET, NSET=LEFT\nfew\n"
                         "*NSET, NSET=some, UNSORTED\nnall, Left\n*ELSET,ELSET=All\nEALL\n");
  EXPECT_EQ(deck.node_numbers, (Numbers{1, 2, 3, 4}));
  EXPECT_EQ(deck.positions[2], Vector3(1, 1, 0));
  ASSERT_EQ(deck.elements.size(), 1U);
  EXPECT_EQ(deck.elements[0].type.analysis, settings::Analysis::plane_strain);
  EXPECT_EQ(deck.elements[0].nodes, (Numbers{1, 2, 3, 4}));
  EXPECT_EQ(deck.node_sets.at("LEFT").name, "Left");
  EXPECT_EQ(deck.node_sets.at("LEFT").members, (Numbers{1, 4, 3, 2}));
  EXPECT_EQ(deck.node_sets.at("SOME").members, (Numbers{1, 2, 3, 4}));
  EXPECT_EQ(deck.element_sets.at("ALL").members, Numbers{7});
}

/// The lines of an element end where its nodes do, whatever commas say.
TEST(Deck, ElementsOverSeveralLines) {
  std::string text = "*NODE\n";
  for (int i = 1; i <= 20; ++i) text += std::to_string(i) + ", 0, 0, 0\n";
  const Deck deck = read(
      text +
      "*ELEMENT, TYPE=c3d20r\n1, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10,\n11, 12, 13, 14, 15, 16,\n"
      "** a comment in between\n17, 18, 19, 20,\n2, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11\n12, 13, 14, 15, 16, 17, 18, "
      "19, 20\n");
  ASSERT_EQ(deck.elements.size(), 1U);
  EXPECT_EQ(deck.elements[0].numbers, (Numbers{1, 2}));
  EXPECT_EQ(deck.elements[0].nodes.size(), 40U);
  EXPECT_EQ(deck.elements[0].type.variant, "R");
}

TEST(Deck, SurfacesSectionsAndMaterials) {
  const Deck deck = read(square +
                         "*SURFACE, NAME=Top\nEall, S3\n7, s2\n*SURFACE, NAME=Nodes, TYPE=NODE\nNall\n"
                         "*MATERIAL, NAME=Steel\n*ELASTIC\n210000,.3,20\n150000.,.3,600.\n*EXPANSION, ZERO=20\n1.2E-5\n"
                         "*CREEP, LAW=NORTON\n1e-20, 5, 0, 500\n*SOLID SECTION, ELSET=eall, MATERIAL=STEEL\n2.5\n");
  EXPECT_EQ(deck.surfaces.at("TOP").entries[1].target, "7");
  EXPECT_EQ(deck.surfaces.at("TOP").entries[1].face, 2);
  EXPECT_TRUE(deck.surfaces.at("NODES").of_nodes);
  const Material& steel = deck.materials.at("STEEL");
  EXPECT_EQ(steel.name, "Steel");
  EXPECT_EQ(steel.elastic->rows, (std::vector<std::vector<double>>{{210000, 0.3, 20}, {150000, 0.3, 600}}));
  EXPECT_EQ(steel.expansion_zero, 20);
  EXPECT_EQ(steel.creep->rows[0], (std::vector<double>{1e-20, 5, 0, 500}));
  ASSERT_EQ(deck.sections.size(), 1U);
  EXPECT_EQ(deck.sections[0].thickness, 2.5);
}

TEST(Deck, MaterialsWithAxes) {
  const Deck deck = read(
      square +
      "*MATERIAL, NAME=Crystal\n*ELASTIC, TYPE=ENGINEERING CONSTANTS\n1e5, 2e5, 3e5, .1, .2, .3, 4e4, 5e4\n6e4, 20\n"
      "9e4, 1e5, 2e5, .1, .2, .3, 4e4, 5e4,\n6e4, 600,\n*EXPANSION, TYPE=ORTHO\n1e-5, 2e-5, 3e-5, 20\n"
      "*CREEP\n1e-20, 5, 0\n*POTENTIAL\n1, 0.9, 1.1, 0.7, 0.8, 0.6\n"
      "*MATERIAL, NAME=Plate\n*ELASTIC, TYPE=ORTHO\n5e5, 157200., 4e5, 157200., 157200., 3e5, 126200., 126200.,\n"
      "126200., 294.\n"
      "*ORIENTATION, NAME=Or1\n1, 1, 0, 0, 1, 0\n3, 30\n*ORIENTATION, NAME=or2, SYSTEM=CYLINDRICAL\n1,2,3,1,2,5\n"
      "*ORIENTATION, NAME=or3, DEFINITION=NODES\n1, 2, 3\n"
      "*SOLID SECTION, ELSET=eall, MATERIAL=CRYSTAL, ORIENTATION=OR1\n");
  const Material& crystal = deck.materials.at("CRYSTAL");
  EXPECT_EQ(crystal.elasticity, Elasticity::engineering_constants);
  ASSERT_EQ(crystal.elastic->rows.size(), 2U);
  EXPECT_EQ(crystal.elastic->rows[1], (std::vector<double>{9e4, 1e5, 2e5, .1, .2, .3, 4e4, 5e4, 6e4, 600}));
  EXPECT_TRUE(crystal.expands_along_axes);
  EXPECT_EQ(crystal.potential->rows[0], (std::vector<double>{1, 0.9, 1.1, 0.7, 0.8, 0.6}));
  EXPECT_EQ(deck.materials.at("PLATE").elasticity, Elasticity::stiffness_matrix);
  const Orientation& turned = deck.orientations.at("OR1");
  EXPECT_EQ(turned.a, Vector3(1, 1, 0));
  EXPECT_EQ(turned.turned_about, 3);
  EXPECT_EQ(turned.turned_by, 30);
  EXPECT_TRUE(turned.problem.empty());
  EXPECT_TRUE(deck.orientations.at("OR2").is_cylindrical);
  EXPECT_EQ(deck.orientations.at("OR2").b, Vector3(1, 2, 5));
  EXPECT_FALSE(deck.orientations.at("OR3").problem.empty());
  EXPECT_EQ(deck.sections[0].orientation, "OR1");
  EXPECT_TRUE(says(refusal(square + "*ORIENTATION, NAME=o\n1, 0, 0, 0, 1, 0\n4, 30\n"),
                   {"deck.inp:10: *ORIENTATION: ", "'4'"}));
}

/// Axes turn with their instance.
TEST(Deck, OrientationsOfInstances) {
  const Deck deck = read(
      "*Part, name=Plate\n*Node\n1, 0, 0, 0\n2, 1, 0, 0\n3, 1, 1, 0\n4, 0, 1, 0\n*Element, type=CPS4\n1, 1, 2, 3, 4\n"
      "*Elset, elset=all\n1\n*Orientation, name=o\n1, 0, 0, 0, 1, 0\n*Orientation, name=c, system=cylindrical\n"
      "1, 0, 0, 1, 0, 1\n*Solid Section, elset=all, material=m, orientation=o\n*End Part\n"
      "*Assembly, name=A\n*Instance, name=P, part=PLATE\n10, 0, 0\n10, 0, 0, 10, 0, 1, 90\n*End Instance\n*End "
      "Assembly\n");
  EXPECT_EQ(deck.sections[0].orientation, "P.O");
  EXPECT_LT((deck.orientations.at("P.O").a - Vector3(0, 1, 0)).norm(), 1e-14);
  EXPECT_LT((deck.orientations.at("P.C").a - Vector3(10, 1, 0)).norm(), 1e-14);
}

TEST(Deck, StepsKeepTheirCards) {
  const Deck deck =
      read(square +
           "*BOUNDARY\nNall, 1\n*RIGIDBODY, NSET=Nall\n*AMPLITUDE, NAME=A, TIME=TOTAL TIME\n0., 0., 1., 1.,\n2., 0.5\n"
           "*STEP, NLGEOM\n*STATIC\n*CLOAD, OP=NEW\n3, 2, 5.\n*END STEP\n"
           "*STEP\n*VISCO, CETOL=1e-5\n1., 100.\n*DLOAD\nEall, P3, 2.\n*NODE FILE\nU\n*END STEP\n");
  ASSERT_EQ(deck.cards.size(), 2U);
  EXPECT_EQ(deck.cards[1].card.name, "RIGID BODY");
  EXPECT_EQ(deck.cards[0].data[0], (std::vector<std::string>{"Nall", "1"}));
  EXPECT_EQ(deck.amplitudes.at("A").points.size(), 3U);
  EXPECT_TRUE(deck.amplitudes.at("A").total_time);
  ASSERT_EQ(deck.steps.size(), 2U);
  EXPECT_TRUE(deck.steps[0].nonlinear_geometry);
  EXPECT_EQ(deck.steps[0].period, 1);
  EXPECT_EQ(deck.steps[0].cards[0].card.value("OP"), "NEW");
  EXPECT_TRUE(deck.steps[1].is_creep);
  EXPECT_EQ(deck.steps[1].period, 100);
  ASSERT_EQ(deck.steps[1].cards.size(), 1U) << "output files of CalculiX change nothing";
}

TEST(Deck, PartsAndInstances) {
  const Deck deck = read(
      "*HEADING\n*Part, name=Plate\n*Node\n1, 0, 0, 0\n2, 1, 0, 0\n3, 1, 1, 0\n4, 0, 1, 0\n*Element, type=CPS4\n1, 1, "
      "2, 3, 4\n"
      "*Nset, nset=corner\n3\n*Elset, elset=all\n1\n*Surface, name=top\nall, S3\n*Solid Section, elset=all, "
      "material=m\n*End Part\n"
      "*Assembly, name=A\n*Instance, name=Plate-1, part=Plate\n*End Instance\n"
      "*Instance, name=Plate-2, part=PLATE\n10, 0, 0\n10, 0, 0, 10, 0, 1, 90\n*End Instance\n"
      "*Nset, nset=both, instance=Plate-1\ncorner\n*Nset, nset=both, instance=Plate-2\n3\n*End Assembly\n");
  EXPECT_EQ(deck.node_numbers, (Numbers{1, 2, 3, 4, 5, 6, 7, 8}));
  EXPECT_LT((deck.positions[5] - Vector3(10, 1, 0)).norm(), 1e-14) << "moved, then turned about its corner";
  EXPECT_EQ(deck.elements[0].nodes, (Numbers{1, 2, 3, 4, 5, 6, 7, 8}));
  EXPECT_EQ(deck.node_sets.at("BOTH").members, (Numbers{3, 7}));
  EXPECT_EQ(deck.node_sets.at("PLATE-2.CORNER").members, Numbers{7});
  EXPECT_EQ(deck.surfaces.at("PLATE-2.TOP").entries[0].target, "PLATE-2.ALL");
  ASSERT_EQ(deck.sections.size(), 2U);
  EXPECT_EQ(deck.sections[1].elements, "PLATE-2.ALL");
}

TEST(Deck, WhatIsLeftOutAndWhatIsImpossible) {
  const Deck deck = read(square +
                         "*HYPERELASTIC\n200, 0\n*ELEMENT, TYPE=S8R, ELSET=SHELL\n8, 1, 2, 3, 4, 1, 2, 3, 4\n"
                         "*LATENT HEAT\n1, 2, 3\n*BOUNDRY\n1, 1\n*STEP\n*FREQUENCY\n10\n*END STEP\n");
  ASSERT_EQ(deck.impossible.size(), 4U);
  EXPECT_EQ(deck.impossible[0].card, "HYPERELASTIC");
  EXPECT_EQ(deck.impossible[0].place.line, 8U);
  EXPECT_TRUE(says(deck.impossible[1].consequence, {"unknown card", "'BOUNDARY'"}));
  EXPECT_TRUE(says(deck.impossible[2].consequence, {"*STATIC", "*VISCO"}));
  EXPECT_TRUE(says(deck.impossible[3].consequence, {"S8R"}));
  ASSERT_EQ(deck.left_out.size(), 1U);
}

TEST(Deck, EveryMistakeIsNamedWithItsPlace) {
  EXPECT_TRUE(says(
      refusal(
          square +
          "*NSET, NSET=A\nnone\n*NSET\n1\n*NODE\nx, 1\n5, 1, a\n*ELEMENT, TYPE=CPE4\n7, 1, 2, 3, 4\n8, 1, 2, 3, 99\n"
          "*ELASTIC\n1, 0\n*AMPLITUDE, NAME=T\n1, 0, 0, 1\n*SURFACE, NAME=S\nEall, S9\n*STEP\n*STATIC\n1, -1\n"),
      {"deck.inp:10: *NSET: NSET",
       "deck.inp:13: *NODE: 'x'",
       "deck.inp:14: *NODE: 'a'",
       "deck.inp:16: *ELEMENT: element 7",
       "deck.inp:18: *ELASTIC: ",
       "*MATERIAL",
       "deck.inp:21: *AMPLITUDE: ",
       "times",
       "deck.inp:23: *SURFACE: 'S9'",
       "S1",
       "S6",
       "deck.inp:26: *STATIC: ",
       "-1",
       "deck.inp:9: *NSET: ",
       "'NONE'",
       "deck.inp:24: *STATIC: ",
       "*END STEP",
       "deck.inp:15: *ELEMENT: element 8",
       "node 99",
       "*NODE"}));
  EXPECT_TRUE(says(refusal("*NODE\n1, 0\n*ELEMENT, TYPE=CPE8\n3, 1, 1, 1,\n*STEP\n*END STEP\n"),
                   {"deck.inp:4: *ELEMENT: element 3", "CPE8", "3", "8 nodes"}));
  EXPECT_TRUE(says(refusal("*NODE\n1, 0\n"), {"deck.inp:1: *NODE: ", "no elements"}));
  EXPECT_TRUE(says(refusal("*PART, NAME=A\n*NODE\n1, 0\n"), {"deck.inp:2: *NODE: ", "part", "end"}));
  EXPECT_TRUE(says(refusal("*INSTANCE, NAME=I, PART=P\n"), {"deck.inp:1: *INSTANCE: ", "'P'"}));
  EXPECT_TRUE(says(refusal(square + "*NSET, NSET=X, GENERATE\n1, 1000000000000\n"),
                   {"deck.inp:9: *NSET: ", "10000000 members"}));
  std::string many = square + "*NODE\n";
  for (int i = 0; i < 80; ++i) many += "x" + std::to_string(i) + "\n";
  EXPECT_TRUE(says(refusal(many), {"'x49'", "and 30 more"}));
}

/// What is missing is one mistake, wherever it is named.
TEST(Deck, MistakesOfOneCauseAreOne) {
  std::string faces = square + "*ELSET, ELSET=Some\n7\n";
  for (int i = 0; i < 1000; ++i) faces += "7, S" + std::to_string(1 + i % 4) + "\n";
  EXPECT_EQ(refusal(faces),
            "deck.inp:10: *ELSET: faces of elements (S1 to S6) belong below *SURFACE; is the line of a *SURFACE "
            "missing? (and at 999 more places)");
  EXPECT_EQ(refusal("*ELEMENT, TYPE=CPE4\n1, 1, 2, 3, 4\n2, 5, 6, 7, 8\n"),
            "deck.inp:1: *ELEMENT: element 1 has the node 1, which no *NODE defines; nor 7 other nodes of elements");
  EXPECT_EQ(refusal(square + "*NSET, NSET=A\nnone\n*NSET, NSET=B\nnone, 1\n"),
            "deck.inp:9: *NSET: there is no set 'NONE' (and at 1 more place)");
}

/// Lines and faces that a mesh program writes next to the bodies name nodes.
TEST(Deck, ElementsOfLinesAndFacesOfAMesh) {
  const std::string mesh =
      "*NODE\n1, 0, 0, 0\n2, 1, 0, 0\n3, 0, 1, 0\n4, 0, 0, 1\n*ELEMENT, TYPE=T3D2, ELSET=Line\n1, 1, 2\n"
      "*ELEMENT, TYPE=CPS3, ELSET=Low\n2, 1, 3, 2\n*ELEMENT, TYPE=S3, ELSET=High\n3, 2, 3, 4\n"
      "*ELEMENT, TYPE=C3D4, ELSET=Body\n4, 1, 2, 3, 4\n*NSET, NSET=n, ELSET=Low\n*NSET, NSET=n, ELSET=HIGH\n";
  const std::string section = "*SOLID SECTION, ELSET=Body, MATERIAL=M\n";
  const Deck deck = read(mesh + section);
  ASSERT_EQ(deck.elements.size(), 1U);
  EXPECT_EQ(deck.elements[0].numbers, Numbers{4});
  EXPECT_EQ(deck.element_of_number.at(4).block, 0U);
  EXPECT_FALSE(deck.element_of_number.contains(2));
  EXPECT_EQ(deck.node_sets.at("N").members, (Numbers{1, 3, 2, 4}));
  ASSERT_EQ(deck.left_out.size(), 1U);
  EXPECT_TRUE(says(deck.left_out[0].consequence, {"3 elements", "CPS3, S3, T3D2", "not bodies"}));
  EXPECT_TRUE(read(mesh).is_only_mesh());
  EXPECT_FALSE(deck.is_only_mesh());
  const Deck shell = read(mesh + section + "*SOLID SECTION, ELSET=High, MATERIAL=M\n");
  ASSERT_EQ(shell.impossible.size(), 1U);
  EXPECT_TRUE(says(shell.impossible[0].consequence, {"type S3"}));
}

TEST(Deck, NodesOfInstancesByNumber) {
  const Deck deck = read(
      "*Part, name=P\n*Node\n1, 0, 0\n2, 1, 0\n3, 1, 1\n4, 0, 1\n*Element, type=CPS4\n1, 1, 2, 3, 4\n*End Part\n"
      "*Assembly, name=A\n*Instance, name=P-1, part=P\n*End Instance\n*Instance, name=P-2, part=P\n*End Instance\n"
      "*Nset, nset=both\nP-1.2, p-2.3\n*End Assembly\n");
  EXPECT_EQ(deck.node_sets.at("BOTH").members, (Numbers{2, 7}));
  EXPECT_EQ(deck.number_in_instance("P-2.1", true), 5);
  EXPECT_EQ(deck.number_in_instance("P-2.1", false), 2);
  EXPECT_FALSE(deck.number_in_instance("P-3.1", true));
  EXPECT_FALSE(deck.number_in_instance("P-2.x", true));
}

TEST(ElementTypes, NamesVariantsAndFaces) {
  EXPECT_EQ(element_type("c3d10m")->cell, mesh::CellType::tet10);
  EXPECT_EQ(element_type("CAX8RH")->variant, "RH");
  EXPECT_EQ(element_type("CPEG8")->analysis, settings::Analysis::generalized_plane_strain);
  EXPECT_EQ(element_type("C3D20RT")->variant, "RT");
  EXPECT_EQ(element_type("DCAX8")->analysis, settings::Analysis::axisymmetric);
  EXPECT_EQ(element_type("DC3D20")->cell, mesh::CellType::hex20);
  for (const char* name : {"DC3D8E", "DCC3D8", "S8R", "B32", "C3D", "C3D27", "CPE8P", ""})
    EXPECT_FALSE(element_type(name)) << name;
  EXPECT_EQ(*face(mesh::CellType::hex20, 2), (std::vector<int>{4, 7, 6, 5, 15, 14, 13, 12}));
  EXPECT_EQ(*face(mesh::CellType::tet10, 3), (std::vector<int>{1, 3, 2, 8, 9, 5}));
  EXPECT_EQ(*face(mesh::CellType::quad8, 4), (std::vector<int>{3, 0, 7}));
  EXPECT_EQ(face(mesh::CellType::wedge15, 6), nullptr);
  EXPECT_EQ(face(mesh::CellType::tet4, 0), nullptr);
}

}  // namespace
}  // namespace creepcontact::deck
