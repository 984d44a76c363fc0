// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string_view>

#include "croquis/geometry/perspective_drawing.h"

/// How the files of perspective drawings spell things.
namespace croquis {

inline constexpr const char* perspective_format = "croquis-perspective/1";
inline constexpr const char* perspective_namespace = "urn:croquis:perspective:1";

inline const char* word_of(StrokeRole role) { return role == StrokeRole::Edge ? "edge" : "construction"; }

inline const char* word_of(EndLock lock) {
  return lock == EndLock::Smooth ? "smooth" : lock == EndLock::Corner ? "corner" : "none";
}

inline std::optional<StrokeRole> role_of(std::string_view word) {
  if (word == "edge") return StrokeRole::Edge;
  if (word == "construction") return StrokeRole::Construction;
  return std::nullopt;
}

inline std::optional<EndLock> lock_of(std::string_view word) {
  if (word == "smooth") return EndLock::Smooth;
  if (word == "corner") return EndLock::Corner;
  if (word == "none") return EndLock::None;
  return std::nullopt;
}

}  // namespace croquis
