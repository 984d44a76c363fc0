// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/subdivision/refinement/point_rules.h"

#include <algorithm>

#include "algorithms/subdivision/refinement/chain_rules.h"

namespace croquis::subdivision {
namespace {

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

PointRules make_point_rules(const Neighbourhood& near, const Rules& rules, const FaceMask& mask) {
  return Builder(near, rules, mask).run();
}

}  // namespace croquis::subdivision
