// SPDX-License-Identifier: GPL-3.0-or-later
#include "tools/holes/hole_scene.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include <Eigen/Geometry>

#include "croquis/geometry/polyline.h"
#include "tools/pointer/segment_distance.h"

namespace croquis {
namespace {

constexpr std::size_t most_views = 4;     // as many as a window shows at once
constexpr std::size_t sight_samples = 8;  // places of a rim of which one has to be seen

bool same_view(const ViewFrame& a, const ViewFrame& b) { return a.to_clip == b.to_clip && a.size == b.size; }

/// The share of the ray at which it goes into a box, if it does.
bool meets_box(const Ray& ray, const Vec3& low, const Vec3& high) {
  double enter = 0;
  double leave = std::numeric_limits<double>::infinity();
  for (int axis = 0; axis < 3; ++axis) {
    if (ray.direction[axis] == 0) {
      if (ray.origin[axis] < low[axis] || ray.origin[axis] > high[axis]) return false;
      continue;
    }
    const double a = (low[axis] - ray.origin[axis]) / ray.direction[axis];
    const double b = (high[axis] - ray.origin[axis]) / ray.direction[axis];
    enter = std::max(enter, std::min(a, b));
    leave = std::min(leave, std::max(a, b));
  }
  return enter <= leave;
}

/// Möller and Trumbore 1997: the distance along the ray, from either side.
std::optional<double> meets_triangle(const Ray& ray, const Vec3& a, const Vec3& b, const Vec3& c) {
  const Vec3 to_b = b - a;
  const Vec3 to_c = c - a;
  const Vec3 across = ray.direction.cross(to_c);
  const double volume = to_b.dot(across);
  if (volume == 0) return std::nullopt;
  const Vec3 from_a = ray.origin - a;
  const double u = from_a.dot(across) / volume;
  const Vec3 turned = from_a.cross(to_b);
  const double v = ray.direction.dot(turned) / volume;
  const double distance = to_c.dot(turned) / volume;
  if (!(u >= 0 && v >= 0 && u + v <= 1 && distance >= 0)) return std::nullopt;
  return distance;
}

/// Whether a ray from the pixel to the right crosses the polygon an odd number of times. NaN sides don't count.
bool encloses(const std::vector<Vec2>& polygon, const Vec2& pixel) {
  bool inside = false;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Vec2& a = polygon[i];
    const Vec2& b = polygon[(i + 1) % polygon.size()];
    if ((a.y() > pixel.y()) == (b.y() > pixel.y()) || !a.allFinite() || !b.allFinite()) continue;
    if (pixel.x() < a.x() + (pixel.y() - a.y()) / (b.y() - a.y()) * (b.x() - a.x())) inside = !inside;
  }
  return inside;
}

/// Cosine between axis and line of sight (10 degrees): nearer to it the pointer's place on the axis is
/// random.
constexpr double end_on_cosine = 0.985;

}  // namespace

void HoleScene::set_rims(std::vector<HoleRim> rims) {
  rims_ = std::move(rims);
  std::sort(rims_.begin(), rims_.end(), [](const HoleRim& a, const HoleRim& b) { return a.id < b.id; });
  views_.clear();
}

void HoleScene::set_sight(HoleSight sight) {
  sight_ = std::move(sight);
  views_.clear();
}

void HoleScene::set_patches(std::vector<HolePatchView> patches) {
  patches_.clear();
  for (HolePatchView& shown : patches) {
    Vec3 low = Vec3::Constant(std::numeric_limits<double>::infinity());
    Vec3 high = -low;
    for (const Vec3& place : shown.positions) {
      low = low.cwiseMin(place);
      high = high.cwiseMax(place);
    }
    patches_.push_back({std::move(shown), low, high});
  }
}

const HoleRim* HoleScene::rim(Index hole) const {
  const auto found =
      std::lower_bound(rims_.begin(), rims_.end(), hole, [](const HoleRim& rim, Index id) { return rim.id < id; });
  return found != rims_.end() && found->id == hole ? &*found : nullptr;
}

HoleScene::View& HoleScene::view(const ViewFrame& frame) {
  const auto found =
      std::find_if(views_.begin(), views_.end(), [&](const View& v) { return same_view(v.frame, frame); });
  if (found != views_.end()) {
    views_.splice(views_.begin(), views_, found);
    return views_.front();
  }
  if (views_.size() == most_views) views_.pop_back();
  View& fresh = views_.emplace_front();
  fresh.frame = frame;
  fresh.pins = place_pins(rims_, frame, options_.pins, sight_);
  for (const HoleRim& rim : rims_) {
    ScreenRim& shown = fresh.rims.emplace_back();
    shown.box = {Vec2::Constant(std::numeric_limits<double>::infinity()),
                 Vec2::Constant(-std::numeric_limits<double>::infinity())};
    shown.pixels.reserve(rim.points.size());
    for (const Vec3& point : rim.points) {
      const auto at = frame.project(point);
      shown.pixels.push_back(at ? at->pixel : Vec2::Constant(std::numeric_limits<double>::quiet_NaN()));
      if (at) shown.box = {shown.box.low.cwiseMin(at->pixel), shown.box.high.cwiseMax(at->pixel)};
    }
  }
  return fresh;
}

HoleHover HoleScene::at(const ViewFrame& frame, const Vec2& pixel) {
  if (const auto handle = handle_at(frame, pixel))
    return {HolePart::Handle, {handles[*handle].hole}, *handle, handles[*handle].place};
  const View& seen = view(frame);
  if (const HolePin* pin = pin_at(seen, pixel)) return {HolePart::Pin, pin->holes, 0, std::nullopt};
  if (const Index rim = rim_at(seen, pixel); rim != no_index) return {HolePart::Rim, {rim}, 0, std::nullopt};
  if (const auto hit = patch_at(frame, pixel)) return {HolePart::Patch, {hit->hole}, 0, hit->place};
  if (const Index hole = opening_at(seen, pixel); hole != no_index) return {HolePart::Opening, {hole}, 0, std::nullopt};
  return {};
}

Vec3 HoleScene::normal_at(const HoleHover& hover, const ViewFrame& frame) const {
  if (hover.part == HolePart::Handle && hover.handle < handles.size()) return handles[hover.handle].normal;
  const auto at = hover.place ? frame.project(*hover.place) : std::nullopt;
  const auto hit = at ? patch_at(frame, at->pixel) : std::nullopt;
  return hit ? hit->normal : frame.to_eye(hover.place.value_or(Vec3::Zero()));
}

std::optional<std::size_t> HoleScene::handle_at(const ViewFrame& frame, const Vec2& pixel) const {
  std::optional<std::size_t> best;
  double best_distance = options_.handle_pixels;
  for (std::size_t i = 0; i < handles.size(); ++i) {
    const auto at = frame.project(handles[i].place);
    if (!at || (at->pixel - pixel).norm() > best_distance || !sees(frame, handles[i].place)) continue;
    best = i;
    best_distance = (at->pixel - pixel).norm();
  }
  return best;
}

const HolePin* HoleScene::pin_at(const View& view, const Vec2& pixel) const {
  const HolePin* best = nullptr;
  double best_distance = options_.pins.radius + options_.pin_slack;
  for (const HolePin& pin : view.pins) {
    const double distance = (pin.pixel - pixel).norm();
    if (distance > best_distance) continue;
    best = &pin;
    best_distance = distance;
  }
  return best;
}

/// The nearest rim within reach that is seen there.
Index HoleScene::rim_at(const View& view, const Vec2& pixel) const {
  struct Candidate {
    double distance;
    std::size_t rim;
    Vec3 place;
  };
  std::vector<Candidate> candidates;
  const double reach = options_.rim_pixels;
  for (std::size_t r = 0; r < rims_.size(); ++r) {
    const ScreenRim& shown = view.rims[r];
    if (((pixel - shown.box.low).array() < -reach).any() || ((shown.box.high - pixel).array() < -reach).any()) continue;
    Candidate nearest{reach, rims_.size(), Vec3::Zero()};
    for (std::size_t i = 0; i < shown.pixels.size(); ++i) {
      const std::size_t next = (i + 1) % shown.pixels.size();
      const double share = nearest_parameter(pixel, shown.pixels[i], shown.pixels[next]);
      const double distance = (shown.pixels[i] + share * (shown.pixels[next] - shown.pixels[i]) - pixel).norm();
      if (!(distance <= nearest.distance)) continue;  // also NaN
      nearest = {distance, r, rims_[r].points[i] + share * (rims_[r].points[next] - rims_[r].points[i])};
    }
    if (nearest.rim < rims_.size()) candidates.push_back(nearest);
  }
  std::stable_sort(candidates.begin(), candidates.end(),
                   [](const Candidate& a, const Candidate& b) { return a.distance < b.distance; });
  for (const Candidate& candidate : candidates) {
    if (sees(view.frame, candidate.place)) return rims_[candidate.rim].id;
  }
  return no_index;
}

std::optional<HoleScene::PatchHit> HoleScene::patch_at(const ViewFrame& frame, const Vec2& pixel) const {
  const Ray ray = frame.ray(pixel);
  std::optional<PatchHit> best;
  for (const Patch& patch : patches_) {
    if (!meets_box(ray, patch.low, patch.high)) continue;
    for (const auto& [i, j, k] : patch.shown.triangles) {
      const Vec3& a = patch.shown.positions[i];
      const Vec3& b = patch.shown.positions[j];
      const Vec3& c = patch.shown.positions[k];
      const auto distance = meets_triangle(ray, a, b, c);
      if (!distance || (best && best->distance <= *distance)) continue;
      Vec3 normal = (b - a).cross(c - a).normalized();
      if (normal.dot(ray.direction) > 0) normal = -normal;
      best = PatchHit{patch.shown.hole, ray.at(*distance), normal, *distance};
    }
  }
  return best && sees(frame, best->place) ? best : std::nullopt;
}

/// Of the rims around the pixel that look at the eye and are seen, the smallest on screen: the inner one of two.
Index HoleScene::opening_at(const View& view, const Vec2& pixel) const {
  Index best = no_index;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t r = 0; r < rims_.size(); ++r) {
    const PickBox& box = view.rims[r].box;
    const double size = (box.high - box.low).prod();
    if (!(size < least) || !encloses(view.rims[r].pixels, pixel)) continue;
    if (rims_[r].normal.dot(view.frame.to_eye(rims_[r].at)) <= 0 || !sees_some_of(view.frame, rims_[r])) continue;
    best = rims_[r].id;
    least = size;
  }
  return best;
}

bool HoleScene::sees_some_of(const ViewFrame& frame, const HoleRim& rim) const {
  const std::size_t stride = rim.points.size() / sight_samples + 1;
  for (std::size_t i = 0; i < rim.points.size(); i += stride) {
    if (sees(frame, rim.points[i])) return true;
  }
  return false;
}

std::vector<Index> HoleScene::in_box(const ViewFrame& frame, const PickBox& box) const {
  std::vector<Index> inside;
  for (const HoleRim& rim : rims_) {
    const auto at = frame.project(rim.at);
    if (at && box.has(at->pixel) && sees(frame, rim.at)) inside.push_back(rim.id);
  }
  return inside;
}

PatchDrag::PatchDrag(const ViewFrame& frame, const Vec2& grip, const Vec3& from, const std::optional<Vec3>& axis)
    : frame_(frame), grip_(grip), from_(from), axis_(axis) {
  end_on_ = axis && std::abs(axis->dot(frame.to_eye(from))) > end_on_cosine;
}

Vec3 PatchDrag::to(const Vec2& pixel) const {
  if (axis_) return from_ + (along_axis(pixel) - along_axis(grip_)) * *axis_;
  const auto at = frame_.project(from_);
  return at ? frame_.unproject(at->pixel + pixel - grip_, at->depth) : from_;
}

double PatchDrag::along_axis(const Vec2& pixel) const {
  if (end_on_) {
    const double towards_eye = axis_->dot(frame_.to_eye(from_)) < 0 ? -1 : 1;
    return towards_eye * (grip_.y() - pixel.y()) * frame_.units_per_pixel(from_);
  }
  // The place of the axis that the pixel's ray passes nearest to.
  const Ray ray = frame_.ray(pixel);
  const double cosine = ray.direction.dot(*axis_);
  const Vec3 apart = ray.origin - from_;
  const double sine_squared = 1 - cosine * cosine;
  if (!(sine_squared > 0)) return 0;
  return (axis_->dot(apart) - cosine * ray.direction.dot(apart)) / sine_squared;
}

}  // namespace croquis
