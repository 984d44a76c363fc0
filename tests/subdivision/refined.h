// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include "croquis/base/finding.h"
#include "croquis/subdivision/doo_sabin.h"
#include "croquis/subdivision/uniform_schemes.h"

namespace croquis::test {

/// A mesh subdivided: the plan and the points of all levels.
struct Refined {
  subdivision::DooSabinPlan plan;
  subdivision::PositionBuffers points;

  const std::vector<Vec3>& at(int k) const { return points.levels[static_cast<std::size_t>(k)]; }
};

struct UniformRefined {
  subdivision::UniformPlan plan;
  subdivision::PositionBuffers points;

  const std::vector<Vec3>& at(int k) const { return points.levels[static_cast<std::size_t>(k)]; }
};

Refined refined(const PolyMesh& mesh, int levels, const subdivision::Rules& rules = {});

UniformRefined uniformly_refined(const PolyMesh& mesh, int levels, const subdivision::UniformRules& rules = {});

/// The largest distance of a point of `a` from its nearest one in `b`. #a #b steps.
double greatest_gap(std::span<const Vec3> a, std::span<const Vec3> b);

/// The longest diagonal of the box around the points.
double extent(std::span<const Vec3> points);

double degrees(double radians);

}  // namespace croquis::test
