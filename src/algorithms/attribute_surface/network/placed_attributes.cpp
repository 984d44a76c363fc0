// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/attribute_surface/network/placed_attributes.h"

#include <utility>

#include "algorithms/attribute_surface/network/loop_curves.h"
#include "croquis/base/stage_key.h"

namespace croquis {
namespace {

/// Footprints nearer than this, in domains of perimeter 1, are one place.
constexpr double least_distance = 1e-6;
/// Nearer than this, the triangles between them are slivers.
constexpr double near_distance = 1e-3;
/// Knots of inner curves, ends included.
constexpr int inner_knots = 33;

double limit_of(const DomainPolygon& polygon) { return 1e-3 / static_cast<double>(polygon.corners.size()); }

/// The footprint of an inner curve: where it leaves the face, the first parameter outside.
struct CurveFootprint {
  PlacedCurve placed;
  std::optional<double> outside;
  bool across = false;  ///< both ends are on the boundary
};

CurveFootprint footprint_along(const ArcLengthCurve& curve, const FaceSurface& base) {
  CurveFootprint result;
  std::optional<Vec2> guess;
  for (int i = 0; i < inner_knots; ++i) {
    const double s = static_cast<double>(i) / (inner_knots - 1);
    const Vec3 point = curve.at(s);
    const NearestPlace found = nearest_base_place(base, point, guess);
    if (found.at_limit && !result.outside) result.outside = s;
    result.placed.points.push_back(point);
    result.placed.places.push_back(found.place);
    if (i == 0) result.across = found.at_limit;
    if (i + 1 == inner_knots) result.across = result.across && found.at_limit;
    guess = found.place;
  }
  return result;
}

std::size_t byte_size(const CurveFootprint& footprint) {
  return sizeof footprint + footprint.placed.points.capacity() * (sizeof(Vec3) + sizeof(Vec2));
}

}  // namespace

PlacedAttributes AttributePlacing::place(Index face, const FaceSurface& base, const std::string& content,
                                         std::vector<SurfacePoint>& places) {
  PlacedAttributes result;
  std::vector<Index> placed;
  for (Index i = 0; i < network_.points.size(); ++i) {
    const PointAttribute& point = network_.points[i];
    if (point.face != face) continue;
    const Footprint footprint = footprint_of(point, base, content);
    if (conflicts(result.points, placed, i, footprint.place)) continue;
    if (footprint.moved_inside) report_moved(point, network_.faces[face]);
    places[i] = {fan_place_in(base.domain(), footprint.place), footprint.moved_inside};
    std::optional<Vec3> normal;
    if (point.normal) normal = point.normal->normalized();
    result.points.push_back({point.point, footprint.place, point.radius, point.profile, normal});
    placed.push_back(i);
  }
  if (base.frame().mode == AttributeMode::Paper) return result;
  for (const InnerCurve& inner : network_.faces[face].inner) {
    auto curve = place_inner(network_.faces[face], inner, base, content);
    if (curve) result.curves.push_back(std::move(*curve));
  }
  return result;
}

AttributePlacing::Footprint AttributePlacing::footprint_of(const PointAttribute& point, const FaceSurface& base,
                                                           const std::string& content) {
  if (!point.fan || point.fan->corner >= base.domain().corners.size()) return nearest(point, base, content);
  const Vec2 place = place_in(base.domain(), *point.fan);
  if (distance_inside(base.domain(), place) >= limit_of(base.domain())) return {place, false};
  // Back towards the middle until it keeps the limit.
  const double depth = distance_inside(base.domain(), place);
  const double middle_depth = distance_inside(base.domain(), base.domain().middle);
  const double part = (limit_of(base.domain()) - depth) / (middle_depth - depth);
  return {place + part * (base.domain().middle - place), true};
}

AttributePlacing::Footprint AttributePlacing::nearest(const PointAttribute& point, const FaceSurface& base,
                                                      const std::string& content) {
  StageKey key;
  key.add(content).add(point.point);
  const auto found = cached<NearestPlace>(
      cache_, "attribute surface footprint", key, [&] { return nearest_base_place(base, point.point); },
      [](const NearestPlace&) { return sizeof(NearestPlace); });
  return {found->place, found->at_limit};
}

bool AttributePlacing::conflicts(const std::vector<PlacedPoint>& before, const std::vector<Index>& ids, Index point,
                                 const Vec2& place) {
  for (std::size_t i = 0; i < before.size(); ++i) {
    const double distance = (before[i].place - place).norm();
    if (distance >= near_distance) continue;
    const std::string& id = network_.points[point].id;
    const std::string& other = network_.points[ids[i]].id;
    const std::string face = quoted(network_.faces[network_.points[point].face].id);
    std::vector<Subject> both{subject_of(SubjectKind::Point, id), subject_of(SubjectKind::Point, other)};
    if (distance < least_distance) {
      findings_.push_back(make_error(Category::Geometry, "E_POINT_CONFLICT",
                                     "Point " + quoted(id) + " is left out, since it lies on the same place of face " +
                                         face + " as point " + quoted(other) +
                                         ": delete one of them, or place one elsewhere.",
                                     std::move(both)));
      return true;
    }
    findings_.push_back(make_warning(Category::Geometry, "W_POINTS_NEAR",
                                     "Points " + quoted(id) + " and " + quoted(other) +
                                         " lie almost on the same place of face " + face +
                                         ", so that the surface is very steep between them: delete one of them, or "
                                         "place one elsewhere.",
                                     std::move(both)));
  }
  return false;
}

void AttributePlacing::report_moved(const PointAttribute& point, const AttributeFace& face) {
  findings_.push_back(make_warning(Category::Geometry, "W_MOVED_INSIDE",
                                   "The place of face " + quoted(face.id) + " nearest to point " + quoted(point.id) +
                                       " is on its boundary, where curves alone decide: the point acts just inside; " +
                                       "move it over the face, or change the curve.",
                                   {subject_of(SubjectKind::Point, point.id), subject_of(SubjectKind::Face, face.id)}));
}

std::optional<PlacedCurve> AttributePlacing::place_inner(const AttributeFace& face, const InnerCurve& inner,
                                                         const FaceSurface& base, const std::string& content) {
  const auto& curve = curves_.curves[inner.curve].curve;
  if (!curve) return std::nullopt;
  StageKey key;
  key.add(content).add(curve->control());
  const auto footprint = cached<CurveFootprint>(
      cache_, "attribute surface inner curve", key, [&] { return footprint_along(*curve, base); },
      [](const CurveFootprint& made) { return byte_size(made); });
  if (footprint->outside) {
    const std::string& id = network_.curves[inner.curve].id;
    findings_.push_back(
        make_error(Category::Geometry, "E_INNER_OUTSIDE",
                   "Inner curve " + quoted(id) + " leaves face " + quoted(face.id) + " at " +
                       rounded_text(*footprint->outside) + " of its length and is left out: " +
                       (footprint->across ? "split the face along it." : "keep it within the face's sides, off them."),
                   {subject_of(SubjectKind::Curve, id), subject_of(SubjectKind::Face, face.id)}));
    return std::nullopt;
  }
  PlacedCurve placed = footprint->placed;
  placed.profile = inner.profile;
  placed.radius = inner.radius;
  return placed;
}

}  // namespace croquis
