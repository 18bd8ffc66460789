/// What a run writes, when, and in which form.
#include <sys/syscall.h>
#include <unistd.h>

#include <atomic>

#include "creepcontact/base/error.hpp"
#include "support/run/running.hpp"

namespace {
std::atomic<int> n_syncs = 0;
}

/// Stands before the function of the system in this program, which it calls and counts.
extern "C" int fsync(int file) {
  ++n_syncs;
  return static_cast<int>(::syscall(SYS_fsync, file));
}

namespace creepcontact::run::test {
namespace {

std::vector<std::string> listed(const std::filesystem::path& list) {
  std::vector<std::string> times;
  const std::string text = read_text(list), mark = "timestep=\"";
  for (std::size_t at = text.find(mark); at != std::string::npos; at = text.find(mark, at + 1))
    times.push_back(text.substr(at + mark.size(), text.find('"', at + mark.size()) - at - mark.size()));
  return times;
}

int syncs_of_a_run(const config::Config& config, const std::filesystem::path& directory) {
  n_syncs = 0;
  EXPECT_EQ(run(config, {.output = directory.string()}).exit_status, 0);
  return n_syncs;
}

/// A sync takes longer than a step: files are synced with checkpoints, not one by one.
TEST(OutputFiles, TheDiskIsWaitedForAtTheEnd) {
  const Case blocks;
  const auto syncs = [&](const char* fields, int count) {
    const std::string output = "time.output={count=" + std::to_string(count) + "}";
    return syncs_of_a_run(blocks.config(pressure_probe, {output, fields}), blocks / "out");
  };
  const int of_tables = syncs("output.fields=false", 4);
  EXPECT_EQ(syncs("output.fields=false", 40), of_tables) << "as many for any number of output times";
  EXPECT_GT(of_tables, 0) << "the checkpoint at the end";
  EXPECT_EQ(syncs("output.fields=true", 40) - syncs("output.fields=true", 4), 2 * 36) << "once per file";
  const int often = syncs_of_a_run(
      blocks.config(pressure_probe, {"output.checkpoint_seconds=0", "output.fields=false"}), blocks / "often");
  EXPECT_GT(often, of_tables + static_cast<int>(Table(blocks / "often/steps.csv").rows())) << "one with every step";
}

TEST(OutputFiles, FieldsAtTheTimesAskedFor) {
  const Case blocks;
  const auto config = blocks.config(pressure_probe, {"time.output=[1, 2, 3]", "output.fields=[3, 0, 1.5]"});
  ASSERT_EQ(run(config, {.output = (blocks / "out").string()}).exit_status, 0);
  const std::vector<std::string> times{"0", "1.5", "3"};
  EXPECT_EQ(listed(blocks / "out/fields.pvd"), times);
  EXPECT_EQ(listed(blocks / "out/contact.pvd"), times);
  EXPECT_TRUE(std::filesystem::exists(blocks / "out/fields/fields_0002.vtu"));
  EXPECT_FALSE(std::filesystem::exists(blocks / "out/fields/fields_0003.vtu"));
  EXPECT_EQ(Table(blocks / "out/history.csv").times(), (std::vector<double>{0, 1, 1.5, 2, 3, 4}));
}

TEST(OutputFiles, TablesForSpreadsheets) {
  const Case blocks;
  const std::vector<std::string> outputs{"time.output=[0.5, 1, 2]", "time.integrator=explicit_euler", "time.step=0.25"};
  std::vector<std::string> german = outputs;
  german.insert(german.end(), {"output.separator=';'", "output.decimal=','"});
  const std::filesystem::path plain = blocks / "plain", other = blocks / "other";
  ASSERT_EQ(run(blocks.config(pressure_probe, outputs), {.output = plain.string()}).exit_status, 0);
  const config::Config config = blocks.config(pressure_probe, german);
  ASSERT_EQ(run(config, {.output = other.string(), .log_contact = (blocks / "log.csv").string()}).exit_status, 0);
  EXPECT_EQ(read_text(other / "history.csv").substr(0, 16), "time;pressure\n0;");
  EXPECT_TRUE(contains(read_text(other / "history.csv"), "\n0,5;0,")) << read_text(other / "history.csv");
  EXPECT_EQ(Table(other / "history.csv").column("pressure"), Table(plain / "history.csv").column("pressure"));
  EXPECT_EQ(Table(other / "steps.csv").times(), Table(plain / "steps.csv").times());
  EXPECT_TRUE(contains(read_text(blocks / "log.csv"), "time;contact_solve;"));
  std::string text = read_text(other / "history.csv");
  std::replace(text.begin(), text.end(), ',', '.');
  std::replace(text.begin(), text.end(), ';', ',');
  EXPECT_EQ(text, read_text(plain / "history.csv"));
}

/// The files of an output time are written beside the next steps; where they fail, the run is resumed from before them.
TEST(OutputFiles, FieldsThatCannotBeWrittenAreMadeUpFor) {
  const Case blocks;
  const config::Config config = blocks.config(
      pressure_probe, {"time.output=[0.5, 1, 1.6, 3]", "time.integrator=explicit_euler", "time.step=0.25"});
  const std::filesystem::path whole = blocks / "whole", out = blocks / "out";
  ASSERT_EQ(run(config, {.output = whole.string()}).exit_status, 0);
  const std::filesystem::path obstacle = out / "fields/fields_0002.vtu.part";
  std::filesystem::create_directories(obstacle);
  const Summary failed = run(config, {.output = out.string()});
  EXPECT_EQ(failed.exit_status, 4);
  EXPECT_TRUE(contains(failed.message, "fields_0002.vtu")) << failed.message;
  std::filesystem::remove(obstacle);
  const Summary resumed = run(config, {.output = out.string(), .resume = true});
  ASSERT_EQ(resumed.exit_status, 0) << resumed.message;
  for (const char* file : {"history.csv", "steps.csv", "fields.pvd", "contact.pvd"})
    EXPECT_EQ(read_text(out / file), read_text(whole / file)) << file;
  for (const char* file : {"fields/fields_0002.vtu", "fields/fields_0005.vtu"})
    EXPECT_EQ(std::filesystem::exists(out / file), std::filesystem::exists(whole / file)) << file;
}

TEST(OutputFiles, TheLastFieldsThatCannotBeWrittenAreAnErrorToo) {
  const Case blocks;
  const config::Config config = blocks.config(pressure_probe, {"time.output=[1]"});
  std::filesystem::create_directories(blocks / "out/fields/fields_0002.vtu.part");
  const Summary failed = run(config, {.output = (blocks / "out").string()});
  EXPECT_EQ(failed.exit_status, 4);
  EXPECT_EQ(SummaryFile(blocks / "out/summary.json").text("status"), "failed");
}

}  // namespace
}  // namespace creepcontact::run::test
