// SPDX-License-Identifier: GPL-3.0-or-later
#include "croquis/geometry/self_intersection.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/box_intersection_d.h>
#include <Eigen/Geometry>

#include "geometry/require_usable.h"

namespace croquis {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Box = CGAL::Box_intersection_d::Box_with_info_d<double, 3, Index, CGAL::Box_intersection_d::ID_FROM_BOX_ADDRESS>;

/// Below this many boxes CGAL tests all pairs instead of dividing further; CGAL's own self-intersection test uses the
/// same number.
constexpr std::ptrdiff_t box_cutoff = 2000;

/// Overlapping boxes per triangle of a well-shaped mesh, for the estimate of the progress.
constexpr double usual_overlaps = 10;

/// How clear a sign must be before the exact test is spared, relative to the product of the lengths multiplied.
/// Rounding of differences and products stays below 20 × 2^-53 of it; this leaves a wide margin.
constexpr double sign_margin = 1e-12;

/// Under this products may have lost their precision to underflow.
constexpr double smallest_product = 1e-200;

/// Beyond this products may overflow; the exact tests decide.
constexpr double largest_size = 1e100;

struct FanTriangle {
  std::array<Index, 3> vertices{};
  Index face = no_index;
};

class IntersectionTest {
 public:
  explicit IntersectionTest(const PolyMesh& mesh) : mesh_(mesh) {
    points_.reserve(mesh.positions.size());
    for (const Vec3& p : mesh.positions) points_.emplace_back(p.x(), p.y(), p.z());
    first_triangle_.reserve(mesh.face_count() + 1);
    for (Index f = 0; f < mesh.face_count(); ++f) {
      first_triangle_.push_back(static_cast<Index>(triangles_.size()));
      add_fan(f);
    }
    first_triangle_.push_back(static_cast<Index>(triangles_.size()));
  }

  std::vector<Box> boxes() const {
    std::vector<Box> boxes;
    boxes.reserve(triangles_.size());
    for (Index t = 0; t < triangles_.size(); ++t) {
      CGAL::Bbox_3 bounds;
      for (const Index v : triangles_[t].vertices) bounds += points_[v].bbox();
      boxes.emplace_back(bounds, t);
    }
    return boxes;
  }

  Index face(Index triangle) const { return triangles_[triangle].face; }

  bool intersect(Index a, Index b) const {
    std::array<Index, 3> u = triangles_[a].vertices;
    std::array<Index, 3> v = triangles_[b].vertices;
    switch (move_shared_to_front(u, v)) {
      case 0: return !clearly_apart(u, v, 0) && CGAL::do_intersect(triangle(u), triangle(v));
      case 1: return !clearly_apart(u, v, 1) && meet_beyond_vertex(u, v);
      case 2: return fold_over(u[0], u[1], u[2], v[2]);
      default: return true;
    }
  }

  /// Whether these two triangles, which intersect, are the first pair of their faces that does.
  bool first_of_faces(Index a, Index b) const {
    const Index face_a = face(a);
    const Index face_b = face(b);
    for (Index i = first_triangle_[face_a]; i < first_triangle_[face_a + 1]; ++i) {
      const Index begin = face_a == face_b ? i + 1 : first_triangle_[face_b];
      for (Index j = begin; j < first_triangle_[face_b + 1]; ++j) {
        if (i == a && j == b) return true;
        if (intersect(i, j)) return false;
      }
    }
    return true;
  }

 private:
  Kernel::Triangle_3 triangle(const std::array<Index, 3>& v) const {
    return {points_[v[0]], points_[v[1]], points_[v[2]]};
  }

  void add_fan(Index f) {
    const auto face = mesh_.face(f);
    for (std::size_t i = 2; i < face.size(); ++i) {
      const std::array<Index, 3> v = {face[0], face[i - 1], face[i]};
      if (!CGAL::collinear(points_[v[0]], points_[v[1]], points_[v[2]])) triangles_.push_back({v, f});
    }
  }

  /// Brings the vertices common to both to the same places at the front. @return how many there are
  static std::size_t move_shared_to_front(std::array<Index, 3>& u, std::array<Index, 3>& v) {
    std::size_t shared = 0;
    for (std::size_t i = 0; i < 3; ++i) {
      const auto found = std::find(v.begin() + static_cast<std::ptrdiff_t>(shared), v.end(), u[i]);
      if (found == v.end()) continue;
      std::swap(*found, v[shared]);
      std::swap(u[i], u[shared]);
      ++shared;
    }
    return shared;
  }

  /// Spares most exact tests: a plane across the line between the centroids that clearly separates the triangles, but
  /// for the `shared` (0 or 1) vertices in front, through which it must go.
  bool clearly_apart(const std::array<Index, 3>& u, const std::array<Index, 3>& v, std::size_t shared) const {
    const Vec3& origin = mesh_.positions[u[0]];
    std::array<Vec3, 3> a;
    std::array<Vec3, 3> b;
    for (std::size_t i = 0; i < 3; ++i) {
      a[i] = mesh_.positions[u[i]] - origin;
      b[i] = mesh_.positions[v[i]] - origin;
    }
    // Directions, not distances, from a shared vertex: else the larger triangle alone would turn the plane.
    Vec3 across = shared == 0 ? Vec3(b[0] + b[1] + b[2] - a[1] - a[2])
                              : Vec3(b[1].normalized() + b[2].normalized() - a[1].normalized() - a[2].normalized());
    double low_b = std::numeric_limits<double>::infinity();
    double high_a = -low_b;
    double size = 0;
    for (std::size_t i = shared; i < 3; ++i) {
      high_a = std::max(high_a, across.dot(a[i]));
      low_b = std::min(low_b, across.dot(b[i]));
      size = std::max({size, a[i].norm(), b[i].norm()});
    }
    if (!(size < largest_size)) return false;
    const double margin = sign_margin * size * across.norm() + smallest_product;
    return shared == 0 ? low_b - high_a > margin : low_b > margin && high_a < -margin;
  }

  /// Triangles with the common vertex u[0] = v[0] that meet elsewhere too: following a common ray from the vertex, one
  /// of them ends first, on its opposite edge, inside the other.
  bool meet_beyond_vertex(const std::array<Index, 3>& u, const std::array<Index, 3>& v) const {
    return CGAL::do_intersect(triangle(u), Kernel::Segment_3(points_[v[1]], points_[v[2]])) ||
           CGAL::do_intersect(triangle(v), Kernel::Segment_3(points_[u[1]], points_[u[2]]));
  }

  /// Triangles on the common edge (p, q) overlap only when they lie in one plane on the same side of it.
  bool fold_over(Index p, Index q, Index r, Index s) const {
    const Vec3 edge = mesh_.positions[q] - mesh_.positions[p];
    const Vec3 a = mesh_.positions[r] - mesh_.positions[p];
    const Vec3 b = mesh_.positions[s] - mesh_.positions[p];
    const double product = edge.squaredNorm() * a.norm() * b.norm();
    if (edge.cross(a).dot(edge.cross(b)) < -(sign_margin * product + smallest_product)) return false;
    return CGAL::coplanar(points_[p], points_[q], points_[r], points_[s]) &&
           CGAL::coplanar_orientation(points_[p], points_[q], points_[r], points_[s]) == CGAL::POSITIVE;
  }

  const PolyMesh& mesh_;
  std::vector<Kernel::Point_3> points_;
  std::vector<FanTriangle> triangles_;
  std::vector<Index> first_triangle_;  ///< per face, in triangles_
};

/// Keeps the lexicographically first pairs, whatever order they come in.
class PairList {
 public:
  explicit PairList(std::size_t capacity) : capacity_(capacity) {}

  void add(Index face_a, Index face_b) {
    ++result_.count;
    if (capacity_ == 0) return;
    result_.pairs.push_back({face_a, face_b});
    if (result_.pairs.size() >= 2 * capacity_) keep_first();
  }

  SelfIntersections take() {
    keep_first();
    return std::move(result_);
  }

 private:
  void keep_first() {
    std::sort(result_.pairs.begin(), result_.pairs.end());
    result_.pairs.resize(std::min(result_.pairs.size(), capacity_));
  }

  std::size_t capacity_;
  SelfIntersections result_;
};

}  // namespace

SelfIntersections find_self_intersections(const PolyMesh& mesh, Progress& progress,
                                          const SelfIntersectionOptions& options) {
  require_usable(mesh);
  progress.check();
  const IntersectionTest test(mesh);
  std::vector<Box> boxes = test.boxes();
  std::vector<const Box*> pointers;
  pointers.reserve(boxes.size());
  for (const Box& box : boxes) pointers.push_back(&box);

  PairList found(options.max_pairs);
  std::size_t tested = 0;
  const double expected = usual_overlaps * static_cast<double>(boxes.size());
  const auto test_pair = [&](const Box* first, const Box* second) {
    progress.check();
    if (++tested % 65536 == 0) progress.report(std::min(0.95, static_cast<double>(tested) / expected));
    const auto [a, b] = std::minmax({first->info(), second->info()});
    if (test.intersect(a, b) && test.first_of_faces(a, b)) found.add(test.face(a), test.face(b));
  };
  CGAL::box_self_intersection_d(pointers.begin(), pointers.end(), test_pair, box_cutoff);
  progress.report(1);
  return found.take();
}

}  // namespace croquis
