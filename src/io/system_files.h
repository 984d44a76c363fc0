// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <utility>

#include <unistd.h>

namespace croquis {

/// The system's reason for a failure with a file, for people. @param error an errno
std::string reading_reason(int error);
std::string writing_reason(int error);

/// @throws Error E_FILE_OPEN (Malformed)
[[noreturn]] void fail_reading(const std::string& path, const std::string& reason);

/// @throws Error E_WRITE (Io)
[[noreturn]] void fail_writing(const std::string& path, const std::string& reason);

/// Makes renames in a file's folder survive a power cut; not every file system can, so failure is no error.
void sync_folder_of(const std::filesystem::path& file);

/// Owns a file descriptor; closes it in the destructor.
class Descriptor {
 public:
  explicit Descriptor(int descriptor) : descriptor_(descriptor) {}
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  Descriptor& operator=(Descriptor&& other) noexcept {
    std::swap(descriptor_, other.descriptor_);
    return *this;
  }
  ~Descriptor() { close(); }

  bool valid() const { return descriptor_ >= 0; }
  int get() const { return descriptor_; }

  /// Closes now. @return false when the system reports a late write error
  bool close() {
    if (descriptor_ < 0) return true;
    const bool good = ::close(descriptor_) == 0;
    descriptor_ = -1;
    return good;
  }

 private:
  int descriptor_;
};

}  // namespace croquis
