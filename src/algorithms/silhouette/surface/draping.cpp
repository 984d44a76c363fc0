// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include "algorithms/silhouette/skeleton/rest_depths.h"
#include "algorithms/silhouette/surface/inflation.h"
#include "croquis/solver/symmetric_factors.h"

namespace croquis::silhouette {
namespace {

using SparseMatrix = Eigen::SparseMatrix<double>;

/// Only what is so much thinner than what it rests on is bent by it: a belly, not a head.
constexpr double much_thicker = 1.5;

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

/// The part of all sheets that is one object; its vertices are the rows of its own systems.
struct ObjectSheet {
  std::vector<Eigen::Index> vertices;             ///< per row
  std::vector<Index> rows;                        ///< per vertex of all sheets
  std::vector<std::array<Index, 3>> triangles{};  ///< of vertices of all sheets
};

ObjectSheet object_sheet(const SheetBasis& basis, Index object) {
  ObjectSheet sheet{{}, std::vector<Index>(basis.op.position.size(), no_index)};
  for (std::size_t m = 0; m < basis.objects.size(); ++m) {
    if (basis.objects[m] != object) continue;
    sheet.triangles.push_back(basis.sampling.lifted.triangles[m]);
    for (const Index v : sheet.triangles.back()) {
      if (sheet.rows[v] != no_index) continue;
      sheet.rows[v] = static_cast<Index>(sheet.vertices.size());
      sheet.vertices.push_back(v);
    }
  }
  return sheet;
}

/// Per row the length of the gradient of a piecewise linear function, given at vertices of all sheets: its mean over
/// the triangles around that know all their corners; 0 where there is none.
Eigen::ArrayXd slopes(const SheetOperator& op, const ObjectSheet& sheet, const Eigen::VectorXd& values) {
  std::vector<Vec2> sum(sheet.vertices.size(), Vec2::Zero());
  std::vector<double> area(sheet.vertices.size(), 0);
  for (const auto& corners : sheet.triangles) {
    const auto at = [&](std::size_t k) -> const Vec2& { return op.position[corners[k]]; };
    Vec2 gradient = Vec2::Zero();
    for (std::size_t k = 0; k < 3; ++k) gradient += values[corners[k]] * left_of(at((k + 2) % 3) - at((k + 1) % 3));
    if (!gradient.allFinite()) continue;
    for (const Index v : corners) {
      sum[sheet.rows[v]] += gradient;  // times twice the area of the triangle
      area[sheet.rows[v]] += cross(at(1) - at(0), at(2) - at(0));
    }
  }
  Eigen::ArrayXd lengths = Eigen::ArrayXd::Zero(static_cast<Eigen::Index>(area.size()));
  for (std::size_t row = 0; row < area.size(); ++row) {
    if (area[row] > 0) lengths[static_cast<Eigen::Index>(row)] = sum[row].norm() / area[row];
  }
  return lengths;
}

/// Means over neighbours, several times: thickness must not show single triangles.
Eigen::ArrayXd evened(const SheetOperator& op, const ObjectSheet& sheet, Eigen::ArrayXd values) {
  constexpr int passes = 6;
  for (int pass = 0; pass < passes; ++pass) {
    const Eigen::ArrayXd before = values;
    for (Eigen::Index row = 0; row < values.size(); ++row) {
      double sum = 0;
      double weight = 0;
      for (SparseMatrix::InnerIterator near(op.stiffness, sheet.vertices[static_cast<std::size_t>(row)]); near;
           ++near) {
        sum += op.area[near.row()] * before[sheet.rows[static_cast<std::size_t>(near.row())]];
        weight += op.area[near.row()];
      }
      values[row] = sum / weight;
    }
  }
  return values;
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
    if (upper == lower || attachments.joins(upper)) tied[upper] = 1;
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

/// Per row the part of its area that is pulled to the floor; 0 where nothing lies below.
Eigen::ArrayXd pulls(const Eigen::ArrayXd& floor, const Eigen::ArrayXd& slope) {
  const auto covered = floor > nothing_below;
  const double gentlest = covered.select(slope, std::numeric_limits<double>::infinity()).minCoeff();
  const Eigen::ArrayXd rest = (1 - ((slope - gentlest) / steep).square()).max(0);
  return covered.select(rest.square().max(least_pull), 0);
}

/// The square of the Laplacian, integrated. At a rim that lies on something nothing keeps the slope level.
SparseMatrix bending_energy(const SheetOperator& op, const ObjectSheet& sheet, const Eigen::ArrayXd& pull,
                            double length) {
  std::vector<Eigen::Triplet<double>> entries;
  for (Eigen::Index row = 0; row < pull.size(); ++row) {
    const Eigen::Index v = sheet.vertices[static_cast<std::size_t>(row)];
    if (op.on_boundary[static_cast<std::size_t>(v)] && pull[row] > firm_pull) continue;
    const double scale = 1 / std::sqrt(op.area[v]);
    for (SparseMatrix::InnerIterator near(op.stiffness, v); near; ++near) {
      entries.emplace_back(row, sheet.rows[static_cast<std::size_t>(near.row())], scale * near.value());
    }
  }
  SparseMatrix laplacian(pull.size(), pull.size());
  laplacian.setFromTriplets(entries.begin(), entries.end());
  const SparseMatrix square = laplacian.transpose() * laplacian;
  return std::pow(length, 4) * square;
}

/// Per row the height of a sheet that is as near to the floor as the bending allows, and nowhere below it.
/// @param floor per vertex of all sheets, see floor_of
Eigen::VectorXd bent_to(const Eigen::VectorXd& floor, const SheetOperator& op, const ObjectSheet& sheet,
                        double radius) {
  const Eigen::ArrayXd own = floor(sheet.vertices);
  const Eigen::ArrayXd pull = pulls(own, slopes(op, sheet, floor));
  std::vector<Eigen::Triplet<double>> entries;
  Eigen::VectorXd right = Eigen::VectorXd::Zero(own.size());
  double least = std::numeric_limits<double>::infinity();
  for (Eigen::Index row = 0; row < own.size(); ++row) {
    if (!(own[row] > nothing_below)) continue;
    const double weight = pull[row] * op.area[sheet.vertices[static_cast<std::size_t>(row)]];
    entries.emplace_back(row, row, weight);
    right[row] = weight * own[row];
    least = std::min(least, own[row]);
  }
  // The square of the gradient where nothing lies below.
  const double length = bending_length * bending_length / levelling_length * radius;
  for (Eigen::Index row = 0; row < own.size(); ++row) {
    if (own[row] > nothing_below) continue;
    for (SparseMatrix::InnerIterator near(op.stiffness, sheet.vertices[static_cast<std::size_t>(row)]); near; ++near) {
      const Eigen::Index column = sheet.rows[static_cast<std::size_t>(near.row())];
      if (column == row) continue;
      const double weight = length * length * std::max(-near.value(), 0.0);
      entries.emplace_back(row, row, weight);
      entries.emplace_back(column, column, weight);
      entries.emplace_back(row, column, -weight);
      entries.emplace_back(column, row, -weight);
    }
  }
  SparseMatrix matrix(own.size(), own.size());
  matrix.setFromTriplets(entries.begin(), entries.end());
  matrix += bending_energy(op, sheet, pull, bending_length * radius);
  return SymmetricFactors(matrix).solve(right).array().max(own.max(least)).matrix();
}

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

/// Per row the height of the sheet as it is, moved as a whole so that it touches the floor.
Eigen::VectorXd moved_to(const Eigen::VectorXd& floor, const ObjectSheet& sheet, const Eigen::VectorXd& z) {
  const Eigen::ArrayXd own = z(sheet.vertices);
  return own + (floor(sheet.vertices).array() - own).maxCoeff();
}

}  // namespace

Draping drape_sheets(const Skeleton& skeleton, const SheetBasis& basis, const DepthSettings& settings,
                     const MidSurfaceData& data, InflatedSheets& sheets, Progress& progress) {
  Draping draping{{}, Eigen::VectorXd::Zero(sheets.z.size())};
  if (!settings.attachments.any(Hold::Resting)) return draping;
  const std::vector<Index>& objects = basis.vertex_objects;
  const std::vector<double> radii = object_radii(skeleton);
  Eigen::VectorXd middle = Eigen::VectorXd::Constant(sheets.z.size(), nothing_below);
  for (const Index object : draping_order(objects, data.pairs, settings.attachments)) {
    progress.check();
    const ObjectSheet sheet = object_sheet(basis, object);
    const auto rests = [&](const StackedPair& pair) { return pair.resting && objects[pair.upper] == object; };
    const auto bends = [&](const StackedPair& pair) {
      return rests(pair) && radii[objects[pair.lower]] >= much_thicker * radii[object];
    };
    middle(sheet.vertices) = std::ranges::any_of(data.pairs, bends)
                                 ? bent_to(floor_of(data, sheets, bends), basis.op, sheet, radii[object])
                                 : moved_to(floor_of(data, sheets, rests), sheet, sheets.z);
    const Eigen::ArrayXd slope = evened(basis.op, sheet, slopes(basis.op, sheet, middle));
    const Eigen::ArrayXd tilt = (1 + slope.square()).sqrt().min(greatest_tilt);
    for (Eigen::Index row = 0; row < tilt.size(); ++row) {
      const Eigen::Index v = sheet.vertices[static_cast<std::size_t>(row)];
      sheets.thickness[v] = factored_thickness(basis, v, settings.thickness_of(object) * tilt[row]);
    }
    sheets.z(sheet.vertices) = draping.z(sheet.vertices) = middle(sheet.vertices);
    draping.objects.push_back(object);
  }
  std::sort(draping.objects.begin(), draping.objects.end());
  return draping;
}

}  // namespace croquis::silhouette
