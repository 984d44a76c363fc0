// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/attribute_surface/bridges/rim_face.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>
#include <numbers>
#include <utility>

#include <Eigen/Geometry>

#include "croquis/geometry/bezier_fit.h"
#include "croquis/geometry/planar_triangulation.h"

namespace croquis {
namespace {

constexpr std::size_t most_rim_sides = 12;
constexpr std::size_t round_sides = 4;  // of a rim with fewer corners than a face has sides
constexpr std::size_t fewest_sides = 3;
constexpr std::size_t coarse_rim = 16;  // edges: turns of longer ones are taken over two

/// The sharpest corners, ascending; at most `most`.
std::vector<std::size_t> sharpest_corners(std::span<const Vec3> loop, double corner, std::size_t most) {
  const std::size_t n = loop.size(), reach = n < coarse_rim ? 1 : 2;
  const double least = corner + 2 * std::numbers::pi * static_cast<double>(reach) / static_cast<double>(n);
  std::vector<std::pair<double, std::size_t>> turns;  // less the turn, so that the sharpest come first
  for (std::size_t i = 0; i < n; ++i) {
    const double turn = angle_between(loop[i] - loop[(i + n - reach) % n], loop[(i + reach) % n] - loop[i]);
    if (turn > least) turns.emplace_back(-turn, i);
  }
  std::ranges::sort(turns);
  std::vector<std::size_t> found;
  for (const auto& [turn, i] : turns) {
    const auto is_near = [&, at = i](std::size_t other) {
      const std::size_t apart = at > other ? at - other : other - at;
      return std::min(apart, n - apart) < reach;
    };
    if (found.size() < most && std::ranges::none_of(found, is_near)) found.push_back(i);
  }
  std::ranges::sort(found);
  return found;
}

/// A stretch of the loop between two corners, or all of it.
struct Stretch {
  std::size_t first = 0;
  std::size_t edges = 0;
  double length = 0;
  std::size_t parts = 1;
};

/// Lengths from the stretch's first point to each of its points.
std::vector<double> lengths_along(std::span<const Vec3> loop, const Stretch& stretch) {
  std::vector<double> lengths{0};
  for (std::size_t e = 0; e < stretch.edges; ++e) {
    const std::size_t i = (stretch.first + e) % loop.size();
    lengths.push_back(lengths.back() + (loop[(i + 1) % loop.size()] - loop[i]).norm());
  }
  return lengths;
}

std::vector<Stretch> stretches_between(std::span<const Vec3> loop, std::vector<std::size_t> corners) {
  if (corners.empty()) corners.push_back(0);
  std::vector<Stretch> stretches;
  for (std::size_t k = 0; k < corners.size(); ++k) {
    const std::size_t next = corners[(k + 1) % corners.size()];
    Stretch stretch{corners[k], (next + loop.size() - corners[k]) % loop.size(), 0, 1};
    if (stretch.edges == 0) stretch.edges = loop.size();
    stretch.length = lengths_along(loop, stretch).back();
    stretches.push_back(stretch);
  }
  return stretches;
}

/// Divides the stretch with the longest parts, again and again.
void share_out(std::vector<Stretch>& stretches, std::size_t sides) {
  const auto part_length = [](const Stretch& s) {
    return s.parts < s.edges ? s.length / static_cast<double>(s.parts) : -1;
  };
  for (std::size_t count = stretches.size(); count < sides; ++count) {
    Stretch& longest = *std::ranges::max_element(stretches, {}, part_length);
    if (longest.parts < longest.edges) ++longest.parts;
  }
}

void cut_evenly(std::span<const Vec3> loop, const Stretch& stretch, std::vector<std::size_t>& cuts) {
  const std::vector<double> lengths = lengths_along(loop, stretch);
  std::size_t before = 0;
  cuts.push_back(stretch.first % loop.size());
  for (std::size_t k = 1; k < stretch.parts; ++k) {
    const double wanted = stretch.length * static_cast<double>(k) / static_cast<double>(stretch.parts);
    auto e = static_cast<std::size_t>(std::ranges::lower_bound(lengths, wanted) - lengths.begin());
    if (e > 0 && wanted - lengths[e - 1] < lengths[e] - wanted) --e;
    e = std::clamp(e, before + 1, stretch.edges - (stretch.parts - k));
    cuts.push_back((stretch.first + e) % loop.size());
    before = e;
  }
}

constexpr double rim_gap = 0.6;       // × spacing: places inside keep so far from the outline
constexpr double bend = 1e-4;         // × side: sides are bent inwards, so that no triangle lies along one alone
constexpr double finest = 1.0 / 800;  // of the perimeter: rims of more edges don't make finer triangles inside
constexpr int most_passes = 20;
constexpr double least_gain_of_angle = 1e-9;

using Triangle = std::array<Index, 3>;
using Edge = std::array<Index, 2>;

std::vector<Vec2> places_inside(const DomainPolygon& domain, double spacing) {
  Vec2 low = domain.corners[0], high = low;
  for (const Vec2& corner : domain.corners) {
    low = low.cwiseMin(corner);
    high = high.cwiseMax(corner);
  }
  const double row = spacing * std::sqrt(3.0) / 2;
  const auto rows = static_cast<int>((high - low).y() / row) + 1;
  const auto columns = static_cast<int>((high - low).x() / spacing) + 2;
  std::vector<Vec2> places;
  for (int j = -rows; j <= rows; ++j) {
    for (int i = -columns; i <= columns; ++i) {
      const double shift = j % 2 == 0 ? 0 : 0.5;
      const Vec2 place = domain.centroid + Vec2((i + shift) * spacing, j * row);
      if (distance_inside(domain, place) >= rim_gap * spacing) places.push_back(place);
    }
  }
  return places;
}

/// Which triangle has each directed edge.
std::map<Edge, std::size_t> edges_of(const std::vector<Triangle>& triangles) {
  std::map<Edge, std::size_t> edges;
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    for (std::size_t i = 0; i < 3; ++i) edges[{triangles[t][i], triangles[t][(i + 1) % 3]}] = t;
  }
  return edges;
}

Index third_corner(const Triangle& triangle, const Edge& edge) {
  for (const Index corner : triangle) {
    if (corner != edge[0] && corner != edge[1]) return corner;
  }
  return no_index;
}

class EdgeTurner {
 public:
  EdgeTurner(std::span<const Vec3> points, std::vector<Triangle>& triangles)
      : points_(points), triangles_(triangles), edges_(edges_of(triangles)) {}

  void run() {
    bool changed = true;
    for (int pass = 0; changed && pass < most_passes; ++pass) {
      changed = false;
      std::vector<Edge> inner;
      for (const auto& [edge, triangle] : edges_) {
        if (edge[0] < edge[1] && edges_.contains({edge[1], edge[0]})) inner.push_back(edge);
      }
      for (const Edge& edge : inner) changed = turn(edge) || changed;
    }
  }

 private:
  Vec3 area(const Triangle& t) const { return (points_[t[1]] - points_[t[0]]).cross(points_[t[2]] - points_[t[0]]); }

  /// The least angle, or less than any where the triangle is turned over.
  double quality(const Triangle& t, const Vec3& upwards) const {
    if (area(t).dot(upwards) <= 0) return -1;
    double least = 4;
    for (std::size_t i = 0; i < 3; ++i) {
      const Vec3& at = points_[t[i]];
      least = std::min(least, angle_between(points_[t[(i + 1) % 3]] - at, points_[t[(i + 2) % 3]] - at));
    }
    return least;
  }

  bool turn(const Edge& edge) {
    const auto left = edges_.find(edge), right = edges_.find({edge[1], edge[0]});
    if (left == edges_.end() || right == edges_.end()) return false;  // turned by now
    const std::size_t l = left->second, r = right->second;
    const Index c = third_corner(triangles_[l], edge), d = third_corner(triangles_[r], edge);
    if (edges_.contains({c, d}) || edges_.contains({d, c})) return false;
    const Triangle first{c, edge[0], d}, second{d, edge[1], c};
    const Vec3 upwards = area(triangles_[l]) + area(triangles_[r]);
    const double old_quality = std::min(quality(triangles_[l], upwards), quality(triangles_[r], upwards));
    const double new_quality = std::min(quality(first, upwards), quality(second, upwards));
    if (new_quality <= old_quality + least_gain_of_angle) return false;
    edges_.erase(edge);
    edges_.erase({edge[1], edge[0]});
    triangles_[l] = first;
    triangles_[r] = second;
    for (const std::size_t t : {l, r}) {
      for (std::size_t i = 0; i < 3; ++i) edges_[{triangles_[t][i], triangles_[t][(i + 1) % 3]}] = t;
    }
    return true;
  }

  std::span<const Vec3> points_;
  std::vector<Triangle>& triangles_;
  std::map<Edge, std::size_t> edges_;
};

/// One cut for a triangle at most.
bool cut_some_edges(const std::function<bool(Index, Index)>& is_taken, PatchTriangles& patch) {
  const auto edges = edges_of(patch.triangles);
  std::vector<bool> is_cut(patch.triangles.size(), false);
  for (const auto& [edge, left] : edges) {
    const auto right = edges.find({edge[1], edge[0]});
    if (edge[0] > edge[1] || right == edges.end() || !is_taken(edge[0], edge[1])) continue;
    if (is_cut[left] || is_cut[right->second]) continue;
    is_cut[left] = is_cut[right->second] = true;
    const auto middle = static_cast<Index>(patch.places.size());
    patch.places.push_back((patch.places[edge[0]] + patch.places[edge[1]]) / 2);
    for (const std::size_t t : {left, right->second}) {
      Triangle other = patch.triangles[t];
      std::ranges::replace(patch.triangles[t], edge[0], middle);
      std::ranges::replace(other, edge[1], middle);
      patch.triangles.push_back(other);
    }
  }
  return std::ranges::count(is_cut, true) > 0;
}

constexpr double fit_tolerance = 0.01;  // × mean edge: what is left is moved along
constexpr double edges_of_reach = 3;    // edges of the rim over which misses fade
constexpr double misses_of_reach = 8;   // the same, × the greatest miss: a surface is bent by them hardly
constexpr std::size_t long_rim = 16;    // edges: corners of longer ones are looked for without their teeth
constexpr double least_upright = 0.2;   // cosine: rims that stand up more say nothing of heights
constexpr double least_rise = 1e-6;     // × perimeter
constexpr double usual_fullness = 0.5;
constexpr double least_step = 1e-9;  // between fractions of a curve

double loop_length(const RimLoop& loop) {
  double length = (loop.points.front() - loop.points.back()).norm();
  for (std::size_t i = 1; i < loop.points.size(); ++i) length += (loop.points[i] - loop.points[i - 1]).norm();
  return length;
}

/// Fractions by the nearest places of a curve, or where these don't ascend, as on jagged rims, by the chords.
std::vector<double> ascending_fractions(const FittedBezier& fitted, const ArcLengthCurve& curve,
                                        const std::vector<Vec3>& points) {
  std::vector<double> fractions, chords{0};
  for (const double t : fitted.parameters) fractions.push_back(curve.fraction(t));
  fractions.front() = 0;
  fractions.back() = 1;
  bool ascend = true;
  for (std::size_t i = 1; i < points.size(); ++i) {
    chords.push_back(chords.back() + (points[i] - points[i - 1]).norm());
    ascend = ascend && fractions[i] > fractions[i - 1] + least_step;
  }
  if (ascend) return fractions;
  for (double& chord : chords) chord /= chords.back();
  return chords;
}

/// Every point but corners and its neighbours, 1 : 2 : 1, on the surface that the normals give: the mean of the points
/// is as far from a round surface on one side as the mean of their tangent planes on the other.
RimLoop blurred(const RimLoop& loop, const std::vector<bool>& is_corner) {
  RimLoop result = loop;
  const std::size_t n = loop.points.size();
  for (std::size_t i = 0; i < n; ++i) {
    if (is_corner[i]) continue;
    const std::array<std::pair<std::size_t, double>, 3> parts{{{(i + n - 1) % n, 0.25}, {i, 0.5}, {(i + 1) % n, 0.25}}};
    Vec3 point = Vec3::Zero(), normal = Vec3::Zero(), to_planes = Vec3::Zero();
    for (const auto& [j, weight] : parts) {
      point += weight * loop.points[j];
      normal += weight * loop.normals[j];
    }
    for (const auto& [j, weight] : parts)
      to_planes += weight * (loop.points[j] - point).dot(loop.normals[j]) * loop.normals[j];
    result.points[i] = point + to_planes / 2;
    result.normals[i] = unit_or_zero(normal);
  }
  return result;
}

/// The rim without what changes from each point to the next, as where triangles were taken away: curves can't follow
/// that, and surfaces shouldn't. What changes slowly stays.
RimLoop evened_out(const RimLoop& loop, const std::vector<bool>& is_corner) {
  const RimLoop once = blurred(loop, is_corner), twice = blurred(once, is_corner);
  RimLoop result = once;
  for (std::size_t i = 0; i < loop.points.size(); ++i) {
    result.points[i] += once.points[i] - twice.points[i];
    result.normals[i] = unit_or_zero(2 * once.normals[i] - twice.normals[i]);
  }
  return result;
}

/// How high a surface rises over the rim in the middle, along an axis: of the cubics with the rim's heights and slopes
/// through opposite places their mean, which is halfway between the mean height and that of the tangent planes.
double expected_height(const RimLoop& rim, const Vec3& middle, const Vec3& axis) {
  double heights = 0, lengths = 0;
  const std::size_t n = rim.points.size();
  for (std::size_t i = 0; i < n; ++i) {
    const double length = (rim.points[(i + 1) % n] - rim.points[(i + n - 1) % n]).norm();
    const double upright = std::max(rim.normals[i].dot(axis), least_upright);
    const Vec3 across = (middle - rim.points[i]) - (middle - rim.points[i]).dot(axis) * axis;
    const double rise = -rim.normals[i].dot(across) / upright;
    heights += length * (rim.points[i].dot(axis) + rise / 2);
    lengths += length;
  }
  return heights / lengths;
}

/// The fullness with which the surface has the height in its middle that the rim lets expect: it depends linearly on
/// it.
double expected_fullness(SurfaceFrame frame, const RimLoop& rim) {
  Vec3 axis = Vec3::Zero();
  for (const Vec3& normal : rim.normals) axis += normal;
  axis = unit_or_zero(axis);
  frame.fullness = 0;
  const FaceSurface flat(frame);
  frame.fullness = 1;
  const FaceSurface full(frame);
  const Vec2 centroid = flat.domain().centroid;
  const double low = flat.at(centroid).dot(axis), high = full.at(centroid).dot(axis);
  if (std::abs(high - low) < least_rise * flat.sigma()) return usual_fullness;
  const Vec3 middle = (flat.at(centroid) + full.at(centroid)) / 2;
  return std::clamp((expected_height(rim, middle, axis) - low) / (high - low), 0.0, 1.0);
}

}  // namespace

RimCuts cut_rim(std::span<const Vec3> loop, double corner, std::size_t sides) {
  const std::vector<std::size_t> corners = sharpest_corners(loop, corner, sides == 0 ? most_rim_sides : sides);
  const std::size_t automatic = corners.size() < fewest_sides ? round_sides : corners.size();
  const std::size_t wanted = sides != 0 ? sides : automatic;
  std::vector<Stretch> stretches = stretches_between(loop, corners);
  share_out(stretches, std::min(wanted, loop.size()));
  RimCuts cuts;
  for (const Stretch& stretch : stretches) cut_evenly(loop, stretch, cuts.at);
  std::ranges::sort(cuts.at);
  for (const std::size_t at : cuts.at) cuts.is_corner.push_back(std::ranges::binary_search(corners, at));
  return cuts;
}

PatchTriangles fill_domain(const DomainPolygon& domain, std::span<const OutlinePlace> outline, double spacing) {
  PatchTriangles patch;
  std::vector<Vec2> bent;
  std::vector<Edge> ring;
  const std::size_t n = outline.size();
  for (std::size_t i = 0; i < n; ++i) {
    const OutlinePlace& at = outline[i];
    const Vec2 side = domain.corners[(at.side + 1) % domain.corners.size()] - domain.corners[at.side];
    patch.places.push_back(at.place);
    bent.push_back(at.place + 4 * bend * at.fraction * (1 - at.fraction) * left_of(side));
    ring.push_back({static_cast<Index>(i), static_cast<Index>((i + 1) % n)});
  }
  if (n > 3) {
    for (const Vec2& place : places_inside(domain, std::max(spacing, finest))) {
      patch.places.push_back(place);
      bent.push_back(place);
    }
  }
  const PlanarTriangulationResult plane = triangulate(bent, ring);
  if (plane.conflict.empty()) patch.triangles = triangles_inside(plane.triangulation);
  return patch;
}

void even_out(std::span<const Vec3> points, std::vector<Triangle>& triangles) { EdgeTurner(points, triangles).run(); }

void cut_edges(const std::function<bool(Index, Index)>& is_taken, PatchTriangles& patch) {
  while (cut_some_edges(is_taken, patch)) {
  }
}

RimFace::RimFace(const RimLoop& loop, const RimPatchOptions& options) : is_corner_(loop.points.size(), false) {
  const std::size_t n = loop.points.size();
  const RimCuts cuts =
      cut_rim(n < long_rim ? loop.points : evened_out(loop, is_corner_).points, options.corner, options.sides);
  for (std::size_t k = 0; k < cuts.at.size(); ++k) is_corner_[cuts.at[k]] = cuts.is_corner[k];
  first_point_ = cuts.at.front();
  even_ = evened_out(loop, is_corner_);
  SurfaceFrame frame;
  frame.mode = options.smooth ? AttributeMode::Smooth : AttributeMode::Position;
  frame.fullness = options.fullness.value_or(1);
  for (std::size_t k = 0; k < cuts.at.size(); ++k) {
    const std::size_t edges = (cuts.at[(k + 1) % cuts.at.size()] + n - cuts.at[k]) % n;
    frame.sides.push_back(make_side(loop, cuts.at[k], edges, options));
  }
  if (options.smooth && !options.fullness) frame.fullness = expected_fullness(frame, even_);
  surface_.emplace(frame);
  for (OutlinePlace& at : outline_) at.place = surface_->side_place(at.side, at.fraction);
  miss_reach_ =
      std::max(edges_of_reach / static_cast<double>(n), misses_of_reach * curve_distance_ / surface_->sigma());
}

SurfaceSide RimFace::make_side(const RimLoop& loop, std::size_t from, std::size_t edges,
                               const RimPatchOptions& options) {
  const std::size_t n = loop.points.size();
  std::vector<Vec3> points;
  for (std::size_t e = 0; e <= edges; ++e) points.push_back(even_.points[(from + e) % n]);
  BezierFitOptions fit;
  fit.divide = false;
  fit.tolerance = fit_tolerance * loop_length(loop) / static_cast<double>(n);
  const auto direction_at = [&](std::size_t i) -> std::optional<Vec3> {
    if (is_corner_[i]) return std::nullopt;
    const Vec3 direction = row_direction(even_.points, i, 0, true);
    return direction == Vec3::Zero() ? std::nullopt : std::optional(direction);
  };
  fit.start_direction = direction_at(from);
  fit.end_direction = direction_at((from + edges) % n);
  const FittedBezier fitted = fit_beziers(points, fit).front();
  SurfaceSide side;
  side.curve = std::make_shared<const ArcLengthCurve>(fitted.control);
  const std::vector<double> fractions = ascending_fractions(fitted, *side.curve, points);
  const std::size_t number = sides_++;
  for (std::size_t e = 0; e < edges; ++e) {
    outline_.push_back({Vec2::Zero(), number, fractions[e]});
    misses_.push_back(loop.points[(from + e) % n] - side.curve->at(fractions[e]));
    curve_distance_ = std::max(curve_distance_, misses_.back().norm());
  }
  if (options.smooth) {
    side.fence.at = fractions;
    for (std::size_t e = 0; e <= edges; ++e) side.fence.normals.push_back(even_.normals[(from + e) % n]);
  }
  return side;
}

double RimFace::spacing() const {
  const SurfacePlace middle = surface_->evaluate(surface_->domain().centroid);
  const double stretch = std::sqrt(middle.du.cross(middle.dv).norm()) / surface_->sigma();
  return 1 / static_cast<double>(outline_.size()) / std::clamp(stretch, 0.5, 4.0);
}

/// The nearer a point of the rim, the more of its miss: those that alternate cancel out a little inside.
Vec3 RimFace::miss_at(const Vec2& place) const {
  Vec3 sum = Vec3::Zero();
  double weights = 0;
  for (std::size_t i = 0; i < outline_.size(); ++i) {
    const double distance = std::max((place - outline_[i].place).norm(), 1e-12);
    const double weight = 1 / (distance * distance * distance);
    sum += weight * misses_[i];
    weights += weight;
  }
  return sum / weights;
}

/// Misses fade without a slope at the rim, so that tangent planes there stay the fence's.
Vec3 RimFace::at(const Vec2& place) const {
  const Vec3 point = surface_->at(place);
  const double depth = distance_inside(surface_->domain(), place) / miss_reach_;
  if (depth >= 1 || curve_distance_ == 0) return point;
  return point + (1 - depth * depth * (3 - 2 * depth)) * miss_at(place);
}

}  // namespace croquis
