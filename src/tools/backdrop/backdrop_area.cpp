// SPDX-License-Identifier: GPL-3.0-or-later
#include "croquis/tools/backdrop/backdrop_area.h"

#include <algorithm>
#include <utility>

#include "croquis/geometry/drawing.h"
#include "croquis/geometry/perspective_drawing.h"

namespace croquis {
namespace {

/// Where a first stroke is drawn: an empty sketch is shown with 640 units from top to bottom.
const BackdropArea first_area{{-400, -300}, {400, 300}};

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

}  // namespace croquis
