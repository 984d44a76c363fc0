// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>

#include "io/descriptor.h"

namespace croquis {

/// A new version of a file, made beside it and put in its place in one step; the old ones become backups.
///
/// A process that dies leaves the old file and its backups as they were, and its temporary file, which the next
/// replacement of the same file removes. Symbolic links are followed.
class AtomicReplacement {
 public:
  /// Makes the empty temporary file, with the permissions of the file that it replaces.
  /// @throws Error E_WRITE
  explicit AtomicReplacement(const std::filesystem::path& path);
  AtomicReplacement(const AtomicReplacement&) = delete;
  AtomicReplacement& operator=(const AtomicReplacement&) = delete;

  /// Removes the temporary file unless it was committed.
  ~AtomicReplacement();

  /// To be filled by the caller, and closed.
  const std::filesystem::path& temporary() const { return temporary_; }

  /// Syncs, moves the backups on (NAME~1 to NAME~2 …), makes the old file NAME~1, and renames the new one.
  /// @throws Error E_WRITE
  void commit(int backups);

 private:
  std::filesystem::path path_;    ///< as given, for messages
  std::filesystem::path target_;  ///< with symbolic links resolved
  std::filesystem::path temporary_;
  Descriptor held_;  ///< of the temporary file, locked: it isn't one of a dead process
};

}  // namespace croquis
