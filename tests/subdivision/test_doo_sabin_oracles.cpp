// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <vector>

#include <catch2/catch.hpp>

#include "subdivision/cgal_subdivision.h"
#include "subdivision/subdivided.h"
#include "support/meshes/cages.h"
#include "support/meshes/mesh_shapes.h"
#include "support/random.h"

/// Surfaces that others compute too.
namespace croquis::test {
namespace {

TEST_CASE("closed meshes without tags are refined as CGAL does it") {
  const Subdivided screw = subdivide(bolt(), 3);
  CHECK(sum_of_squares(screw.points(1)) == Approx(246.25).epsilon(1e-13));
  CHECK(sum_of_squares(screw.points(2)) == Approx(874.81640625).epsilon(1e-13));
  CHECK(sum_of_squares(screw.points(3)) == Approx(3399.735412597656).epsilon(1e-13));
  int compared = 0;
  for (const NamedCage& cage : all_cages()) {
    if (cage.name == "two pentagons") continue;                             // valence 2 is nothing to CGAL
    if (!subdivide(cage.mesh, 0).plan.level(0).boundary.empty()) continue;  // CGAL lets borders recede
    for (int k = 1; k <= 3; ++k) {
      INFO(cage.name << ", level " << k);
      const Subdivided result = subdivide(cage.mesh, k);
      const CgalLevel expected = cgal_doo_sabin(cage.mesh, k);
      CHECK(counts(result.topology(k)) == Counts{expected.points.size(), expected.edges, expected.faces});
      CHECK(same_points(result.points(k), expected.points, 1e-12 * 4));
    }
    ++compared;
  }
  CHECK(compared >= 9);
}

/// A clamped uniform quadratic B-spline of scalars: knots 0 0 0 1 … n-2 n-2 n-2.
class Spline {
 public:
  explicit Spline(std::vector<double> controls) : controls_(std::move(controls)) {}

  int spans() const { return static_cast<int>(controls_.size()) - 2; }

  /// The polar form of the span that begins at the knot `span`: de Boor's steps with an argument of their own each.
  double blossom(int span, double u, double v) const {
    std::array<double, 3> d{};
    for (int i = 0; i < 3; ++i) d[static_cast<std::size_t>(i)] = controls_[static_cast<std::size_t>(span + i)];
    for (const int step : {1, 2}) {
      const double argument = step == 1 ? u : v;
      for (int i = 2; i >= step; --i) {
        const double low = knot(span + i), high = knot(span + i + 3 - step);
        const double t = (argument - low) / (high - low);
        auto& here = d[static_cast<std::size_t>(i)];
        here = (1 - t) * d[static_cast<std::size_t>(i - 1)] + t * here;
      }
    }
    return d[2];
  }

  /// The controls over knots 2^-levels apart.
  std::vector<double> refined(int levels) const {
    const int pieces = 1 << levels, fine_spans = spans() * pieces;
    std::vector<double> fine;
    for (int i = 0; i < fine_spans + 2; ++i) {
      const auto fine_knot = [&](int j) { return std::clamp(j, 0, fine_spans) / static_cast<double>(pieces); };
      const int span = std::min(std::max(i - 1, 0) / pieces, spans() - 1);
      fine.push_back(blossom(span, fine_knot(i - 1), fine_knot(i)));
    }
    return fine;
  }

 private:
  double knot(int i) const { return std::clamp(i - 2, 0, spans()); }

  std::vector<double> controls_;
};

/// Refines along the rows, then along the columns.
std::vector<Vec3> refined_net(const std::vector<Vec3>& net, int columns, int rows, int levels) {
  std::vector<std::vector<Vec3>> wide;
  for (int j = 0; j < rows; ++j) {
    std::vector<Vec3> row;
    for (int axis = 0; axis < 3; ++axis) {
      std::vector<double> controls;
      for (int i = 0; i < columns; ++i) controls.push_back(net[static_cast<std::size_t>(j * columns + i)][axis]);
      const std::vector<double> fine = Spline(controls).refined(levels);
      row.resize(fine.size());
      for (std::size_t i = 0; i < fine.size(); ++i) row[i][axis] = fine[i];
    }
    wide.push_back(row);
  }
  std::vector<Vec3> result;
  for (std::size_t i = 0; i < wide.front().size(); ++i) {
    std::vector<Vec3> column;
    for (int axis = 0; axis < 3; ++axis) {
      std::vector<double> controls;
      for (const auto& row : wide) controls.push_back(row[i][axis]);
      const std::vector<double> fine = Spline(controls).refined(levels);
      column.resize(fine.size());
      for (std::size_t j = 0; j < fine.size(); ++j) column[j][axis] = fine[j];
    }
    result.insert(result.end(), column.begin(), column.end());
  }
  return result;
}

TEST_CASE("open grids are clamped uniform biquadratic B-splines") {
  Random random(7);
  for (const auto& [columns, rows] : {std::array{4, 3}, std::array{2, 2}, std::array{3, 5}, std::array{6, 2}}) {
    PolyMesh mesh = grid(static_cast<Index>(columns), static_cast<Index>(rows));
    for (Vec3& point : mesh.positions) point += Vec3(random.unit(), random.unit(), 2 * random.unit());
    const Subdivided result = subdivide(mesh, 3);
    for (int k = 1; k <= 3; ++k) {
      INFO(columns << " x " << rows << ", level " << k);
      CHECK(same_points(result.points(k), refined_net(mesh.positions, columns + 1, rows + 1, k), 1e-9));
    }
  }
}

}  // namespace
}  // namespace croquis::test
