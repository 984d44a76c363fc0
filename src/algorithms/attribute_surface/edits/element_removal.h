// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "croquis/base/error.h"
#include "croquis/base/limits.h"
#include "croquis/geometry/attribute_network.h"
#include "croquis/geometry/vector.h"

namespace croquis {

/// What an edit can't do.
[[noreturn]] inline void refuse_edit(const std::string& sentence, std::vector<Subject> subjects = {}) {
  throw Error(make_error(Category::Usage, "E_INPUT", sentence, std::move(subjects)));
}

inline Subject named_curve(const std::string& id) { return {SubjectKind::Curve, id, {}, {}, {}}; }
inline Subject named_face(const std::string& id) { return {SubjectKind::Face, id, {}, {}, {}}; }

inline void require_finite(const Vec3& place) {
  if (!are_usable_numbers(place))
    refuse_edit(std::string("A place or way has a coordinate that ") + unusable_words + ".");
}

inline void require_direction(const Vec3& direction) {
  require_finite(direction);
  if (!(direction.norm() > 0)) refuse_edit("A normal has no length: give one that points somewhere.");
}

inline void require_radius(const std::optional<double>& radius) {
  if (radius && !(is_usable_number(*radius) && *radius > 0)) refuse_edit("A radius must be above 0.");
}

inline void require_fraction(double at) {
  if (!(at >= 0 && at <= 1)) refuse_edit("A place along a curve must be a fraction from 0 to 1.");
}

/// Elements that go, by index.
struct RemovedElements {
  std::vector<bool> nodes, curves, faces, points;

  explicit RemovedElements(const AttributeNetwork& network)
      : nodes(network.nodes.size()),
        curves(network.curves.size()),
        faces(network.faces.size()),
        points(network.points.size()) {}
};

/// The network without these, renumbered. Points of faces that go, and slopes and inner curves of what goes, go too.
/// @pre no curve that stays has a node that goes, no face that stays a curve that goes in its loop
AttributeNetwork without_elements(AttributeNetwork network, const RemovedElements& removed);

/// Forgets where points of a face lie in its domain, which has become another one.
void forget_places(AttributeNetwork& network, Index face);

}  // namespace croquis
