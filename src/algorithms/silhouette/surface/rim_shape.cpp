// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/silhouette/surface/rim_shape.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "algorithms/silhouette/surface/rim_distance.h"
#include "algorithms/silhouette/surface/rim_radius.h"

namespace croquis::silhouette {
namespace {

/// Nearer to the rim, in parts of the first row's depth, the chord would be too thin for rounded numbers.
constexpr double least_part_of_row = 0.05;

// The factor is read off down to the third row, in parts of the radius.
constexpr double least_read_depth = 0.02;
constexpr double greatest_read_depth = 0.5;

constexpr double crease_width = 0.1;  // of the radius
constexpr double greatest_change = 0.2;
constexpr int reach_of_slope = 12;      // edges: about a limb's radius, over which noise of the radius evens out
constexpr double greatest_slope = 0.2;  // of the radius along the rim, where no section is trusted any more
constexpr double all_trusted = 0.05;    // changes up to here are taken as they are
constexpr double none_trusted = 0.08;
constexpr int smoothing_passes = 30;  // with weights 1/4, 1/2, 1/4: over about eight edges, a radius of a limb

/// Across a bent tube of the bend e the solution of Lap u = -4 is a parabola times 1 + e t, t from -1 on one rim to 1
/// on the other: the change is linear in t. It is rounded at the axis, where rims of equal bends would leave a crease.
double fade(double depth, double radius) {
  const double t = std::max(0.0, 1 - depth / radius);
  return (1 + crease_width) * t * t / (t + crease_width);
}

/// Per edge of the rim ln(wanted thickness / thickness) at the rim, 0 where nothing could be read.
std::vector<double> read_changes(const RimDistances& rim, const Eigen::VectorXd& thickness) {
  std::vector<double> sums(rim.edges.size(), 0.0);
  std::vector<double> weights(rim.edges.size(), 0.0);
  for (std::size_t v = 0; v < rim.nearest.size(); ++v) {
    if (rim.nearest[v] == no_index) continue;
    const double radius = rim.edges[rim.nearest[v]].radius;
    const double depth = rim.distance[v];
    if (depth < least_read_depth * radius || depth > greatest_read_depth * radius) continue;
    const double wanted = std::sqrt(depth * (2 * radius - depth));
    const double change = std::log(wanted / thickness[static_cast<Eigen::Index>(v)]);
    const double weight = fade(depth, radius);
    sums[rim.nearest[v]] += weight * std::clamp(change, -greatest_change, greatest_change);
    weights[rim.nearest[v]] += weight * weight;
  }
  for (std::size_t e = 0; e < sums.size(); ++e) {
    if (weights[e] > 0) sums[e] = std::clamp(sums[e] / weights[e], -greatest_change, greatest_change);
  }
  return sums;
}

/// Per edge the one that follows it along the boundary's loop.
std::vector<Index> following_edges(const RimDistances& rim) {
  std::vector<Index> leaving(rim.nearest.size(), no_index);
  for (Index e = 0; e < rim.edges.size(); ++e) leaving[rim.edges[e].begin] = e;
  std::vector<Index> following(rim.edges.size());
  for (Index e = 0; e < rim.edges.size(); ++e) following[e] = leaving[rim.edges[e].end];
  return following;
}

/// Where the radius changes along the rim the section is no circle of that radius: from 1 on a tube down to 0 on a
/// flare, where the factor would show as lumps.
void trust_even_radii(const SheetSampling& sheets, const RimDistances& rim, const std::vector<Index>& following,
                      std::vector<double>& changes) {
  const auto place = [&](Index i) { return sheets.points[sheets.lifted.planar_vertex[i]]; };
  std::vector<double> trust(changes.size(), 1.0);
  for (Index e = 0; e < changes.size(); ++e) {
    double length = 0;
    Index last = e;
    for (int step = 0; step < reach_of_slope; ++step) {
      length += (place(rim.edges[last].end) - place(rim.edges[last].begin)).norm();
      last = following[last];
    }
    const double slope = std::abs(rim.edges[last].radius - rim.edges[e].radius) / length;
    Index passed = e;
    for (int step = 0; step <= reach_of_slope; ++step, passed = following[passed]) {
      trust[passed] = std::min(trust[passed], std::max(0.0, 1 - slope / greatest_slope));
    }
  }
  for (std::size_t e = 0; e < changes.size(); ++e) {
    // A bend asks for a few hundredths; what asks for more is a corner or the side of a box, not a tube.
    const double small = (none_trusted - std::abs(changes[e])) / (none_trusted - all_trusted);
    changes[e] *= trust[e] * std::clamp(small, 0.0, 1.0);
  }
}

/// Along the boundary's loops.
std::vector<double> smoothed(const std::vector<Index>& following, std::vector<double> changes) {
  for (int pass = 0; pass < smoothing_passes; ++pass) {
    std::vector<double> next(changes.size(), 0.0);
    for (Index e = 0; e < changes.size(); ++e) {
      const Index after = following[e];
      next[e] += changes[e] / 2 + changes[after] / 4;
      next[after] += changes[e] / 4;
    }
    changes = std::move(next);
  }
  return changes;
}

/// Where the place meets its edge, so that the factor is linear along the rim.
double change_at(const SheetSampling& sheets, const RimDistances& rim, const std::vector<double>& at_vertex, Index v) {
  const auto place = [&](Index i) { return sheets.points[sheets.lifted.planar_vertex[i]]; };
  const RimEdge& edge = rim.edges[rim.nearest[v]];
  const Vec2 along = place(edge.end) - place(edge.begin);
  const double part = std::clamp((place(v) - place(edge.begin)).dot(along) / along.squaredNorm(), 0.0, 1.0);
  return (1 - part) * at_vertex[edge.begin] + part * at_vertex[edge.end];
}

}  // namespace

void shape_rims(const SheetSampling& sheets, Eigen::VectorXd& thickness) {
  const RimDistances rim = rim_distances(sheets, 1);
  const std::vector<Index> following = following_edges(rim);
  std::vector<double> changes = read_changes(rim, thickness);
  trust_even_radii(sheets, rim, following, changes);
  changes = smoothed(following, std::move(changes));
  std::vector<double> at_vertex(rim.nearest.size(), 0.0);
  for (std::size_t e = 0; e < changes.size(); ++e) {
    at_vertex[rim.edges[e].begin] += changes[e] / 2;
    at_vertex[rim.edges[e].end] += changes[e] / 2;
  }
  for (Index v = 0; v < rim.nearest.size(); ++v) {
    if (rim.nearest[v] == no_index || rim.distance[v] <= 0) continue;
    const double radius = rim.edges[rim.nearest[v]].radius;
    const double chord = std::clamp(rim.distance[v] / row_depth(radius, row_angles[0]), least_part_of_row, 1.0);
    thickness[v] *= std::exp(fade(rim.distance[v], radius) * change_at(sheets, rim, at_vertex, v)) * std::sqrt(chord);
  }
}

}  // namespace croquis::silhouette
