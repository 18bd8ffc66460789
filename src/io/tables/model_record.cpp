#include "creepcontact/io/tables/model_record.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "../file_text.hpp"
#include "creepcontact/base/error.hpp"
#include "creepcontact/platform/replace_file.hpp"

namespace creepcontact::io {

// Each member is an entry of its name.
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE_WITH_DEFAULT(RecordedTable, title, head, rows)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE_WITH_DEFAULT(RecordedCurve, name, x, y)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE_WITH_DEFAULT(RecordedPlot, title, x_label, y_label, log_x, log_y, curves)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE_WITH_DEFAULT(RecordedSection, title, notes, tables, plots)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE_WITH_DEFAULT(RecordedField, name, label, unit, array, component, is_on_contact)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE_WITH_DEFAULT(RecordedInput, key, value)

namespace {

template <class T>
std::optional<T> if_given(const nlohmann::json& json, const char* name) {
  const auto found = json.find(name);
  return found == json.end() || found->is_null() ? std::nullopt : std::optional(found->get<T>());
}

}  // namespace

static void to_json(nlohmann::json& json, const RecordedPicture& picture) {
  json = {{"field", picture.field}};
  if (picture.time) json["time"] = *picture.time;
  if (picture.section) json["section"] = *picture.section;
  if (!picture.view.empty()) json["view"] = picture.view;
  if (picture.range) json["range"] = *picture.range;
}

static void from_json(const nlohmann::json& json, RecordedPicture& picture) {
  picture.field = json.value("field", "");
  picture.time = if_given<double>(json, "time");
  picture.section = if_given<std::array<double, 6>>(json, "section");
  picture.view = json.value("view", "");
  picture.range = if_given<std::pair<double, double>>(json, "range");
}

NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE_WITH_DEFAULT(RecordedReport, title, project, drawing, revision, author, checker,
                                                logo, logo_file, purpose, assumptions, assessment, appendix, pictures)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE_WITH_DEFAULT(ModelRecord, version, started, configuration, fingerprint, fields,
                                                sections, report, inputs)

namespace {

void require_equal_lengths(const ModelRecord& record) {
  for (const RecordedSection& section : record.sections) {
    for (const RecordedPlot& plot : section.plots)
      for (const RecordedCurve& curve : plot.curves)
        if (curve.x.size() != curve.y.size())
          throw std::invalid_argument(
              fmt::format("curve '{}' has {} and {} numbers", curve.name, curve.x.size(), curve.y.size()));
    for (const RecordedTable& table : section.tables)
      for (const std::vector<std::string>& row : table.rows)
        if (row.size() != table.head.size())
          throw std::invalid_argument(fmt::format("table '{}' has a row of {} cells", table.title, row.size()));
  }
}

}  // namespace

void write_model_record(const std::filesystem::path& path, const ModelRecord& record) {
  const nlohmann::json json = record;
  platform::replace_file(path, json.dump(1, ' ', false, nlohmann::json::error_handler_t::replace) + "\n",
                         platform::Durable::when_synced);
}

ModelRecord parse_model_record(std::string_view text, const std::string& name) {
  try {
    ModelRecord record = nlohmann::json::parse(text).get<ModelRecord>();
    require_equal_lengths(record);
    return record;
  } catch (const std::exception& error) {
    throw ConfigError(fmt::format("'{}' does not describe a model: {}", name, error.what()));
  }
}

ModelRecord read_model_record(const std::filesystem::path& path) {
  return parse_model_record(file_text<ConfigError>(path), path.string());
}

}  // namespace creepcontact::io
