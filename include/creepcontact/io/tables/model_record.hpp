#pragma once
/// model.json: what a run computes, in words, tables and curves, for reports.

#include <filesystem>
#include <string>
#include <string_view>
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

struct ModelRecord {
  std::string version = {};        ///< of the program
  std::string started = {};        ///< date and time, ISO 8601 with the offset from UTC
  std::string configuration = {};  ///< path as given
  std::string fingerprint = {};    ///< of the configuration and the mesh: equal for equal models
  std::vector<RecordedField> fields = {};
  std::vector<RecordedSection> sections = {};
};

/// Replaces the file atomically. @throws Error if the disk cannot take it
void write_model_record(const std::filesystem::path& path, const ModelRecord& record);

/// Missing members have their defaults. @throws ConfigError naming the file if it cannot be read or has another content
ModelRecord read_model_record(const std::filesystem::path& path);
/// Like read_model_record(), from text. @param name  of the file, for messages
ModelRecord parse_model_record(std::string_view text, const std::string& name);

}  // namespace creepcontact::io
