#include "creepcontact/material/law_reference.hpp"

#include <gtest/gtest.h>

#include "creepcontact/material/registry.hpp"

namespace creepcontact::material {
namespace {

TEST(LawReference, HasEveryLawAndKey) {
  const std::string text = law_reference();
  for (const LawInfo& law : creep_laws()) {
    EXPECT_NE(text.find("### `" + law.name + "`"), std::string::npos);
    for (const ParameterInfo& key : law.parameters) EXPECT_NE(text.find("| `" + key.key + "` |"), std::string::npos);
  }
}

}  // namespace
}  // namespace creepcontact::material
