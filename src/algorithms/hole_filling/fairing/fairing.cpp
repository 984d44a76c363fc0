// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/hole_filling/fairing/fairing.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

#include <Eigen/Geometry>

#include "algorithms/hole_filling/analysis/sorted_lists.h"
#include "croquis/hole_filling/editable_triangles.h"

namespace croquis::hole_filling {
namespace {

using Side = EditableTriangles::Side;

constexpr double too_long = 4.0 / 3;
constexpr double too_short = 4.0 / 5;
constexpr int most_flip_rounds = 5;

/// Cosine: triangles that a step makes may not turn further from those they come from.
constexpr double least_normal_agreement = 0.5;

/// Of the sine of the two angles against an edge: rounding must not flip back and forth.
constexpr double least_flip_gain = 1e-9;

class PatchEditing {
 public:
  PatchEditing(LoosePatch& patch, EditableTriangles& sides)
      : points_(patch.points), sizes_(patch.sizes), rim_points_(static_cast<Index>(patch.known)), sides_(sides) {}

  void run() {
    split_long();
    collapse_short();
    for (int round = 0; round < most_flip_rounds && flip_once(); ++round) {
    }
  }

 private:
  bool on_rim(Index v) const { return v < rim_points_; }
  Index from(Side s) const { return sides_.from(s); }
  Index to(Side s) const { return sides_.to(s); }

  /// Length as a share of what is wanted.
  double relative_length(Index a, Index b) const {
    return 2 * (points_[a] - points_[b]).norm() / (sizes_[a] + sizes_[b]);
  }

  Vec3 normal(Index a, Index b, Index c) const { return (points_[b] - points_[a]).cross(points_[c] - points_[a]); }
  static bool agree(const Vec3& a, const Vec3& b) {
    const double dot = a.dot(b);
    return dot > 0 && dot * dot > least_normal_agreement * least_normal_agreement * a.squaredNorm() * b.squaredNorm();
  }

  /// The edges there are now, the longest first.
  void split_long() {
    std::vector<std::pair<double, Side>> order;
    for (Side s = 0; s < sides_.count(); ++s) {
      if (!sides_.is_inner_edge(s)) continue;
      const double length = relative_length(from(s), to(s));
      if (length > too_long) order.emplace_back(-length, s);
    }
    std::sort(order.begin(), order.end());
    for (const auto& [length, side] : order) {
      const Side s = sides_.where_is_now(side);
      const Index a = from(s), b = to(s);
      points_.push_back(0.5 * (points_[a] + points_[b]));
      sizes_.push_back(0.5 * (sizes_[a] + sizes_[b]));
      sides_.split(s);
    }
  }

  void collapse_short() {
    for (Side side = 0; side < sides_.count(); ++side) {
      if (!sides_.is_inner_edge(side)) continue;
      const Side s = on_rim(from(side)) ? sides_.twin(side) : side;
      if (on_rim(from(s)) || relative_length(from(s), to(s)) >= too_short) continue;
      if (keeps_shape(s) && keeps_edges_apart(s)) sides_.collapse(s);
    }
  }

  /// Whether the triangles around keep a good size and their side.
  bool keeps_shape(Side s) const {
    const Index gone = from(s), kept = to(s);
    return sides_.all_around(gone, [&](Side out) {
      const Index a = to(out), b = sides_.apex(out);
      if (a == kept) return true;
      if (relative_length(a, kept) > too_long) return false;
      return b == kept || agree(normal(gone, a, b), normal(kept, a, b));
    });
  }

  /// Whether no edge comes to lie on another one, nor a further one between two rim points.
  bool keeps_edges_apart(Side s) const {
    const Index gone = from(s), kept = to(s);
    const Index left = sides_.apex(s), right = sides_.apex(sides_.twin(s));
    if (left == right) return false;
    return sides_.all_around(gone, [&](Side out) {
      const Index a = to(out);
      return a == kept || a == left || a == right || can_be_joined(a, kept);
    });
  }

  bool can_be_joined(Index a, Index b) const {
    if (on_rim(a) && on_rim(b)) return false;
    if (on_rim(a)) std::swap(a, b);  // a rim point's triangles may be several fans: the other one is checked
    return sides_.all_around(a, [&](Side out) { return to(out) != b; });
  }

  bool flip_once() {
    bool any = false;
    for (Side s = 0; s < sides_.count(); ++s) {
      if (!sides_.is_inner_edge(s) || !gains_by_flip(s)) continue;
      sides_.flip(s);
      any = true;
    }
    return any;
  }

  /// Whether the angles against the edge are more than two right ones together, by the sign of their sine, and the
  /// triangles go on looking the same way.
  bool gains_by_flip(Side s) const {
    const Index a = from(s), b = to(s), c = sides_.apex(s), d = sides_.apex(sides_.twin(s));
    const Vec3 ca = points_[a] - points_[c], cb = points_[b] - points_[c];
    const Vec3 da = points_[a] - points_[d], db = points_[b] - points_[d];
    const double at_c = ca.dot(cb), at_d = da.dot(db);
    if (at_c >= 0 && at_d >= 0) return false;
    const double sine = ca.cross(cb).norm() * at_d + at_c * da.cross(db).norm();
    const double scale = std::sqrt(ca.squaredNorm() * cb.squaredNorm() * da.squaredNorm() * db.squaredNorm());
    if (sine >= -least_flip_gain * scale || !can_be_joined(c, d)) return false;
    const Vec3 both = normal(a, b, c) + normal(b, a, d);
    return agree(both, normal(a, d, c)) && agree(both, normal(b, c, d));
  }

  std::vector<Vec3>& points_;
  std::vector<double>& sizes_;
  Index rim_points_;
  EditableTriangles& sides_;
};

/// Without the points that have collapsed.
void take_back(const EditableTriangles& sides, LoosePatch& patch) {
  std::vector<Index> numbers(patch.points.size());
  Index next = 0;
  for (Index v = 0; v < patch.points.size(); ++v) {
    numbers[v] = next;
    if (sides.is_gone(v)) continue;
    patch.points[next] = patch.points[v];
    patch.sizes[next++] = patch.sizes[v];
  }
  patch.points.resize(next);
  patch.sizes.resize(next);
  patch.triangles = sides.triangles();
  for (auto& t : patch.triangles) {
    for (Index& v : t) v = numbers[v];
  }
}

constexpr int most_halvings = 16;  // each halves edges

using SparseMatrix = Eigen::SparseMatrix<double>;
using Neighbours = std::vector<std::pair<Index, Index>>;  ///< both directions of edges, ascending

/// Of a place that is to be met, beside 1 for every vertex' bending.
constexpr double pin_weight = 1e6;

Neighbours neighbours_in(std::span<const Triangle> triangles, std::span<const Triangle> around = {}) {
  Neighbours edges;
  for (const auto list : {triangles, around}) {
    for (const auto& [a, b, c] : list) edges.insert(edges.end(), {{a, b}, {b, a}, {b, c}, {c, b}, {c, a}, {a, c}});
  }
  sort_unique(edges);
  return edges;
}

auto neighbours_of(const Neighbours& edges, Index vertex) {
  return with_key(edges, vertex, &std::pair<Index, Index>::first);
}

/// The normal equations of the least sum of squared distances from vertices to the means of their neighbours, for the
/// vertices from the first unknown one on. Their lower triangle.
class BendingEquations {
 public:
  BendingEquations(Index first_unknown, std::size_t unknowns)
      : first_unknown_(first_unknown), right_(Eigen::MatrixXd::Zero(static_cast<Eigen::Index>(unknowns), 3)) {}

  /// @param known the place of a vertex before the first unknown one
  template <typename Known>
  void add(Index vertex, const Neighbours& edges, const Known& known) {
    Eigen::RowVector3d offset = Eigen::RowVector3d::Zero();  // the known part of the vector to the mean
    std::vector<std::pair<int, double>> row;
    const auto place = [&](Index v, double weight) {
      if (v < first_unknown_)
        offset += weight * known(v).transpose();
      else
        row.emplace_back(static_cast<int>(v - first_unknown_), weight);
    };
    place(vertex, 1);
    const auto around = neighbours_of(edges, vertex);
    for (const auto& edge : around) place(edge.second, -1 / static_cast<double>(around.size()));
    for (const auto& [i, weight] : row) {
      right_.row(i) -= weight * offset;
      for (const auto& [j, other] : row) {
        if (j <= i) entries_.emplace_back(i, j, weight * other);
      }
    }
  }

  /// Draws an unknown to a place.
  void pin(std::size_t unknown, const Vec3& place) {
    const auto i = static_cast<int>(unknown);
    entries_.emplace_back(i, i, pin_weight);
    right_.row(i) += pin_weight * place.transpose();
  }

  /// A place per row; nothing when the equations are singular.
  std::optional<Eigen::MatrixXd> solve() const {
    SparseMatrix matrix(right_.rows(), right_.rows());
    matrix.setFromTriplets(entries_.begin(), entries_.end());
    const Eigen::SimplicialLDLT<SparseMatrix> solver(matrix);
    if (solver.info() != Eigen::Success) return std::nullopt;
    Eigen::MatrixXd places = solver.solve(right_);
    if (!places.allFinite()) return std::nullopt;
    return places;
  }

 private:
  Index first_unknown_;
  std::vector<Eigen::Triplet<double>> entries_;
  Eigen::MatrixXd right_;
};

}  // namespace

std::vector<Index> vertices_of(std::span<const Triangle> triangles) {
  std::vector<Index> vertices;
  for (const auto& t : triangles) vertices.insert(vertices.end(), t.begin(), t.end());
  sort_unique(vertices);
  return vertices;
}

std::vector<std::size_t> nearest_points(std::span<const Vec3> points, std::span<const Vec3> places) {
  std::vector<std::size_t> chosen;
  for (const Vec3& place : places) {
    std::size_t best = points.size();
    for (std::size_t v = 0; v < points.size(); ++v) {
      if ((best == points.size() || (points[v] - place).norm() < (points[best] - place).norm()) &&
          std::ranges::find(chosen, v) == chosen.end())
        best = v;
    }
    chosen.push_back(best);
  }
  return chosen;
}

std::vector<double> mean_lengths(std::span<const Vec3> points, std::span<const std::array<Index, 2>> edges) {
  std::vector<double> sums(points.size(), 0), counts(points.size(), 0);
  for (const auto& edge : edges) {
    const double length = (points[edge[0]] - points[edge[1]]).norm();
    for (const Index v : edge) {
      sums[v] += length;
      counts[v] += 1;
    }
  }
  for (std::size_t v = 0; v < sums.size(); ++v) {
    if (counts[v] > 0) sums[v] /= counts[v];
  }
  return sums;
}

bool bring_to_size(LoosePatch& patch) {
  EditableTriangles sides(patch.triangles, patch.points.size());
  if (!sides.is_manifold(patch.known)) return false;
  PatchEditing(patch, sides).run();
  take_back(sides, patch);
  return true;
}

void relax(LoosePatch& patch, std::span<const std::uint8_t> fixed) {
  std::vector<Vec3> sums(patch.points.size(), Vec3::Zero());  // of weight times the vector to the triangle's centroid
  std::vector<double> weights(patch.points.size(), 0);
  for (const auto& t : patch.triangles) {
    const Vec3 ab = patch.points[t[1]] - patch.points[t[0]], ac = patch.points[t[2]] - patch.points[t[0]];
    const double size = patch.sizes[t[0]] + patch.sizes[t[1]] + patch.sizes[t[2]];
    const double weight = ab.cross(ac).norm() / size;  // but for a common factor
    const Vec3 middle = (ab + ac) / 3;                 // from a, for the digits of patches far away
    sums[t[0]] += weight * middle;
    sums[t[1]] += weight * (middle - ab);
    sums[t[2]] += weight * (middle - ac);
    for (const Index v : t) weights[v] += weight;
  }
  for (std::size_t v = 0; v < sums.size(); ++v) {
    if (fixed[v] == 0 && weights[v] > 0) patch.points[v] += sums[v] / weights[v];
  }
}

bool refine_evenly(LoosePatch& patch, double coarseness) {
  const EditableTriangles sides(patch.triangles, patch.points.size());
  std::vector<std::array<Index, 2>> boundary;
  for (Side s = 0; s < sides.count(); ++s) {
    if (sides.twin(s) == EditableTriangles::none) boundary.push_back({sides.from(s), sides.to(s)});
  }
  patch.sizes = mean_lengths(patch.points, boundary);
  for (double& size : patch.sizes) size *= coarseness;
  for (int round = 0; round < most_halvings; ++round) {
    const std::size_t before = patch.points.size();
    if (!bring_to_size(patch)) return false;
    if (patch.points.size() <= before) break;
  }
  return true;
}

HarmonicValues::HarmonicValues(const HolePatch& patch, Index vertices_given) {
  const Neighbours edges = neighbours_in(patch.triangles);
  for (const auto& [from, to] : edges) {
    if (from < vertices_given && (rim_.empty() || rim_.back() != from)) rim_.push_back(from);
  }
  const auto unknowns = static_cast<Eigen::Index>(patch.points.size());
  to_rim_.resize(unknowns, std::ssize(rim_));
  if (patch.points.empty()) return;
  std::vector<Eigen::Triplet<double>> inner, to_rim;
  for (const auto& [from, to] : edges) {
    if (from < vertices_given) continue;
    const auto row = static_cast<int>(from - vertices_given);
    inner.emplace_back(row, row, 1.0);
    if (to >= vertices_given)
      inner.emplace_back(row, static_cast<int>(to - vertices_given), -1.0);
    else
      to_rim.emplace_back(row, static_cast<int>(place_in(rim_, to)), 1.0);
  }
  SparseMatrix matrix(unknowns, unknowns);
  matrix.setFromTriplets(inner.begin(), inner.end());
  to_rim_.setFromTriplets(to_rim.begin(), to_rim.end());
  solver_.compute(matrix);
}

Eigen::MatrixXd HarmonicValues::continued(const Eigen::MatrixXd& known) const {
  if (to_rim_.rows() == 0 || known.rows() == 0) return Eigen::MatrixXd(0, known.cols());
  const Eigen::RowVectorXd base = known.row(0);  // where all are equal the differences are 0, and so is the solution
  if (solver_.info() != Eigen::Success) return base.replicate(to_rim_.rows(), 1);
  Eigen::MatrixXd values = solver_.solve(to_rim_ * (known.rowwise() - base));
  values.rowwise() += base;
  return values;
}

bool fair_evenly(LoosePatch& patch) {
  if (patch.points.size() == patch.known) return true;
  const Neighbours edges = neighbours_in(patch.surroundings, patch.triangles);
  BendingEquations equations(static_cast<Index>(patch.known), patch.points.size() - patch.known);
  for (const Index v : vertices_of(patch.triangles))
    equations.add(v, edges, [&](Index known) -> const Vec3& { return patch.points[known]; });
  const auto places = equations.solve();
  if (!places) return false;
  for (Eigen::Index i = 0; i < places->rows(); ++i)
    patch.points[patch.known + static_cast<std::size_t>(i)] = places->row(i).transpose();
  return true;
}

bool displace_through(const PolyMesh& mesh, HolePatch& patch, std::span<const Vec3> places) {
  if (patch.points.size() < places.size()) return false;
  const Neighbours edges = neighbours_in(patch.triangles);
  BendingEquations equations(static_cast<Index>(mesh.vertex_count()), patch.points.size());
  for (const Index v : vertices_of(patch.triangles))
    equations.add(v, edges, [](Index) -> Vec3 { return Vec3::Zero(); });
  const std::vector<std::size_t> pins = nearest_points(patch.points, places);
  for (std::size_t i = 0; i < pins.size(); ++i) equations.pin(pins[i], places[i] - patch.points[pins[i]]);
  const auto moves = equations.solve();
  if (!moves) return false;
  for (std::size_t v = 0; v < patch.points.size(); ++v)
    patch.points[v] += moves->row(static_cast<Eigen::Index>(v)).transpose();
  return true;
}

}  // namespace croquis::hole_filling
