#include "creepcontact/platform/memory.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <unistd.h>

#include <cmath>
#include <cstdio>
#include <fstream>

#include "support/says.hpp"

namespace creepcontact::platform {
namespace {

namespace fs = std::filesystem;

/// What a system tells about its memory.
class Machine : public testing::Test {
 protected:
  Machine() : root_(fs::path(testing::TempDir()) / fmt::format("creepcontact_memory_test_{}", ::getpid())) {
    fs::remove_all(root_);
    write("proc/meminfo", "MemTotal:       24684084 kB\nMemAvailable:    4000000 kB\nSwapFree:         100000 kB\n");
  }
  ~Machine() override { fs::remove_all(root_); }
  void write(const fs::path& file, const std::string& text) const {
    fs::create_directories((root_ / file).parent_path());
    std::ofstream(root_ / file) << text;
  }
  fs::path root_;
};

TEST_F(Machine, AvailableMemoryAndSwap) {
  EXPECT_EQ(free_memory(root_).bytes, 4100000 * 1024.0);
  EXPECT_TRUE(creepcontact::test::says(free_memory(root_).reason, {"machine", "4198 MB"}));
  EXPECT_TRUE(std::isinf(free_memory(root_ / "nothing").bytes));
}

TEST_F(Machine, ControlGroupsOfTheSecondKind) {
  write("proc/self/cgroup", "0::/batch/job_7\n");
  write("sys/fs/cgroup/batch/job_7/memory.max", "max\n");
  write("sys/fs/cgroup/batch/job_7/memory.current", "1000000\n");
  EXPECT_EQ(free_memory(root_).bytes, 4100000 * 1024.0);
  write("sys/fs/cgroup/batch/memory.max", "2000000000\n");
  write("sys/fs/cgroup/batch/memory.current", "800000000\n");
  write("sys/fs/cgroup/batch/memory.stat", "active_file 7\ninactive_file 300000000\n");  // which may be dropped
  EXPECT_EQ(free_memory(root_).bytes, 1.5e9);
  EXPECT_TRUE(creepcontact::test::says(free_memory(root_).reason, {"control group '/batch'", "2000 MB", "500 MB"}));
}

TEST_F(Machine, ControlGroupsOfTheFirstKind) {
  write("proc/self/cgroup", "5:cpu,cpuacct:/docker/1\n4:hugetlb,memory:/docker/1\n0::/\n");
  write("sys/fs/cgroup/memory/memory.limit_in_bytes", "9223372036854771712\n");
  write("sys/fs/cgroup/memory/memory.usage_in_bytes", "5000000000\n");
  EXPECT_EQ(free_memory(root_).bytes, 4100000 * 1024.0);
  write("sys/fs/cgroup/memory/docker/1/memory.limit_in_bytes", "1000000000\n");
  write("sys/fs/cgroup/memory/docker/1/memory.usage_in_bytes", "1200000000\n");
  EXPECT_EQ(free_memory(root_).bytes, 0);
}

TEST(AddressSpace, IsBoundedByLimitsOfTheProcess) {
#ifdef __SANITIZE_ADDRESS__
  GTEST_SKIP() << "the sanitizer takes more address space than any limit leaves";
#endif
  testing::FLAGS_gtest_death_test_style = "threadsafe";
  for (const auto kind : {RLIMIT_AS, RLIMIT_DATA})
    EXPECT_EXIT(
        {
          rlimit limit{};
          limit.rlim_cur = limit.rlim_max = 3000000000;
          setrlimit(kind, &limit);
          const Room room = address_space();
          std::fputs(room.reason.c_str(), stderr);
          std::_Exit(room.bytes > 2.0e9 && room.bytes < 3e9 ? 0 : 1);
        },
        testing::ExitedWithCode(0), "^[^\n]*\\(ulimit -[vd]\\)[^\n]* 3000 MB[^\n]* [0-9]+ MB[^\n]*$");
}

}  // namespace
}  // namespace creepcontact::platform
