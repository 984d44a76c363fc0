// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

#include <catch2/catch.hpp>

#include "algorithms/silhouette/surface/certificate.h"
#include "algorithms/silhouette/surface/sheet_mesh.h"
#include "croquis/geometry/self_intersection.h"
#include "silhouette/solids.h"
#include "silhouette/surface_quality.h"
#include "support/random.h"

using namespace croquis;
using namespace croquis::silhouette;

namespace {

struct Improved {
  SheetMesh before;
  SheetMesh after;
};

Improved improved(const LabelledFigure& figure) {
  Progress progress;
  const InflatedSheets sheets = test::inflated_sheets(figure);
  Improved result;
  result.before = make_sheet_mesh(sheets, objects_of_triangles(figure, sheets.sampling));
  result.after = result.before;
  improve_triangles(result.after, progress);
  return result;
}

std::vector<test::FigureFixture> fixtures() {
  return {test::disk_figure(), test::ring_figure(), test::crossed_capsules_figure(), test::snake_figure(),
          test::trefoil_figure()};
}

double area_of(const SheetMesh& mesh) {
  double sum = 0;
  for (const auto& [a, b, c] : mesh.triangles) {
    sum += cross(mesh.place[b] - mesh.place[a], mesh.place[c] - mesh.place[a]) / 2;
  }
  return sum;
}

int euler_of(const SheetMesh& mesh) {
  std::set<Index> used;
  int half_edges = 0;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    used.insert(mesh.triangles[t].begin(), mesh.triangles[t].end());
    for (const Index next : mesh.neighbours[t]) half_edges += next == no_index ? 2 : 1;
  }
  return static_cast<int>(used.size()) - half_edges / 2 + static_cast<int>(mesh.triangles.size());
}

PolyMesh whole_surface(const LabelledFigure& figure, const SheetMesh& mesh) {
  PolyMesh all;
  for (const Shell& surface : object_surfaces(figure, mesh)) append_triangles(surface.mesh, all);
  return all;
}

}  // namespace

TEST_CASE("even triangles cover the same region and keep its sense, its rim and its holes") {
  for (const test::FigureFixture& fixture : fixtures()) {
    const auto [before, after] = improved(fixture.figure);
    CHECK(after.triangles.size() < before.triangles.size());
    CHECK(area_of(after) == Approx(area_of(before)).epsilon(1e-9));
    CHECK(euler_of(after) == euler_of(before));
    for (std::size_t t = 0; t < after.triangles.size(); ++t) {
      const auto& [a, b, c] = after.triangles[t];
      CHECK(cross(after.place[b] - after.place[a], after.place[c] - after.place[a]) > 0);
      for (std::size_t k = 0; k < 3; ++k) {
        const Index v = after.triangles[t][(k + 1) % 3];
        const Index w = after.triangles[t][(k + 2) % 3];
        const Index other = after.neighbours[t][k];
        CHECK((other == no_index) == (after.on_boundary[v] && after.on_boundary[w]));
        if (other == no_index) continue;
        CHECK(std::count(after.neighbours[other].begin(), after.neighbours[other].end(), t) == 1);
        CHECK(after.objects[other] == after.objects[t]);
      }
    }
  }
}

TEST_CASE("even triangles leave sheets apart by the gap, and the proof of it notices when they aren't") {
  for (const test::FigureFixture& fixture : {test::crossed_capsules_figure(), test::trefoil_figure()}) {
    auto [before, after] = improved(fixture.figure);
    const PolyMesh surface = whole_surface(fixture.figure, after);
    Progress progress;
    CHECK(find_self_intersections(surface, progress).pairs.empty());
    test::Random random(3);
    int stacked = 0;
    for (int k = 0; k < 200; ++k) {
      const auto& corners = before.triangles[random.below(static_cast<std::uint32_t>(before.triangles.size()))];
      const double s = random.between(0.1, 0.5);
      const double r = random.between(0.1, 0.4);
      const Vec2 place =
          (1 - s - r) * before.place[corners[0]] + s * before.place[corners[1]] + r * before.place[corners[2]];
      const std::vector<double> hits = test::vertical_hits(surface, place);
      CHECK(hits.size() % 2 == 0);
      for (std::size_t i = 2; i < hits.size(); i += 2) {
        ++stacked;
        CHECK(hits[i] - hits[i - 1] >= after.gap * (1 - 1e-6));
      }
    }
    CHECK(stacked > 5);

    const double unit = fixture.figure.unit;
    for (const Rounding rounding : {Rounding::None, Rounding::Single, Rounding::Grid}) {
      CHECK(mesh_in_order(before, rounding, unit));
      CHECK(mesh_in_order(after, rounding, unit));
    }
    SheetMesh folded = after;
    std::swap(folded.triangles[0][0], folded.triangles[0][1]);
    CHECK(!mesh_in_order(folded, Rounding::None, unit));
    SheetMesh tight = after;
    tight.gap = 1e-9;
    CHECK(mesh_in_order(tight, Rounding::None, unit));
    CHECK(!mesh_in_order(tight, Rounding::Grid, unit));
    after.thickness[static_cast<std::size_t>(after.triangles[0][0])] = 0;
    after.on_boundary[after.triangles[0][0]] = 0;
    CHECK(!mesh_in_order(after, Rounding::None, unit));
  }
}

TEST_CASE("most slender triangles are gone") {
  for (const test::FigureFixture& fixture : fixtures()) {
    const auto [before, after] = improved(fixture.figure);
    const auto slender = [&](const SheetMesh& mesh) {
      const PolyMesh surface = whole_surface(fixture.figure, mesh);
      return test::slender_share(surface) * static_cast<double>(surface.face_count());
    };
    CHECK(10 * slender(after) <= slender(before) + 40);
  }
}
