// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/silhouette/surface/draping.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include "algorithms/silhouette/skeleton/overlap_cycles.h"
#include "croquis/solver/symmetric_factors.h"

namespace croquis::silhouette {
namespace {

using SparseMatrix = Eigen::SparseMatrix<double>;

/// In radii of the object that rests: what bends over a shorter length is smoothed.
constexpr double bending_length = 0.3;

/// In radii: over how long it levels out where nothing lies below.
constexpr double levelling_length = 1;

/// Slope of the surface below, over the gentlest one, at which it no longer pulls: at its own outline it falls away.
constexpr double steep = 2.5;

/// Of a place's area: the pull there all the same. A rim that is pulled harder than `firm` may slope as it likes.
constexpr double least_pull = 1e-6;
constexpr double firm_pull = 0.25;

/// A thin part that leans more than that would become a spike.
constexpr double greatest_tilt = 2;

/// In L: no row presses on what was laid down.
constexpr double lying_clearance = 1e-4;

constexpr double nothing_below = -std::numeric_limits<double>::infinity();

/// The part of all sheets that is one object, its vertices numbered by themselves.
class ObjectSheet {
 public:
  ObjectSheet(const SheetBasis& basis, Index object) : op_(basis.op), local_(basis.op.position.size(), no_index) {
    for (std::size_t m = 0; m < basis.objects.size(); ++m) {
      if (basis.objects[m] != object) continue;
      triangles_.push_back(basis.sampling.lifted.triangles[m]);
      for (const Index v : triangles_.back()) {
        if (local_[v] != no_index) continue;
        local_[v] = static_cast<Index>(vertices_.size());
        vertices_.push_back(v);
      }
    }
  }

  const SheetOperator& op() const { return op_; }
  const std::vector<Index>& vertices() const { return vertices_; }
  Index local(Index vertex) const { return local_[vertex]; }
  Eigen::Index size() const { return static_cast<Eigen::Index>(vertices_.size()); }

  /// Calls with every neighbour of a vertex, the vertex among them, and its entry of the stiffness matrix.
  template <typename Visit>
  void for_neighbours(Index vertex, Visit visit) const {
    for (SparseMatrix::InnerIterator near(op_.stiffness, static_cast<Eigen::Index>(vertex)); near; ++near) {
      visit(static_cast<Index>(near.row()), near.value());
    }
  }

  /// The length of the gradient of a piecewise linear function, given at vertices of all sheets, at the object's own:
  /// its mean over the triangles around that know all their corners; 0 where there is none.
  Eigen::VectorXd slopes(const Eigen::VectorXd& values) const {
    std::vector<Vec2> sum(vertices_.size(), Vec2::Zero());
    Eigen::VectorXd area = Eigen::VectorXd::Zero(size());
    for (const auto& corners : triangles_) {
      const auto at = [&](std::size_t k) -> const Vec2& { return op_.position[corners[k]]; };
      Vec2 gradient = Vec2::Zero();
      for (std::size_t k = 0; k < 3; ++k) gradient += values[corners[k]] * left_of(at((k + 2) % 3) - at((k + 1) % 3));
      if (!gradient.allFinite()) continue;
      for (const Index v : corners) {
        sum[local_[v]] += gradient;  // times twice the area of the triangle
        area[local_[v]] += cross(at(1) - at(0), at(2) - at(0));
      }
    }
    Eigen::VectorXd lengths = Eigen::VectorXd::Zero(size());
    for (Eigen::Index row = 0; row < size(); ++row) {
      if (area[row] > 0) lengths[row] = sum[static_cast<std::size_t>(row)].norm() / area[row];
    }
    return lengths;
  }

 private:
  const SheetOperator& op_;
  std::vector<Index> local_;  ///< per vertex of all sheets
  std::vector<Index> vertices_;
  std::vector<std::array<Index, 3>> triangles_;
};

/// Means over neighbours, several times: thickness must not show single triangles.
Eigen::VectorXd evened(const ObjectSheet& sheet, Eigen::VectorXd values) {
  constexpr int passes = 6;
  for (int pass = 0; pass < passes; ++pass) {
    const Eigen::VectorXd before = values;
    for (Eigen::Index row = 0; row < sheet.size(); ++row) {
      double sum = 0;
      double weight = 0;
      sheet.for_neighbours(sheet.vertices()[static_cast<std::size_t>(row)], [&](Index near, double) {
        const double area = sheet.op().area[static_cast<Eigen::Index>(near)];
        sum += area * before[static_cast<Eigen::Index>(sheet.local(near))];
        weight += area;
      });
      values[row] = sum / weight;
    }
  }
  return values;
}

/// Only what is much thinner than what it rests on is bent by it: a belly, not a head.
bool bends_over(const StackedPair& pair, const std::vector<Index>& objects, const std::vector<double>& radii) {
  constexpr double much_thicker = 1.5;
  return pair.resting && radii[objects[pair.lower]] >= much_thicker * radii[objects[pair.upper]];
}

/// Which objects are laid down, in that order.
std::vector<Index> draping_order(const std::vector<Index>& objects, const std::vector<StackedPair>& pairs,
                                 const Attachments& attachments) {
  const Index count = objects.empty() ? 0 : *std::max_element(objects.begin(), objects.end()) + 1;
  std::vector<std::vector<Index>> below(count);
  std::vector<std::uint8_t> rests(count, 0);
  std::vector<std::uint8_t> tied(count, 0);
  std::pair<Index, Index> last(no_index, no_index);
  for (const StackedPair& pair : pairs) {
    const auto [upper, lower] = std::pair(objects[pair.upper], objects[pair.lower]);
    if (pair.resting) rests[upper] = 1;
    if (upper == lower || attachments.involves(upper)) tied[upper] = 1;
    if (std::exchange(last, {upper, lower}) != std::pair(upper, lower)) below[upper].push_back(lower);
  }
  const OverlapCycles cycles = overlap_cycles(below);
  std::vector<Index> members(cycles.count, 0);
  for (const Index cycle : cycles.cycle) ++members[cycle];
  std::vector<Index> order;
  for (Index object = 0; object < count; ++object) {
    if (rests[object] && !tied[object] && members[cycles.cycle[object]] == 1) order.push_back(object);
  }
  std::sort(order.begin(), order.end(), [&](Index a, Index b) { return cycles.cycle[a] < cycles.cycle[b]; });
  return order;
}

/// Heights over one object's vertices.
class Layer {
 public:
  /// @param floor per vertex of all sheets, the highest front below it
  Layer(const ObjectSheet& sheet, const Eigen::VectorXd& floor, double radius)
      : sheet_(sheet), floor_(floor), radius_(radius), pull_(pulls()) {}

  /// As near to the floor as the bending allows, nowhere below it.
  Eigen::VectorXd heights() const {
    Eigen::VectorXd right = Eigen::VectorXd::Zero(sheet_.size());
    std::vector<Eigen::Triplet<double>> entries;
    double least = std::numeric_limits<double>::infinity();
    for (Eigen::Index row = 0; row < sheet_.size(); ++row) {
      if (!covered(row)) continue;
      const double pull = pull_[row] * sheet_.op().area[static_cast<Eigen::Index>(vertex(row))];
      entries.emplace_back(row, row, pull);
      right[row] = pull * floor_at(row);
      least = std::min(least, floor_at(row));
    }
    add_levelling(entries);
    SparseMatrix matrix(sheet_.size(), sheet_.size());
    matrix.setFromTriplets(entries.begin(), entries.end());
    matrix += bending();
    Eigen::VectorXd result = SymmetricFactors(matrix).solve(right);
    for (Eigen::Index row = 0; row < sheet_.size(); ++row) {
      result[row] = std::max(result[row], covered(row) ? floor_at(row) : least);
    }
    return result;
  }

 private:
  Index vertex(Eigen::Index row) const { return sheet_.vertices()[static_cast<std::size_t>(row)]; }
  double floor_at(Eigen::Index row) const { return floor_[static_cast<Eigen::Index>(vertex(row))]; }
  bool covered(Eigen::Index row) const { return floor_at(row) > nothing_below; }

  /// Per row the part of its area that is pulled; 0 where nothing lies below.
  Eigen::VectorXd pulls() const {
    const Eigen::VectorXd slope = sheet_.slopes(floor_);
    double gentlest = std::numeric_limits<double>::infinity();
    for (Eigen::Index row = 0; row < sheet_.size(); ++row) {
      if (covered(row)) gentlest = std::min(gentlest, slope[row]);
    }
    Eigen::VectorXd pull = Eigen::VectorXd::Zero(sheet_.size());
    for (Eigen::Index row = 0; row < sheet_.size(); ++row) {
      if (!covered(row)) continue;
      const double excess = (slope[row] - gentlest) / steep;
      const double rest = std::max(0.0, 1 - excess * excess);
      pull[row] = std::max(rest * rest, least_pull);
    }
    return pull;
  }

  /// The square of the Laplacian, integrated. At a rim that lies on something nothing keeps the slope level.
  SparseMatrix bending() const {
    std::vector<Eigen::Triplet<double>> entries;
    for (Eigen::Index row = 0; row < sheet_.size(); ++row) {
      const Index v = vertex(row);
      if (sheet_.op().on_boundary[v] && pull_[row] > firm_pull) continue;
      const double scale = 1 / std::sqrt(sheet_.op().area[static_cast<Eigen::Index>(v)]);
      sheet_.for_neighbours(
          v, [&](Index near, double value) { entries.emplace_back(row, sheet_.local(near), scale * value); });
    }
    SparseMatrix laplacian(sheet_.size(), sheet_.size());
    laplacian.setFromTriplets(entries.begin(), entries.end());
    const SparseMatrix square = laplacian.transpose() * laplacian;
    return std::pow(bending_length * radius_, 4) * square;
  }

  /// The square of the gradient where nothing lies below.
  void add_levelling(std::vector<Eigen::Triplet<double>>& entries) const {
    const double length = bending_length * bending_length / levelling_length * radius_;
    for (Eigen::Index row = 0; row < sheet_.size(); ++row) {
      if (covered(row)) continue;
      sheet_.for_neighbours(vertex(row), [&](Index near, double value) {
        if (near == vertex(row)) return;
        const auto column = static_cast<Eigen::Index>(sheet_.local(near));
        const double weight = length * length * std::max(-value, 0.0);
        entries.emplace_back(row, row, weight);
        entries.emplace_back(column, column, weight);
        entries.emplace_back(row, column, -weight);
        entries.emplace_back(column, row, -weight);
      });
    }
  }

  const ObjectSheet& sheet_;
  const Eigen::VectorXd& floor_;
  double radius_;
  Eigen::VectorXd pull_;  ///< per row
};

/// Per lifted vertex of the object the height at which its middle lies on what it rests on: on the highest front, or
/// before it where that is too thin for all of the half that sinks in.
/// @param counts whether a pair does
template <class Counts>
Eigen::VectorXd floor_of(const MidSurfaceData& data, const InflatedSheets& sheets, const Counts& counts) {
  Eigen::VectorXd floor = Eigen::VectorXd::Constant(sheets.z.size(), nothing_below);
  for (const StackedPair& pair : data.pairs) {
    if (!counts(pair)) continue;
    const double front = sheets.thickness[pair.lower] + data.resting_gap;
    const double height = std::max(front, least_distance(data, pair, sheets.thickness)) + lying_clearance * data.scale;
    floor[pair.upper] = std::max(floor[pair.upper], sheets.z[pair.lower] + height);
  }
  return floor;
}

/// Heights of the sheet as it is, moved as a whole so that it touches the floor.
Eigen::VectorXd moved_to(const Eigen::VectorXd& floor, const ObjectSheet& sheet, const Eigen::VectorXd& z) {
  double move = nothing_below;
  for (const Index v : sheet.vertices()) move = std::max(move, floor[v] - z[v]);
  Eigen::VectorXd heights(sheet.size());
  for (Eigen::Index row = 0; row < sheet.size(); ++row)
    heights[row] = z[sheet.vertices()[static_cast<std::size_t>(row)]] + move;
  return heights;
}

}  // namespace

Draping drape_sheets(const Skeleton& skeleton, const SheetBasis& basis, const DepthSettings& settings,
                     const MidSurfaceData& data, InflatedSheets& sheets, Progress& progress) {
  const std::vector<Index> objects = objects_of_vertices(basis);
  const std::vector<double> radii = object_radii(skeleton);
  Draping draping{{}, Eigen::VectorXd::Zero(sheets.z.size())};
  Eigen::VectorXd middle = Eigen::VectorXd::Constant(sheets.z.size(), nothing_below);
  for (const Index object : draping_order(objects, data.pairs, settings.attachments)) {
    progress.check();
    const ObjectSheet sheet(basis, object);
    const auto rests = [&](const StackedPair& pair) { return pair.resting && objects[pair.upper] == object; };
    const auto bends = [&](const StackedPair& pair) { return rests(pair) && bends_over(pair, objects, radii); };
    const Eigen::VectorXd heights = std::ranges::any_of(data.pairs, bends)
                                        ? Layer(sheet, floor_of(data, sheets, bends), radii[object]).heights()
                                        : moved_to(floor_of(data, sheets, rests), sheet, sheets.z);
    for (Eigen::Index row = 0; row < sheet.size(); ++row) {
      middle[sheet.vertices()[static_cast<std::size_t>(row)]] = heights[row];
    }
    const Eigen::VectorXd slope = evened(sheet, sheet.slopes(middle));
    for (Eigen::Index row = 0; row < sheet.size(); ++row) {
      const auto v = static_cast<Eigen::Index>(sheet.vertices()[static_cast<std::size_t>(row)]);
      const double tilt = std::min(std::sqrt(1 + slope[row] * slope[row]), greatest_tilt);
      sheets.thickness[v] = factored_thickness(basis, v, settings.thickness_of(object) * tilt);
      sheets.z[v] = draping.z[v] = middle[v];
    }
    draping.objects.push_back(object);
  }
  std::sort(draping.objects.begin(), draping.objects.end());
  return draping;
}

}  // namespace croquis::silhouette
