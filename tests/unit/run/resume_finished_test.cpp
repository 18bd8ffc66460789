// A run that has come to its end is resumed: nothing changes, or only what is missing is added.

#include <chrono>
#include <map>

#include "creepcontact/base/error.hpp"
#include "support/run/running.hpp"

namespace creepcontact::run::test {
namespace {

/// Of summary.json, where the keys of the contact begin.
const std::string contact = "contacts/lower_top-upper_bottom/";

struct FileState {
  std::string content;
  std::filesystem::file_time_type written;
  bool operator==(const FileState&) const = default;
};

std::map<std::string, FileState> files_in(const std::filesystem::path& directory) {
  std::map<std::string, FileState> files;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(directory))
    if (entry.is_regular_file()) files[entry.path()] = {read_text(entry.path()), entry.last_write_time()};
  return files;
}

void expect_left_alone(const config::Config& config, const std::filesystem::path& out,
                       std::initializer_list<std::string_view> reason) {
  const auto before = files_in(out);
  const std::filesystem::path log = out / "contact_log.csv";
  const Summary result = run(config, {.output = out.string(), .resume = true, .log_contact = log.string()});
  EXPECT_EQ(result.exit_status, 0);
  EXPECT_TRUE(says(result.message, reason));
  EXPECT_EQ(result.message.find('\n'), std::string::npos);
  const auto after = files_in(out);
  EXPECT_EQ(after.size(), before.size());
  for (const auto& [file, state] : before) EXPECT_TRUE(after.contains(file) && after.at(file) == state) << file;
}

TEST(ResumeFinished, ACompletedRunIsLeftAsItIs) {
  const Case blocks;
  for (const char* integrator : {"arkode_erk", "cvode_bdf"}) {
    const config::Config config = blocks.config(
        pressure_probe, {std::string("time.integrator=") + integrator, "time.output=[1, 3]", "time.step=0.5"});
    const std::filesystem::path out = blocks / integrator;
    ASSERT_EQ(run(config, {.output = out.string()}).exit_status, 0);
    EXPECT_GT(SummaryFile(out / "summary.json").number(contact + "final_normal_force"), 0);
    expect_left_alone(config, out, {"t = 4", "time.end"});
    expect_left_alone(blocks.config(pressure_probe, {"time.end=3"}), out, {"t = 4", "time.end"});
  }
}

TEST(ResumeFinished, AnElasticRunToo) {
  const Case blocks;
  const config::Config config = blocks.config(pressure_probe, elastic({"time.output=[1, 3]"}));
  ASSERT_EQ(run(config, {.output = (blocks / "out").string()}).exit_status, 0);
  expect_left_alone(config, blocks / "out", {"t = 4", "time.end"});
}

TEST(ResumeFinished, ARupturedRunIsLeftAsItIs) {
  const Case blocks;
  const std::string damage = "[{law='kachanov_rabotnov', A=1e-4, n=3, B=0.1, r=3, phi=3}]";
  const config::Config config = blocks.config(
      pressure_probe, {"contacts.0.type=tied", "materials.soft.creep=" + damage, "materials.hard.creep=" + damage,
                       "supports.3.displacement.z={t=[0, 100], values=[-0.025, -5]}", "time.end=100"});
  const std::filesystem::path out = blocks / "out";
  ASSERT_EQ(run(config, {.output = out.string()}).exit_status, 0);
  ASSERT_EQ(SummaryFile(out / "summary.json").text("status"), "ruptured");
  expect_left_alone(config, out, {"rupture", "t = "});
}

/// Killed between its last checkpoint and its last summary: that is made up for, with the forces of the end.
TEST(ResumeFinished, AMissingSummaryIsWritten) {
  const Case blocks;
  const config::Config config = blocks.config(pressure_probe, {"time.output=[1, 3]"});
  const std::filesystem::path out = blocks / "out";
  ASSERT_EQ(run(config, {.output = out.string()}).exit_status, 0);
  const SummaryFile summary(out / "summary.json");
  std::string killed = read_text(out / "summary.json");
  killed.replace(killed.find("completed"), 9, "interrupted");
  for (const std::string& left : {killed, std::string()}) {
    if (left.empty())
      std::filesystem::remove(out / "summary.json");
    else
      io::test::write_text(out / "summary.json", left);
    auto before = files_in(out);
    ASSERT_EQ(run(config, {.output = out.string(), .resume = true}).exit_status, 0);
    const SummaryFile found(out / "summary.json");
    EXPECT_EQ(found.text("status"), "completed");
    for (const std::string& key : {std::string("time_reached"), std::string("steps"), contact + "largest_normal_force"})
      EXPECT_EQ(found.number(key), summary.number(key)) << key;
    for (const std::string& key : {contact + "final_normal_force", contact + "remaining_fraction"})
      EXPECT_NEAR(found.number(key), summary.number(key), 1e-6) << key;
    for (const auto& [file, state] : files_in(out)) {
      const bool same = state.content == before[file].content;
      EXPECT_TRUE(same || contains(file, "summary.json")) << file;
    }
  }
}

TEST(ResumeFinished, AnotherModelIsRefused) {
  const Case blocks;
  const std::filesystem::path out = blocks / "out";
  ASSERT_EQ(run(blocks.config(pressure_probe), {.output = out.string()}).exit_status, 0);
  const config::Config other = blocks.config(pressure_probe, {"materials.soft.young_modulus=101"});
  const auto resume = [&] { run(other, {.output = out.string(), .resume = true}); };
  EXPECT_TRUE(says(message_of<ConfigError>(resume), {"checkpoint.h5: ", "materials.soft.young_modulus", "101"}));
}

}  // namespace
}  // namespace creepcontact::run::test
