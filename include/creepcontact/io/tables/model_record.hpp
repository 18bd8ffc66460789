#pragma once
/// model.json: what a run computes, in words, tables and curves, for reports.

#include <array>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace creepcontact::io {

/// Cells are plain text.
struct RecordedTable {
  std::string title = {};  ///< may be empty
  std::vector<std::string> head = {};
  std::vector<std::vector<std::string>> rows = {};
};

struct RecordedCurve {
  std::string name;
  std::vector<double> x, y;  ///< of the same length, finite
};

/// Curves with common axes.
struct RecordedPlot {
  std::string title = {}, x_label = {}, y_label = {};
  bool log_x = false, log_y = false;
  std::vector<RecordedCurve> curves = {};
};

struct RecordedSection {
  std::string title = {};
  std::vector<std::string> notes = {};  ///< sentences
  std::vector<RecordedTable> tables = {};
  std::vector<RecordedPlot> plots = {};
};

/// A scalar in the field files.
struct RecordedField {
  std::string name = {};       ///< "stress_xx"
  std::string label = {};      ///< for people: "stress xx"
  std::string unit = {};       ///< empty: none
  std::string array = {};      ///< name of its array, without a unit
  int component = 0;           ///< of the array; -1: its magnitude
  bool is_on_contact = false;  ///< has values on contact surfaces only
};

/// A still picture that the configuration asks for.
struct RecordedPicture {
  std::string field = {};
  std::optional<double> time = {};                      ///< nullopt: the last
  std::optional<std::array<double, 6>> section = {};    ///< a point of the plane, its normal
  std::string view = {};                                ///< empty: the usual one
  std::optional<std::pair<double, double>> range = {};  ///< of the colours
};

/// [report] of the configuration.
struct RecordedReport {
  std::string title = {}, project = {}, drawing = {}, revision = {}, author = {}, checker = {};
  std::string logo = {};       ///< the file, in base64; empty: there is none, or it could not be read
  std::string logo_file = {};  ///< its name
  std::string purpose = {}, assumptions = {}, assessment = {};  ///< Markdown
  bool appendix = true;
  std::vector<RecordedPicture> pictures = {};
};

struct RecordedInput {
  std::string key = {}, value = {};
};

struct ModelRecord {
  std::string version = {};        ///< of the program
  std::string started = {};        ///< date and time, ISO 8601 with the offset from UTC
  std::string configuration = {};  ///< path as given
  std::string fingerprint = {};    ///< of the configuration and the mesh: equal for equal models
  std::vector<RecordedField> fields = {};
  std::vector<RecordedSection> sections = {};
  RecordedReport report = {};
  std::vector<RecordedInput> inputs = {};  ///< keys of the configuration and their values, as a file has them
};

/// Replaces the file atomically. @throws Error if the disk cannot take it
void write_model_record(const std::filesystem::path& path, const ModelRecord& record);

/// Missing members have their defaults. @throws ConfigError naming the file if it cannot be read or has another content
ModelRecord read_model_record(const std::filesystem::path& path);
/// Like read_model_record(), from text. @param name  of the file, for messages
ModelRecord parse_model_record(std::string_view text, const std::string& name);

}  // namespace creepcontact::io
