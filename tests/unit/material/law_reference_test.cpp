#include "creepcontact/material/law_reference.hpp"

#include <gtest/gtest.h>

#include <fstream>
#include <sstream>

#include "creepcontact/material/registry.hpp"

namespace creepcontact::material {
namespace {

TEST(LawReference, StandsInTheDocumentation) {
  std::ifstream file(CREEPCONTACT_DOCS "/materials.md");
  std::ostringstream content;
  content << file.rdbuf();
  const std::string text = content.str(), begin = "<!-- begin: creepcontact list laws --markdown -->\n\n";
  const std::size_t from = text.find(begin), to = text.find("<!-- end -->");
  ASSERT_NE(from, std::string::npos) << "docs/materials.md lacks the line " << begin;
  ASSERT_NE(to, std::string::npos) << "docs/materials.md lacks the line <!-- end -->";
  EXPECT_EQ(text.substr(from + begin.size(), to - from - begin.size()), law_reference())
      << "docs/materials.md is stale: put the output of 'creepcontact list laws --markdown' between its marks";
}

TEST(LawReference, HasEveryLawAndKey) {
  const std::string text = law_reference();
  for (const LawInfo& law : creep_laws()) {
    EXPECT_NE(text.find("### `" + law.name + "`"), std::string::npos);
    for (const ParameterInfo& key : law.parameters) EXPECT_NE(text.find("| `" + key.key + "` |"), std::string::npos);
  }
}

}  // namespace
}  // namespace creepcontact::material
