// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <exception>
#include <string>

#include "croquis/base/finding.h"

namespace croquis {

/// Carries every finding that stopped an operation, never only the first one.
///
/// Thrown anywhere below the hosts and caught in the operation runner, the job runner and `main` alone. Exceptions of
/// third-party libraries are turned into it where the library is called.
class Error : public std::exception {
 public:
  /// @param findings at least one of them of Severity::Error
  explicit Error(Findings findings);
  explicit Error(Finding finding);

  const Findings& findings() const noexcept { return findings_; }

  /// The first error's sentence.
  const char* what() const noexcept override;

 private:
  Findings findings_;
};

/// What must not happen whatever the input, as an Error with the code E_INTERNAL.
[[noreturn]] void throw_internal(const std::string& sentence);

/// The caller asked to stop. No finding: nothing is wrong with the input.
class Cancelled : public std::exception {
 public:
  const char* what() const noexcept override { return "cancelled"; }
};

}  // namespace croquis
