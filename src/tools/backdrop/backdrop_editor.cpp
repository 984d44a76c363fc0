// SPDX-License-Identifier: GPL-3.0-or-later
#include "croquis/tools/backdrop/backdrop_editor.h"

#include <algorithm>
#include <utility>

#include "croquis/base/error.h"
#include "croquis/geometry/drawing.h"
#include "croquis/geometry/perspective_drawing.h"
#include "croquis/tools/backdrop/backdrop_steps.h"

namespace croquis {
namespace {

/// Where a first stroke is drawn: an empty sketch is shown with 640 units from top to bottom.
const BackdropArea first_area{{-400, -300}, {400, 300}};

constexpr double least_share = 1e-3;  // of its size before: a corner dragged past the opposite one turns nothing over

recorded::Step step_of(const Backdrop& backdrop) {
  return recorded::BackdropSetting{backdrop.centre, backdrop.scale, backdrop.opacity, backdrop.visible};
}

}  // namespace

BackdropArea backdrop_area(const Node& drawing) {
  if (const auto sheet = source_of<PerspectiveDrawing>(&drawing)) {
    const Vec2 far = sheet->origin + sheet->image_size;
    return {{sheet->origin.x(), -far.y()}, {far.x(), -sheet->origin.y()}};
  }
  const auto sketch = source_of<Drawing>(&drawing);
  if (!sketch || sketch->strokes.empty()) return first_area;
  BackdropArea area{sketch->strokes.front().samples.front().position, sketch->strokes.front().samples.front().position};
  for (const Stroke& stroke : sketch->strokes) {
    for (const StrokeSample& sample : stroke.samples) {
      area.low = area.low.cwiseMin(sample.position);
      area.high = area.high.cwiseMax(sample.position);
    }
  }
  return (area.high - area.low).minCoeff() > 0 ? area : first_area;
}

Backdrop fitted(std::shared_ptr<const PictureFile> picture, const BackdropArea& area) {
  Backdrop backdrop;
  const Vec2 size = area.high - area.low;
  backdrop.scale = std::min(size.x() / picture->width, size.y() / picture->height);
  backdrop.centre = (area.low + area.high) / 2;
  backdrop.picture = std::move(picture);
  return backdrop;
}

BackdropArea area_of(const Backdrop& backdrop) {
  return {backdrop.centre - backdrop.size() / 2, backdrop.centre + backdrop.size() / 2};
}

Vec2 sheet_for(const PictureFile& picture, double longest) {
  const Vec2 size(picture.width, picture.height);
  const double scale = std::min(1.0, longest / size.maxCoeff());
  return (scale * size).array().round().max(1).matrix();
}

Document with_backdrop(const Document& document, NodeId drawing, std::optional<Backdrop> backdrop) {
  Node edited = *document.find(drawing);
  edited.backdrop = backdrop ? std::make_shared<const Backdrop>(*std::move(backdrop)) : nullptr;
  return document.with(std::move(edited));
}

std::shared_ptr<const Backdrop> BackdropEditor::backdrop() const {
  const Node* node = session_.document().find(node_);
  return node == nullptr ? nullptr : node->backdrop;
}

void BackdropEditor::require_valid(const Backdrop& backdrop) const {
  if (is_valid(backdrop)) return;
  throw Error(make_error(Category::Usage, "E_INPUT",
                         "The picture needs a finite place, a scale above 0 and an opacity from 0 to 1; type other "
                         "numbers."));
}

Verdict BackdropEditor::set(const std::string& label, const Backdrop& backdrop) {
  give_up();
  require_valid(backdrop);
  const auto now = this->backdrop();
  if (!now || *now == backdrop) return Verdict::Continue;
  done_ = step_of(backdrop);
  session_.edit(label, with_backdrop(session_.document(), node_, backdrop));
  return Verdict::Commit;
}

Verdict BackdropEditor::fit() {
  const auto now = backdrop();
  if (!now) return Verdict::Continue;
  Backdrop placed = fitted(now->picture, backdrop_area(*session_.document().find(node_)));
  placed.opacity = now->opacity;
  placed.visible = now->visible;
  return set("Fit picture", placed);
}

Verdict BackdropEditor::remove() {
  give_up();
  if (!backdrop()) return Verdict::Continue;
  done_ = recorded::BackdropRemoval{};
  session_.edit("Remove picture", with_backdrop(session_.document(), node_, std::nullopt));
  return Verdict::Commit;
}

void BackdropEditor::change(const std::string& label, const Backdrop& backdrop) {
  require_valid(backdrop);
  if (gesture_ != Gesture::Change || drag_.interrupted()) {
    give_up();
    before_ = this->backdrop();
    if (!before_) return;
    gesture_ = Gesture::Change;
    drag_.begin(label);
  }
  drag_to(backdrop);
}

void BackdropEditor::drag_to(const Backdrop& backdrop) {
  drag_.to(with_backdrop(session_.document(), node_, backdrop));
}

Verdict BackdropEditor::finish() {
  if (std::exchange(gesture_, Gesture::None) == Gesture::None || drag_.interrupted()) return Verdict::Continue;
  drag_.end();
  const auto now = backdrop();
  if (!now || *now == *before_) return Verdict::Continue;
  done_ = step_of(*now);
  return Verdict::Commit;
}

Verdict BackdropEditor::give_up() {
  if (std::exchange(gesture_, Gesture::None) == Gesture::None) return Verdict::Continue;
  drag_.cancel();
  return Verdict::Revert;
}

void BackdropEditor::begin(const SketchEvent& event) {
  give_up();
  before_ = backdrop();
  if (!before_) return;
  from_ = event.sample.position;
  const BackdropArea area = area_of(*before_);
  gesture_ = Gesture::Move;
  double reach = corner_pixels_ * event.units_per_pixel;
  for (const Vec2& corner :
       {area.low, area.high, Vec2(area.low.x(), area.high.y()), Vec2(area.high.x(), area.low.y())}) {
    if ((corner - from_).norm() > reach) continue;
    reach = (corner - from_).norm();
    gesture_ = Gesture::Scale;
    fixed_ = 2 * before_->centre - corner;
  }
  drag_.begin(gesture_ == Gesture::Scale ? "Scale picture" : "Move picture");
}

void BackdropEditor::go_on(const SketchEvent& event) {
  if (gesture_ == Gesture::None || drag_.interrupted()) return;
  Backdrop dragged = *before_;
  const Vec2& place = event.sample.position;
  if (gesture_ == Gesture::Move) {
    dragged.centre += place - from_;
  } else {
    const Vec2 diagonal = 2 * (before_->centre - fixed_);
    const double share = std::max(least_share, (diagonal + place - from_).dot(diagonal) / diagonal.squaredNorm());
    dragged.scale *= share;
    dragged.centre = fixed_ + share * (before_->centre - fixed_);
  }
  drag_to(dragged);
}

Verdict BackdropEditor::handle(const SketchEvent& event) {
  switch (event.kind) {
    case PenStep::Kind::Begin: begin(event); return Verdict::Continue;
    case PenStep::Kind::Sample: go_on(event); return Verdict::Continue;
    case PenStep::Kind::End: return finish();
    case PenStep::Kind::Cancel: break;
  }
  return give_up();
}

}  // namespace croquis
