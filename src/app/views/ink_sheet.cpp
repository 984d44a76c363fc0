// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/views/ink_sheet.h"

#include <algorithm>
#include <cmath>

#include "app/views/render_color.h"
#include "app/window/theme.h"

namespace croquis::app {
namespace {

constexpr double ink_margin = 6;  // logical pixels around samples: half of the widest ink, and its soft border

}  // namespace

render::LineItemPtr ink_item(const std::vector<StrokeSample>& ink, bool pale) {
  if (ink.empty()) return nullptr;
  render::LinePath path;
  path.points.reserve(ink.size());
  for (const StrokeSample& sample : ink) {
    const glm::dvec3 place(sample.position.x(), sample.position.y(), 0);
    path.points.push_back({place, static_cast<float>(0.5 + 0.8 * sample.pressure), {}});
  }
  const render::Color color = pale ? to_color(colors::behind) : to_color(colors::ink);
  return render::make_line_item(path, {ink_width, color, {}, render::LineDepth::OnTop});
}

void InkSheet::keep(const render::Scene& scene, const render::RenderOptions& options, const ViewPane& pane,
                    std::size_t inked) {
  drawn_ = Drawn{scene, options, pane};
  inked_ = inked;
}

bool InkSheet::fits(const ViewPane& pane) const {
  return drawn_ && drawn_->pane.rect == pane.rect && drawn_->pane.camera == pane.camera;
}

render::PixelRect InkSheet::part_of(const std::vector<StrokeSample>& ink, const render::PixelRect& whole) const {
  const SketchFrame frame = drawn_->pane.sketch_frame();
  const double ratio = drawn_->options.pixel_ratio;
  const Vec2 size(whole.width, whole.height);
  Vec2 low = size;
  Vec2 high = Vec2::Zero();
  // From the last sample that is there on: the new piece begins at it.
  for (std::size_t i = inked_ == 0 ? 0 : inked_ - 1; i < ink.size(); ++i) {
    const Vec2 pixel = frame.to_pixel(ink[i].position);
    const Vec2 place = ratio * Vec2(pixel.x(), drawn_->pane.rect.height() - pixel.y());
    low = low.cwiseMin(place - Vec2::Constant(ink_margin * ratio));
    high = high.cwiseMax(place + Vec2::Constant(ink_margin * ratio));
  }
  low = low.array().floor().matrix().cwiseMax(Vec2::Zero());
  high = high.array().ceil().matrix().cwiseMin(size);
  render::PixelRect part;
  const auto left = static_cast<int>(low.x());
  const auto bottom = static_cast<int>(low.y());
  part.x = whole.x + left;
  part.y = whole.y + bottom;
  part.width = static_cast<int>(high.x()) - left;
  part.height = static_cast<int>(high.y()) - bottom;
  part.crop = render::PictureCrop{whole.width, whole.height, left, bottom};
  return part;
}

void InkSheet::draw_new_ink(render::Renderer& renderer, const std::vector<StrokeSample>& ink, bool pale,
                            const render::PixelRect& whole) {
  if (ink.size() <= inked_) return;
  const render::PixelRect part = part_of(ink, whole);
  inked_ = ink.size();
  if (part.width <= 0 || part.height <= 0) return;  // drawn outside of the view
  render::Scene scene = drawn_->scene;
  scene.lines.emplace_back(ink_item(ink, pale));
  renderer.draw(scene, drawn_->pane.camera, drawn_->options, part);
}

}  // namespace croquis::app
