// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

#include "croquis/hole_filling/fill_holes.h"
#include "croquis/hole_filling/hole_site.h"

namespace croquis::test {

inline hole_filling::HoleAnalysis analysis_of(const PolyMesh& mesh) {
  Progress progress;
  return hole_filling::analyse_holes(mesh, progress);
}

/// The first hole that isn't a border, or where all are, the first.
inline Index inner_hole(const hole_filling::HoleAnalysis& analysis) {
  const auto inner = std::ranges::find_if(
      analysis.holes, [](const hole_filling::Hole& hole) { return hole.kind != hole_filling::HoleClass::Outer; });
  return inner == analysis.holes.end() ? 0 : inner->id;
}
inline Index inner_hole(const PolyMesh& mesh) { return inner_hole(analysis_of(mesh)); }

/// All holes, borders too, none by a flat cap.
inline hole_filling::FillOptions everything(hole_filling::Fairness fairness = hole_filling::Fairness::Implicit) {
  hole_filling::FillOptions options;
  options.selection = hole_filling::Selection::All;
  options.flat_caps = false;
  options.fairness = fairness;
  return options;
}

inline std::vector<Vec3> new_points(const hole_filling::FillResult& result) {
  return {result.mesh.positions.end() - static_cast<std::ptrdiff_t>(result.new_vertices), result.mesh.positions.end()};
}

/// Of new vertices to the unit sphere.
inline double greatest_radial_error(const hole_filling::FillResult& result) {
  double greatest = 0;
  for (const Vec3& p : new_points(result)) greatest = std::max(greatest, std::abs(p.norm() - 1));
  return greatest;
}

/// A site of a hole with what it refers to.
struct SiteScene {
  PolyMesh mesh;
  hole_filling::HoleAnalysis analysis;
  hole_filling::HoleSite site;

  explicit SiteScene(PolyMesh given) : mesh(std::move(given)), analysis(analysis_of(mesh)) {
    const Index hole = inner_hole(analysis);
    site = hole_filling::make_site(mesh, analysis, std::vector{hole}, {});
  }
  SiteScene(const SiteScene&) = delete;
  SiteScene& operator=(const SiteScene&) = delete;
};

}  // namespace croquis::test
