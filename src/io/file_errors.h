// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace croquis {

/// The system's reason for a failure with a file, for people. @param error an errno
std::string reading_reason(int error);
std::string writing_reason(int error);

/// @throws Error E_FILE_OPEN (Malformed)
[[noreturn]] void fail_reading(const std::string& path, const std::string& reason);

/// @throws Error E_WRITE (Io)
[[noreturn]] void fail_writing(const std::string& path, const std::string& reason);

}  // namespace croquis
