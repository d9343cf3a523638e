// SPDX-License-Identifier: BSD-3-Clause
/// Limits as Linux tells them: affinity, control groups, resource limits.
#include "engine/machine.hpp"

#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <limits>
#include <optional>
#include <sstream>
#include <string>
#include <string_view>
#include <vector>

#include "engine/parallel.hpp"

namespace scarp {
namespace {

namespace fs = std::filesystem;
constexpr double unlimited = std::numeric_limits<double>::infinity();

std::vector<std::string> split(const std::string& text, char separator) {
  std::vector<std::string> parts;
  std::istringstream stream(text);
  for (std::string part; std::getline(stream, part, separator);) parts.push_back(part);
  return parts;
}

bool contains(const std::string& list, const std::string& word) {
  const std::vector<std::string> words = split(list, ',');
  return std::find(words.begin(), words.end(), word) != words.end();
}

/// The numbers of a file's first line; "max" and what is no number are infinite.
std::vector<double> numbers_in(const fs::path& path) {
  std::ifstream stream(path);
  std::string line;
  std::getline(stream, line);
  std::vector<double> numbers;
  for (const std::string& word : split(line, ' ')) {
    std::istringstream number(word);
    double value = unlimited;
    if (!(number >> value)) value = unlimited;
    numbers.push_back(value);
  }
  return numbers;
}

/// Quota over period; a quota of -1 is none.
double ratio(double quota, double period) {
  return quota > 0.0 && period > 0.0 ? quota / period : unlimited;
}

double cores_of_v2(const fs::path& group) {
  const std::vector<double> both = numbers_in(group / "cpu.max");
  return both.size() == 2 ? ratio(both[0], both[1]) : unlimited;
}
double cores_of_v1(const fs::path& group) {
  const std::vector<double> quota = numbers_in(group / "cpu.cfs_quota_us"),
                            period = numbers_in(group / "cpu.cfs_period_us");
  return quota.size() == 1 && period.size() == 1 ? ratio(quota[0], period[0]) : unlimited;
}
double memory_of(const fs::path& file) {
  const std::vector<double> bytes = numbers_in(file);
  return bytes.size() == 1 ? bytes[0] : unlimited;
}

/// Where a hierarchy of groups can be seen: the folder it is mounted on and the group that this
/// folder stands for (in a container its own).
struct Mount {
  std::string folder, group;
};

/// `controller` empty: the one hierarchy of version 2.
std::optional<Mount> mount_of(const fs::path& root, const std::string& controller) {
  std::ifstream stream(root / "proc/self/mountinfo");
  for (std::string line; std::getline(stream, line);) {
    const std::vector<std::string> fields = split(line, ' ');
    const auto dash = std::find(fields.begin(), fields.end(), "-");
    if (fields.size() < 5 || fields.end() - dash < 4) continue;
    const bool found = controller.empty() ? dash[1] == "cgroup2"
                                          : dash[1] == "cgroup" && contains(dash[3], controller);
    if (found) return Mount{fields[4], fields[3]};
  }
  return {};
}

/// The group of this process in a hierarchy, as /proc/self/cgroup names it.
std::optional<std::string> own_group(const fs::path& root, const std::string& controller) {
  std::ifstream stream(root / "proc/self/cgroup");
  for (std::string line; std::getline(stream, line);) {
    const std::size_t first = line.find(':'), second = line.find(':', first + 1);
    if (second == std::string::npos) continue;
    const std::string controllers = line.substr(first + 1, second - first - 1);
    const bool found = controller.empty() ? controllers.empty() : contains(controllers, controller);
    if (found) return line.substr(second + 1);
  }
  return {};
}

/// The least that `limit` finds in the process's own group and every one above it.
template <class Limit>
double least_upwards(const fs::path& root, const std::string& controller, Limit&& limit) {
  const std::optional<Mount> mount = mount_of(root, controller);
  const std::optional<std::string> own = own_group(root, controller);
  if (!mount || !own) return unlimited;
  const fs::path top = root / fs::path(mount->folder).relative_path();
  // A group outside what is mounted here shows as "/../..": then the mount's own counts.
  fs::path below = fs::path(*own).lexically_relative(mount->group);
  if (below.empty() || *below.begin() == "..") below = ".";
  double least = limit(top);
  fs::path group = top;
  for (const fs::path& part : below) {
    group /= part;
    least = std::min(least, limit(group));
  }
  return least;
}

double of_limit(int resource) {
  rlimit limit{};
  if (getrlimit(static_cast<__rlimit_resource_t>(resource), &limit) != 0) return unlimited;
  return limit.rlim_cur == RLIM_INFINITY ? unlimited : static_cast<double>(limit.rlim_cur);
}

double physical_memory() {
  const double pages = static_cast<double>(sysconf(_SC_PHYS_PAGES));
  const double page = static_cast<double>(sysconf(_SC_PAGESIZE));
  constexpr double unknown = 4e9;
  return pages > 0.0 && page > 0.0 ? pages * page : unknown;
}

}  // namespace

GroupLimits group_limits(const fs::path& root) {
  const auto in_file = [](const char* name) {
    return [name](const fs::path& group) { return memory_of(group / name); };
  };
  return {std::min(least_upwards(root, "", cores_of_v2), least_upwards(root, "cpu", cores_of_v1)),
          std::min(least_upwards(root, "", in_file("memory.max")),
                   least_upwards(root, "memory", in_file("memory.limit_in_bytes")))};
}

int usable_cores() {
  const double paid = std::ceil(group_limits().cores);
  return std::max(1, static_cast<int>(std::min<double>(offered_cores(), paid)));
}

double usable_memory() {
  return std::min(
      {physical_memory(), group_limits().memory_bytes, of_limit(RLIMIT_AS), of_limit(RLIMIT_DATA)});
}

ResidentMemory resident_memory() {
  ResidentMemory memory;
  std::ifstream stream("/proc/self/status");
  for (std::string line; std::getline(stream, line);) {
    for (const auto& [key, value] : {std::pair{"VmRSS:", &memory.now}, {"VmHWM:", &memory.peak}}) {
      if (!line.starts_with(key)) continue;
      std::istringstream(line.substr(std::string_view(key).size())) >> *value;
      *value *= 1024.0;  // told in kB
    }
  }
  return memory;
}

}  // namespace scarp
