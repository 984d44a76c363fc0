// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/silhouette/figure/nested_outlines.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <set>
#include <string>
#include <utility>

#include "algorithms/silhouette/strokes/drawing_findings.h"
#include "algorithms/silhouette/strokes/ring_shape.h"
#include "croquis/geometry/polyline.h"

namespace croquis::silhouette {
namespace {

int filled_side(const ContourPath& path) { return signed_area(path.points) >= 0 ? 1 : -1; }

class NestingReader {
 public:
  NestingReader(const Drawing& drawing, const std::vector<ContourPath>& paths, const Arrangement& arrangement,
                const Faces& faces)
      : drawing_(drawing), paths_(paths), neighbours_(paths.size()) {
    for (const ContourCrossing& crossing : arrangement.crossings) {
      if (crossing.contour_a == crossing.contour_b) continue;
      neighbours_[crossing.contour_a].insert(crossing.contour_b);
      neighbours_[crossing.contour_b].insert(crossing.contour_a);
    }
    find_surrounding(arrangement, faces);
  }

  /// From the outside in: what lies in a hole is no part of the surface around the hole.
  std::vector<NestedContour> read() {
    std::vector<Index> order;
    for (Index c = 0; c < paths_.size(); ++c) {
      if (around_[c] != no_index && paths_[c].side == 0) order.push_back(c);
    }
    std::sort(order.begin(), order.end(),
              [this](Index a, Index b) { return depth_of(a) != depth_of(b) ? depth_of(a) < depth_of(b) : a < b; });
    std::vector<char> is_hole(paths_.size(), 0);
    std::vector<NestedContour> nested;
    for (const Index c : order) {
      if (bounds_hole(around_[c], is_hole)) continue;
      NestedContour reading{c, around_[c], false, false};
      reading.chosen = told(c, reading.hole);
      if (!reading.chosen)
        reading.hole = is_hole_of_ring(paths_[c].points, paths_[around_[c]].points, things_beside(c));
      is_hole[c] = reading.hole ? 1 : 0;
      nested.push_back(reading);
    }
    return nested;
  }

 private:
  /// Contours lie in one another with all their samples or not at all, unless they cross.
  void find_surrounding(const Arrangement& arrangement, const Faces& faces) {
    around_.assign(paths_.size(), no_index);
    std::vector<double> area;
    for (const ContourPath& path : paths_) area.push_back(std::abs(signed_area(path.points)));
    std::vector<std::vector<Index>> face_beside(paths_.size());
    for (Index arc = 0; arc < arrangement.arcs.size(); ++arc) {
      face_beside[arrangement.arcs[arc].contour].push_back(faces.left[arc]);
      face_beside[arrangement.arcs[arc].contour].push_back(faces.right[arc]);
    }
    for (Index c = 0; c < paths_.size(); ++c) {
      for (Index o = 0; o < paths_.size(); ++o) {
        if (o == c || area[o] <= area[c] || neighbours_[c].contains(o)) continue;
        const bool inside = std::all_of(face_beside[c].begin(), face_beside[c].end(),
                                        [&](Index face) { return faces.winding[face][o] != 0; });
        if (inside && (around_[c] == no_index || area[o] < area[around_[c]])) around_[c] = o;
      }
    }
  }

  int depth_of(Index contour) const {
    int depth = 0;
    for (Index o = around_[contour]; o != no_index; o = around_[o]) ++depth;
    return depth;
  }

  bool bounds_hole(Index contour, const std::vector<char>& is_hole) const {
    if (is_hole[contour] != 0) return true;
    return paths_[contour].side != 0 && paths_[contour].side != filled_side(paths_[contour]);
  }

  std::string object_of(Index contour) const {
    for (const Index stroke : paths_[contour].strokes) {
      if (!drawing_.strokes[stroke].object.empty()) return drawing_.strokes[stroke].object;
    }
    return {};
  }

  bool told(Index contour, bool& hole) const {
    if (const std::optional<bool> by_kind = told_hole(drawing_, paths_[contour].strokes)) {
      hole = *by_kind;
      return true;
    }
    const std::string own = object_of(contour);
    const std::string other = object_of(around_[contour]);
    hole = own == other;
    return !own.empty() && (!other.empty() || !hole);
  }

  /// What covers the outline around or is covered by it, and what else lies within it.
  std::size_t things_beside(Index contour) const {
    const Index outer = around_[contour];
    std::size_t things = neighbours_[outer].size();
    for (Index c = 0; c < paths_.size(); ++c) {
      if (c != contour && around_[c] == outer && paths_[c].side == 0) ++things;
    }
    if (around_[outer] != no_index && paths_[outer].side == 0) things += 2;
    return things;
  }

  const Drawing& drawing_;
  const std::vector<ContourPath>& paths_;
  std::vector<std::set<Index>> neighbours_;  ///< per contour: those that cross it
  std::vector<Index> around_;                ///< per contour: the smallest that it lies in
};

}  // namespace

std::vector<NestedContour> nested_contours(const Drawing& drawing, const std::vector<ContourPath>& paths,
                                           const Arrangement& arrangement, const Faces& faces) {
  return NestingReader(drawing, paths, arrangement, faces).read();
}

std::vector<int> sides_with(const std::vector<NestedContour>& nested, const std::vector<ContourPath>& paths) {
  std::vector<int> sides;
  for (const ContourPath& path : paths) sides.push_back(path.side);
  for (const NestedContour& reading : nested) {
    sides[reading.contour] = (reading.hole ? -1 : 1) * filled_side(paths[reading.contour]);
  }
  return sides;
}

std::vector<NestedOutline> nested_outlines(const std::vector<NestedContour>& nested,
                                           const std::vector<ContourPath>& paths) {
  std::vector<NestedOutline> outlines;
  for (const auto& [contour, around, hole, chosen] : nested) {
    outlines.push_back(
        {paths[contour].strokes.front(), paths[around].strokes.front(), hole, chosen, paths[contour].points.front()});
  }
  return outlines;
}

Findings nested_findings(const Drawing& drawing, const LabelledFigure& figure) {
  Findings findings;
  for (const auto& [stroke, around, hole, chosen, at] : figure.nested) {
    if (chosen) continue;
    const std::string names = in_quotes(drawing, stroke) + " lies within " + in_quotes(drawing, around);
    Finding note = make_warning(Category::Geometry, "W_NESTED",
                                names + (hole ? " and was read as a hole: mark it as a part if it lies in front"
                                              : " and was read as a part in front: mark it as a hole if it is one"),
                                {stroke_subject(drawing, stroke, at)});
    note.severity = Severity::Info;
    findings.push_back(std::move(note));
  }
  return findings;
}

}  // namespace croquis::silhouette
