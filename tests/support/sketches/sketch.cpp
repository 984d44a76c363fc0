// SPDX-License-Identifier: GPL-3.0-or-later
#include "support/sketches/sketch.h"

#include <algorithm>
#include <numeric>
#include <optional>
#include <stdexcept>

namespace croquis::test {
namespace {

struct Segment {
  int contour;
  int index;
  Vec2 from;
  Vec2 to;
};

/// A crossing as met while walking along one of its two contours.
struct Meeting {
  double where;  ///< point index plus fraction along the contour
  int crossing;
  int sink;  ///< change of the number of surfaces in front
};

struct Arc {
  int first;  ///< meeting it starts at, -1 for a whole contour
  int last;
  int depth;
  int layers;  ///< on its surface side
};

struct Walk {
  std::vector<Meeting> meetings;
  std::vector<Arc> arcs;
};

int size_of(const TrueContour& contour) { return static_cast<int>(contour.points.size()); }

const Vec2& point(const TrueContour& contour, int index) {
  return contour.points[static_cast<std::size_t>(index % size_of(contour))];
}

std::vector<Segment> all_segments(const std::vector<TrueContour>& contours) {
  std::vector<Segment> segments;
  for (int c = 0; c < static_cast<int>(contours.size()); ++c) {
    const TrueContour& contour = contours[static_cast<std::size_t>(c)];
    for (int i = 0; i < size_of(contour); ++i) segments.push_back({c, i, point(contour, i), point(contour, i + 1)});
  }
  return segments;
}

double low_x(const Segment& s) { return std::min(s.from.x(), s.to.x()); }
double high_x(const Segment& s) { return std::max(s.from.x(), s.to.x()); }

bool left_or_on(const Vec2& a, const Vec2& b, const Vec2& p) { return cross(b - a, p - a) >= 0; }

/// "On the line" counts as left, so a polyline through a vertex of another is met once, not twice or never.
bool segments_cross(const Segment& a, const Segment& b) {
  return left_or_on(a.from, a.to, b.from) != left_or_on(a.from, a.to, b.to) &&
         left_or_on(b.from, b.to, a.from) != left_or_on(b.from, b.to, a.to);
}

bool adjacent(const Segment& a, const Segment& b, const std::vector<TrueContour>& contours) {
  if (a.contour != b.contour) return false;
  const int size = size_of(contours[static_cast<std::size_t>(a.contour)]);
  const int apart = std::abs(a.index - b.index);
  return apart <= 1 || apart == size - 1;
}

double height_at(const TrueContour& contour, int index, double fraction) {
  const auto at = [&](int i) { return contour.height[static_cast<std::size_t>(i % size_of(contour))]; };
  return (1 - fraction) * at(index) + fraction * at(index + 1);
}

/// Notes the crossing of two segments with both contours.
void meet(const Segment& a, const Segment& b, const std::vector<TrueContour>& contours, SketchTruth& truth,
          std::vector<Walk>& walks) {
  const Vec2 da = a.to - a.from;
  const Vec2 db = b.to - b.from;
  const double turn = cross(da, db);
  const double ta = cross(b.from - a.from, db) / turn;
  const double tb = cross(b.from - a.from, da) / turn;
  const bool a_over = height_at(contours[static_cast<std::size_t>(a.contour)], a.index, ta) >
                      height_at(contours[static_cast<std::size_t>(b.contour)], b.index, tb);
  const int id = static_cast<int>(truth.places.size());
  // The surface of a lies left of da: b enters it when it turns left there.
  const int b_enters_a = turn > 0 ? 1 : -1;
  walks[static_cast<std::size_t>(a.contour)].meetings.push_back({a.index + ta, id, a_over ? 0 : -b_enters_a});
  walks[static_cast<std::size_t>(b.contour)].meetings.push_back({b.index + tb, id, a_over ? b_enters_a : 0});
  truth.places.push_back({a.from + ta * da, a_over ? a.contour : b.contour, a_over ? b.contour : a.contour,
                          std::abs(turn) / (da.norm() * db.norm())});
}

/// Sweeps over x, so that only segments side by side are compared.
void find_crossings(const std::vector<TrueContour>& contours, SketchTruth& truth, std::vector<Walk>& walks) {
  std::vector<Segment> segments = all_segments(contours);
  std::stable_sort(segments.begin(), segments.end(),
                   [](const Segment& a, const Segment& b) { return low_x(a) < low_x(b); });
  for (std::size_t i = 0; i < segments.size(); ++i) {
    for (std::size_t k = i + 1; k < segments.size() && low_x(segments[k]) <= high_x(segments[i]); ++k) {
      if (adjacent(segments[i], segments[k], contours) || !segments_cross(segments[i], segments[k])) continue;
      meet(segments[i], segments[k], contours, truth, walks);
    }
  }
}

/// Layers on the surface side of a contour between two places, seen beside its middle.
int layers_beside(const SketchTruth& truth, const TrueContour& contour, double from, double to) {
  const double middle = (from + to) / 2;
  const int index = static_cast<int>(middle);
  const Vec2 direction = point(contour, index + 1) - point(contour, index);
  const Vec2 on = point(contour, index) + (middle - index) * direction;
  return layers_at(truth, on + 1e-5 * left_of(direction.normalized()));
}

void cut_into_arcs(const TrueContour& contour, const SketchTruth& truth, Walk& walk) {
  auto& meetings = walk.meetings;
  std::sort(meetings.begin(), meetings.end(), [](const Meeting& a, const Meeting& b) { return a.where < b.where; });
  if (meetings.empty()) {
    walk.arcs.push_back({-1, -1, 0, 0});
    return;
  }
  int depth = 0;
  int lowest = 0;
  const int count = static_cast<int>(meetings.size());
  for (int i = 0; i < count; ++i) {
    const int next = (i + 1) % count;
    const double from = meetings[static_cast<std::size_t>(i)].where;
    const double to = meetings[static_cast<std::size_t>(next)].where + (next == 0 ? size_of(contour) : 0);
    depth += meetings[static_cast<std::size_t>(i)].sink;
    lowest = std::min(lowest, depth);
    walk.arcs.push_back({i, next, depth, layers_beside(truth, contour, from, to)});
  }
  if (depth != 0) throw std::logic_error("the heights of the sketch contradict each other");
  for (Arc& arc : walk.arcs) arc.depth -= lowest;
}

void append_stroke(Drawing& drawing, const std::vector<Vec2>& points, bool closed) {
  drawing.strokes.push_back(stroke_of("s" + std::to_string(drawing.strokes.size()), points, closed));
}

/// The contour from one meeting to another, without samples that all but repeat the two ends.
std::vector<Vec2> piece(const TrueContour& contour, const Meeting& from, const Meeting& to, const SketchTruth& truth) {
  std::vector<Vec2> points{truth.places[static_cast<std::size_t>(from.crossing)].at};
  const double end = to.where > from.where ? to.where : to.where + size_of(contour);
  for (int i = static_cast<int>(from.where) + 1; i < end; ++i) {
    if (i - from.where > 0.2 && end - i > 0.2) points.push_back(point(contour, i));
  }
  points.push_back(truth.places[static_cast<std::size_t>(to.crossing)].at);
  return points;
}

/// One stroke per longest run of visible arcs.
void draw_contour(const TrueContour& contour, const Walk& walk, const SketchTruth& truth, Drawing& drawing) {
  const std::size_t count = walk.arcs.size();
  const auto visible = [&](std::size_t i) { return walk.arcs[i % count].depth == 0; };
  std::size_t start = 0;
  while (start < count && !(visible(start) && !visible(start + count - 1))) ++start;
  if (start == count) {
    append_stroke(drawing, contour.points, true);
    return;
  }
  for (std::size_t i = start; i < start + count; ++i) {
    if (!visible(i) || visible(i + count - 1)) continue;
    std::size_t last = i;
    while (visible(last + 1)) ++last;
    const auto& from = walk.meetings[static_cast<std::size_t>(walk.arcs[i % count].first)];
    const auto& to = walk.meetings[static_cast<std::size_t>(walk.arcs[last % count].last)];
    append_stroke(drawing, piece(contour, from, to, truth), false);
  }
}

void count_arcs(const std::vector<Walk>& walks, SketchTruth& truth) {
  for (const Walk& walk : walks) {
    for (const Arc& arc : walk.arcs) {
      const auto depth = static_cast<std::size_t>(arc.depth);
      if (truth.depth_histogram.size() <= depth) truth.depth_histogram.resize(depth + 1, 0);
      ++truth.depth_histogram[depth];
      ++truth.arcs;
      if (arc.depth > 0) ++truth.hidden_arcs;
    }
  }
}

/// Contours that hang together through crossings share a number.
std::vector<int> connected_groups(const SketchTruth& truth) {
  std::vector<int> group(truth.outlines.size());
  std::iota(group.begin(), group.end(), 0);
  for (const TrueCrossing& crossing : truth.places) {
    const int kept = group[static_cast<std::size_t>(crossing.over)];
    const int gone = group[static_cast<std::size_t>(crossing.under)];
    std::replace(group.begin(), group.end(), gone, kept);
  }
  return group;
}

/// Layers that surround a connected group of contours: it cuts a hole into that many panels.
int layers_around(const SketchTruth& truth, const std::vector<int>& group, int number) {
  const auto member = std::find(group.begin(), group.end(), number);
  if (member == group.end()) return 0;
  const Vec2 place = truth.outlines[static_cast<std::size_t>(member - group.begin())].points.front();
  int layers = 0;
  for (std::size_t i = 0; i < group.size(); ++i) {
    if (group[i] != number) layers += winding(truth.outlines[i].points, place);
  }
  return layers;
}

/// Panels from Euler's formula of the region M cut along all contours: V - E + F = chi, where an arc is lifted to as
/// many edges as it has layers on its surface side, a crossing to as many vertices as the fullest of its four corners,
/// and a group of contours inside a panel takes one from that panel's own characteristic.
int count_panels(const std::vector<Walk>& walks, const SketchTruth& truth) {
  int panels = std::accumulate(truth.euler_region.begin(), truth.euler_region.end(), 0);
  std::vector<int> fullest(truth.places.size(), 0);
  for (const Walk& walk : walks) {
    for (const Arc& arc : walk.arcs) {
      panels += arc.layers;
      for (const int end : {arc.first, arc.last}) {
        if (end < 0) continue;
        int& most = fullest[static_cast<std::size_t>(walk.meetings[static_cast<std::size_t>(end)].crossing)];
        most = std::max(most, arc.layers);
      }
    }
  }
  panels -= std::accumulate(fullest.begin(), fullest.end(), 0);
  const std::vector<int> group = connected_groups(truth);
  for (int number = 0; number < static_cast<int>(group.size()); ++number) panels += layers_around(truth, group, number);
  return panels;
}

}  // namespace

int winding(const std::vector<Vec2>& loop, const Vec2& place) {
  int turns = 0;
  for (std::size_t i = 0; i < loop.size(); ++i) {
    const Vec2& a = loop[i];
    const Vec2& b = loop[(i + 1) % loop.size()];
    const bool up = a.y() <= place.y() && b.y() > place.y();
    const bool down = a.y() > place.y() && b.y() <= place.y();
    if (up && cross(b - a, place - a) > 0) ++turns;
    if (down && cross(b - a, place - a) < 0) --turns;
  }
  return turns;
}

int layers_at(const SketchTruth& truth, const Vec2& place) {
  int layers = 0;
  for (const TrueContour& contour : truth.outlines) layers += winding(contour.points, place);
  return layers;
}

Sketch draw_visible(std::vector<TrueContour> contours, std::vector<int> euler_region) {
  Sketch sketch;
  SketchTruth& truth = sketch.truth;
  truth.euler_region = std::move(euler_region);
  for (const int euler : truth.euler_region) truth.euler_mesh.push_back(2 * euler);
  truth.components = static_cast<int>(truth.euler_region.size());
  truth.contours = static_cast<int>(contours.size());
  truth.outlines = std::move(contours);

  std::vector<Walk> walks(truth.outlines.size());
  find_crossings(truth.outlines, truth, walks);
  truth.crossings = static_cast<int>(truth.places.size());
  for (std::size_t i = 0; i < walks.size(); ++i) {
    cut_into_arcs(truth.outlines[i], truth, walks[i]);
    draw_contour(truth.outlines[i], walks[i], truth, sketch.drawing);
  }
  truth.strokes = static_cast<int>(sketch.drawing.strokes.size());
  count_arcs(walks, truth);
  truth.panels = count_panels(walks, truth);
  return sketch;
}

Stroke stroke_of(const std::string& id, const std::vector<Vec2>& points, bool closed) {
  Stroke stroke;
  stroke.id = id;
  stroke.closed = closed;
  for (const Vec2& point : points) stroke.samples.push_back({point});
  return stroke;
}

}  // namespace croquis::test
