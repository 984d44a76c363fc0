// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/silhouette/figure/arrangement.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <tuple>

#include "algorithms/silhouette/strokes/segment_grid.h"

namespace croquis::silhouette {
namespace {

using Drawn = ContourPath::Drawn;

/// A crossing as seen by one of its two segments.
struct Passage {
  Index contour = 0;
  Index segment = 0;
  double fraction = 0;
  Index crossing = 0;
  bool is_a = false;
};

struct RawCrossings {
  std::vector<Vec2> places;
  std::vector<int> signs;
  std::vector<Passage> passages;  ///< two per crossing
};

std::vector<GridSegment> path_segments(const std::vector<ContourPath>& contours) {
  std::vector<GridSegment> segments;
  for (Index c = 0; c < contours.size(); ++c) {
    const Points& points = contours[c].points;
    for (Index i = 0; i < points.size(); ++i) segments.push_back({points[i], points[(i + 1) % points.size()], c, i});
  }
  return segments;
}

RawCrossings find_crossings(const std::vector<ContourPath>& contours, double spacing) {
  RawCrossings raw;
  for (const SegmentContact& found : find_contacts(SegmentGrid(path_segments(contours), spacing))) {
    const auto crossing = static_cast<Index>(raw.places.size());
    raw.places.push_back(found.at);
    raw.signs.push_back(found.sign);
    raw.passages.push_back({found.a.line, found.a.position, found.fraction_a, crossing, true});
    raw.passages.push_back({found.b.line, found.b.position, found.fraction_b, crossing, false});
  }
  std::sort(raw.passages.begin(), raw.passages.end(), [](const Passage& x, const Passage& y) {
    return std::tuple(x.contour, x.segment, x.fraction, x.crossing) <
           std::tuple(y.contour, y.segment, y.fraction, y.crossing);
  });
  return raw;
}

/// Builds the contours with their crossings, one after the other.
class Crosser {
 public:
  Crosser(const std::vector<ContourPath>& contours, const VisibleCrossings& order, double spacing, double merging)
      : paths_(contours), order_(order), merging_(merging), raw_(find_crossings(contours, spacing)) {}

  Arrangement build() {
    result_.points = raw_.places;
    result_.crossings.resize(raw_.places.size());
    for (Index k = 0; k < raw_.places.size(); ++k) {
      result_.crossings[k].vertex = k;
      result_.crossings[k].sign = raw_.signs[k];
    }
    order_drawn_lines();
    auto passage = raw_.passages.cbegin();
    for (Index c = 0; c < paths_.size(); ++c) {
      const auto end = std::find_if(passage, raw_.passages.cend(), [c](const Passage& p) { return p.contour != c; });
      build_contour(c, {passage, end});
      passage = end;
    }
    build_arcs();
    return std::move(result_);
  }

 private:
  /// What is drawn over what is drawn.
  void order_drawn_lines() {
    std::vector<std::array<Index, 2>> lines(raw_.places.size(), {no_index, no_index});  // a's, b's
    for (const Passage& passage : raw_.passages) {
      lines[passage.crossing][passage.is_a ? 0 : 1] = paths_[passage.contour].line[passage.segment];
    }
    for (Index k = 0; k < lines.size(); ++k) {
      const auto [a, b] = lines[k];
      if (order_.in_front.contains({a, b})) result_.crossings[k].over = ContourCrossing::Over::A;
      if (order_.in_front.contains({b, a})) result_.crossings[k].over = ContourCrossing::Over::B;
    }
  }

  void build_contour(Index c, const std::vector<Passage>& passages) {
    const ContourPath& path = paths_[c];
    const auto count = static_cast<Index>(path.points.size());
    CrossedContour& contour = result_.contours.emplace_back();
    std::vector<std::vector<Passage>> on_segment(count);
    for (const Passage& passage : passages) on_segment[passage.segment].push_back(passage);
    for (Index i = 0; i < count; ++i) {
      const std::vector<Passage>& before = on_segment[(i + count - 1) % count];
      const bool gives_way = (!on_segment[i].empty() && on_segment[i].front().fraction < merging_) ||
                             (!before.empty() && before.back().fraction > 1 - merging_);
      const std::optional<std::size_t> cut = cut_of(path, i, on_segment[i]);
      const bool drawn_first = path.drawn[i] == Drawn::Yes || path.drawn[i] == Drawn::UntilCut;
      if (!gives_way) append(contour, new_point(path.points[i]), drawn_first, path, i);
      if (gives_way && !contour.vertices.empty() && on_segment[i].empty()) {
        // The sample is gone: its segment now starts at the crossing before it.
        contour.drawn.back() = drawn_first;
        contour.stroke.back() = path.stroke[i];
        contour.line.back() = path.line[i];
      }
      for (std::size_t k = 0; k < on_segment[i].size(); ++k) {
        append_crossing(c, on_segment[i][k], drawn_after(path.drawn[i], cut, k));
        if (cut == k) fix_over(on_segment[i][k]);
      }
    }
    if (!contour.vertices.empty()) settle_start(path, on_segment, contour);
  }

  /// When the first sample was dropped for a crossing on the last segment, that crossing begins the first segment.
  void settle_start(const ContourPath& path, const std::vector<std::vector<Passage>>& on_segment,
                    CrossedContour& contour) const {
    if (!on_segment.front().empty() || on_segment.back().empty()) return;
    if (on_segment.back().back().fraction <= 1 - merging_) return;
    contour.drawn.back() = path.drawn.front() == Drawn::Yes || path.drawn.front() == Drawn::UntilCut;
    contour.stroke.back() = path.stroke.front();
    contour.line.back() = path.line.front();
  }

  Index new_point(const Vec2& place) {
    result_.points.push_back(place);
    return static_cast<Index>(result_.points.size() - 1);
  }

  static void append(CrossedContour& contour, Index vertex, bool drawn, const ContourPath& path, Index segment) {
    contour.vertices.push_back(vertex);
    contour.drawn.push_back(drawn ? 1 : 0);
    contour.stroke.push_back(path.stroke[segment]);
    contour.line.push_back(path.line[segment]);
  }

  void append_crossing(Index c, const Passage& passage, bool drawn) {
    CrossedContour& contour = result_.contours[c];
    ContourCrossing& crossing = result_.crossings[passage.crossing];
    const auto position = static_cast<Index>(contour.vertices.size());
    (passage.is_a ? crossing.contour_a : crossing.contour_b) = c;
    (passage.is_a ? crossing.position_a : crossing.position_b) = position;
    append(contour, crossing.vertex, drawn, paths_[c], passage.segment);
  }

  /// Which of the crossings on a stem's last segment is its bar's.
  static std::optional<std::size_t> cut_of(const ContourPath& path, Index segment,
                                           const std::vector<Passage>& passages) {
    if (path.drawn[segment] != Drawn::UntilCut && path.drawn[segment] != Drawn::FromCut) return std::nullopt;
    std::optional<std::size_t> best;
    for (std::size_t k = 0; k < passages.size(); ++k) {
      const auto distance = [&](std::size_t i) { return std::abs(passages[i].fraction - path.cut[segment]); };
      if (!best || distance(k) < distance(*best)) best = k;
    }
    return best;
  }

  static bool drawn_after(Drawn drawn, const std::optional<std::size_t>& cut, std::size_t k) {
    switch (drawn) {
      case Drawn::Yes: return true;
      case Drawn::No: return false;
      case Drawn::UntilCut: return k < *cut;
      case Drawn::FromCut: return k >= *cut;
    }
    return false;
  }

  /// At a T-junction the other contour is in front.
  void fix_over(const Passage& stem) {
    result_.crossings[stem.crossing].over = stem.is_a ? ContourCrossing::Over::B : ContourCrossing::Over::A;
  }

  void build_arcs() {
    std::vector<char> is_crossing(result_.points.size(), 0);
    for (const ContourCrossing& crossing : result_.crossings) is_crossing[crossing.vertex] = 1;
    for (Index c = 0; c < result_.contours.size(); ++c) {
      const CrossedContour& contour = result_.contours[c];
      const auto count = static_cast<Index>(contour.vertices.size());
      std::vector<Index> starts;
      for (Index i = 0; i < count; ++i) {
        if (is_crossing[contour.vertices[i]]) starts.push_back(i);
      }
      if (starts.empty()) starts.push_back(0);
      const auto base = static_cast<Index>(result_.segments.size());
      for (Index i = 0; i < count; ++i) {
        result_.segments.push_back({contour.vertices[i], contour.vertices[(i + 1) % count]});
      }
      result_.segment_arc.resize(base + count);
      for (std::size_t k = 0; k < starts.size(); ++k) {
        const Index next = k + 1 < starts.size() ? starts[k + 1] : starts.front() + count;
        append_arc(c, starts[k], next - starts[k], base);
      }
    }
  }

  void append_arc(Index c, Index begin, Index length, Index base) {
    const CrossedContour& contour = result_.contours[c];
    const auto count = static_cast<Index>(contour.vertices.size());
    double drawn = 0, behind = 0, all = 0;
    for (Index k = 0; k < length; ++k) {
      const Index i = (begin + k) % count;
      const double size =
          (result_.points[contour.vertices[(i + 1) % count]] - result_.points[contour.vertices[i]]).norm();
      all += size;
      if (contour.drawn[i]) drawn += size;
      if (contour.drawn[i] && order_.behind.contains(contour.line[i])) behind += size;
      result_.segment_arc[base + i] = static_cast<Index>(result_.arcs.size());
    }
    result_.arcs.push_back({c, begin, length, 2 * drawn > all, 0});
    result_.may_be_covered.push_back(2 * drawn > all && 2 * behind > drawn ? 1 : 0);
  }

  const std::vector<ContourPath>& paths_;
  const VisibleCrossings& order_;
  double merging_;
  RawCrossings raw_;
  Arrangement result_;
};

}  // namespace

Arrangement cross_contours(const std::vector<ContourPath>& contours, const VisibleCrossings& order, double spacing,
                           double merging) {
  return Crosser(contours, order, spacing, merging).build();
}

ArcEnds arc_ends(const Arrangement& arrangement) {
  ArcEnds ends;
  for (const CrossedContour& contour : arrangement.contours) ends.arc_of_segment.emplace_back(contour.vertices.size());
  for (Index arc = 0; arc < arrangement.arcs.size(); ++arc) {
    const FigureArc& piece = arrangement.arcs[arc];
    std::vector<Index>& segments = ends.arc_of_segment[piece.contour];
    for (Index k = 0; k < piece.count; ++k) segments[(piece.begin + k) % segments.size()] = arc;
  }
  return ends;
}

}  // namespace croquis::silhouette
