// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/tools/silhouette/thickness_handle.h"

#include <algorithm>
#include <cmath>
#include <limits>
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
  constexpr double infinity = std::numeric_limits<double>::infinity();
  double highest = -infinity, lowest = infinity;
  Index front = no_index;
  for (std::size_t f = 0; f < mesh.face_count(); ++f) {
    if ((*labels)[f] != label) continue;
    for (const Index corner : mesh.face(f)) {
      const double height = mesh.positions[corner].dot(direction);
      if (height > highest) front = corner;
      highest = std::max(highest, height);
      lowest = std::min(lowest, height);
    }
  }
  if (front == no_index) return std::nullopt;
  return PartReach{mesh.positions[front], highest - lowest};
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
  if (part_.stroke.empty()) return in_sketch_.show({});
  const DrawingPlane& plane = studio_.drawing().plane;
  forwards_ = plane.u.cross(plane.v);
  const SketchChip::Look look{"thickness", QString("× ") + chip_text(factor()),
                              tr("Thickness of %1. Drag up or down; click to type it").arg(name),
                              factor() == 1 ? SketchChip::Look::Strength::Plain : SketchChip::Look::Strength::Half};
  in_sketch_.show({{part_.at, look, above_outline}});
  in_solid_->set_look(look);
  in_solid_->setToolTip(tr("Thickness of %1. Drag its front; click to type it").arg(name));
}

const std::optional<PartReach>& ThicknessHandle::reach() {
  const auto result = studio_.result();
  const bool known = result && found_.result.lock() == result;
  if (known && found_.part == part_.object && found_.forwards == forwards_) return found_.reach;
  found_ = {result, part_.object, forwards_, std::nullopt};
  const auto mesh = result ? result->outputs.find("mesh") : Values::const_iterator();
  if (result && mesh != result->outputs.end())
    found_.reach = part_reach(mesh->second.get<PolyMesh>(), part_.object, forwards_);
  return found_.reach;
}

std::optional<Vec2> ThicknessHandle::pixel_of(const Vec3& place) const {
  const auto seen = views_.own_frame_of(view_).project(place);
  return seen ? std::optional(seen->pixel) : std::nullopt;
}

Vec2 ThicknessHandle::depth_in_view() {
  if (view_ < 0 || !reach()) return Vec2::Zero();
  const PartReach& part = *reach();
  const auto front = pixel_of(part.front), beyond = pixel_of(part.front + forwards_ * part.depth / 2);
  return front && beyond ? Vec2(*beyond - *front) : Vec2::Zero();
}

void ThicknessHandle::place(ChipPlaces& places, bool shown) {
  in_sketch_.place(places, shown);
  place_in_solid(places, shown);
}

void ThicknessHandle::place_in_solid(ChipPlaces& places, bool shown) {
  view_ = places.layout().alone() >= 0 ? places.layout().alone() : PerspectiveView;
  const ViewPane& pane = places.scene_pane();
  const bool shows_solid = shown && !part_.stroke.empty() && view_ != SketchView && pane.visible();
  const auto pixel = shows_solid && reach() ? pixel_of(reach()->front) : std::nullopt;
  const QPointF at = pane.rect.topLeft() + (pixel ? QPointF(pixel->x(), pixel->y()) : QPointF(-1, -1));
  if (pixel && pane.rect.contains(at))
    places.put(*in_solid_, at - QPointF(in_solid_->width(), in_solid_->height()) / 2, pane.rect);
  else
    in_solid_->hide();
}

}  // namespace croquis::app
