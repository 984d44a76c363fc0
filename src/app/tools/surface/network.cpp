// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/tools/surface/network.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

#include <Eigen/Geometry>

#include "app/views/own_space.h"
#include "app/views/viewport.h"
#include "croquis/attribute_surface/domain_comparison.h"
#include "croquis/base/error.h"
#include "croquis/mesh_editing/mesh_edit.h"

namespace croquis::app {
namespace {

constexpr int ring_places = 64;
constexpr double handle_share = 0.06;  // of the loop's length: a slope's handle

/// A ray in another space. @return and how long its unit is there
std::pair<Ray, double> mapped(const Ray& ray, const Affine3& map) {
  const Vec3 direction = map.linear * ray.direction;
  const double stretch = direction.norm();
  return {Ray{map(ray.origin), direction / stretch}, stretch};
}

/// Normals go the other way round by the transpose.
Vec3 normal_back(const Vec3& normal, const Affine3& map) { return (map.linear.transpose() * normal).normalized(); }

/// How far a direction can be followed inside a polygon.
double way_inside(const DomainPolygon& domain, const Vec2& from, const Vec2& direction) {
  double way = std::numeric_limits<double>::infinity();
  for (std::size_t k = 0; k < domain.corners.size(); ++k) {
    const Vec2& a = domain.corners[k];
    const Vec2 along = (domain.corners[(k + 1) % domain.corners.size()] - a).normalized();
    const Vec2 inward(-along.y(), along.x());
    const double nearer = -direction.dot(inward);
    if (nearer > 0) way = std::min(way, std::max(0.0, (from - a).dot(inward)) / nearer);
  }
  return way;
}

/// Weights of a triangle's corners at a place in its plane.
Vec3 weights_at(const std::array<Vec3, 3>& triangle, const Vec3& place) {
  const Vec3 normal = (triangle[1] - triangle[0]).cross(triangle[2] - triangle[0]);
  const double area = normal.squaredNorm();
  if (!(area > 0)) return Vec3::Constant(1.0 / 3);
  const double b = (place - triangle[0]).cross(triangle[2] - triangle[0]).dot(normal) / area;
  const double c = (triangle[1] - triangle[0]).cross(place - triangle[0]).dot(normal) / area;
  return {1 - b - c, b, c};
}

/// Where a ray in the world meets the mesh of an object. @param except an object: the one that is drawn
std::optional<MeshHit> nearest_hit(const Studio& studio, MeshPickers& pickers, const Ray& ray, NodeId except) {
  std::optional<MeshHit> nearest;
  for (const WorkObject& object : studio.objects()) {
    const bool is_seen = object.visible && object.shown() && object.shown()->face_count() > 0;
    if (!is_seen || object.node == except) continue;
    const Affine3 to_model = object.placement.map();
    const Affine3 back = inverse_of(to_model);
    const auto hit = pickers.of(object).face_under({back(ray.origin), (back.linear * ray.direction).normalized()});
    const Vec3 place = hit ? to_model(hit->place) : Vec3();
    const double distance = (place - ray.origin).norm();
    if (!hit || (nearest && distance >= nearest->distance)) continue;
    const Vec3 normal = back.linear.transpose() * mean_normal(*object.shown(), std::array{hit->element});
    nearest = MeshHit{place, normal.normalized(), distance};
  }
  return nearest;
}

}  // namespace

const FaceSurface* NetworkSight::surface_of(Index face) const {
  return !shown_ || face == no_index ? nullptr : shown_.surface().faces[face].surface.get();
}

std::optional<NetworkSight::Placed> NetworkSight::placed(const std::string& id) const {
  const Index point = shown_ ? shown_.find(NetworkElement::Point, id) : no_index;
  if (point == no_index) return std::nullopt;
  const auto index = placed_index(shown_.network(), shown_.surface(), point);
  if (!index) return std::nullopt;
  return Placed{surface_of(shown_.network().points[point].face), *index};
}

MeshPicker& NetworkSight::picker() const {
  if (!picker_) picker_ = std::make_unique<MeshPicker>(shown_.mesh);
  return *picker_;
}

/// Between the corners of the triangle.
std::optional<Vec2> NetworkSight::domain_place(const SurfacePart& part, Index triangle, const Vec3& place) const {
  const auto corners = shown_.mesh->face(triangle);
  if (corners.size() != 3) return std::nullopt;
  const Vec3 weights = weights_at(
      {shown_.mesh->positions[corners[0]], shown_.mesh->positions[corners[1]], shown_.mesh->positions[corners[2]]},
      place);
  Vec2 found = Vec2::Zero();
  for (int k = 0; k < 3; ++k) {
    const auto vertex = std::ranges::find(part.vertices, corners[static_cast<std::size_t>(k)]);
    if (vertex == part.vertices.end()) return std::nullopt;
    found += weights[k] * part.places[static_cast<std::size_t>(vertex - part.vertices.begin())];
  }
  return found;
}

std::optional<SurfaceHit> NetworkSight::patch_under(const Ray& ray) const {
  if (!shown_ || !shown_.mesh || shown_.mesh->face_count() == 0) return std::nullopt;
  const auto [in_mesh, stretch] = mapped(ray, shown_.to_mesh);
  const auto hit = picker().face_under(in_mesh);
  if (!hit) return std::nullopt;
  const auto part = std::ranges::find_if(shown_.found->parts, [&](const SurfacePart& one) {
    return hit->element >= one.first_triangle && hit->element < one.first_triangle + one.triangle_count;
  });
  if (part == shown_.found->parts.end()) return std::nullopt;
  const FaceSurface* surface = surface_of(part->face);
  const auto place = domain_place(*part, hit->element, hit->place);
  if (surface == nullptr || !place) return std::nullopt;
  return SurfaceHit{shown_.network().faces[part->face].id, fan_place_in(surface->domain(), *place),
                    inverse_of(shown_.to_result)(surface->at(*place)),
                    normal_back(surface->normal(*place), shown_.to_result), hit->distance / stretch};
}

std::optional<MeshHit> NetworkSight::mesh_under(const Ray& ray) const {
  const auto [in_world, stretch] = mapped(ray, shown_.to_world);
  auto hit = nearest_hit(studio_, meshes_, in_world, object_);
  if (!hit) return std::nullopt;
  hit->point = inverse_of(shown_.to_world)(hit->point);
  hit->normal = normal_back(hit->normal, shown_.to_world);
  hit->distance /= stretch;
  return hit;
}

std::optional<Vec3> NetworkSight::normal_at(const std::string& point) const {
  const auto found = placed(point);
  if (!found) return std::nullopt;
  const Vec3 normal = found->face->normal(found->point().place);
  if (normal.isZero()) return std::nullopt;
  return normal_back(normal, shown_.to_result);
}

std::optional<double> NetworkSight::radius_of(const std::string& point) const {
  const auto found = placed(point);
  return found ? found->point().radius : std::nullopt;
}

std::vector<Vec3> NetworkSight::ring_of(const std::string& point, double radius) const {
  const auto found = placed(point);
  if (!found) return {};
  const Affine3 back = inverse_of(shown_.to_result);
  const Vec2& middle = found->point().place;
  std::vector<Vec3> ring;
  for (int k = 0; k < ring_places; ++k) {
    const double angle = 2 * std::numbers::pi * k / ring_places;
    const Vec2 direction(std::cos(angle), std::sin(angle));
    const double way = std::min(radius / found->face->sigma(), way_inside(found->face->domain(), middle, direction));
    ring.push_back(back(found->face->at(middle + way * direction)));
  }
  return ring;
}

std::optional<SlopeFrame> NetworkSight::slope_at(const std::string& face_id, const std::string& curve_id,
                                                 double at) const {
  const Index face = shown_ ? shown_.find(NetworkElement::Face, face_id) : no_index;
  const Index curve = shown_ ? shown_.find(NetworkElement::Curve, curve_id) : no_index;
  const FaceSurface* surface = surface_of(face);
  if (surface == nullptr || curve == no_index) return std::nullopt;
  const std::vector<AttributeSide>& loop = shown_.network().faces[face].loop;
  const auto side = std::ranges::find(loop, curve, &AttributeSide::curve);
  if (side == loop.end()) return std::nullopt;
  const auto number = static_cast<std::size_t>(side - loop.begin());
  const double fraction = side->reversed ? 1 - at : at;
  const SurfaceSide& walked = surface->frame().sides[number];
  const auto on_curve = walked.curve->place(at);
  const Vec3 along = (side->reversed ? -1 : 1) * on_curve.derivative.normalized();
  const Vec3 normal = surface->side_normal(number, fraction);
  const Vec3 inward = normal.cross(along);
  if (!(inward.norm() > 0)) return std::nullopt;
  const Affine3 back = inverse_of(shown_.to_result);
  return SlopeFrame{back(on_curve.point), normal_back(normal, shown_.to_result), (back.linear * inward).normalized(),
                    handle_share * surface->sigma()};
}

DrawnNetwork::DrawnNetwork(Tool& tool_of_window, ToolHost& window)
    : owner(tool_of_window),
      host(window),
      tool(window.studio().session(), window.studio().network_options()),
      content(std::make_shared<const AttributeNetwork>()) {
  tool.settings().ground = {Vec3::Zero(), Vec3::UnitZ()};
}

ViewFrame DrawnNetwork::frame_of(int view) const { return seen_from(app::frame_of(host.views(), view), to_world()); }

void DrawnNetwork::act(const recorded::Step& step) {
  try {
    finish(tool.take(step));
  } catch (const Error& error) {
    host.say(sentences_of(error.findings()));
  }
  show_preview();
  owner.refresh();
  emit owner.state_changed();
}

void DrawnNetwork::finish(Verdict verdict) {
  if (verdict == Verdict::Commit && tool.done()) emit owner.committed(*tool.done());
  if (!tool.active()) host.say(sentences_of(tool.notes()));
}

void DrawnNetwork::show_preview() {
  scene.show_preview(tool.preview(), network(), to_world());
  scene.show_handles(tool, network(), to_world());
  emit owner.changed();
}

void DrawnNetwork::show_jumps(bool on) {
  jumps = on;
  scene.show_jumps(network(), shown, jumps);
  emit owner.changed();
}

void DrawnNetwork::follow_document() {
  const NodeId node = host.studio().network_node();
  if (!owner.down()) tool.settings().node = node;
  const auto network = source_of<AttributeNetwork>(host.studio().session().document().find(node));
  content = network ? network : std::make_shared<const AttributeNetwork>();
  follow_result();
}

void DrawnNetwork::follow_result() {
  const NodeId node = host.studio().network_node();
  if (node == 0) return;
  const NodeId operation = tool.operation_node();
  ShownSurface now = shown_surface(host.studio(), node, operation);
  if (now.result != shown.result || now.mesh != shown.mesh || now.to_world != shown.to_world) {
    const WorkObject* object = host.studio().object(operation);
    sight = std::make_shared<NetworkSight>(now, object == nullptr ? operation : object->node, host.studio(), meshes);
    tool.settings().sight = sight;
  }
  shown = std::move(now);
  scene.show_network(network(), shown, tool.selected());
  scene.show_findings(network(), to_world(), findings());
  scene.show_jumps(network(), shown, jumps);
  show_preview();
}

void look_at(DrawnNetwork& network, const NetworkElements& elements) {
  if (elements.empty()) return;
  if (network.host.views().mode != select_mode) network.host.set_mode(select_mode);
  network.act(recorded::SurfaceChoice{elements});
  frame_selection(network.host.views());
}

}  // namespace croquis::app
