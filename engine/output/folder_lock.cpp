// SPDX-License-Identifier: BSD-3-Clause
/// The lock by flock(2).
#include "engine/output/folder_lock.hpp"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <cerrno>
#include <system_error>

#include <fmt/format.h>

#include "engine/errors.hpp"

namespace scarp {

FolderLock::FolderLock(const std::filesystem::path& folder) {
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (!error) {
    descriptor_ = ::open((folder / ".lock").c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0666);
    if (descriptor_ < 0) error.assign(errno, std::generic_category());
  }
  if (error) {
    throw FileError(fmt::format("'{}': cannot be used as output folder: {}. Try another with -o.",
                                folder.string(), error.message()));
  }
  if (::flock(descriptor_, LOCK_EX | LOCK_NB) == 0 || errno != EWOULDBLOCK) return;
  ::close(descriptor_);
  throw FileError(fmt::format(
      "'{}': another run is writing there. Wait for its end, or try another folder with -o.",
      folder.string()));
}

FolderLock::~FolderLock() { ::close(descriptor_); }

}  // namespace scarp
