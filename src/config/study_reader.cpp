#include <fmt/format.h>

#include <algorithm>
#include <sstream>

#include "creepcontact/config/study.hpp"
#include "study_tables.hpp"
#include "toml_document.hpp"

namespace creepcontact::config {
namespace {

void check_axes(const Study& study, Diagnostics& errors) {
  for (auto axis = study.axes.begin(); axis != study.axes.end(); ++axis) {
    for (auto other = study.axes.begin(); other != axis; ++other) {
      if (axis->key.given() && axis->key.name == other->key.name)
        errors.add(axis->key.location,
                   fmt::format("'{}' has an axis already, in line {}", axis->key.name, other->key.location.line));
      if (axis->zip.empty() || axis->zip != other->zip || axis->values.empty() || other->values.empty()) continue;
      if (axis->values.size() != other->values.size())
        errors.add(axis->location,
                   fmt::format("{} values of '{}' and {} of '{}', which run together (zip = \"{}\")",
                               axis->values.size(), axis->key.name, other->values.size(), other->key.name, axis->zip),
                   "as many values on all axes of a zip");
      break;
    }
  }
}

void check_comparison(const Study& study, const Item& root, Diagnostics& errors) {
  const bool reference = root.has("reference"), compare = root.has("compare");
  if (reference != compare)
    errors.add(root.child(reference ? "reference" : "compare").location,
               reference ? "nothing is compared with it" : "nothing to compare with",
               "[reference] and [compare] together");
  if (root.child("compare").has("quantities") && study.compare.quantities.empty() && errors.empty())
    errors.add(root.child("compare").child("quantities").location, "an empty list", "at least one probe");
  if (!study.reference || study.reference->expressions.empty()) return;
  std::vector<std::string> names;
  for (const auto& [name, expression] : study.reference->expressions) names.push_back(name);
  for (const Reference& quantity : study.compare.quantities)
    if (!study.reference->expressions.contains(quantity.name))
      errors.add_unknown(quantity.location, fmt::format("'{}' has no expression in [reference]", quantity.name),
                         quantity.name, names);
}

}  // namespace

Study parse_study(const std::string& text, const std::filesystem::path& file) {
  const toml::table document = parse_toml(text, file);
  Context context{file.parent_path(), {}};
  const Item root{&document, {.file = file.string(), .line = 1, .column = 1}};
  Study study = study_table().read(root, context).value();
  check_axes(study, context.errors);
  check_comparison(study, root, context.errors);
  if (!root.has("axes") && !root.has("runs")) context.errors.add(root.location, "no runs", "[[axes]] or [[runs]]");
  context.errors.throw_if_any();
  study.file = file;
  study.base_location = root.child("base").location;
  std::ostringstream normalized;
  normalized << document << '\n';
  study.normalized = normalized.str();
  return study;
}

Study read_study(const std::filesystem::path& file) {
  return parse_study(read_text(file), file);
}

}  // namespace creepcontact::config
