/// Computed temperatures that runs share.
#include <fmt/format.h>

#include <chrono>
#include <filesystem>
#include <fstream>

#include "creepcontact/base/error.hpp"
#include "creepcontact/base/files.hpp"
#include "support/says.hpp"
#include "unit/io/temporary_directory.hpp"
#include "verification/boxes.hpp"
#include "verification/case.hpp"
#include "verification/rings.hpp"

namespace creepcontact {
namespace heat_kept {
namespace {

using namespace test;

const std::string geo = boxes_geo({{"block", {0, 0, 0}, {1, 1, 1}, {2, 2, 2}}});

class KeptHeat : public testing::Test {
 protected:
  /// @param A  of the creep law @param film  its coefficient @returns the axial force at the end
  double run(double A, double film) {
    std::string toml = "[mesh]\nfile = \"case.geo\"\norder = 2\n" + body("block", 1e5, 0.3, A, 5);
    const std::string before = "poisson_ratio = 0.3\n";
    toml.insert(toml.find(before) + before.size(),
                "conductivity = 1\nheat_capacity = 1\ndensity = 1\nthermal_expansion = 1e-5\nreference_temperature = "
                "0\n");
    toml += fmt::format(
        "[heat]\nstart = 0\ntime_unit = 1\nkeep = \"{}\"\nfilms = [{{ on = \"block_z1\", coefficient = {}, fluid = 100 "
        "}}]\n",
        file().string(), film);
    toml += support("block_x0", "x") + support("block_y0", "y") + support("block_z0", "z") + support("block_z1", "z") +
            "[time]\nend = 1\n" + probe("force", "reaction_z", "on = \"block_z0\"");
    return run_case(toml, geo).history.at("force", 1);
  }
  std::filesystem::path file() const { return directory_.path() / "heat.kept"; }
  std::string bytes() const { return read_file(file()).bytes; }
  /// Tells whether the file was written again.
  bool is_old() const { return std::filesystem::last_write_time(file()) < written_ - std::chrono::minutes(1); }
  void make_old() {
    written_ = std::filesystem::last_write_time(file());
    std::filesystem::last_write_time(file(), written_ - std::chrono::hours(1));
  }

 private:
  io::test::TemporaryDirectory directory_;
  std::filesystem::file_time_type written_;
};

TEST_F(KeptHeat, ServesRunsWithOtherMechanics) {
  const double elastic = run(0, 1);
  const std::string kept = bytes();
  make_old();
  EXPECT_EQ(run(0, 1), elastic) << "to the last bit";
  const double crept = run(1e-12, 1);
  EXPECT_TRUE(is_old());
  EXPECT_LT(std::abs(crept), 0.99 * std::abs(elastic));
  std::filesystem::remove(file());
  EXPECT_EQ(run(1e-12, 1), crept);
  EXPECT_EQ(bytes(), kept);
}

TEST_F(KeptHeat, DoesNotReplaceFilesOfOthers) {
  std::ofstream(file()) << "notes of somebody";
  EXPECT_TRUE(says(message_of<Error>([&] { run(0, 1); }), {"keep", "heat.kept", "another name"}));
  EXPECT_EQ(bytes(), "notes of somebody");
}

TEST_F(KeptHeat, IsComputedAgainWhereItDoesNotFit) {
  const double slow = run(0, 1);
  make_old();
  const double fast = run(0, 2);
  EXPECT_FALSE(is_old());
  EXPECT_GT(std::abs(fast), 1.1 * std::abs(slow));
  std::ofstream(file(), std::ios::app) << "damage";
  make_old();
  EXPECT_EQ(run(0, 2), fast);
  EXPECT_FALSE(is_old());
}

}  // namespace
}  // namespace heat_kept
}  // namespace creepcontact
