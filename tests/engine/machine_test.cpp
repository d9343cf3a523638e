// SPDX-License-Identifier: BSD-3-Clause
/// Limits of control groups, read from trees of files like those of Linux.
#include "engine/machine.hpp"

#include <gtest/gtest.h>
#include <sys/resource.h>
#include <unistd.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <map>
#include <string>
#include <vector>

namespace scarp {
namespace {

namespace fs = std::filesystem;

class GroupLimitsTest : public testing::Test {
 protected:
  GroupLimitsTest()
      : root_(fs::temp_directory_path() / ("scarp_groups_" + std::to_string(getpid()))) {
    fs::remove_all(root_);
  }
  ~GroupLimitsTest() override { fs::remove_all(root_); }

  GroupLimits limits(const std::map<std::string, std::string>& files) {
    for (const auto& [name, text] : files) {
      fs::create_directories((root_ / name).parent_path());
      std::ofstream(root_ / name) << text << '\n';
    }
    return group_limits(root_);
  }

  fs::path root_;
};

const std::string v2_mount = "30 24 0:26 / /sys/fs/cgroup rw,nosuid shared:4 - cgroup2 cgroup2 rw";
const std::string v1_mounts =
    "30 24 0:26 / /sys/fs/cgroup/cpu,cpuacct rw - cgroup cgroup rw,cpu,cpuacct\n"
    "31 24 0:27 / /sys/fs/cgroup/memory rw shared:9 - cgroup cgroup rw,memory";

TEST_F(GroupLimitsTest, AreInfiniteWithoutGroups) {
  EXPECT_TRUE(std::isinf(limits({}).cores));
  EXPECT_TRUE(std::isinf(limits({}).memory_bytes));
}

TEST_F(GroupLimitsTest, AreTheLeastOfAllGroupsAbove) {
  const GroupLimits found = limits({{"proc/self/mountinfo", v2_mount},
                                    {"proc/self/cgroup", "0::/batch/job/step"},
                                    {"sys/fs/cgroup/batch/cpu.max", "150000 100000"},
                                    {"sys/fs/cgroup/batch/memory.max", "max"},
                                    {"sys/fs/cgroup/batch/job/cpu.max", "max 100000"},
                                    {"sys/fs/cgroup/batch/job/memory.max", "1310720000"},
                                    {"sys/fs/cgroup/batch/job/step/memory.max", "2000000000"}});
  EXPECT_DOUBLE_EQ(found.cores, 1.5);
  EXPECT_DOUBLE_EQ(found.memory_bytes, 1310720000.0);
}

TEST_F(GroupLimitsTest, AreReadInTheFirstVersionToo) {
  const GroupLimits found =
      limits({{"proc/self/mountinfo", v1_mounts},
              {"proc/self/cgroup", "4:memory:/job\n3:cpu,cpuacct:/job\n0::/"},
              {"sys/fs/cgroup/cpu,cpuacct/cpu.cfs_quota_us", "-1"},
              {"sys/fs/cgroup/cpu,cpuacct/cpu.cfs_period_us", "100000"},
              {"sys/fs/cgroup/cpu,cpuacct/job/cpu.cfs_quota_us", "300000"},
              {"sys/fs/cgroup/cpu,cpuacct/job/cpu.cfs_period_us", "100000"},
              {"sys/fs/cgroup/memory/memory.limit_in_bytes", "9223372036854771712"},
              {"sys/fs/cgroup/memory/job/memory.limit_in_bytes", "1000000000"}});
  EXPECT_DOUBLE_EQ(found.cores, 3.0);
  EXPECT_DOUBLE_EQ(found.memory_bytes, 1e9);
}

// In a container the mount stands for the container's own group, whatever its name outside is.
TEST_F(GroupLimitsTest, AreThoseOfTheContainer) {
  const std::string mount = "30 24 0:26 /docker/abc /sys/fs/cgroup ro,nosuid - cgroup2 cgroup rw";
  for (const char* group : {"0::/docker/abc", "0::/", "0::/../elsewhere"}) {
    const GroupLimits found = limits({{"proc/self/mountinfo", mount},
                                      {"proc/self/cgroup", group},
                                      {"sys/fs/cgroup/cpu.max", "200000 100000"},
                                      {"sys/fs/cgroup/memory.max", "500000000"}});
    EXPECT_DOUBLE_EQ(found.cores, 2.0) << group;
    EXPECT_DOUBLE_EQ(found.memory_bytes, 5e8) << group;
  }
}

#ifndef SCARP_ADDRESS_SANITIZER  // whose own memory does not fit
TEST(UsableMemoryTest, IsBoundedByUlimit) {
  rlimit before{};
  ASSERT_EQ(getrlimit(RLIMIT_DATA, &before), 0);
  rlimit lower = before;
  lower.rlim_cur = 700'000'000;
  ASSERT_EQ(setrlimit(RLIMIT_DATA, &lower), 0);
  EXPECT_LE(usable_memory(), 700e6);
  ASSERT_EQ(setrlimit(RLIMIT_DATA, &before), 0);
  EXPECT_GT(usable_memory(), 0.0);
}
#endif

TEST(ResidentMemoryTest, SeesWhatIsTaken) {
  const double before = resident_memory().now;
  std::vector<char> taken(100'000'000, 'x');
  const auto after = resident_memory();
  EXPECT_GT(after.now, before + 0.9e8);
  EXPECT_GE(after.peak, after.now);
  EXPECT_EQ(taken[12345], 'x');
}

}  // namespace
}  // namespace scarp
