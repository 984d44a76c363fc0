// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "croquis/operators/perspective_result.h"
#include "croquis/render/line_item.h"

/// Sets of faces that would close a solid, too: how each differs from the one that is shown.
namespace croquis::app {

struct FaceDifference {
  std::vector<PerspectiveFace> added;    ///< in the other set alone
  std::vector<PerspectiveFace> removed;  ///< in the one shown alone
};

FaceDifference difference_of(const PerspectiveResult& result, const FaceAlternative& alternative);

/// "s1+s2+s3": as the operation's lists name faces.
std::vector<std::string> names_of(const std::vector<PerspectiveFace>& faces);

/// Where a place in the drawing's space lies in a view.
using FromSpace = std::function<glm::dvec3(const Vec3&)>;

/// Hatched, over all else: what is added in blue, what is removed as a dashed red outline.
std::vector<render::LineItemPtr> difference_items(const PerspectiveResult& result, const FaceDifference& difference,
                                                  const FromSpace& place);

}  // namespace croquis::app
