// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/silhouette/cage/quad_sheet.h"

#include <algorithm>
#include <map>
#include <utility>

#include "algorithms/silhouette/skeleton/triangle_corners.h"
#include "croquis/geometry/disjoint_sets.h"

namespace croquis::silhouette {
namespace {

/// Of a chord: where a ring of eight vertices, seen from its side, has the second one.
constexpr double second_of_ring = 0.146;

/// Vertices on a cut, from left to right.
using CutRow = std::array<Index, 5>;

/// One end of a limb.
struct LimbSide {
  Index limb = 0;
  bool at_end = false;
};

/// Four quads, or two where one of the rows is a tip.
void add_faces_between(const CutRow& low, const CutRow& high, std::vector<std::array<Index, 4>>& faces) {
  if (high[0] == high[4]) {
    faces.push_back({low[0], low[1], low[2], high[0]});
    faces.push_back({low[2], low[3], low[4], high[0]});
  } else if (low[0] == low[4]) {
    faces.push_back({low[0], high[2], high[1], high[0]});
    faces.push_back({low[0], high[4], high[3], high[2]});
  } else {
    for (std::size_t i = 0; i < 4; ++i) faces.push_back({low[i], low[i + 1], high[i + 1], high[i]});
  }
}

class SheetBuilder {
 public:
  explicit SheetBuilder(const LimbedRegion& region) : region_(region), merged_(region.triangles) {}

  QuadSheet build() {
    for (Index l = 0; l < region_.limbs.size(); ++l) {
      const CageLimb& limb = region_.limbs[l];
      for (const bool at_end : {false, true}) {
        if (limb.gates[at_end] != no_index) sides_[limb.gates[at_end]] = {l, at_end};
      }
      const bool joins = limb.rings == 0 && merged_.root(limb.gates[0] / 3) != merged_.root(limb.gates[1] / 3);
      if (joins) merged_.unite(limb.gates[0] / 3, limb.gates[1] / 3);
      joins_.push_back(joins);
      cuts_.push_back({});
      if (joins) continue;
      CageLimb cut = limb;
      cut.rings = std::max<std::size_t>(limb.rings, 1);
      cuts_.back() = ring_cuts(region_, cut);
      rows_[l].resize(cuts_.back().size());
    }
    std::vector<bool> done(region_.triangles, false);
    std::vector<std::vector<LimbSide>> polygons;
    for (const Index t : region_.junctions) {
      const Index root = merged_.root(t);
      if (done[root]) continue;
      done[root] = true;
      polygons.emplace_back();
      for (Index corner = 0; corner < 3; ++corner) collect_sides(3 * t + corner, polygons.back());
    }
    for (const std::vector<LimbSide>& polygon : polygons) add_corners(polygon);
    for (Index l = 0; l < region_.limbs.size(); ++l) {
      if (!joins_[l]) add_rim_vertices(l);
    }
    part_rim_vertices();
    for (Index l = 0; l < region_.limbs.size(); ++l) {
      if (!joins_[l]) add_limb(l);
    }
    for (const std::vector<LimbSide>& polygon : polygons) add_junction(polygon);
    even_junctions();
    return std::move(sheet_);
  }

 private:
  /// Out of a junction through a gate: the limb there, or what lies beyond one that is too short, counter-clockwise.
  void collect_sides(Index gate, std::vector<LimbSide>& polygon) const {
    const LimbSide side = sides_.at(gate);
    if (!joins_[side.limb]) {
      polygon.push_back(side);
      return;
    }
    const Index entry = region_.limbs[side.limb].gates[side.at_end ? 0 : 1];
    const Index t = entry / 3, corner = entry % 3;
    collect_sides(3 * t + next(corner), polygon);
    collect_sides(3 * t + previous(corner), polygon);
  }

  CutRow& row(const LimbSide& side) {
    std::vector<CutRow>& rows = rows_[side.limb];
    return side.at_end ? rows.back() : rows.front();
  }

  /// Of the cut at a limb's end, seen from the junction: where its side begins, counter-clockwise, and where it ends.
  std::pair<double, double> ends_of(const LimbSide& side) const {
    const std::vector<LimbCut>& cuts = cuts_[side.limb];
    const LimbCut& cut = side.at_end ? cuts.back() : cuts.front();
    return side.at_end ? std::pair(cut.left, cut.right) : std::pair(cut.right, cut.left);
  }

  Index add_vertex(const QuadVertex& vertex) {
    sheet_.vertices.push_back(vertex);
    return static_cast<Index>(sheet_.vertices.size() - 1);
  }

  Index add_rim_vertex(Index rim, double at) {
    rim_next_.push_back(no_index);
    return add_vertex({region_.rims[rim].place_at(at), rim, at, no_index});
  }

  /// Two limbs meet in every corner of a junction.
  void add_corners(const std::vector<LimbSide>& polygon) {
    for (std::size_t i = 0; i < polygon.size(); ++i) {
      const LimbSide &side = polygon[i], &before = polygon[i > 0 ? i - 1 : polygon.size() - 1];
      const CageLimb& limb = region_.limbs[side.limb];
      const Index rim = side.at_end ? limb.left_rim : limb.right_rim;
      const double length = region_.rims[rim].length;
      const double here = ends_of(side).first;
      const double apart = std::remainder(here - ends_of(before).second, length);
      const Index corner = add_rim_vertex(rim, here - apart / 2);
      row(side)[side.at_end ? 0 : 4] = corner;
      row(before)[before.at_end ? 4 : 0] = corner;
    }
  }

  void add_rim_vertices(Index l) {
    const CageLimb& limb = region_.limbs[l];
    std::vector<CutRow>& rows = rows_[l];
    for (std::size_t k = 0; k < rows.size(); ++k) {
      const bool is_start = k == 0, is_end = k + 1 == rows.size();
      if (is_end && limb.ends[1] == LimbEnd::Loop) {
        rows[k] = rows[0];
      } else if ((is_start && limb.ends[0] == LimbEnd::Tip) || (is_end && limb.ends[1] == LimbEnd::Tip)) {
        rows[k].fill(add_rim_vertex(limb.right_rim, cuts_[l][k].right));
        ++sheet_.tips;
      } else if (!(is_start || is_end) || limb.ends[0] == LimbEnd::Loop) {
        rows[k][0] = add_rim_vertex(limb.left_rim, cuts_[l][k].left);
        rows[k][4] = add_rim_vertex(limb.right_rim, cuts_[l][k].right);
      }
    }
    for (std::size_t k = 0; k + 1 < rows.size(); ++k) {
      rim_next_[rows[k][4]] = rows[k + 1][4];
      rim_next_[rows[k + 1][0]] = rows[k][0];
    }
  }

  /// Where vertices of a rim fall together, or nearly, they are moved apart along it.
  void part_rim_vertices() {
    constexpr double least_gap = 0.25;  // of the mean one of the vertices around
    constexpr int passes = 60;
    std::vector<bool> seen(sheet_.vertices.size(), false);
    for (Index first = 0; first < seen.size(); ++first) {
      if (seen[first]) continue;
      std::vector<Index> cycle;
      for (Index v = first; !seen[v]; v = rim_next_[v]) {
        seen[v] = true;
        cycle.push_back(v);
      }
      part_cycle(cycle, region_.rims[sheet_.vertices[first].rim], least_gap, passes);
    }
  }

  void part_cycle(const std::vector<Index>& cycle, const RimLine& rim, double least_gap, int passes) {
    const std::size_t count = cycle.size();
    std::vector<double> step(count);
    double sum = 0;
    for (std::size_t i = 0; i < count; ++i) {
      const double to = sheet_.vertices[cycle[(i + 1) % count]].at, from = sheet_.vertices[cycle[i]].at;
      step[i] = std::remainder(to - from, rim.length);
      // Half of the rim and more is a step forward, a little less than none is none.
      if (step[i] < -rim.length / 8) step[i] += rim.length;
      step[i] = std::max(step[i], 0.0);
      sum += step[i];
    }
    const double begin = sheet_.vertices[cycle[0]].at;
    for (double& one : step) one *= rim.length / sum;
    for (int pass = 0; pass < passes; ++pass) {
      for (std::size_t i = 0; i < count; ++i) {
        double& before = step[(i + count - 1) % count];
        double& after = step[(i + 1) % count];
        const double least = least_gap * (before + step[i] + after) / 3;
        if (step[i] >= least) continue;
        const double lacks = least - step[i], both = before + after;
        before -= lacks * before / both;
        after -= lacks * after / both;
        step[i] = least;
      }
    }
    double at = begin;
    for (std::size_t i = 0; i < count; ++i) {
      QuadVertex& vertex = sheet_.vertices[cycle[i]];
      vertex.at = at;
      vertex.place = rim.place_at(at);
      at += step[i];
    }
  }

  const Vec2& place(Index vertex) const { return sheet_.vertices[vertex].place; }

  Index add_inner(const Vec2& at, Index before) { return add_vertex({at, no_index, 0, before}); }

  void fill_row(CutRow& row) {
    const Vec2 left = place(row[0]), along = place(row[4]) - left;
    row[1] = add_inner(left + second_of_ring * along, row[0]);
    row[2] = add_inner(left + along / 2, row[1]);
    row[3] = add_inner(left + (1 - second_of_ring) * along, row[4]);
  }

  void add_limb(Index l) {
    const CageLimb& limb = region_.limbs[l];
    std::vector<CutRow>& rows = rows_[l];
    const bool loops = limb.ends[0] == LimbEnd::Loop;
    for (std::size_t k = 0; k < rows.size(); ++k) {
      if (loops && k + 1 == rows.size()) {
        rows[k] = rows[0];
      } else if (rows[k][0] != rows[k][4]) {
        fill_row(rows[k]);
      }
    }
    for (std::size_t k = 0; k + 1 < rows.size(); ++k) add_faces_between(rows[k], rows[k + 1], sheet_.faces);
  }

  void add_junction(const std::vector<LimbSide>& polygon) {
    const std::size_t count = polygon.size();
    std::vector<CutRow> rows;  // counter-clockwise
    Vec2 centre = Vec2::Zero();
    for (const LimbSide& side : polygon) {
      CutRow own = row(side);
      if (!side.at_end) std::ranges::reverse(own);
      rows.push_back(own);
      centre += place(own[2]) / static_cast<double>(count);
    }
    const Index middle = add_inner(centre, rows[0][2]);
    movable_.push_back(middle);
    std::vector<Index> spokes;
    for (const CutRow& own : rows) spokes.push_back(add_inner((place(own[2]) + centre) / 2, own[2]));
    for (std::size_t i = 0; i < count; ++i) {
      const CutRow &own = rows[i], &last = rows[i > 0 ? i - 1 : count - 1];
      const Index spoke = spokes[i], last_spoke = spokes[i > 0 ? i - 1 : count - 1];
      const Vec2 inside = (place(own[1]) + place(last[3]) + place(spoke) + place(last_spoke)) / 4;
      const Index face = add_inner(inside, own[1]);
      for (const Index v : {face, spoke, own[2]}) movable_.push_back(v);
      sheet_.faces.push_back({own[0], own[1], face, last[3]});
      sheet_.faces.push_back({own[1], own[2], spoke, face});
      sheet_.faces.push_back({face, spoke, middle, last_spoke});
      sheet_.faces.push_back({last[3], face, last_spoke, last[2]});
    }
  }

  /// What lies inside of junctions goes to the middle of its neighbours.
  void even_junctions() {
    constexpr int passes = 10;
    std::vector<Vec2> sum(sheet_.vertices.size());
    std::vector<double> count(sum.size());
    for (int pass = 0; pass < passes; ++pass) {
      std::ranges::fill(sum, Vec2::Zero());
      std::ranges::fill(count, 0);
      for (const std::array<Index, 4>& face : sheet_.faces) {
        for (std::size_t i = 0; i < 4; ++i) {
          for (const std::size_t k : {i + 1, i + 3}) sum[face[i]] += place(face[k % 4]);
          count[face[i]] += 2;
        }
      }
      for (const Index v : movable_) sheet_.vertices[v].place = sum[v] / count[v];
    }
  }

  const LimbedRegion& region_;
  DisjointSets merged_;                        ///< junctions
  std::vector<bool> joins_;                    ///< per limb: its junctions are one
  std::map<Index, LimbSide> sides_;            ///< by gates
  std::vector<std::vector<LimbCut>> cuts_;     ///< per limb
  std::map<Index, std::vector<CutRow>> rows_;  ///< per limb
  std::vector<Index> rim_next_;                ///< per rim vertex, which come first
  std::vector<Index> movable_;                 ///< inside of junctions
  QuadSheet sheet_;
};

}  // namespace

QuadSheet quad_sheet(const LimbedRegion& region) { return SheetBuilder(region).build(); }

}  // namespace croquis::silhouette
