// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <vector>

#include <catch2/catch.hpp>

#include "croquis/hole_filling/hole_site.h"
#include "support/scans/scans.h"

using namespace croquis;
using namespace croquis::test;
using namespace croquis::hole_filling;

TEST_CASE("measures of a site are those of all its rims together") {
  const PolyMesh mesh = cut_ring(round_sphere(4), Vec3(0, 0, 1), 0.12, 0.4).mesh;
  Progress progress;
  const HoleAnalysis analysis = analyse_holes(mesh, progress);
  REQUIRE(analysis.holes.size() == 2);
  const HoleSite site = make_site(mesh, analysis, std::vector<Index>{0, 1}, {});
  double length = 0, widest = 0;
  std::size_t edges = 0;
  for (const Hole& hole : analysis.holes) {
    for (std::size_t i = 0; i < hole.vertices.size(); ++i, ++edges)
      length +=
          (mesh.positions[hole.vertices[(i + 1) % hole.vertices.size()]] - mesh.positions[hole.vertices[i]]).norm();
    for (const Index a : hole.vertices)
      for (const Index b : hole.vertices) widest = std::max(widest, (mesh.positions[a] - mesh.positions[b]).norm());
  }
  CHECK(rim_length(site) == Approx(length));
  CHECK(mean_rim_edge(site) == Approx(length / static_cast<double>(edges)));
  CHECK(widest_diameter(site) == Approx(widest));
}
