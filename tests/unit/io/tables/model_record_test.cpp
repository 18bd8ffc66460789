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
  record.report.title = "Tight?";
  record.report.purpose = "<b>";
  record.report.logo = "iVBORw0KGgo=";
  record.report.appendix = false;
  record.report.pictures = {{.field = "von_mises", .time = 10, .section = {{0, 0, 0, 0, 0, 1}}, .range = {{1, 2}}},
                            {"mesh"}};
  record.inputs = {{"contacts[0].gap", "-0.1"}};
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
  EXPECT_EQ(read.report.title, "Tight?");
  EXPECT_EQ(read.report.purpose, "<b>");
  EXPECT_EQ(read.report.logo, record.report.logo);
  EXPECT_FALSE(read.report.appendix);
  ASSERT_EQ(read.report.pictures.size(), 2U);
  EXPECT_EQ(read.report.pictures[0].time, 10);
  EXPECT_EQ(read.report.pictures[0].section, record.report.pictures[0].section);
  EXPECT_EQ(read.report.pictures[0].range, record.report.pictures[0].range);
  EXPECT_FALSE(read.report.pictures[1].time || read.report.pictures[1].section || read.report.pictures[1].range);
  ASSERT_EQ(read.inputs.size(), 1U);
  EXPECT_EQ(read.inputs[0].value, "-0.1");
}

TEST(ModelRecordFile, OfAnEarlierVersionHasNoReport) {
  const ModelRecord read = parse_model_record("{}", "m");
  EXPECT_TRUE(read.report.appendix);
  EXPECT_TRUE(read.report.title.empty() && read.inputs.empty());
}

TEST(ModelRecordFile, OtherTextsAreRefused) {
  EXPECT_EQ(parse_model_record("{}", "m").sections.size(), 0U);
  for (const char* text : {"", "[1]", "{\"sections\": 3}", "{\"version\": {}}", "{\"report\": []}",
                           R"({"report": {"pictures": [{"section": [1]}]}})",
                           R"({"sections": [{"plots": [{"curves": [{"x": [1], "y": []}]}]}]})",
                           R"({"sections": [{"tables": [{"head": ["a"], "rows": [["1", "2"]]}]}]})"})
    EXPECT_THROW(parse_model_record(text, "m"), ConfigError) << text;
  EXPECT_THROW(read_model_record("/nowhere/model.json"), ConfigError);
}

}  // namespace
}  // namespace creepcontact::io::test
