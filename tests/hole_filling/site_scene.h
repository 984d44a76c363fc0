// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <utility>
#include <vector>

#include "croquis/hole_filling/hole_analysis.h"
#include "croquis/hole_filling/hole_site.h"

namespace croquis::test {

/// A site with what it refers to: the first hole that isn't a border, or where all are, the first.
struct SiteScene {
  PolyMesh mesh;
  hole_filling::HoleAnalysis analysis;
  hole_filling::HoleSite site;

  explicit SiteScene(PolyMesh given) : mesh(std::move(given)) {
    Progress progress;
    analysis = hole_filling::analyse_holes(mesh, progress);
    const auto inner = std::ranges::find_if(
        analysis.holes, [](const hole_filling::Hole& hole) { return hole.kind != hole_filling::HoleClass::Outer; });
    const Index hole = inner == analysis.holes.end() ? 0 : inner->id;
    site = hole_filling::make_site(mesh, analysis, std::vector{hole}, {});
  }
  SiteScene(const SiteScene&) = delete;
  SiteScene& operator=(const SiteScene&) = delete;
};

}  // namespace croquis::test
