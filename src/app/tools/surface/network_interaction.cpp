// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/tools/surface/network_interaction.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

#include <Eigen/Geometry>

#include "app/views/own_space.h"
#include "app/views/viewport.h"
#include "croquis/attribute_surface/domain_comparison.h"
#include "croquis/base/error.h"

namespace croquis::app {
namespace {

/// Newell's normal: of concave faces, too. Of no length for a face without area.
Vec3 face_normal(const PolyMesh& mesh, Index face) {
  const auto corners = mesh.face(face);
  Vec3 sum = Vec3::Zero();
  for (std::size_t k = 0; k < corners.size(); ++k) {
    const Vec3& a = mesh.positions[corners[k]];
    const Vec3& b = mesh.positions[corners[(k + 1) % corners.size()]];
    sum += (a - mesh.positions[corners[0]]).cross(b - mesh.positions[corners[0]]);
  }
  return sum.normalized();
}

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

constexpr int network_watch_ms = 100;
constexpr double network_mark_reach = 12;  // logical pixels

QString network_sentences(const Findings& findings) {
  QStringList sentences;
  for (const Finding& finding : findings) {
    const QString sentence = QString::fromStdString(finding.message);
    sentences << (sentence.endsWith('.') ? sentence : sentence + ".");
  }
  return sentences.join(' ');
}

const std::shared_ptr<const AttributeNetwork>& no_network() {
  static const auto none = std::make_shared<const AttributeNetwork>();
  return none;
}

}  // namespace

MeshPicker& DrawableMeshes::picker_of(const WorkObject& object) {
  Kept& kept = kept_[object.node];
  if (kept.mesh != object.shown()) {
    kept.mesh = object.shown();
    kept.picker = std::make_unique<MeshPicker>(kept.mesh);
  }
  return *kept.picker;
}

std::optional<MeshHit> DrawableMeshes::under(const Ray& ray, NodeId except) {
  std::optional<MeshHit> nearest;
  for (const WorkObject& object : studio_.objects()) {
    const bool is_seen = object.visible && object.shown() && object.shown()->face_count() > 0;
    if (!is_seen || object.node == except) continue;
    const Affine3 to_model = object.placement.map();
    const Affine3 back = inverse_of(to_model);
    const auto hit = picker_of(object).face_under({back(ray.origin), (back.linear * ray.direction).normalized()});
    const Vec3 place = hit ? to_model(hit->place) : Vec3();
    const double distance = (place - ray.origin).norm();
    if (!hit || (nearest && distance >= nearest->distance)) continue;
    const Vec3 normal = back.linear.transpose() * face_normal(*object.shown(), hit->element);
    nearest = MeshHit{place, normal.normalized(), distance};
  }
  return nearest;
}

const FaceSurface* NetworkSight::surface_of(Index face) const {
  return !shown_ || face == no_index ? nullptr : shown_.surface().faces[face].surface.get();
}

std::optional<NetworkSight::Placed> NetworkSight::placed(const std::string& id) const {
  const Index point = shown_ ? shown_.point(id) : no_index;
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
  auto hit = meshes_.under(in_world, object_);
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
  const Index face = shown_ ? shown_.face(face_id) : no_index;
  const Index curve = shown_ ? shown_.curve(curve_id) : no_index;
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

NetworkInteraction::NetworkInteraction(Studio& studio, Viewport& views)
    : studio_(studio),
      views_(views),
      tool_(studio.session(), studio.network_options()),
      meshes_(studio),
      network_(no_network()) {
  tool_.settings().ground = {Vec3::Zero(), Vec3::UnitZ()};
  connect(&pen_watch_, &QTimer::timeout, this,
          [this] { take_pen(pen_.settle(last_time_ + static_cast<double>(since_event_.nsecsElapsed()) * 1e-9)); });
}

Findings NetworkInteraction::findings() const { return shown_.result ? shown_.result->findings : Findings(); }

ViewFrame NetworkInteraction::frame_of(int view) const { return seen_from(views_.frame_of(view), shown_.to_world); }

void NetworkInteraction::act(const recorded::Step& step) {
  try {
    finish(tool_.take(step));
  } catch (const Error& error) {
    emit told(network_sentences(error.findings()));
  }
  show_preview();
  emit state_changed();
}

void NetworkInteraction::finish(Verdict verdict) {
  if (verdict == Verdict::Commit && tool_.done()) emit committed(*tool_.done());
  if (!tool_.active()) emit told(network_sentences(tool_.notes()));
}

void NetworkInteraction::set_mode(SurfaceMode mode) {
  tool_.set_mode(mode);
  studio_.hold_results(false);
  show_preview();
}

void NetworkInteraction::take(const PointerEvent& event) {
  last_time_ = event.time;
  since_event_.start();
  take_pen(pen_.handle(event));
  if (event.action == PointerEvent::Action::Leave) {
    told_finding_.clear();
    if (tool_.leave()) show_preview();
  } else if (!pen_.down()) {
    hover(event);
  }
}

bool NetworkInteraction::abandon() {
  if (!pen_.down()) return false;
  take_pen(pen_.cancel());
  return true;
}

void NetworkInteraction::take_pen(const std::vector<PenStep>& steps) {
  const bool was_active = tool_.active();
  for (const PenStep& step : steps) feed(step);
  if (pen_.down() && !pen_watch_.isActive()) pen_watch_.start(network_watch_ms);
  if (!pen_.down()) pen_watch_.stop();
  if (steps.empty()) return;
  // Nothing else changes under a pen that draws: what is computed meanwhile is shown when the stroke has ended.
  studio_.hold_results(tool_.active() && tool_.mode() == SurfaceMode::Draw);
  show_preview();
  if (was_active != tool_.active()) emit state_changed();
}

void NetworkInteraction::feed(const PenStep& step) {
  gesture_view_ = step.view;
  const MeshEvent event{step.kind, step.sample.position, step.modifiers, frame_of(step.view), step.sample.time};
  try {
    const Verdict verdict = tool_.handle(event);
    if (step.kind == PenStep::Kind::End || step.kind == PenStep::Kind::Cancel) finish(verdict);
  } catch (const Error& error) {
    emit told(network_sentences(error.findings()));
  }
}

void NetworkInteraction::hover(const PointerEvent& event) {
  gesture_view_ = event.view;
  const QString before = std::exchange(told_finding_, told_at(event.position, event.view));
  if (tool_.hover(event.position, frame_of(event.view))) show_preview();
}

QString NetworkInteraction::told_at(const Vec2& pixel, int view) const {
  QStringList sentences;
  const ViewFrame frame = views_.frame_of(view);
  for (const NetworkMark& mark : scene_.marks()) {
    const auto seen = frame.project(mark.at);
    const bool under = seen && (seen->pixel - pixel).norm() < network_mark_reach;
    if (under && !sentences.contains(mark.sentence)) sentences << mark.sentence;
  }
  return sentences.join("\n");
}

void NetworkInteraction::show_preview() {
  scene_.show_preview(tool_.preview(), *network_, to_world());
  scene_.show_handles(tool_, *network_, to_world());
  emit changed();
}

void NetworkInteraction::show_jumps(bool on) {
  jumps_ = on;
  scene_.show_jumps(*network_, shown_, jumps_);
  emit changed();
}

void NetworkInteraction::add_to(render::Scene& scene, int view) const {
  scene_.add_to(scene);
  const auto& box = tool_.preview().box;
  if (box && view == gesture_view_) add_box(*box, views_.frame_of(view), scene);
}

void NetworkInteraction::follow_document() {
  const NodeId node = studio_.network_node();
  if (!pen_.down()) tool_.settings().node = node;
  const auto network = source_of<AttributeNetwork>(studio_.session().document().find(node));
  network_ = network ? network : no_network();
  follow_result();
}

void NetworkInteraction::follow_result() {
  const NodeId node = studio_.network_node();
  if (node == 0) return;
  const NodeId operation = tool_.operation_node();
  ShownSurface now = shown_surface(studio_, node, operation);
  if (now.result != shown_.result || now.mesh != shown_.mesh || now.to_world != shown_.to_world) {
    const WorkObject* object = studio_.object(operation);
    sight_ = std::make_shared<NetworkSight>(now, object == nullptr ? operation : object->node, meshes_);
    tool_.settings().sight = sight_;
  }
  shown_ = std::move(now);
  scene_.show_network(*network_, shown_, tool_.selected());
  scene_.show_findings(*network_, to_world(), findings());
  scene_.show_jumps(*network_, shown_, jumps_);
  show_preview();
}

}  // namespace croquis::app
