// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "croquis/document/document.h"
#include "croquis/io/project_file.h"

/// Work that isn't saved yet, kept safe from crashes in a folder of the user's state ($XDG_STATE_HOME/croquis).
namespace croquis {

/// The working database of one open document.
///
/// Every commit is one transaction in write-ahead mode: a process killed at any moment leaves a readable database that
/// lacks the commit under way at most. Only nodes that changed are written, and values that are not stored yet. Belongs
/// to one thread at a time, which need not be the window's: a commit waits for the disk.
class WorkingCopy {
 public:
  /// Makes folder and database, and takes the lock that shows that its process lives. Empty remains of dead processes
  /// are swept away.
  /// @throws Error E_WRITE (Io)
  static WorkingCopy create(const std::filesystem::path& folder);

  WorkingCopy(WorkingCopy&&) noexcept;
  WorkingCopy& operator=(WorkingCopy&&) noexcept;

  /// Closes without a word: what was committed can be recovered.
  ~WorkingCopy();

  /// The document is safe when this returns.
  /// @param project_path where people save it; empty for a new one
  /// @param thumbnail_png empty: the one before stays
  /// @throws Error E_WRITE (Io): the last commit that succeeded is still there, and the next one makes up for this
  void commit(const Document& document, const std::string& project_path,
              const std::vector<std::uint8_t>& thumbnail_png = {}, const KeptWork& kept = {});

  /// The work is saved or not wanted: removes the database. Nothing may be committed afterwards.
  void close_cleanly();

  const std::filesystem::path& file() const;

 private:
  struct State;
  explicit WorkingCopy(std::unique_ptr<State> state);

  std::unique_ptr<State> state_;
};

/// A document that somebody may want back.
struct RecoverableWork {
  std::filesystem::path file;
  std::string project_path;                 ///< empty when it was never saved
  std::string time;                         ///< of its last commit, UTC: "2026-03-07T14:05:09Z"
  std::vector<std::uint8_t> thumbnail_png;  ///< may be empty
};

/// Working databases whose process is gone and which were not closed cleanly, the newest first. Unreadable ones are
/// listed, too, without a time. A folder that isn't there has none.
std::vector<RecoverableWork> find_recoverable(const std::filesystem::path& folder);

/// The document of a working database, with warnings like load_project.
/// @throws Error like load_project
/// @throws Cancelled
ProjectFile recover(const std::filesystem::path& file, Progress& progress);

/// Removes a working database that find_recoverable listed.
void discard(const std::filesystem::path& file);

}  // namespace croquis
