// SPDX-License-Identifier: GPL-3.0-or-later
#include "tools/surface/patch_sight.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <unordered_map>
#include <utility>

#include <Eigen/Geometry>

#include "croquis/attribute_surface/network_elements.h"
#include "tools/pointer/face_tree.h"

namespace croquis::test {
namespace {

constexpr double handle_share = 0.08;  // × the loop's length: how long a slope of magnitude 1 is shown
constexpr int ring_places = 64;

/// A triangle's face and the places of its corners in the domain.
struct DomainTriangle {
  Index face = no_index;
  std::array<Vec2, 3> places = {Vec2::Zero(), Vec2::Zero(), Vec2::Zero()};
};

std::vector<DomainTriangle> domain_triangles(const SurfaceTessellation& shown) {
  std::vector<DomainTriangle> triangles(shown.mesh.face_count());
  for (const SurfacePart& part : shown.parts) {
    std::unordered_map<Index, Vec2> places;
    for (std::size_t i = 0; i < part.vertices.size(); ++i) places.emplace(part.vertices[i], part.places[i]);
    for (std::size_t t = part.first_triangle; t < part.first_triangle + part.triangle_count; ++t) {
      triangles[t].face = part.face;
      for (std::size_t k = 0; k < 3; ++k)
        triangles[t].places[k] = places.at(shown.mesh.corners[shown.mesh.face_offsets[t] + k]);
    }
  }
  return triangles;
}

/// Shares of a triangle's corners at a place of its plane.
Vec3 shares_at(const std::array<Vec3, 3>& corners, const Vec3& place) {
  const Vec3 normal = (corners[1] - corners[0]).cross(corners[2] - corners[0]);
  const double area = normal.squaredNorm();
  if (!(area > 0)) return {1, 0, 0};
  const double b = (place - corners[0]).cross(corners[2] - corners[0]).dot(normal) / area;
  const double c = (corners[1] - corners[0]).cross(place - corners[0]).dot(normal) / area;
  return {1 - b - c, b, c};
}

/// Brought inside along the way to the middle, by halving.
Vec2 inside(const DomainPolygon& domain, const Vec2& place) {
  if (distance_inside(domain, place) >= 0) return place;
  double low = 0, high = 1;
  for (int step = 0; step < 40; ++step) {
    const double middle = (low + high) / 2;
    const Vec2 tried = domain.middle + middle * (place - domain.middle);
    (distance_inside(domain, tried) >= 0 ? low : high) = middle;
  }
  return domain.middle + low * (place - domain.middle);
}

}  // namespace

struct PatchSight::State {
  std::shared_ptr<const AttributeNetwork> network;
  std::shared_ptr<const AttributeSurface> surface;
  std::shared_ptr<const SurfaceTessellation> shown;
  FindMesh find_mesh;
  FaceTree tree;
  std::vector<DomainTriangle> triangles;

  /// A point attribute with the surface that it is on.
  struct OnSurface {
    const PointAttribute* point = nullptr;
    const FaceSurface* surface = nullptr;
    Vec2 place = Vec2::Zero();
  };

  std::optional<OnSurface> find(const std::string& id) const {
    const Index index = find_element(*network, NetworkElement::Point, id);
    if (index == no_index || !surface->points[index].fan) return std::nullopt;
    const PointAttribute& point = network->points[index];
    const FaceSurface* patch = surface->faces[point.face].surface.get();
    if (patch == nullptr) return std::nullopt;
    return OnSurface{&point, patch, place_in(patch->domain(), *surface->points[index].fan)};
  }
};

PatchSight::PatchSight(std::shared_ptr<const AttributeNetwork> network, std::shared_ptr<const AttributeSurface> surface,
                       std::shared_ptr<const SurfaceTessellation> tessellation, FindMesh find_mesh) {
  FaceTree tree(tessellation->mesh);
  std::vector<DomainTriangle> triangles = domain_triangles(*tessellation);
  state_ = std::make_unique<const State>(State{std::move(network), std::move(surface), std::move(tessellation),
                                               std::move(find_mesh), std::move(tree), std::move(triangles)});
}

PatchSight::~PatchSight() = default;

std::optional<SurfaceHit> PatchSight::patch_under(const Ray& ray) const {
  const PolyMesh& mesh = state_->shown->mesh;
  if (state_->triangles.empty()) return std::nullopt;
  const FaceTree::Hit hit = state_->tree.first(mesh, ray, 0, std::numeric_limits<double>::infinity());
  if (hit.face == no_index) return std::nullopt;
  const DomainTriangle& triangle = state_->triangles[hit.face];
  const FaceSurface* patch = triangle.face == no_index ? nullptr : state_->surface->faces[triangle.face].surface.get();
  if (patch == nullptr) return std::nullopt;
  std::array<Vec3, 3> corners;
  for (std::size_t k = 0; k < 3; ++k) corners[k] = mesh.positions[mesh.corners[mesh.face_offsets[hit.face] + k]];
  const Vec3 shares = shares_at(corners, ray.at(hit.distance));
  const Vec2 place = shares[0] * triangle.places[0] + shares[1] * triangle.places[1] + shares[2] * triangle.places[2];
  SurfaceHit found;
  found.face = state_->network->faces[triangle.face].id;
  found.fan = fan_place_in(patch->domain(), place);
  found.point = patch->at(place);
  found.normal = patch->normal(place);
  found.distance = hit.distance;
  return found;
}

std::optional<MeshHit> PatchSight::mesh_under(const Ray& ray) const {
  return state_->find_mesh ? state_->find_mesh(ray) : std::nullopt;
}

std::optional<Vec3> PatchSight::normal_at(const std::string& point) const {
  const auto found = state_->find(point);
  if (!found) return std::nullopt;
  const Vec3 normal = found->surface->normal(found->place);
  return normal.norm() > 0.5 ? std::optional(normal) : std::nullopt;
}

std::optional<double> PatchSight::radius_of(const std::string& point) const {
  const auto found = state_->find(point);
  if (!found) return std::nullopt;
  for (const PlacedPoint& placed : found->surface->points()) {
    if ((placed.place - found->place).norm() < 1e-9 && placed.radius) return placed.radius;
  }
  return found->point->radius;
}

std::vector<Vec3> PatchSight::ring_of(const std::string& point, double radius) const {
  const auto found = state_->find(point);
  if (!found) return {};
  std::vector<Vec3> ring;
  const double reach = radius / found->surface->sigma();
  for (int i = 0; i < ring_places; ++i) {
    const double angle = 2 * std::numbers::pi * i / ring_places;
    const Vec2 place = found->place + reach * Vec2(std::cos(angle), std::sin(angle));
    ring.push_back(found->surface->at(inside(found->surface->domain(), place)));
  }
  return ring;
}

std::optional<SlopeFrame> PatchSight::slope_at(const std::string& face, const std::string& curve, double at) const {
  const AttributeNetwork& network = *state_->network;
  const Index index = find_element(network, NetworkElement::Face, face);
  const Index along = find_element(network, NetworkElement::Curve, curve);
  if (index == no_index || along == no_index || !state_->surface->faces[index].surface) return std::nullopt;
  const auto& loop = network.faces[index].loop;
  const auto side = std::ranges::find(loop, along, &AttributeSide::curve);
  if (side == loop.end()) return std::nullopt;
  const FaceSurface& patch = *state_->surface->faces[index].surface;
  const auto number = static_cast<std::size_t>(side - loop.begin());
  const auto place = state_->surface->curves[along].curve->place(at);
  const Vec3 tangent = (side->reversed ? -1 : 1) * unit_or_zero(place.derivative);
  SlopeFrame frame;
  frame.point = place.point;
  frame.normal = patch.side_normal(number, side->reversed ? 1 - at : at);
  frame.inward = unit_or_zero(frame.normal.cross(tangent));
  frame.length = handle_share * patch.sigma();
  return frame.inward.norm() > 0 ? std::optional(frame) : std::nullopt;
}

}  // namespace croquis::test
