// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <limits>

#include <glm/glm.hpp>

namespace croquis::render {

/// An axis-aligned box in model units; empty until something is added.
struct Bounds {
  glm::dvec3 min = glm::dvec3(std::numeric_limits<double>::infinity());
  glm::dvec3 max = glm::dvec3(-std::numeric_limits<double>::infinity());

  bool empty() const { return !(min.x <= max.x); }

  void add(const glm::dvec3& point) {
    min = glm::min(min, point);
    max = glm::max(max, point);
  }

  void add(const Bounds& other) {
    min = glm::min(min, other.min);
    max = glm::max(max, other.max);
  }

  /// Halved before it is added, so that no finite box overflows.
  glm::dvec3 center() const { return 0.5 * min + 0.5 * max; }

  /// Half the diagonal; 0 for a point.
  double radius() const { return glm::length(0.5 * max - 0.5 * min); }

  std::array<glm::dvec3, 8> corners() const {
    return {{{min.x, min.y, min.z},
             {max.x, min.y, min.z},
             {min.x, max.y, min.z},
             {max.x, max.y, min.z},
             {min.x, min.y, max.z},
             {max.x, min.y, max.z},
             {min.x, max.y, max.z},
             {max.x, max.y, max.z}}};
  }
};

/// The box around what becomes of a box.
inline Bounds placed(const Bounds& bounds, const glm::dmat4& placement) {
  Bounds box;
  if (bounds.empty()) return box;
  for (const glm::dvec3& corner : bounds.corners()) box.add(glm::dvec3(placement * glm::dvec4(corner, 1)));
  return box;
}

}  // namespace croquis::render
