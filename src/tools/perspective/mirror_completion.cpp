// SPDX-License-Identifier: GPL-3.0-or-later
#include "croquis/tools/perspective/mirror_completion.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "croquis/tools/perspective/drawing_edit.h"
#include "tools/strokes/cubic_fit.h"

namespace croquis {
namespace {

constexpr int samples_per_curve = 33;

/// px, RMS: what is projected is exact, so that this is the only error that completion adds.
constexpr double fit_tolerance = 0.1;

/// A vertex of a solid has at least three edges.
constexpr int least_edges = 3;

/// Ids need no names here: vertices and curves are found by their numbers.
class MirroredCurves {
 public:
  MirroredCurves(const SolvedDrawing& solved, const MirrorPlane& plane, const MirrorOptions& options)
      : solved_(solved), plane_(plane) {
    const auto& vertices = network().vertices;
    Vec3 low = Vec3::Constant(std::numeric_limits<double>::infinity()), high = -low;
    for (const Vec3& vertex : vertices) {
      low = low.cwiseMin(vertex);
      high = high.cwiseMax(vertex);
    }
    reach_ = options.same_share * (high - low).norm();
    for (const Vec3& vertex : vertices) images_.push_back(nearest_vertex(reflected(vertex)));
  }

  const CurveNetwork& network() const { return solved_.network; }

  Vec3 reflected(const Vec3& point) const {
    Vec3 image = point;
    image[plane_.axis] = 2 * plane_.at - point[plane_.axis];
    return image;
  }

  bool lies_in_plane(const Vec3& point) const { return std::abs(point[plane_.axis] - plane_.at) <= reach_; }

  /// The vertex that is a vertex's image, or no_index.
  Index image_of(Index vertex) const { return images_[vertex]; }

  /// All of it lies in the plane, or another curve is its image.
  bool is_complete(const NetworkCurve& curve) const {
    const bool flat = std::ranges::all_of(curve.pieces, [&](const RationalCubic& piece) {
      return std::ranges::all_of(piece.points, [&](const Vec3& point) { return lies_in_plane(point); });
    });
    return flat || std::ranges::any_of(network().curves, [&](const auto& other) { return is_image(other, curve); });
  }

  std::size_t images_found() const {
    std::size_t count = 0;
    for (std::size_t i = 0; i < images_.size(); ++i) count += images_[i] != no_index && images_[i] != i;
    return count;
  }

 private:
  Index nearest_vertex(const Vec3& place) const {
    Index nearest = no_index;
    double least = reach_;
    for (std::size_t i = 0; i < network().vertices.size(); ++i) {
      const double distance = (network().vertices[i] - place).norm();
      if (distance > least) continue;
      least = distance;
      nearest = static_cast<Index>(i);
    }
    return nearest;
  }

  bool is_image(const NetworkCurve& other, const NetworkCurve& curve) const {
    const Index start = images_[curve.start], end = images_[curve.end];
    if (start == no_index || end == no_index) return false;
    const bool same = other.start == start && other.end == end;
    const bool reversed = other.start == end && other.end == start;
    if (!same && !reversed) return false;
    const auto middle = [](const NetworkCurve& one) { return one.pieces[one.pieces.size() / 2].at(0.5); };
    const bool one_piece = curve.pieces.size() == 1 && other.pieces.size() == 1;
    return !one_piece || (middle(other) - reflected(middle(curve))).norm() <= 4 * reach_;
  }

  const SolvedDrawing& solved_;
  MirrorPlane plane_;
  double reach_ = 0;
  std::vector<Index> images_;
};

/// Where the drawing has a vertex of the network: the nearer end of a stroke that ends there.
std::optional<Vec2> drawn_place(const PerspectiveDrawing& drawing, const SolvedDrawing& solved, Index vertex) {
  const Vec2 seen = solved.camera.project(solved.network.vertices[vertex]);
  for (const NetworkCurve& curve : solved.network.curves) {
    const PerspectiveStroke* stroke = find_stroke(drawing, curve.id);
    if (stroke == nullptr || (curve.start != vertex && curve.end != vertex)) continue;
    return (stroke->start() - seen).norm() <= (stroke->end() - seen).norm() ? stroke->start() : stroke->end();
  }
  return std::nullopt;
}

/// The image's picture: places on it, empty when some of it isn't before the eye.
std::vector<Vec2> seen_image(const SolvedDrawing& solved, const MirroredCurves& mirror, const NetworkCurve& curve) {
  std::vector<Vec2> places;
  for (const RationalCubic& piece : curve.pieces) {
    for (int i = places.empty() ? 0 : 1; i < samples_per_curve; ++i) {
      const Vec3 point = mirror.reflected(piece.at(i / (samples_per_curve - 1.0)));
      if (!(solved.camera.depth(point) > 0)) return {};
      const Vec2 place = solved.camera.project(point);
      if (places.empty() || place != places.back()) places.push_back(place);
    }
  }
  return places;
}

StrokeShape shape_of(const std::vector<Vec2>& places, bool straight) {
  if (straight) return {{line_piece(places.front(), places.back())}, true};
  constexpr double reach = 3;
  const std::vector<Vec2> reversed(places.rbegin(), places.rend());
  StrokeShape shape;
  for (const FittedPiece& piece :
       fit_cubics(places, tangent_at_begin(places, reach), -tangent_at_begin(reversed, reach), reach, fit_tolerance))
    shape.pieces.push_back(piece.cubic);
  return shape;
}

/// Another edge is drawn where the image would be.
bool is_drawn(const PerspectiveDrawing& drawing, const StrokeShape& shape, double reach) {
  const Vec2 middle = place_on(shape.pieces[shape.pieces.size() / 2], 0.5);
  return std::ranges::any_of(drawing.strokes, [&](const PerspectiveStroke& stroke) {
    if (stroke.role != StrokeRole::Edge || !stroke.start().allFinite()) return false;
    const double same = std::max((stroke.start() - shape.start()).norm(), (stroke.end() - shape.end()).norm());
    const double reversed = std::max((stroke.start() - shape.end()).norm(), (stroke.end() - shape.start()).norm());
    const Vec2 other = place_on(stroke.pieces[stroke.pieces.size() / 2], 0.5);
    return std::min(same, reversed) <= reach && (other - middle).norm() <= 2 * reach;
  });
}

/// The place that the image of a vertex is drawn at: of a vertex that is there, in space or on the sheet, else its own.
Vec2 joined_place(const PerspectiveDrawing& drawing, const SolvedDrawing& solved, Index image, const Vec2& seen,
                  double reach) {
  const auto drawn = image == no_index ? std::nullopt : drawn_place(drawing, solved, image);
  if (drawn) return *drawn;
  const auto near = nearest_end(drawing, seen, reach);
  return near ? place_of(drawing, *near) : seen;
}

std::vector<int> edge_counts(const CurveNetwork& network) {
  std::vector<int> counts(network.vertices.size(), 0);
  for (const NetworkCurve& curve : network.curves) {
    ++counts[curve.start];
    ++counts[curve.end];
  }
  return counts;
}

/// The planes through the middle and both ends of each axis.
std::vector<MirrorPlane> planes_to_try(const CurveNetwork& network) {
  std::vector<MirrorPlane> planes;
  for (int axis = 0; axis < 3; ++axis) {
    const auto along = [axis](const Vec3& vertex) { return vertex[axis]; };
    const auto [low, high] = std::ranges::minmax(network.vertices, {}, along);
    for (const double at : {(low[axis] + high[axis]) / 2, low[axis], high[axis]}) planes.push_back({axis, at});
  }
  return planes;
}

/// Vertices that have their image count for the plane; those that stay without are a reason against it, unless
/// they lie off a plane at which open ends wait for the other half.
double worth_of(const MirroredCurves& mirror, const std::vector<int>& counts) {
  const auto& vertices = mirror.network().vertices;
  std::size_t in_plane = 0, waiting = 0;
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    if (!mirror.lies_in_plane(vertices[i])) continue;
    ++in_plane;
    waiting += counts[i] > 0 && counts[i] < least_edges;
  }
  const std::size_t others = vertices.size() - in_plane;
  const double paired = others == 0 ? 0 : static_cast<double>(mirror.images_found()) / static_cast<double>(others);
  if (paired > 0.5) return 1 + paired;
  return mirror.images_found() == 0 && waiting >= 2 ? static_cast<double>(waiting) / static_cast<double>(in_plane) : 0;
}

}  // namespace

std::vector<PerspectiveStroke> mirrored_strokes(const PerspectiveDrawing& drawing, const SolvedDrawing& solved,
                                                const MirrorPlane& plane, const MirrorOptions& options) {
  std::vector<PerspectiveStroke> strokes;
  if (solved.network.vertices.empty()) return strokes;
  const MirroredCurves mirror(solved, plane, options);
  const double reach = options.same_sheet * drawing.diagonal();
  for (const NetworkCurve& curve : solved.network.curves) {
    const PerspectiveStroke* original = find_stroke(drawing, curve.id);
    if (original == nullptr || original->role != StrokeRole::Edge || mirror.is_complete(curve)) continue;
    const std::vector<Vec2> places = seen_image(solved, mirror, curve);
    if (places.size() < 2) continue;
    StrokeShape shape = shape_of(places, curve.straight);
    const Vec2 start = joined_place(drawing, solved, mirror.image_of(curve.start), shape.start(), reach);
    const Vec2 end = joined_place(drawing, solved, mirror.image_of(curve.end), shape.end(), reach);
    if ((end - start).norm() < reach) continue;
    shape = with_ends(std::move(shape), start, end);
    if (is_drawn(drawing, shape, reach)) continue;
    PerspectiveStroke stroke;
    stroke.group = original->group;
    stroke.pieces = std::move(shape.pieces);
    stroke.straight = shape.straight;
    stroke.hidden = true;
    strokes.push_back(std::move(stroke));
  }
  return strokes;
}

std::optional<MirrorProposal> propose_mirror(const PerspectiveDrawing& drawing, const SolvedDrawing& solved,
                                             const MirrorOptions& options) {
  const std::vector<int> counts = edge_counts(solved.network);
  const bool dangles = std::ranges::find(counts, 1) != counts.end();
  if (counts.empty() || (solved.open_strokes.empty() && !dangles)) return std::nullopt;
  double best = 0;
  MirrorProposal proposal;
  for (const MirrorPlane& plane : planes_to_try(solved.network)) {
    const MirroredCurves mirror(solved, plane, options);
    const double worth = worth_of(mirror, counts);
    if (worth <= best) continue;
    std::vector<PerspectiveStroke> strokes = mirrored_strokes(drawing, solved, plane, options);
    if (strokes.empty()) continue;
    best = worth;
    proposal = {plane, std::move(strokes)};
  }
  return proposal.strokes.empty() ? std::nullopt : std::optional(std::move(proposal));
}

std::vector<std::string> add_mirrored(PerspectiveDrawing& drawing, const std::vector<PerspectiveStroke>& strokes) {
  std::vector<std::string> ids;
  for (const PerspectiveStroke& stroke : strokes) {
    ids.push_back(add_stroke(drawing, {stroke.pieces, stroke.straight}, stroke.group, stroke.role, stroke.hidden));
  }
  return ids;
}

}  // namespace croquis
