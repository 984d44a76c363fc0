// SPDX-License-Identifier: GPL-3.0-or-later
#include "silhouette/figure_fixtures.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <optional>
#include <queue>
#include <stdexcept>

#include "algorithms/silhouette/skeleton/chordal_axis.h"
#include "algorithms/silhouette/skeleton/depth.h"
namespace croquis::test {
namespace {

using namespace croquis::silhouette;
using std::numbers::pi;

/// Where one contour crosses another: segment and fraction on both.
struct Meeting {
  std::array<Index, 2> contour;
  std::array<double, 2> position;
  Vec2 at;
};

std::optional<std::array<double, 2>> crossing_of(const Vec2& a, const Vec2& b, const Vec2& c, const Vec2& d) {
  const double turn = cross(b - a, d - c);
  if (turn == 0) return std::nullopt;
  const double s = cross(c - a, d - c) / turn;
  const double t = cross(c - a, b - a) / turn;
  if (s <= 0 || s >= 1 || t <= 0 || t >= 1) return std::nullopt;
  return std::array{s, t};
}

struct Segment {
  Index contour;
  Index position;
  Vec2 begin;
  Vec2 end;
};

std::vector<Segment> segments_of(std::span<const FixtureContour> contours) {
  std::vector<Segment> segments;
  for (Index c = 0; c < contours.size(); ++c) {
    const auto& points = contours[c].points;
    for (Index i = 0; i < points.size(); ++i) {
      segments.push_back({c, i, points[i], points[(i + 1) % points.size()]});
    }
  }
  return segments;
}

std::vector<Meeting> meetings_of(std::span<const FixtureContour> contours) {
  const std::vector<Segment> segments = segments_of(contours);
  std::vector<Meeting> meetings;
  for (std::size_t i = 0; i < segments.size(); ++i) {
    const Segment& a = segments[i];
    const double reach = (a.end - a.begin).cwiseAbs().maxCoeff();
    for (std::size_t k = i + 1; k < segments.size(); ++k) {
      const Segment& b = segments[k];
      if ((b.begin - a.begin).cwiseAbs().maxCoeff() > 4 * reach) continue;
      const auto crossing = crossing_of(a.begin, a.end, b.begin, b.end);
      if (!crossing) continue;
      meetings.push_back({{a.contour, b.contour},
                          {a.position + (*crossing)[0], b.position + (*crossing)[1]},
                          a.begin + (*crossing)[0] * (a.end - a.begin)});
    }
  }
  return meetings;
}

/// The points of a contour with its crossings between them.
struct CutContour {
  std::vector<double> positions;          ///< along the fixture contour
  std::vector<Index> crossing_positions;  ///< of crossings among the vertices, ascending
};

void add_contour(const FixtureContour& contour, Index number, const std::vector<Meeting>& meetings,
                 LabelledFigure& figure, CutContour& cut) {
  std::map<double, Index> order;
  for (Index i = 0; i < contour.points.size(); ++i) {
    order[i] = static_cast<Index>(figure.points.size());
    figure.points.push_back(contour.points[i]);
  }
  for (Index m = 0; m < meetings.size(); ++m) {
    for (std::size_t side = 0; side < 2; ++side) {
      if (meetings[m].contour[side] == number) order[meetings[m].position[side]] = m;
    }
  }
  FigureContour result;
  result.side = contour.side;
  result.object = contour.object;
  for (const auto& [position, vertex] : order) {
    if (vertex < meetings.size()) cut.crossing_positions.push_back(static_cast<Index>(result.vertices.size()));
    result.vertices.push_back(vertex);
    cut.positions.push_back(position);
  }
  for (std::size_t i = 0; i < result.vertices.size(); ++i) {
    figure.segments.push_back({result.vertices[i], result.vertices[(i + 1) % result.vertices.size()]});
  }
  figure.segment_arc.resize(figure.segments.size());
  result.drawn.assign(result.vertices.size(), 1);
  figure.contours.push_back(std::move(result));
  figure.raw_contours.push_back(contour.points);
}

double middle_position(const CutContour& cut, const FigureArc& arc, std::size_t point_count) {
  const Index count = static_cast<Index>(cut.positions.size());
  const Index segment = (arc.begin + arc.count / 2) % count;
  double after = cut.positions[(segment + 1) % count];
  if (segment + 1 == count) after += static_cast<double>(point_count);
  return std::fmod((cut.positions[segment] + after) / 2, static_cast<double>(point_count));
}

void add_arc(FigureArc arc, const CutContour& cut, std::size_t point_count, const DepthAt& depth_at,
             FigureFixture& fixture) {
  LabelledFigure& figure = fixture.figure;
  FigureContour& contour = figure.contours[arc.contour];
  const Index count = static_cast<Index>(contour.vertices.size());
  arc.depth = depth_at(arc.contour, middle_position(cut, arc, point_count));
  arc.visible = arc.depth == 0;
  Stroke stroke;
  stroke.id = "s" + std::to_string(fixture.drawing.strokes.size());
  stroke.closed = arc.count == count;
  const std::size_t first = figure.segments.size() - count;  // the contour is the last one so far
  for (Index i = 0; i < arc.count; ++i) {
    const Index position = (arc.begin + i) % count;
    figure.segment_arc[first + position] = static_cast<Index>(figure.arcs.size());
    contour.drawn[position] = arc.visible ? 1 : 0;
    stroke.samples.push_back({figure.points[contour.vertices[position]]});
  }
  if (!stroke.closed) {
    stroke.samples.push_back({figure.points[contour.vertices[(arc.begin + arc.count) % count]]});
  }
  if (arc.visible) {
    contour.strokes.push_back(static_cast<Index>(fixture.drawing.strokes.size()));
    figure.objects[contour.object].strokes.push_back(contour.strokes.back());
    fixture.drawing.strokes.push_back(std::move(stroke));
  }
  figure.arcs.push_back(arc);
}

void add_arcs(Index contour, const CutContour& cut, std::size_t point_count, const DepthAt& depth_at,
              FigureFixture& fixture) {
  const Index count = static_cast<Index>(fixture.figure.contours[contour].vertices.size());
  const std::vector<Index>& crossings = cut.crossing_positions;
  if (crossings.empty()) add_arc({contour, 0, count}, cut, point_count, depth_at, fixture);
  for (std::size_t i = 0; i < crossings.size(); ++i) {
    const Index end = i + 1 < crossings.size() ? crossings[i + 1] : crossings.front() + count;
    add_arc({contour, crossings[i], end - crossings[i]}, cut, point_count, depth_at, fixture);
  }
}

/// Depth of the segment after a position of a contour.
int depth_after(const LabelledFigure& figure, Index contour, Index position) {
  const Index count = static_cast<Index>(figure.contours[contour].vertices.size());
  for (const FigureArc& arc : figure.arcs) {
    if (arc.contour == contour && (position + count - arc.begin) % count < arc.count) return arc.depth;
  }
  throw std::logic_error("a segment without an arc");
}

/// The contour whose depth changes at a crossing is the one below.
void add_crossings(std::size_t count, LabelledFigure& figure) {
  for (Index m = 0; m < count; ++m) {
    FigureCrossing crossing;
    crossing.vertex = m;
    for (Index c = 0; c < figure.contours.size(); ++c) {
      const auto& vertices = figure.contours[c].vertices;
      const Index size = static_cast<Index>(vertices.size());
      for (Index i = 0; i < size; ++i) {
        if (vertices[i] != m) continue;
        const bool under = depth_after(figure, c, i) != depth_after(figure, c, (i + size - 1) % size);
        (under ? crossing.under_contour : crossing.over_contour) = c;
        (under ? crossing.under_position : crossing.over_position) = i;
      }
    }
    figure.crossings.push_back(crossing);
  }
}

/// Change of the number of layers on entering a triangle across one of its edges.
int entering(const LabelledFigure& figure, Index triangle, std::size_t corner) {
  const Index constraint = figure.triangulation.constraints[triangle][corner];
  if (constraint == no_index) return 0;
  const Index begin = figure.triangulation.triangles[triangle][(corner + 1) % 3];
  const int side = figure.contours[figure.arcs[figure.segment_arc[constraint]].contour].side;
  return figure.segments[constraint][0] == begin ? side : -side;
}

void count_layers(LabelledFigure& figure) {
  const PlanarTriangulation& planar = figure.triangulation;
  std::vector<bool> known(planar.triangles.size(), false);
  figure.layers.assign(planar.triangles.size(), 0);
  std::queue<Index> queue;
  const auto reach = [&](Index triangle, int layers) {
    if (triangle == no_index || known[triangle]) return;
    known[triangle] = true;
    figure.layers[triangle] = layers;
    queue.push(triangle);
  };
  for (Index t = 0; t < planar.triangles.size(); ++t) {
    for (std::size_t i = 0; i < 3; ++i) {
      if (planar.neighbours[t][i] == no_index) reach(t, entering(figure, t, i));
    }
  }
  for (; !queue.empty(); queue.pop()) {
    const Index t = queue.front();
    for (std::size_t i = 0; i < 3; ++i) reach(planar.neighbours[t][i], figure.layers[t] - entering(figure, t, i));
  }
}

void mark_face(Index seed, Index face, LabelledFigure& figure) {
  std::vector<Index> stack{seed};
  figure.faces[seed] = face;
  while (!stack.empty()) {
    const Index t = stack.back();
    stack.pop_back();
    for (std::size_t i = 0; i < 3; ++i) {
      const Index twin = figure.triangulation.neighbours[t][i];
      if (twin == no_index || figure.triangulation.constraints[t][i] != no_index) continue;
      if (figure.faces[twin] != no_index) continue;
      figure.faces[twin] = face;
      stack.push_back(twin);
    }
  }
}

void number_faces(LabelledFigure& figure) {
  const PlanarTriangulation& planar = figure.triangulation;
  figure.faces.assign(planar.triangles.size(), no_index);
  for (Index t = 0; t < planar.triangles.size(); ++t) {
    for (std::size_t i = 0; i < 3; ++i) {
      const bool open = planar.neighbours[t][i] == no_index && planar.constraints[t][i] == no_index;
      if (open && figure.faces[t] == no_index) mark_face(t, 0, figure);
    }
  }
  Index faces = 1;
  for (Index t = 0; t < planar.triangles.size(); ++t) {
    if (figure.faces[t] != no_index) continue;
    figure.panels += figure.layers[t];
    mark_face(t, faces++, figure);
  }
}

// --- tubes ---------------------------------------------------------------------------------------------------------

/// A place on a tube's outline and where on the centre line it belongs.
struct RimPoint {
  Vec2 at;
  Index tube = 0;
  double along = 0;  ///< arc length of the centre line
  double height = 0;
};

std::vector<double> arc_lengths(const FixtureTube& tube) {
  std::vector<double> lengths{0};
  for (std::size_t i = 1; i < tube.centre.size(); ++i) {
    lengths.push_back(lengths.back() + (tube.centre[i] - tube.centre[i - 1]).head<2>().norm());
  }
  return lengths;
}

double total_length(const FixtureTube& tube, const std::vector<double>& lengths) {
  return lengths.back() + (tube.closed ? (tube.centre.front() - tube.centre.back()).head<2>().norm() : 0);
}

Vec2 direction_at(const FixtureTube& tube, std::size_t i) {
  const std::size_t count = tube.centre.size();
  if (count == 1) return {1, 0};
  const std::size_t before = i > 0 ? i - 1 : (tube.closed ? count - 1 : 0);
  const std::size_t after = i + 1 < count ? i + 1 : (tube.closed ? 0 : count - 1);
  return (tube.centre[after] - tube.centre[before]).head<2>().normalized();
}

using Rim = std::vector<RimPoint>;

Rim offset_rim(const FixtureTube& tube, Index number, double side) {
  const std::vector<double> lengths = arc_lengths(tube);
  Rim rim;
  for (std::size_t i = 0; i < tube.centre.size(); ++i) {
    const Vec2 centre = tube.centre[i].head<2>();
    rim.push_back(
        {centre + side * tube.radius * left_of(direction_at(tube, i)), number, lengths[i], tube.centre[i].z()});
  }
  return rim;
}

/// Half a circle about an end, from the direction given through a half turn to the left.
void add_cap(const FixtureTube& tube, Index number, std::size_t end, const Vec2& from, Rim& rim) {
  const double along = arc_lengths(tube)[end];
  constexpr int pieces = 64;
  for (int k = 1; k < pieces; ++k) {
    const double angle = pi * k / pieces;
    const Vec2 out = std::cos(angle) * from + std::sin(angle) * left_of(from);
    rim.push_back({tube.centre[end].head<2>() + tube.radius * out, number, along, tube.centre[end].z()});
  }
}

std::vector<Rim> rims_of(const FixtureTube& tube, Index number) {
  Rim right = offset_rim(tube, number, -1);
  Rim left = offset_rim(tube, number, 1);
  if (tube.closed) return {right, left};
  const std::size_t last = tube.centre.size() - 1;
  add_cap(tube, number, last, -left_of(direction_at(tube, last)), right);
  right.insert(right.end(), left.rbegin(), left.rend());
  add_cap(tube, number, 0, left_of(direction_at(tube, 0)), right);
  return {right};
}

/// The same closed curve with points of even spacing.
Rim resampled(const Rim& rim, double step) {
  std::vector<double> lengths{0};
  for (std::size_t i = 0; i < rim.size(); ++i) {
    lengths.push_back(lengths.back() + (rim[(i + 1) % rim.size()].at - rim[i].at).norm());
  }
  const int count = std::max(8, static_cast<int>(std::lround(lengths.back() / step)));
  Rim result;
  std::size_t i = 0;
  for (int k = 0; k < count; ++k) {
    const double wanted = lengths.back() * k / count;
    while (lengths[i + 1] <= wanted) ++i;
    const double t = (wanted - lengths[i]) / (lengths[i + 1] - lengths[i]);
    const RimPoint& a = rim[i];
    const RimPoint& b = rim[(i + 1) % rim.size()];
    RimPoint point = t < 0.5 ? a : b;
    point.at = a.at + t * (b.at - a.at);
    result.push_back(point);
  }
  return result;
}

/// Passes of one tube over a place: runs of its centre line that come nearer than the radius.
int passes_over(const FixtureTube& tube, bool own, const RimPoint& place) {
  const std::vector<double> lengths = arc_lengths(tube);
  const double total = total_length(tube, lengths);
  const auto covers = [&](std::size_t i) {
    double apart = std::abs(lengths[i] - place.along);
    if (tube.closed) apart = std::min(apart, total - apart);
    if (own && apart < 2 * tube.radius) return false;
    return tube.centre[i].z() > place.height && (tube.centre[i].head<2>() - place.at).norm() < tube.radius;
  };
  int passes = 0;
  for (std::size_t i = 0; i < tube.centre.size(); ++i) {
    const bool first = i == 0 && !tube.closed;
    if (covers(i) && (first || !covers((i + tube.centre.size() - 1) % tube.centre.size()))) ++passes;
  }
  return passes;
}

double default_step(std::span<const Rim> rims) {
  Vec2 low = rims.front().front().at;
  Vec2 high = low;
  for (const Rim& rim : rims) {
    for (const RimPoint& point : rim) {
      low = low.cwiseMin(point.at);
      high = high.cwiseMax(point.at);
    }
  }
  return 0.006 * (high - low).norm();
}

std::vector<Vec3> curve(int count, double end, const std::function<Vec3(double)>& at) {
  std::vector<Vec3> points;
  for (int i = 0; i < count; ++i) points.push_back(at(end * i / count));
  return points;
}

}  // namespace

FigureFixture figure_of_contours(std::span<const FixtureContour> contours, std::span<const std::string> object_names,
                                 double step, const DepthAt& depth_at) {
  FigureFixture fixture;
  LabelledFigure& figure = fixture.figure;
  figure.step = step;
  figure.unit = step / 6;
  for (const std::string& name : object_names) {
    figure.objects.emplace_back();
    figure.objects.back().name = name;
  }
  const std::vector<Meeting> meetings = meetings_of(contours);
  for (const Meeting& meeting : meetings) figure.points.push_back(meeting.at);
  for (Index c = 0; c < contours.size(); ++c) {
    CutContour cut;
    add_contour(contours[c], c, meetings, figure, cut);
    figure.objects[contours[c].object].contours.push_back(c);
    add_arcs(c, cut, contours[c].points.size(), depth_at, fixture);
  }
  add_crossings(meetings.size(), figure);
  const PlanarTriangulationResult result = triangulate(figure.points, figure.segments);
  if (!result.conflict.empty()) throw std::logic_error("the contours of a fixture touch");
  figure.triangulation = result.triangulation;
  count_layers(figure);
  number_faces(figure);
  return fixture;
}

FigureFixture figure_of_tubes(std::span<const FixtureTube> tubes, double step) {
  std::vector<Rim> rims;
  std::vector<FixtureContour> contours;
  std::vector<std::string> names;
  for (Index t = 0; t < tubes.size(); ++t) {
    names.push_back(tubes[t].name);
    for (Rim& rim : rims_of(tubes[t], t)) {
      contours.push_back({{}, tubes[t].closed && contours.size() > 0 && contours.back().object == t ? -1 : 1, t});
      rims.push_back(std::move(rim));
    }
  }
  if (step <= 0) step = default_step(rims);
  for (std::size_t c = 0; c < rims.size(); ++c) {
    rims[c] = resampled(rims[c], step);
    for (const RimPoint& point : rims[c]) contours[c].points.push_back(point.at);
  }
  const DepthAt depth_at = [&](Index contour, double position) {
    const Rim& rim = rims[contour];
    const auto i = static_cast<std::size_t>(position);
    const double t = position - static_cast<double>(i);
    RimPoint place = t < 0.5 ? rim[i] : rim[(i + 1) % rim.size()];
    place.at = (1 - t) * rim[i].at + t * rim[(i + 1) % rim.size()].at;
    int depth = 0;
    for (Index k = 0; k < tubes.size(); ++k) depth += passes_over(tubes[k], k == place.tube, place);
    return depth;
  };
  FigureFixture fixture = figure_of_contours(contours, names, step, depth_at);
  for (Index t = 0; t < tubes.size(); ++t) fixture.figure.objects[t].euler_region = tubes[t].closed ? 0 : 1;
  return fixture;
}

FigureFixture disk_figure() { return figure_of_tubes(std::vector{FixtureTube{"disk", {{0, 0, 0}}, 100, false}}); }

FigureFixture ring_figure() {
  const auto circle = curve(256, 2 * pi, [](double a) { return Vec3(100 * std::cos(a), 100 * std::sin(a), 0); });
  return figure_of_tubes(std::vector{FixtureTube{"ring", circle, 20, true}});
}

FigureFixture capsule_figure() {
  const auto line = curve(101, 220 * 1.01, [](double x) { return Vec3(x, 0, 0); });
  return figure_of_tubes(std::vector{FixtureTube{"capsule", line, 40, false}});
}

FigureFixture crossed_capsules_figure() {
  const auto front = curve(101, 300, [](double x) { return Vec3(x - 150, 0, 50); });
  const auto back = curve(101, 300, [](double y) { return Vec3(20, y - 140, -50); });
  return figure_of_tubes(std::vector{FixtureTube{"front", front, 40, false}, FixtureTube{"back", back, 30, false}});
}

FigureFixture figure_eight_figure() {
  const auto eight =
      curve(512, 2 * pi, [](double a) { return Vec3(300 * std::sin(a), 150 * std::sin(2 * a), 50 * std::cos(a)); });
  return figure_of_tubes(std::vector{FixtureTube{"eight", eight, 30, true}});
}

FigureFixture snake_figure() {
  // One lobe of the eight, with both ends half a radian beyond the crossing.
  const auto loop = curve(401, pi + 1, [](double t) {
    const double a = t - 0.5;
    return Vec3(300 * std::sin(a), 150 * std::sin(2 * a), 60 * std::cos(a));
  });
  return figure_of_tubes(std::vector{FixtureTube{"snake", loop, 28, false}});
}

FigureFixture trefoil_figure() {
  const auto knot = curve(720, 2 * pi, [](double a) {
    return Vec3(100 * (std::sin(a) + 2 * std::sin(2 * a)), 100 * (std::cos(a) - 2 * std::cos(2 * a)),
                -100 * std::sin(3 * a));
  });
  return figure_of_tubes(std::vector{FixtureTube{"trefoil", knot, 36, true}});
}

FigureFixture linked_rings_figure() {
  const auto ring = [](double x, double tilt) {
    return curve(360, 2 * pi,
                 [x, tilt](double a) { return Vec3(x + 150 * std::cos(a), 150 * std::sin(a), tilt * std::sin(a)); });
  };
  return figure_of_tubes(
      std::vector{FixtureTube{"left", ring(0, 40), 30, true}, FixtureTube{"right", ring(170, -40), 30, true}});
}

silhouette::InflatedSheets inflated_sheets(const silhouette::LabelledFigure& figure) {
  Progress progress;
  silhouette::Skeleton skeleton = silhouette::chordal_axis(figure, 0.3, progress);
  solve_depth(skeleton, figure, {}, progress);
  const silhouette::SheetBasis basis = make_sheet_basis(figure, skeleton, silhouette::Quality::Final, {}, progress);
  return raise_sheets(skeleton, basis, {}, progress);
}

}  // namespace croquis::test
