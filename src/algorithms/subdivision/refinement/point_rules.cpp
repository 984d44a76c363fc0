// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/subdivision/refinement/point_rules.h"

#include <algorithm>
#include <numbers>

namespace croquis::subdivision {
namespace {

/// Faces up to this size have their roots tabled; larger ones are rare.
constexpr std::size_t largest_tabled = 32;

/// cos and sin of an angle of at most an eighth of a turn, by their series.
Vec2 cos_sin(double angle) {
  const double square = angle * angle;
  double cosine = 1, sine = 1;
  for (int k = 20; k > 0; k -= 2) {
    cosine = 1 - cosine * square / (k * (k - 1));
    sine = 1 - sine * square / (k * (k + 1));
  }
  return {cosine, sine * angle};
}

/// One point as weights of old vertices; a vertex may come more than once.
struct WeightedVertex {
  Index vertex;
  double weight;
};

using WeightRow = std::vector<WeightedVertex>;

/// Points of chains: Chaikin's 3/4 + 1/4, and their ends.
///
/// Lee, Joo, Hong 2002, figure 11, intersect the line of two new points with the tagged edge: for quads, planar or not,
/// that is exactly (3 V + W)/4, so it is taken for all faces, and a chain depends on its own vertices alone.
class ChainRules {
 public:
  ChainRules(const Neighbourhood& near, const Rules& rules, const FaceMask& mask)
      : near_(near), rules_(rules), mask_(mask) {}

  /// The point of a sharp edge at its end `end`, as NewPoints::chain.
  WeightRow chain_point(Index line, std::size_t end) const;

 private:
  bool stays(Index line, std::size_t end) const;
  bool pinned_dart(Index vertex) const;
  WeightRow smooth_dart(Index line, std::size_t end) const;

  const Neighbourhood& near_;
  const Rules& rules_;
  const FaceMask& mask_;
};

void append_scaled(WeightRow& row, const WeightRow& other, double factor) {
  for (const auto& [vertex, weight] : other) row.push_back({vertex, factor * weight});
}

bool ChainRules::pinned_dart(Index vertex) const {
  return near_.classes.class_of[vertex] == VertexClass::Dart &&
         (near_.classes.pinned[vertex] != 0 || rules_.chain_ends == ChainEnds::Pin);
}

/// Whether the chain's point is the old vertex itself: at pinned ends, and where the edge runs into a kept vertex
/// without a band.
bool ChainRules::stays(Index line, std::size_t end) const {
  const Index vertex = near_.classes.lines[line].vertices[end];
  return pinned_dart(vertex) || near_.points.chain(line, end) == near_.points.kept(vertex);
}

/// The middle between the plain points of the two faces beside the chain's end: it runs out into the surface.
WeightRow ChainRules::smooth_dart(Index line, std::size_t end) const {
  const SharpLine& sharp = near_.classes.lines[line];
  WeightRow row;
  for (std::size_t side = 0; side < 2; ++side) {
    const Index half_edge = sharp.half_edges[side];
    Index corner = side == end ? half_edge : near_.around.next(half_edge);
    const std::size_t n = near_.level.topology.face(near_.around.face(corner)).size();
    for (const double weight : mask_.row(n)) {
      row.push_back({near_.level.topology.corner_vertex[corner], 0.5 * weight});
      corner = near_.around.next(corner);
    }
  }
  return row;
}

WeightRow ChainRules::chain_point(Index line, std::size_t end) const {
  const SharpLine& sharp = near_.classes.lines[line];
  const Index here = sharp.vertices[end], there = sharp.vertices[1 - end];
  if (stays(line, end)) return {{here, 1}};
  if (near_.classes.class_of[here] == VertexClass::Dart && rules_.chain_ends == ChainEnds::Smooth) {
    return smooth_dart(line, end);
  }
  // Beside a point that stays, a clamped B-spline has a knot interval of half the length.
  if (rules_.profile == Profile::Clamped && stays(line, 1 - end)) return {{here, 0.5}, {there, 0.5}};
  return {{here, 0.75}, {there, 0.25}};
}

void sort_unique(std::vector<Index>& values) {
  std::sort(values.begin(), values.end());
  values.erase(std::unique(values.begin(), values.end()), values.end());
}

/// A corner's own point beside creases: `plain_share` of the plain rule and the rest of `row`.
struct AdjustedPoint {
  double plain_share = 1;
  WeightRow row;

  /// A step of the share `factor` towards another point.
  void blend(double factor, const WeightRow& other) {
    plain_share *= 1 - factor;
    for (WeightedVertex& entry : row) entry.weight *= 1 - factor;
    append_scaled(row, other, factor);
  }
};

class Builder {
 public:
  Builder(const Neighbourhood& near, const Rules& rules, const FaceMask& mask)
      : near_(near), mesh_(near.level.topology), rules_(rules), chains_(near, rules, mask) {}

  PointRules run() {
    for (const Index corner : near_.points.own().left_out()) result_.gap_faces.push_back(near_.around.face(corner));
    sort_unique(result_.gap_faces);
    for (const Index corner : corners_to_adjust()) adjust(corner);
    list_points();
    return std::move(result_);
  }

 private:
  Index next(Index corner) const { return near_.around.next(corner); }
  Index previous(Index corner) const { return near_.around.previous(corner); }

  double fractional_sharpness(Index half_edge) const {
    const Index edge = mesh_.corner_edge[half_edge];
    const auto& sharp = near_.level.sharp;
    const auto found = std::lower_bound(sharp.begin(), sharp.end(), edge,
                                        [](const SharpEdge& tag, Index value) { return tag.edge < value; });
    return found != sharp.end() && found->edge == edge && found->sharpness < 1 ? found->sharpness : 0;
  }

  /// Whether the half-edge's face runs beside a chain without a band.
  bool beside_chain(Index half_edge) const {
    const Index line = near_.classes.line_of_edge[mesh_.corner_edge[half_edge]];
    if (line == no_index) return false;
    const std::size_t side = near_.classes.lines[line].half_edges[0] == half_edge ? 0 : 1;
    return !near_.sectors.side_banded[2 * line + side];
  }

  WeightRow chain_point(Index half_edge, Index vertex) const {
    const Index line = near_.classes.line_of_edge[mesh_.corner_edge[half_edge]];
    return chains_.chain_point(line, near_.classes.lines[line].end_at(vertex));
  }

  /// Corners one step away from an unbanded chain, and those at edges of fractional sharpness.
  std::vector<Index> corners_to_adjust() const {
    std::vector<Index> corners;
    for (const SharpLine& line : near_.classes.lines) {
      for (const Index half_edge : line.half_edges) {
        if (rules_.profile == Profile::Plain || half_edge == no_index || !beside_chain(half_edge)) continue;
        corners.push_back(previous(half_edge));
        corners.push_back(next(next(half_edge)));
      }
    }
    for (const auto& [edge, sharpness] : near_.level.sharp) {
      if (sharpness >= 1) continue;
      const Index half_edge = mesh_.edge_corner[edge];
      for (const Index h : {half_edge, mesh_.twin[half_edge]}) {
        corners.push_back(h);
        corners.push_back(next(h));
      }
    }
    sort_unique(corners);
    std::erase_if(corners, [&](Index corner) { return !near_.points.own().keeps(corner); });
    return corners;
  }

  void adjust(Index corner) {
    AdjustedPoint point;
    if (rules_.profile == Profile::Clamped) {
      if (mesh_.face(near_.around.face(corner)).size() == 4) {
        clamp_in_quad(corner, point);
      } else {
        clamp_in_polygon(corner, point);
      }
    }
    blend_fractional(corner, point);
    if (point.row.empty()) return;
    result_.adjusted_corner.push_back(corner);
    result_.plain_share.push_back(point.plain_share);
    append(point.row, result_.adjusted);
  }

  /// The bilinear point at (a,b) from the corner: 1/2 instead of 1/4 where the edge across is a chain.
  void clamp_in_quad(Index corner, AdjustedPoint& point) const {
    const Index after = next(corner), across = next(after), before = next(across);
    const double a = beside_chain(after) ? 0.5 : 0.25;
    const double b = beside_chain(across) ? 0.5 : 0.25;
    if (a == 0.25 && b == 0.25) return;
    point.plain_share = 0;
    point.row = {{mesh_.corner_vertex[corner], (1 - a) * (1 - b)},
                 {mesh_.corner_vertex[after], a * (1 - b)},
                 {mesh_.corner_vertex[across], a * b},
                 {mesh_.corner_vertex[before], (1 - a) * b}};
  }

  /// A third of the way to the chain's points on the edges one step further.
  void clamp_in_polygon(Index corner, AdjustedPoint& point) const {
    const Index after = next(corner), before = previous(corner);
    if (beside_chain(after)) point.blend(1.0 / 3, chain_point(after, mesh_.corner_vertex[after]));
    const Index earlier = previous(before);
    if (beside_chain(earlier)) point.blend(1.0 / 3, chain_point(earlier, mesh_.corner_vertex[before]));
  }

  /// DeRose, Kass, Truong 1998: between two whole numbers of sharpness the points are blended.
  void blend_fractional(Index corner, AdjustedPoint& point) const {
    const Index before = previous(corner), vertex = mesh_.corner_vertex[corner];
    const double after_share = fractional_sharpness(corner), before_share = fractional_sharpness(before);
    const double sum = after_share + before_share;
    if (sum == 0) return;
    const WeightRow target = {{vertex, 0.75},
                              {mesh_.corner_vertex[next(corner)], 0.25 * after_share / sum},
                              {mesh_.corner_vertex[before], 0.25 * before_share / sum}};
    point.blend(std::max(after_share, before_share), target);
  }

  void list_points() {
    for (const VertexOrigin& origin : near_.points.listed()) {
      switch (origin.kind) {
        case PointKind::Kept: append({{origin.vertex, 1}}, result_.listed); break;
        case PointKind::Spoke:
          append({{origin.vertex, 0.75}, {other_end(origin.element, origin.vertex), 0.25}}, result_.listed);
          break;
        default: append(chain_point(mesh_.edge_corner[origin.element], origin.vertex), result_.listed);
      }
    }
  }

  Index other_end(Index edge, Index vertex) const {
    const Index corner = mesh_.edge_corner[edge];
    return mesh_.corner_vertex[corner] == vertex ? mesh_.corner_vertex[next(corner)] : mesh_.corner_vertex[corner];
  }

  static void append(const WeightRow& row, WeightRows& rows) {
    for (const auto& [vertex, weight] : row) {
      if (weight != 0) rows.add(vertex, weight);
    }
    rows.end_row();
  }

  const Neighbourhood& near_;
  const HalfEdges& mesh_;
  const Rules& rules_;
  const ChainRules chains_;
  PointRules result_;
};

}  // namespace

Vec2 unit_root(std::size_t j, std::size_t n) {
  j %= n;
  if (2 * j > n) return unit_root(n - j, n).cwiseProduct(Vec2(1, -1));
  if (4 * j > n) {  // beyond a quarter: mirror; 2n and 2j keep the half of n whole
    return unit_root(n - 2 * j, 2 * n).cwiseProduct(Vec2(-1, 1));
  }
  if (8 * j > n) {  // beyond an eighth: cos and sin change places
    const Vec2 mirrored = unit_root(n - 4 * j, 4 * n);
    return {mirrored.y(), mirrored.x()};
  }
  return cos_sin(2 * std::numbers::pi * static_cast<double>(j) / static_cast<double>(n));
}

FaceMask::FaceMask(Weights weights) : weights_(weights) {
  for (std::size_t n = 1; n <= largest_tabled; ++n) {
    for (std::size_t j = 0; j < n; ++j) roots_.push_back(unit_root(j, n));
  }
}

Vec2 FaceMask::root(std::size_t j, std::size_t n) const {
  return n <= largest_tabled ? roots_[n * (n - 1) / 2 + j] : unit_root(j, n);
}

std::vector<double> FaceMask::row(std::size_t n) const {
  const auto count = static_cast<double>(n);
  std::vector<double> weights(n);
  if (weights_ == Weights::Average) {
    for (double& weight : weights) weight = 1 / (4 * count);
    weights[1] = weights[n - 1] = (count + 2) / (8 * count);
    weights[0] = (2 * count + 1) / (4 * count);
    return weights;
  }
  for (std::size_t j = 1; j < n; ++j) weights[j] = (3 + 2 * root(j, n).x()) / (4 * count);
  weights[0] = (count + 5) / (4 * count);
  return weights;
}

void FaceMask::apply_average(const Vec3* points, std::span<const Index> corners, Vec3* result) const {
  const std::size_t n = corners.size();
  Vec3 sum = Vec3::Zero();
  for (const Index corner : corners) sum += points[corner];
  const Vec3 centroid = sum / static_cast<double>(n);
  for (std::size_t j = 0; j < n; ++j) {
    const Vec3 &before = points[corners[(j + n - 1) % n]], &after = points[corners[(j + 1) % n]];
    result[j] = 0.5 * points[corners[j]] + 0.125 * (before + after) + 0.25 * centroid;
  }
}

void FaceMask::apply_to_polygon(const Vec3* points, std::span<const Index> corners, Vec3* result) const {
  if (weights_ == Weights::Average) return apply_average(points, corners, result);
  const std::size_t n = corners.size();
  Vec3 sum = Vec3::Zero(), cosine = Vec3::Zero(), sine = Vec3::Zero();
  for (std::size_t j = 0; j < n; ++j) {
    const Vec3& point = points[corners[j]];
    const Vec2 at = root(j, n);
    sum += point;
    cosine += at.x() * point;
    sine += at.y() * point;
  }
  const auto count = static_cast<double>(n);
  for (std::size_t j = 0; j < n; ++j) {
    const Vec2 at = root(j, n);
    result[j] = 0.25 * points[corners[j]] + (0.75 * sum + 0.5 * (at.x() * cosine + at.y() * sine)) / count;
  }
}

PointRules make_point_rules(const Neighbourhood& near, const Rules& rules, const FaceMask& mask) {
  return Builder(near, rules, mask).run();
}

}  // namespace croquis::subdivision
