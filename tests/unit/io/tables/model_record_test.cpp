/// model.json is read as it was written; what is damaged is refused with the name of the file.

#include "creepcontact/io/tables/model_record.hpp"

#include <gtest/gtest.h>

#include "creepcontact/base/error.hpp"
#include "unit/io/temporary_directory.hpp"

namespace creepcontact::io::test {
namespace {

TEST(ModelRecordFile, IsReadAsItWasWritten) {
  const TemporaryDirectory directory;
  ModelRecord record{"0.2.0", "2026-11-23T12:00:00+0000", "a/b.toml", "0123456789abcdef", {}, {}};
  record.fields.push_back({"stress_xx", "stress xx", "MPa", "stress", 0, false});
  record.fields.push_back({"displacement_magnitude", "displacement", "mm", "displacement", -1, true});
  record.sections.push_back({"Material <steel>",
                             {"Sources: \"a\""},
                             {{"", {"property", "value"}, {{"E", "2e5"}}}},
                             {{"creep", "time [h]", "strain", true, true, {{"100 MPa", {1, 2.5}, {0.1, 1e-300}}}}}});
  write_model_record(directory / "model.json", record);
  const ModelRecord read = read_model_record(directory / "model.json");
  EXPECT_EQ(read.fingerprint, record.fingerprint);
  ASSERT_EQ(read.fields.size(), 2U);
  EXPECT_EQ(read.fields[1].component, -1);
  EXPECT_TRUE(read.fields[1].is_on_contact);
  ASSERT_EQ(read.sections.size(), 1U);
  EXPECT_EQ(read.sections[0].tables[0].rows, record.sections[0].tables[0].rows);
  EXPECT_EQ(read.sections[0].plots[0].curves[0].y, (std::vector<double>{0.1, 1e-300}));
  EXPECT_TRUE(read.sections[0].plots[0].log_x);
}

TEST(ModelRecordFile, OtherTextsAreRefused) {
  EXPECT_EQ(parse_model_record("{}", "m").sections.size(), 0U);
  for (const char* text : {"", "[1]", "{\"sections\": 3}", "{\"version\": {}}",
                           R"({"sections": [{"plots": [{"curves": [{"x": [1], "y": []}]}]}]})",
                           R"({"sections": [{"tables": [{"head": ["a"], "rows": [["1", "2"]]}]}]})"})
    EXPECT_THROW(parse_model_record(text, "m"), ConfigError) << text;
  EXPECT_THROW(read_model_record("/nowhere/model.json"), ConfigError);
}

}  // namespace
}  // namespace creepcontact::io::test
