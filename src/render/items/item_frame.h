// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>
#include <string>

#include <glm/glm.hpp>
#include <glm/vec3.hpp>

#include "croquis/base/finding.h"
#include "croquis/geometry/vector.h"

namespace croquis::render {

/// Chooses an item's own frame from its bounds: single precision is then enough for coordinates of any size.
template <typename Item>
void set_own_frame(Item& item) {
  if (item.bounds.empty()) return;
  item.origin = item.bounds.center();
  const double radius = item.bounds.radius();
  if (radius > 0) item.scale = radius;
}

template <typename Item>
glm::vec3 to_own_frame(const Item& item, const glm::dvec3& point) {
  return glm::vec3((point - item.origin) / item.scale);
}

template <typename Item>
glm::dvec3 to_model(const Item& item, const glm::vec3& place) {
  return item.origin + item.scale * glm::dvec3(place);
}

inline bool is_finite(const glm::dvec3& place) {
  return std::isfinite(place.x) && std::isfinite(place.y) && std::isfinite(place.z);
}

/// The finding about an element that can't be drawn.
inline Finding not_finite(SubjectKind kind, const std::string& name, std::size_t index) {
  const std::string id = std::to_string(index);
  return make_error(Category::Malformed, "E_NOT_FINITE",
                    "The " + name + " " + id + " to be drawn has a number that is NaN or infinite; leave it out.",
                    {numbered_subject(kind, index)});
}

/// The finding about an index beyond the elements that there are.
inline Finding not_there(SubjectKind kind, const std::string& name, std::size_t index, std::size_t count) {
  const std::string id = std::to_string(index);
  return make_error(
      Category::Malformed, "E_INDEX",
      "The " + name + " " + id + " is to be drawn, but there are only " + std::to_string(count) + "; leave it out.",
      {numbered_subject(kind, index)});
}

inline glm::dvec3 to_glm(const Vec3& v) { return {v.x(), v.y(), v.z()}; }

}  // namespace croquis::render
