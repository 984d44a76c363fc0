// SPDX-License-Identifier: GPL-3.0-or-later
#include "croquis/geometry/self_intersection.h"

#include <algorithm>
#include <cmath>
#include <functional>
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
  /// @param is_wanted which faces to look at, by their index
  template <typename IsWanted>
  IntersectionTest(const PolyMesh& mesh, IsWanted&& is_wanted) : mesh_(mesh) {
    points_.reserve(mesh.positions.size());
    for (const Vec3& p : mesh.positions) points_.emplace_back(p.x(), p.y(), p.z());
    first_triangle_.reserve(mesh.face_count() + 1);
    for (Index f = 0; f < mesh.face_count(); ++f) {
      first_triangle_.push_back(static_cast<Index>(triangles_.size()));
      if (is_wanted(f)) add_fan(f);
    }
    first_triangle_.push_back(static_cast<Index>(triangles_.size()));
  }

  Index triangle_count() const { return static_cast<Index>(triangles_.size()); }

  Box box(Index triangle) const {
    CGAL::Bbox_3 bounds;
    for (const Index v : triangles_[triangle].vertices) bounds += points_[v].bbox();
    return {bounds, triangle};
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

/// The cells of a coarse grid that the boxes of some faces touch: tells cheaply which other faces may be near them.
class TouchedCells {
 public:
  TouchedCells(const PolyMesh& mesh, std::span<const Index> faces)
      : mesh_(mesh), touched_(cells_per_axis * cells_per_axis * cells_per_axis, false) {
    for (const Index f : faces) bounds_.extend(box_of(f));
    for (const Index f : faces) {
      visit_cells(box_of(f), [&](std::size_t cell) {
        touched_[cell] = true;
        return false;
      });
    }
  }

  bool may_be_near(Index face) const {
    const Bounds box = box_of(face);
    return bounds_.intersects(box) && visit_cells(box, [&](std::size_t cell) { return touched_[cell]; });
  }

 private:
  using Bounds = Eigen::AlignedBox3d;

  static constexpr std::size_t cells_per_axis = 64;

  Bounds box_of(Index face) const {
    Bounds box;
    for (const Index v : mesh_.face(face)) box.extend(mesh_.positions[v]);
    return box;
  }

  /// Monotonic in the coordinate, so that boxes which meet have a cell in common however coordinates are rounded.
  std::size_t cell(double coordinate, Eigen::Index axis) const {
    const double size = bounds_.sizes()[axis];
    const double share = size > 0 ? (coordinate - bounds_.min()[axis]) / size : 0;
    return static_cast<std::size_t>(std::clamp(share, 0.0, 1.0) * (cells_per_axis - 1));
  }

  /// Stops at the first cell for which `found` says so. @return whether there was one
  template <typename Found>
  bool visit_cells(const Bounds& box, Found&& found) const {
    std::array<std::size_t, 3> low{};
    std::array<std::size_t, 3> high{};
    for (Eigen::Index axis = 0; axis < 3; ++axis) {
      low[static_cast<std::size_t>(axis)] = cell(box.min()[axis], axis);
      high[static_cast<std::size_t>(axis)] = cell(box.max()[axis], axis);
    }
    for (std::size_t x = low[0]; x <= high[0]; ++x) {
      for (std::size_t y = low[1]; y <= high[1]; ++y) {
        for (std::size_t z = low[2]; z <= high[2]; ++z) {
          if (found((x * cells_per_axis + y) * cells_per_axis + z)) return true;
        }
      }
    }
    return false;
  }

  const PolyMesh& mesh_;
  Bounds bounds_;
  std::vector<bool> touched_;
};

std::vector<const Box*> pointers_to(const std::vector<Box>& boxes) {
  std::vector<const Box*> pointers;
  pointers.reserve(boxes.size());
  for (const Box& box : boxes) pointers.push_back(&box);
  return pointers;
}

/// What is done with each pair of triangles whose boxes meet.
class PairSearch {
 public:
  PairSearch(const IntersectionTest& test, std::size_t max_pairs, Progress& progress)
      : test_(test), found_(max_pairs), progress_(progress) {}

  void operator()(const Box* first, const Box* second) {
    progress_.check();
    if (++tested_ % 65536 == 0)
      progress_.report(std::min(0.95, static_cast<double>(tested_) / (usual_overlaps * test_.triangle_count())));
    const auto [a, b] = std::minmax({first->info(), second->info()});
    if (test_.intersect(a, b) && test_.first_of_faces(a, b)) found_.add(test_.face(a), test_.face(b));
  }

  SelfIntersections finish() {
    progress_.report(1);
    return found_.take();
  }

 private:
  const IntersectionTest& test_;
  PairList found_;
  Progress& progress_;
  std::size_t tested_ = 0;
};

}  // namespace

SelfIntersections find_self_intersections(const PolyMesh& mesh, Progress& progress,
                                          const SelfIntersectionOptions& options) {
  require_usable(mesh);
  progress.check();
  const IntersectionTest test(mesh, [](Index) { return true; });
  std::vector<Box> boxes;
  boxes.reserve(test.triangle_count());
  for (Index t = 0; t < test.triangle_count(); ++t) boxes.push_back(test.box(t));
  std::vector<const Box*> pointers = pointers_to(boxes);
  PairSearch search(test, options.max_pairs, progress);
  CGAL::box_self_intersection_d(pointers.begin(), pointers.end(), std::ref(search), box_cutoff);
  return search.finish();
}

SelfIntersections find_intersections_of(const PolyMesh& mesh, std::span<const Index> faces, Progress& progress,
                                        const SelfIntersectionOptions& options) {
  require_usable(mesh);
  progress.check();
  const TouchedCells cells(mesh, faces);
  const auto is_chosen = [&](Index f) { return std::binary_search(faces.begin(), faces.end(), f); };
  const IntersectionTest test(mesh, [&](Index f) { return cells.may_be_near(f); });
  std::vector<Box> chosen;
  std::vector<Box> others;
  for (Index t = 0; t < test.triangle_count(); ++t) (is_chosen(test.face(t)) ? chosen : others).push_back(test.box(t));
  std::vector<const Box*> chosen_pointers = pointers_to(chosen);
  std::vector<const Box*> other_pointers = pointers_to(others);
  PairSearch search(test, options.max_pairs, progress);
  CGAL::box_self_intersection_d(chosen_pointers.begin(), chosen_pointers.end(), std::ref(search), box_cutoff);
  CGAL::box_intersection_d(chosen_pointers.begin(), chosen_pointers.end(), other_pointers.begin(), other_pointers.end(),
                           std::ref(search), box_cutoff);
  return search.finish();
}

}  // namespace croquis
