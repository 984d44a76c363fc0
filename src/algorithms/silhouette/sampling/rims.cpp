// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/silhouette/sampling/rims.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "algorithms/silhouette/skeleton/triangle_corners.h"
#include "croquis/geometry/polyline.h"

namespace croquis::silhouette {
namespace {

// With weights 1/4, 1/2, 1/4: chords of neighbouring samples differ by their noise.
constexpr int radius_smoothing_passes = 3;

// Between the rows of a tube, radians: 15, 20 and 25 degrees.
constexpr std::array tube_turns = {0.2617993877991494, 0.3490658503988659, 0.4363323129985824};
constexpr double last_angle = 1.12;  // beyond, the plane's own points are even on the surface

// Contour steps.
constexpr double first_arc = 2.2;  // from the rim to the first row
constexpr double widest_gap = 2;   // in the plane: wider ones hold points of their own
constexpr double arc_growth = 1.12;
constexpr double widest_tube = first_arc / tube_turns[0];  // radius; the first row lies nowhere deeper

constexpr double most_widening = 4;  // of the radius of a thin part

/// Linear between the values that there are, periodic. At least one value must be there.
void fill_gaps(std::vector<double>& values) {
  const std::size_t count = values.size();
  std::size_t first = 0;
  while (std::isnan(values[first])) ++first;
  for (std::size_t done = 0; done < count;) {
    const std::size_t from = first + done;
    std::size_t length = 1;
    while (std::isnan(values[(from + length) % count])) ++length;
    const double begin = values[from % count];
    const double end = values[(from + length) % count];
    for (std::size_t k = 1; k < length; ++k) {
      values[(from + k) % count] = begin + (end - begin) * static_cast<double>(k) / static_cast<double>(length);
    }
    done += length;
  }
}

void smooth_cycle(std::vector<double>& values) {
  const std::vector<double> old = values;
  const std::size_t count = old.size();
  for (std::size_t i = 0; i < count; ++i) {
    values[i] = 0.25 * old[(i + count - 1) % count] + 0.5 * old[i] + 0.25 * old[(i + 1) % count];
  }
}

}  // namespace

std::vector<double> row_depths(double radius, double step) {
  std::vector<double> depths;
  double angle = 0;
  double arc = first_arc * step;
  while (depths.size() < most_rows) {
    angle += std::min(tube_turns[std::min(depths.size(), tube_turns.size() - 1)], arc / radius);
    const double depth = radius * (1 - std::cos(angle));
    if (angle > last_angle || (depths.size() >= tube_turns.size() && depth - depths.back() > widest_gap * step)) break;
    arc *= arc_growth;
    depths.push_back(depth);
  }
  return depths;
}

double greatest_first_row() { return 1 - std::cos(tube_turns[0]); }

RimValues rim_radii(const Skeleton& skeleton) {
  RimValues radii = skeleton.contour_radius;
  for (std::vector<double>& values : radii) {
    if (std::all_of(values.begin(), values.end(), [](double r) { return std::isnan(r); })) {
      values.assign(values.size(), skeleton.scale);
    }
    fill_gaps(values);
    for (int pass = 0; pass < radius_smoothing_passes; ++pass) smooth_cycle(values);
  }
  return radii;
}

std::vector<Index> thin_objects(std::span<const double> thickness) {
  std::vector<Index> thin;
  for (Index object = 0; object < thickness.size(); ++object) {
    if (thickness[object] < 1) thin.push_back(object);
  }
  return thin;
}

RimValues row_radii(const LabelledFigure& figure, RimValues radii, std::span<const Index> thin) {
  for (const Index object : thin) {
    for (const Index contour : figure.objects[object].contours) {
      for (double& radius : radii[contour]) radius = std::min(widest_tube * figure.step, most_widening * radius);
    }
  }
  return radii;
}

namespace {

const Vec2& place_of(const SheetSampling& sheets, Index vertex) {
  return sheets.points[sheets.lifted.planar_vertex[vertex]];
}

double distance_to(const SheetSampling& sheets, const RimEdge& edge, Index vertex) {
  const Vec2 &begin = place_of(sheets, edge.begin), &end = place_of(sheets, edge.end),
             &place = place_of(sheets, vertex);
  return (begin + nearest_parameter(place, begin, end) * (end - begin) - place).norm();
}

}  // namespace

RimDistances rim_distances(const SheetSampling& sheets, double reach) {
  const LiftedTriangulation& lifted = sheets.lifted;
  const std::size_t count = lifted.planar_vertex.size();
  RimDistances rim{{}, std::vector<Index>(count, no_index), {}};
  rim.distance.assign(count, std::numeric_limits<double>::infinity());
  std::vector<Index> leaving(count, no_index), entering(count, no_index);  // edges of the boundary
  for (Index t = 0; t < lifted.triangles.size(); ++t) {
    for (Index corner = 0; corner < 3; ++corner) {
      if (lifted.neighbours[t][corner] != no_index) continue;
      const double radius = sheets.pieces[sheets.planar.constraints[lifted.planar_triangle[t]][corner]].row_radius;
      const auto edge = static_cast<Index>(rim.edges.size());
      const Index begin = lifted.triangles[t][next(corner)], end = lifted.triangles[t][previous(corner)];
      rim.edges.push_back({begin, end, radius, row_depths(radius, sheets.step).front()});
      leaving[begin] = entering[end] = edge;
      rim.nearest[begin] = rim.nearest[end] = edge;
      rim.distance[begin] = rim.distance[end] = 0;
    }
  }
  const auto offer = [&](Index vertex, Index edge) {
    bool taken = false;
    for (const Index candidate : {edge, entering[rim.edges[edge].begin], leaving[rim.edges[edge].end]}) {
      const double distance = distance_to(sheets, rim.edges[candidate], vertex);
      if (distance >= rim.distance[vertex] || distance > reach * rim.edges[candidate].radius) continue;
      rim.distance[vertex] = distance;
      rim.nearest[vertex] = candidate;
      taken = true;
    }
    return taken;
  };
  // Each round reaches at least one ring of vertices further in, until no neighbour knows a nearer edge.
  for (bool changed = true; changed;) {
    changed = false;
    for (const std::array<Index, 3>& corners : lifted.triangles) {
      for (const Index from : corners) {
        const Index edge = rim.nearest[from];
        if (edge == no_index) continue;
        for (const Index to : corners) {
          if (!lifted.on_boundary[to] && rim.nearest[to] != edge && offer(to, edge)) changed = true;
        }
      }
    }
  }
  return rim;
}

double depth_below(const SheetSampling& sheets, const RimEdge& edge, Index vertex) {
  const Vec2& begin = place_of(sheets, edge.begin);
  const Vec2 inward = left_of((place_of(sheets, edge.end) - begin).normalized());
  return (place_of(sheets, vertex) - begin).dot(inward);
}

}  // namespace croquis::silhouette
