// SPDX-License-Identifier: GPL-3.0-or-later
// Where strokes lie in space, and what their ends go to.
#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "croquis/tools/surface/surface_tool.h"
#include "tools/surface/drawn_curves.h"

namespace croquis {
namespace {

constexpr double most_samples = 0.6;      // share of a stroke's samples that must lie over what it is drawn on
constexpr double curve_snap_share = 0.7;  // × the reach of nodes: curves are everywhere, and nodes come first
constexpr double on_ground = 1e-6;        // × the network's size: so near to the ground is on it

/// 1 for a plane seen straight on, less the flatter it is seen: there a pen that is a pixel off goes far.
double slant_of(const SpacePlane& plane, const ViewFrame& frame, const Vec3& place) {
  constexpr double flattest = 0.25;
  return std::max(flattest, std::abs(frame.to_eye(place).dot(plane.normal.normalized())));
}

}  // namespace

std::optional<SurfaceSnap> SurfaceTool::snap_at(const ViewFrame& frame, const Vec2& pixel) const {
  const auto now = network();
  if (!now) return std::nullopt;
  if (const auto node = nearest_node(*now, frame, pixel, options_.snap_pixels))
    return SurfaceSnap{{node->id, {}, 0}, node->place};
  const auto curve = nearest_curve(*now, frame, pixel, curve_snap_share * options_.snap_pixels);
  if (!curve) return std::nullopt;
  const AttributeCurve& found = now->curves[require_element(*now, NetworkElement::Curve, curve->id)];
  if (found.from == no_index || found.to == no_index) return std::nullopt;  // inner curves have no nodes to share
  return SurfaceSnap{{{}, curve->id, curve->at}, curve->place};
}

void SurfaceTool::add_sample(const Vec2& pixel) {
  Sample sample{pixel, {}, {}};
  if (sight_ && !start_.pointer.modifiers.ctrl) {
    const Ray ray = start_.pointer.frame.ray(pixel);
    sample.patch = sight_->patch_under(ray);
    const auto mesh = sight_->mesh_under(ray);
    if (mesh && (!sample.patch || mesh->distance < sample.patch->distance)) {
      sample.mesh = mesh->point;
      sample.patch.reset();
    }
  }
  samples_.push_back(std::move(sample));
}

/// Where a stroke begins on nothing it is drawn on the patch under its beginning; else on the one under most of it.
std::string SurfaceTool::face_drawn_on() const {
  if (!from_ && !samples_.front().patch) return {};
  if (!from_) return samples_.front().patch->face;
  std::map<std::string, std::size_t> counts;
  for (const Sample& sample : samples_) {
    if (sample.patch) ++counts[sample.patch->face];
  }
  for (const auto& [face, count] : counts) {
    if (static_cast<double>(count) > most_samples * static_cast<double>(samples_.size())) return face;
  }
  return {};
}

bool SurfaceTool::draws_on_mesh() const {
  if (!from_) return samples_.front().mesh.has_value();
  const auto count = std::ranges::count_if(samples_, [](const Sample& sample) { return sample.mesh.has_value(); });
  return static_cast<double>(count) > most_samples * static_cast<double>(samples_.size());
}

SpacePlane SurfaceTool::plane_for(const std::optional<SurfaceSnap>& end) const {
  const ViewFrame& frame = start_.pointer.frame;
  SpacePlane wanted = plane_ == SurfacePlane::Chosen ? chosen_ : ground_;
  const BoundingBox box = bounds_of(network_or_empty());
  const double size = box ? ((*box)[1] - (*box)[0]).norm() : 1;
  const auto lies_on = [&](const SpacePlane& plane, const std::optional<SurfaceSnap>& snap) {
    return !snap || std::abs((snap->place - plane.point).dot(plane.normal.normalized())) <= on_ground * size;
  };
  if (plane_ == SurfacePlane::View) wanted = view_plane(frame, box ? Vec3(((*box)[0] + (*box)[1]) / 2) : ground_.point);
  if (plane_ == SurfacePlane::Ground) wanted = ground_or_view(frame, ground_);
  if (lies_on(wanted, from_) && lies_on(wanted, end)) return wanted;
  if (from_ && end && from_->end != end->end) return plane_through(frame, from_->place, end->place);
  const Vec3 through = from_ ? from_->place : end->place;
  return plane_ == SurfacePlane::Chosen ? SpacePlane{through, chosen_.normal} : view_plane(frame, through);
}

/// The stroke on a patch, or with an empty face on a mesh; where it leaves that it goes on across the view.
std::vector<Vec3> SurfaceTool::places_over(const std::string& face) const {
  const auto place_of = [&](const Sample& sample) -> std::optional<Vec3> {
    if (face.empty()) return sample.mesh;
    return sample.patch && sample.patch->face == face ? std::optional(sample.patch->point) : std::nullopt;
  };
  std::optional<Vec3> last;
  for (const Sample& sample : samples_) {
    last = place_of(sample);
    if (last) break;
  }
  std::vector<Vec3> places;
  for (const Sample& sample : samples_) {
    auto place = place_of(sample);
    if (!place && last) place = place_on(view_plane(start_.pointer.frame, *last), start_.pointer.frame, sample.pixel);
    if (!place) continue;
    last = place;
    places.push_back(*place);
  }
  return places;
}

std::vector<Vec3> SurfaceTool::stroke_places(const std::optional<SurfaceSnap>& end) const {
  const std::string face = face_drawn_on();
  std::vector<Vec3> places;
  if (!face.empty() || draws_on_mesh()) {
    places = places_over(face);
  } else {
    const SpacePlane plane = plane_for(end);
    for (const Sample& sample : samples_) {
      if (const auto place = place_on(plane, start_.pointer.frame, sample.pixel)) places.push_back(*place);
    }
  }
  return places;
}

void SurfaceTool::preview_stroke() {
  const ViewFrame& frame = start_.pointer.frame;
  preview_.snap = snap_at(frame, last_);
  if (samples_.size() == 1) preview_.snap = from_;
  preview_.face = face_drawn_on();
  const bool on_plane = preview_.face.empty() && !draws_on_mesh();
  const bool moved = (last_ - samples_.front().pixel).norm() > options_.drag_pixels;
  const auto end = moved ? preview_.snap : std::nullopt;
  preview_.plane = on_plane ? std::optional(plane_for(end)) : std::nullopt;
  preview_.ink = stroke_places(end);
}

Verdict SurfaceTool::finish_stroke() {
  const ViewFrame frame = start_.pointer.frame;
  const auto far = [&](const Sample& sample) {
    return (sample.pixel - samples_.front().pixel).norm() > options_.drag_pixels;
  };
  const auto end = std::ranges::any_of(samples_, far) ? snap_at(frame, last_) : std::nullopt;
  recorded::SurfaceStroke stroke;
  stroke.points = stroke_places(end);
  stroke.face = face_drawn_on();
  const bool on_plane = stroke.face.empty() && !draws_on_mesh();
  const double slant = on_plane && !stroke.points.empty() ? slant_of(plane_for(end), frame, stroke.points.front()) : 1;
  if (from_) stroke.start = from_->end;
  if (end) stroke.end = end->end;
  end_gesture();
  if (stroke.points.size() < 2) return Verdict::Revert;
  stroke.unit = frame.units_per_pixel(stroke.points.front()) / slant;
  return stroke.unit > 0 ? draw(stroke) : Verdict::Revert;
}

}  // namespace croquis
