// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

namespace croquis {

/// The whole file as bytes. Standard input is the host's business: "-" is a file name here.
/// @throws Error (E_FILE_OPEN) when it can't be opened or read. Its category is Malformed, since for a program's
///         input "not there" and "not readable" are the same answer.
std::string read_file(const std::string& path);

/// All the files that one command writes: they appear together or not at all.
///
/// `commit` writes each file under a temporary name beside its target, then renames them all. On any failure nothing
/// is left behind and files that were there before are as they were. Symbolic links are followed; devices and pipes
/// (/dev/null) are written directly, last. Not thread-safe.
class OutputTransaction {
 public:
  OutputTransaction() = default;
  OutputTransaction(const OutputTransaction&) = delete;
  OutputTransaction& operator=(const OutputTransaction&) = delete;

  /// Removes whatever a failed or missing `commit` would leave.
  ~OutputTransaction();

  /// Notes a file to be written; touches nothing on disk yet.
  /// @throws Error (E_WRITE, Io) when that path was added already
  void add(const std::string& path, std::string bytes);

  /// Writes all files. Afterwards the transaction is empty.
  /// @throws Error (E_WRITE, Io) with the path and the system's reason
  void commit();

 private:
  struct Entry {
    std::string path;  ///< as given, for messages
    std::string bytes;
    std::string target;     ///< where it goes, with symbolic links resolved
    std::string temporary;  ///< written, waiting to be renamed; empty when there is none
    std::string backup;     ///< second name of the file that was there before; empty when there is none
    bool direct = false;    ///< a device or pipe, which can't be replaced
    bool existed = false;   ///< a file was there before
    bool renamed = false;
  };

  void prepare(Entry& entry);
  void write_temporary(Entry& entry);
  void keep_backup(Entry& entry);
  void rename_all();
  void roll_back() noexcept;

  std::vector<Entry> entries_;
};

}  // namespace croquis
