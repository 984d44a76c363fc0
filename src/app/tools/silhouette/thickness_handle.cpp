// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/tools/silhouette/thickness_handle.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <Eigen/Geometry>

#include "app/views/viewport.h"
#include "croquis/tools/silhouette/stroke_setting.h"

namespace croquis::app {
namespace {

constexpr double above_outline = 20;           // logical pixels
constexpr double pixels_per_thickness = 100;   // a drag so far up makes a part e times as thick
constexpr double least_depth_in_view = 12;     // logical pixels; less can't be aimed at
constexpr double least_share_of_depth = 0.01;  // a front dragged through the back stays before it

}  // namespace

std::optional<PartReach> part_reach(const PolyMesh& mesh, const std::string& part, const Vec3& direction) {
  const AttributeChannel* objects = mesh.channel("object", Domain::Face);
  if (objects == nullptr) return std::nullopt;
  const auto* labels = std::get_if<std::vector<std::int32_t>>(&objects->data);
  const auto found = std::ranges::find(objects->labels, part);
  if (labels == nullptr || found == objects->labels.end()) return std::nullopt;
  const auto label = static_cast<std::int32_t>(found - objects->labels.begin());
  std::optional<Vec3> front, back;
  for (std::size_t f = 0; f < mesh.face_count(); ++f) {
    if ((*labels)[f] != label) continue;
    for (const Index corner : mesh.face(f)) {
      const Vec3& place = mesh.positions[static_cast<std::size_t>(corner)];
      if (!front || place.dot(direction) > front->dot(direction)) front = place;
      if (!back || place.dot(direction) < back->dot(direction)) back = place;
    }
  }
  if (!front) return std::nullopt;
  return PartReach{*front, (*front - *back).dot(direction)};
}

double thickness_after(double from, const Vec2& by, const Vec2& depth) {
  const double factor = depth.norm() < least_depth_in_view
                            ? from * std::exp(-by.y() / pixels_per_thickness)
                            : from * std::max(1 + by.dot(depth) / depth.squaredNorm(), least_share_of_depth);
  return std::clamp(chip_number(factor), least_thickness, most_thickness);
}

ThicknessHandle::ThicknessHandle(Studio& studio, Viewport& views)
    : QObject(&views),
      studio_(studio),
      views_(views),
      in_sketch_(&views, "thickness", true),
      in_solid_(new SketchChip(&views)) {
  in_solid_->setObjectName("thickness-in-solid");
  in_solid_->set_draggable(true);
  connect_to_chips();
}

void ThicknessHandle::connect_to_chips() {
  connect(&in_sketch_, &ChipRow::dragged, this, [this](std::size_t, const QPointF& by) { drag(by, false); });
  connect(in_solid_, &SketchChip::dragged, this, [this](const QPointF& by) { drag(by, true); });
  const auto drop = [this] {
    if (std::exchange(dragged_from_, std::nullopt)) emit wanted({part_.stroke, {}, {}, factor()}, false);
  };
  connect(&in_sketch_, &ChipRow::dropped, this, drop);
  connect(in_solid_, &SketchChip::dropped, this, drop);
  const auto ask_in_sketch = [this](std::size_t number) { ask(*in_sketch_.chip(number)); };
  connect(&in_sketch_, &ChipRow::clicked, this, ask_in_sketch);
  connect(&in_sketch_, &ChipRow::asked, this, ask_in_sketch);
  connect(in_solid_, &SketchChip::clicked, this, [this] { ask(*in_solid_); });
  connect(in_solid_, &SketchChip::asked, this, [this] { ask(*in_solid_); });
}

void ThicknessHandle::drag(const QPointF& by, bool in_solid) {
  if (!dragged_from_) dragged_from_ = {factor(), in_solid ? depth_in_view() : Vec2::Zero()};
  const double factor = thickness_after(dragged_from_->factor, {by.x(), by.y()}, dragged_from_->depth);
  emit wanted({part_.stroke, {}, {}, factor}, true);
}

void ThicknessHandle::ask(SketchChip& chip) {
  ask_number(chip, "part-thickness", factor(), least_thickness, most_thickness,
             [this, stroke = part_.stroke](double factor) {
               emit wanted({stroke, {}, {}, factor}, false);
             });
}

double ThicknessHandle::factor() const { return thickness_of(studio_.drawing(), part_.stroke); }

void ThicknessHandle::follow(const ChosenPart& part, const QString& name) {
  part_ = part;
  reach_.reset();
  if (part_.stroke.empty()) return in_sketch_.show({});
  const DrawingPlane& plane = studio_.drawing().plane;
  forwards_ = plane.u.cross(plane.v);
  const auto result = studio_.result();
  const auto mesh = result ? result->outputs.find("mesh") : Values::const_iterator();
  if (result && mesh != result->outputs.end())
    reach_ = part_reach(mesh->second.get<PolyMesh>(), part_.object, forwards_);
  const SketchChip::Look look{"thickness", QString("× ") + chip_text(factor()),
                              tr("Thickness of %1. Drag up or down; click to type it").arg(name),
                              factor() == 1 ? SketchChip::Look::Strength::Plain : SketchChip::Look::Strength::Half};
  in_sketch_.show({{part_.at, look, above_outline}});
  in_solid_->set_look(look);
  in_solid_->setToolTip(tr("Thickness of %1. Drag its front; click to type it").arg(name));
}

std::optional<Vec2> ThicknessHandle::pixel_of(const Vec3& place) const {
  const auto seen = views_.frame_of(view_).project(place);
  return seen ? std::optional(seen->pixel) : std::nullopt;
}

Vec2 ThicknessHandle::depth_in_view() const {
  if (!reach_ || view_ < 0) return Vec2::Zero();
  const auto front = pixel_of(reach_->front), beyond = pixel_of(reach_->front + forwards_ * reach_->depth / 2);
  return front && beyond ? Vec2(*beyond - *front) : Vec2::Zero();
}

void ThicknessHandle::place(ChipPlaces& places, bool shown) {
  in_sketch_.place(places, shown);
  place_in_solid(places, shown);
}

void ThicknessHandle::place_in_solid(ChipPlaces& places, bool shown) {
  view_ = places.layout().alone() >= 0 ? places.layout().alone() : PerspectiveView;
  const ViewPane& pane = places.scene_pane();
  const bool shows_solid = shown && reach_ && view_ != SketchView && pane.visible();
  const auto pixel = shows_solid ? pixel_of(reach_->front) : std::nullopt;
  const QPointF at = pane.rect.topLeft() + (pixel ? QPointF(pixel->x(), pixel->y()) : QPointF(-1, -1));
  if (pixel && pane.rect.contains(at))
    places.put(*in_solid_, at - QPointF(in_solid_->width(), in_solid_->height()) / 2, pane.rect);
  else
    in_solid_->hide();
}

}  // namespace croquis::app
