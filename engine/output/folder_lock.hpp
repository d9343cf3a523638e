// SPDX-License-Identifier: BSD-3-Clause
/// One run at a time in an output folder.
#pragma once

#include <filesystem>

namespace scarp {

/// Makes the folder and holds a lock on FOLDER/.lock, which the system frees when the process ends,
/// however it ends. File systems without locks are used unlocked. Errors: FileError if another
/// process (or another lock of this one) has it, or the folder cannot be made.
class FolderLock {
 public:
  explicit FolderLock(const std::filesystem::path& folder);
  FolderLock(const FolderLock&) = delete;
  FolderLock& operator=(const FolderLock&) = delete;
  ~FolderLock();

 private:
  int descriptor_ = -1;
};

}  // namespace scarp
