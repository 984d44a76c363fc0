// SPDX-License-Identifier: GPL-3.0-or-later
#include "silhouette/figure_fixtures.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <stdexcept>
#include <utility>

#include <Eigen/Geometry>

#include "algorithms/silhouette/figure/arrangement.h"
#include "algorithms/silhouette/skeleton/chordal_axis.h"
#include "algorithms/silhouette/skeleton/depth.h"
#include "support/sketches/sketch_layers.h"

namespace croquis::test {
namespace {

using namespace croquis::silhouette;
using std::numbers::pi;

Arrangement arrangement_of(const std::vector<FixtureContour>& contours, double step) {
  Arrangement closed;
  for (const FixtureContour& contour : contours) {
    ContourPath& path = closed.paths.emplace_back();
    path.points = contour.points;
    path.segments.assign(path.points.size(), {true, true});
    path.side = contour.side;
  }
  Arrangement made = cross_contours(std::move(closed), {}, step, 0);
  find_faces(made);
  if (!made.conflicts.empty()) throw std::logic_error("the contours of a fixture touch");
  return made;
}

/// Per vertex of a contour its place along the fixture's one, all of whose points it has.
std::vector<double> positions_of(const Arrangement& made, Index contour) {
  const Points& points = made.paths[contour].points;
  std::vector<double> positions;
  std::size_t next = 0;
  for (const Index v : made.contours[contour].vertices) {
    if (v >= made.contour_crossings.size()) {
      positions.push_back(static_cast<double>(next++));
    } else {
      const Vec2 &before = points[next - 1], &after = points[next % points.size()];
      positions.push_back(static_cast<double>(next - 1) + nearest_parameter(made.points[v], before, after));
    }
  }
  return positions;
}

/// What becomes of the contours with that many surfaces in front of each arc.
FigureFixture figure_with_depths(Arrangement made, const std::vector<int>& depths,
                                 const std::vector<FixtureContour>& contours, const std::vector<std::string>& names,
                                 double step) {
  FigureFixture fixture;
  made.step = step;
  made.unit = step / 6;
  for (const std::string& name : names) made.objects.emplace_back().name = name;
  for (Index c = 0; c < contours.size(); ++c) {
    made.contours[c].object = contours[c].object;
    made.objects[contours[c].object].contours.push_back(c);
    made.raw_contours.push_back(contours[c].points);
  }
  for (std::size_t a = 0; a < depths.size(); ++a) {
    FigureArc& arc = made.arcs[a];
    FigureContour& contour = made.contours[arc.contour];
    const auto count = static_cast<Index>(contour.vertices.size());
    arc.depth = depths[a];
    arc.visible = arc.depth == 0;
    std::vector<Vec2> points;
    for (Index k = 0; k <= arc.count; ++k) points.push_back(made.points[contour.vertices[(arc.begin + k) % count]]);
    for (Index k = 0; k < arc.count; ++k) contour.drawn[(arc.begin + k) % count] = arc.visible ? 1 : 0;
    if (!arc.visible) continue;
    const auto number = static_cast<Index>(fixture.drawing.strokes.size());
    if (arc.count == count) points.pop_back();
    fixture.drawing.strokes.push_back(stroke_of("s" + std::to_string(number), points, arc.count == count));
    contour.strokes.push_back(number);
    made.objects[contour.object].strokes.push_back(number);
  }
  // The contour whose depth changes at a crossing is the one below.
  for (Index k = 0; k < made.contour_crossings.size(); ++k) {
    const auto& [a, b] = made.contour_crossings[k].strands;
    const auto& [over, under] = depths[a.before] == depths[a.after] ? std::pair(a, b) : std::pair(b, a);
    made.crossings.push_back({k, over.contour, over.position, under.contour, under.position});
  }
  std::vector<int> layers;
  for (const std::vector<int>& winding : made.winding) {
    int& own = layers.emplace_back(0);
    for (std::size_t c = 0; c < contours.size(); ++c) own += winding[c] * contours[c].side;
    made.panels += own;
  }
  for (const Index face : made.faces) made.layers.push_back(layers[face]);
  fixture.figure = std::move(made);
  return fixture;
}

/// Surfaces in front of each arc, from the heights of contours that have a visible piece each.
std::vector<int> depths_of(const Arrangement& made, const std::vector<std::vector<double>>& heights) {
  std::vector<std::vector<double>> at_vertices;
  for (Index c = 0; c < made.contours.size(); ++c) {
    const std::vector<double>& own = heights[c];
    std::vector<double>& at = at_vertices.emplace_back();
    for (const double position : positions_of(made, c)) {
      const auto i = static_cast<std::size_t>(position);
      at.push_back(own[i] + (position - static_cast<double>(i)) * (own[(i + 1) % own.size()] - own[i]));
    }
  }
  std::vector<int> sinking(made.arcs.size(), 0);  // at its begin
  for (const ContourCrossing& crossing : made.contour_crossings) {
    const auto height = [&](Index s) { return at_vertices[crossing.strands[s].contour][crossing.strands[s].position]; };
    const Index under = height(0) < height(1) ? 0 : 1;
    const int enters = (under == 1 ? 1 : -1) * crossing.sign * made.contours[crossing.strands[1 - under].contour].side;
    sinking[crossing.strands[under].after] = enters;
  }
  std::vector<int> depths;
  for (std::size_t first = 0, last = 0; first < sinking.size(); first = last) {
    while (last < sinking.size() && made.arcs[last].contour == made.arcs[first].contour) ++last;
    const auto begin = sinking.begin() + static_cast<std::ptrdiff_t>(first);
    std::partial_sum(begin, sinking.begin() + static_cast<std::ptrdiff_t>(last), begin);
    const int least = *std::min_element(begin, sinking.begin() + static_cast<std::ptrdiff_t>(last));
    for (std::size_t arc = first; arc < last; ++arc) depths.push_back(sinking[arc] - least);
  }
  return depths;
}

/// Points are 6/1000 of the figure's diagonal apart. Every other contour has its surface on the right.
FigureFixture figure_of_tubes(const std::vector<TubeStrand>& strands, const std::vector<std::string>& names) {
  Eigen::AlignedBox2d box;
  for (const TrueContour& outline : tube_sketch(strands).truth.outlines) {
    for (const Vec2& point : outline.points) box.extend(point);
  }
  const double step = 0.006 * box.diagonal().norm();
  const SketchTruth truth = tube_sketch(strands, {step}).truth;
  std::vector<FixtureContour> contours;
  std::vector<std::vector<double>> heights;
  for (TrueContour outline : truth.outlines) {
    const bool turned = contours.size() % 2 == 1;
    if (turned) {
      std::ranges::reverse(outline.points);
      std::ranges::reverse(outline.height);
    }
    contours.push_back({outline.points, turned ? -1 : 1, static_cast<Index>(outline.component)});
    heights.push_back(outline.height);
  }
  Arrangement made = arrangement_of(contours, step);
  const std::vector<int> depths = depths_of(made, heights);
  FigureFixture fixture = figure_with_depths(std::move(made), depths, contours, names, step);
  for (std::size_t o = 0; o < names.size(); ++o) fixture.figure.objects[o].euler_region = truth.euler_region[o];
  return fixture;
}

std::function<double(double)> level(double height) {
  return [height](double) { return height; };
}

}  // namespace

FigureFixture figure_of_contours(const std::vector<FixtureContour>& contours,
                                 const std::vector<std::string>& object_names, double step, const DepthAt& depth_at) {
  Arrangement made = arrangement_of(contours, step);
  std::vector<int> depths;
  for (const FigureArc& arc : made.arcs) {
    const std::vector<double> positions = positions_of(made, arc.contour);
    const auto count = static_cast<double>(contours[arc.contour].points.size());
    const std::size_t segment = (arc.begin + arc.count / 2) % positions.size();
    const double after = segment + 1 < positions.size() ? positions[segment + 1] : count;
    depths.push_back(depth_at(arc.contour, std::fmod((positions[segment] + after) / 2, count)));
  }
  return figure_with_depths(std::move(made), depths, contours, object_names, step);
}

FigureFixture figure_of_outline(const std::string& name, const std::vector<Vec2>& outline, double step) {
  FigureFixture fixture = figure_of_contours({{outline, 1, 0}}, {name}, step, [](Index, double) { return 0; });
  fixture.figure.objects[0].euler_region = 1;
  return fixture;
}

FigureFixture disk_figure() { return figure_of_outline("disk", circle_outline({0, 0}, 100, 1.7), 1.7); }

FigureFixture ring_figure() { return figure_of_tubes({ring({0, 0}, 100, 20, level(0))}, {"ring"}); }

FigureFixture capsule_figure() { return figure_of_tubes({bar({0, 0}, {220, 0}, 40, level(0))}, {"capsule"}); }

FigureFixture crossed_capsules_figure() {
  // No sample of one lies on the other.
  return figure_of_tubes({bar({-153, 0}, {150, 0}, 40, level(50)), bar({20, -141}, {20, 160}, 30, level(-50))},
                         {"front", "back"});
}

FigureFixture figure_eight_figure() {
  const auto eight = [](double t) { return Vec2(300 * std::sin(2 * pi * t), 150 * std::sin(4 * pi * t)); };
  const auto height = [](double t) { return 50 * std::cos(2 * pi * t); };
  return figure_of_tubes({{eight, [](double) { return 30.0; }, height, true}}, {"eight"});
}

FigureFixture snake_figure() {
  // One lobe of the eight, with both ends half a radian beyond the crossing.
  const auto angle = [](double t) { return (pi + 1) * t - 0.5; };
  const auto loop = [=](double t) { return Vec2(300 * std::sin(angle(t)), 150 * std::sin(2 * angle(t))); };
  const auto height = [=](double t) { return 60 * std::cos(angle(t)); };
  return figure_of_tubes({{loop, [](double) { return 28.0; }, height, false}}, {"snake"});
}

FigureFixture trefoil_figure() {
  const auto knot = [](double t) {
    const double a = 2 * pi * t;
    return Vec2(100 * (std::sin(a) + 2 * std::sin(2 * a)), 100 * (std::cos(a) - 2 * std::cos(2 * a)));
  };
  const auto height = [](double t) { return -100 * std::sin(6 * pi * t); };
  return figure_of_tubes({{knot, [](double) { return 36.0; }, height, true}}, {"trefoil"});
}

FigureFixture linked_rings_figure() {
  const auto tilted = [](double tilt) { return [tilt](double t) { return tilt * std::sin(2 * pi * t); }; };
  return figure_of_tubes({ring({0, 0}, 150, 30, tilted(40)), ring({170, 0}, 150, 30, tilted(-40))}, {"left", "right"});
}

std::vector<NamedFigure> all_figures() {
  return {{"disk", disk_figure()},
          {"ring", ring_figure()},
          {"capsule", capsule_figure()},
          {"crossed capsules", crossed_capsules_figure()},
          {"figure eight", figure_eight_figure()},
          {"snake", snake_figure()},
          {"linked rings", linked_rings_figure()},
          {"trefoil", trefoil_figure()}};
}

Skeleton skeleton_of(const LabelledFigure& figure, double node_spacing) {
  Progress progress;
  return chordal_axis(figure, node_spacing, progress);
}

InflatedSheets inflated_sheets(const LabelledFigure& figure) {
  Progress progress;
  Skeleton skeleton = skeleton_of(figure);
  solve_depth(skeleton, figure, {}, progress);
  const SheetBasis basis = make_sheet_basis(figure, skeleton, Quality::Final, {}, progress);
  return raise_sheets(skeleton, basis, {}, progress);
}

}  // namespace croquis::test
