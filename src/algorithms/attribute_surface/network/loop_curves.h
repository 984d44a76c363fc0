// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <memory>
#include <string>
#include <vector>

#include "croquis/attribute_surface/arc_length_curve.h"
#include "croquis/base/finding.h"
#include "croquis/geometry/attribute_network.h"

/// How findings about a network spell what they are about.
namespace croquis {

std::string quoted(const std::string& id);

/// With four digits, for sentences.
std::string rounded_text(double number);

/// With units where the network has some.
std::string length_text(const AttributeNetwork& network, double length);

Subject subject_of(SubjectKind kind, const std::string& id);

class StageCache;

/// The curves of a network with their ends where they meet.
struct LoopCurves {
  struct Curve {
    std::shared_ptr<const ArcLengthCurve> curve;  ///< null: it failed
    std::array<std::size_t, 2> corners{};         ///< numbers of the places of its start and end
  };
  std::vector<Curve> curves;
  std::size_t corners = 0;
};

/// Moves ends by no more than the tolerance: to their nodes, and free ends to those that follow them in a loop. The
/// whole curve follows, most at that end (W_SNAP). Curves whose ends are farther from their nodes (E_GAP), and those
/// that are no longer than the tolerance (E_ZERO_LENGTH), are left out.
LoopCurves meet_ends(const AttributeNetwork& network, double tolerance, StageCache* cache, Findings& findings);

/// The control points with the ends moved: each follows an end by how near it is to it in the polygon.
std::vector<Vec3> with_ends_moved(std::vector<Vec3> control, const Vec3& start, const Vec3& end);

}  // namespace croquis
