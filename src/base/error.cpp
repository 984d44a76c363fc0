// SPDX-License-Identifier: GPL-3.0-or-later
#include "croquis/base/error.h"

#include <utility>

namespace croquis {

Error::Error(Findings findings) : findings_(std::move(findings)) {}

Error::Error(Finding finding) : findings_{std::move(finding)} {}

const char* Error::what() const noexcept {
  for (const Finding& finding : findings_) {
    if (finding.severity == Severity::Error) return finding.message.c_str();
  }
  return findings_.empty() ? "unknown error" : findings_.front().message.c_str();
}

void throw_internal(const std::string& sentence) {
  throw Error(make_error(Category::Internal, "E_INTERNAL", sentence));
}

}  // namespace croquis
