// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/views/view_pictures.h"

#include <QElapsedTimer>
#include <QOpenGLContext>
#include <QOpenGLFunctions>
#include <algorithm>
#include <cmath>
#include <utility>

#include "app/views/render_color.h"
#include "app/window/theme.h"

namespace croquis::app {
namespace {

constexpr double ink_margin = 6;  // logical pixels around samples: half of the widest ink, and its soft border
constexpr int settle_ms = 180;
constexpr int patience_ms = 700;
constexpr double affordable_ms = 90;               // a frame that takes longer is a visible delay
constexpr double fine_by_coarse = 4;               // a fine frame has twice as many pixels in each direction
constexpr std::size_t upload_budget = 24'000'000;  // bytes a frame: more is a visible delay

/// The ink of a stroke under way, or null before its first sample.
/// @param pale for strokes that will lie behind others
render::LineItemPtr ink_item(const std::vector<StrokeSample>& ink, bool pale) {
  if (ink.empty()) return nullptr;
  render::LinePath path;
  path.points.reserve(ink.size());
  for (const StrokeSample& sample : ink) {
    const glm::dvec3 place(sample.position.x(), sample.position.y(), 0);
    path.points.push_back({place, static_cast<float>(0.5 + 0.8 * sample.pressure), {}});
  }
  const render::Color color = pale ? to_color(colors::behind) : to_color(colors::ink);
  return render::make_line_item(path, {ink_width, color, {}});
}

/// Drawings in perspective and networks have z upwards: the cross says so while they are worked on.
std::array<glm::dvec3, 3> upright_axes() {
  std::array<glm::dvec3, 3> axes;
  const Affine3 placement = upright_placement();
  for (int axis = 0; axis < 3; ++axis) {
    axes[static_cast<std::size_t>(axis)] = to_glm(placement.linear.col(axis));
  }
  return axes;
}

/// The place of a view in the framebuffer.
render::PixelRect place_of(const ViewPane& pane, const QWidget& widget) {
  const double ratio = widget.devicePixelRatioF();
  const auto pixels = [ratio](double length) { return static_cast<int>(std::lround(length * ratio)); };
  render::PixelRect target;
  target.x = pixels(pane.rect.left());
  target.y = pixels(widget.height() - pane.rect.bottom());
  target.width = pixels(pane.rect.width());
  target.height = pixels(pane.rect.height());
  return target;
}

render::Scene scene_of(const ViewPictures& pictures, int view) {
  const Views& views = pictures.views;
  ObjectScenes::Wanted wanted;
  wanted.look = views.look;
  wanted.stale = pictures.stale;
  wanted.outlines = true;
  for (const Tool* tool : views.tools) tool->adjust(wanted, view);
  render::Scene scene = views.objects.scene(wanted);
  if (wanted.instead) return scene;
  for (Tool* tool : views.tools) tool->add_to(scene, view);
  return scene;
}

render::RenderOptions options_of(const Views& views, int view, bool fine) {
  const bool paper = is_paper(views, view);
  auto options = paper  ? render::RenderOptions::paper()
                 : fine ? render::RenderOptions{}
                        : render::RenderOptions::interactive();
  if (!paper) {
    const Studio& studio = views.studio;
    options.supersampling = std::min(options.supersampling, 2);
    options.axis_cross.shown = true;
    if (studio.sheet_node() != 0 || studio.network_node() != 0) options.axis_cross.axes = upright_axes();
    if (views.layout.pane(view).flat()) options.grid.kind = render::GridKind::Lines;
  }
  if (views.zebra && !paper) options.shading = render::Shading::Zebra;
  options.pixel_ratio = views.widget.devicePixelRatioF();
  options.upload_budget = upload_budget;
  return options;
}

/// The stroke under way, where nothing else has to be drawn for it. @return whether that was so
bool draw_ink(ViewPictures& pictures, const Ink& ink) {
  const Views& views = pictures.views;
  const ViewPane& pane = views.layout.pane(ink.view);
  if (views.clear || ink.view != pictures.sheet_view || !pictures.sheet.fits(pane)) return false;
  pictures.sheet.draw_new_ink(*pictures.renderer, *ink.samples, ink.pale, place_of(pane, views.widget));
  pictures.state(ink.view).picture.reset();
  return true;
}

/// @return whether it had to be drawn: not where it would look as before
bool draw_view(ViewPictures& pictures, int view, const std::optional<Ink>& ink) {
  const Views& views = pictures.views;
  const ViewPane& pane = views.layout.pane(view);
  PaneState& state = pictures.state(view);
  state.drawn = !pane.visible();
  if (state.drawn) return false;
  const auto options = [&](bool fine) {
    render::RenderOptions wanted = options_of(views, view, fine);
    wanted.reduced = state.moving;
    return wanted;
  };
  const bool paper = is_paper(views, view);
  // A finer picture of the same stays.
  const bool fine = state.fine || paper;
  const bool finer = fine || (state.picture && state.picture->fine);
  ViewPicture picture{scene_of(pictures, view), options(finer), pane.camera, pane.rect, finer};
  const bool inked = ink && ink->view == view;
  if (paper) {
    // What a stroke is drawn over, should one begin.
    pictures.sheet.keep(picture.scene, picture.options, pane, inked ? ink->samples->size() : 0);
    pictures.sheet_view = view;
  }
  if (inked) picture.scene.lines.emplace_back(ink_item(*ink->samples, ink->pale));
  state.drawn = state.picture == picture;
  if (state.drawn) state.fine = finer;
  if (state.drawn) return false;
  picture.fine = fine;
  picture.options = options(fine);
  state.picture.reset();  // what only the old one shows needs no room any more
  pictures.renderer->draw(picture.scene, pane.camera, picture.options, place_of(pane, views.widget));
  ++state.drawn_count;
  state.triangles = pictures.renderer->triangles_drawn();
  state.drawn = !pictures.renderer->pending();
  if (state.drawn) state.picture = std::move(picture);
  return true;
}

void hold_camera(Views& views) {
  ViewPane& pane = views.layout.pane(PerspectiveView);
  const auto camera = pane.visible() ? looked_through(views) : std::nullopt;
  if (camera) pane.camera = camera->in(pane);
  views.layout.pane(ComparisonView).camera = pane.camera;
}

void draw_views(ViewPictures& pictures, const std::optional<Ink>& ink) {
  Views& views = pictures.views;
  QOpenGLFunctions& gl = *QOpenGLContext::currentContext()->functions();
  QElapsedTimer watch;
  watch.start();
  const bool clears = std::exchange(views.clear, false);
  if (clears) {
    gl.glClearColor(0.22F, 0.23F, 0.25F, 1);
    gl.glClear(GL_COLOR_BUFFER_BIT);
    for (PaneState& state : pictures.states) state.picture.reset();
  }
  hold_camera(views);
  bool fine = false;
  pictures.uploading = false;
  for (const int view : views.layout.shown()) {
    PaneState& state = pictures.state(view);
    if (state.drawn || (ink && view != ink->view && !clears)) continue;
    const bool drew = draw_view(pictures, view, ink);
    pictures.uploading = pictures.uploading || !state.drawn;
    fine = fine || (drew && state.fine);
  }
  if (pictures.uploading) views.widget.update();
  // The graphics card, or who does its work, begins long after the calls that describe the picture.
  const bool measures = std::exchange(pictures.measuring, false);
  if (!fine && !measures) return;
  gl.glFinish();
  pictures.affordable = static_cast<double>(watch.elapsed()) * (fine ? 1 : fine_by_coarse) < affordable_ms;
}

/// After a pause the views become finer. Where there are many more triangles than before, a coarse frame is drawn once
/// more first, with all that it needs made: it shows what a fine one would take. Without a graphics card that can be
/// seconds.
void refine(ViewPictures& pictures) {
  std::size_t triangles = 0;
  for (const PaneState& state : pictures.states) triangles += state.triangles;
  if (triangles <= 2 * pictures.measured) return settle(pictures, pictures.affordable);
  pictures.measured = triangles;
  pictures.measuring = true;
  settle(pictures, false);
  for (PaneState& state : pictures.states) {
    state.drawn = false;
    state.picture.reset();
  }
  pictures.pause.start(settle_ms);
}

void redraw(ViewPictures& pictures, int view) {
  PaneState& state = pictures.state(view);
  state.drawn = false;
  // During a stroke views wait: its ink must be seen at once.
  if (!ink_in(pictures.views)) {
    pictures.views.widget.update();
    if (view == pictures.sheet_view) pictures.sheet.drop();
  }
  if (is_paper(pictures.views, view)) return;  // it is always fine
  state.fine = false;
  if (pictures.affordable) pictures.pause.start(settle_ms);
}

void follow_change(ViewPictures& pictures, int changed) {
  if (changed == ink_alone) return pictures.views.widget.update();
  for (int view = 0; view < view_count; ++view) {
    if (changed == every_view || changed == view) redraw(pictures, view);
  }
}

void follow_busy(ViewPictures& pictures, bool busy) {
  if (busy) {
    if (!pictures.patience.isActive()) pictures.patience.start(patience_ms);
    return;
  }
  pictures.patience.stop();
  const bool stale = std::ranges::any_of(
      pictures.views.studio.objects(), [](const WorkObject& object) { return object.result && object.result->stale; });
  if (std::exchange(pictures.stale, stale) != stale) emit pictures.views.changed();
}

}  // namespace

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

ViewPictures::ViewPictures(Views& shown) : views(shown) {
  pause.setSingleShot(true);
  patience.setSingleShot(true);
  QObject::connect(&pause, &QTimer::timeout, &pause, [this] { refine(*this); });
  QObject::connect(&patience, &QTimer::timeout, &pause, [this] {
    stale = true;
    emit views.changed();
  });
  QObject::connect(&views, &Views::changed, &pause, [this](int view) { follow_change(*this, view); });
  QObject::connect(&views, &Views::camera_moved, &pause, [this](int view) {
    redraw(*this, view);
    state(view).moving = true;
    pause.start(settle_ms);
  });
  QObject::connect(&views.studio, &Studio::busy_changed, &pause, [this](bool busy) { follow_busy(*this, busy); });
  QObject::connect(&views.studio, &Studio::loaded, &pause, [this] {
    affordable = true;
    measured = 0;
  });
}

bool draw(ViewPictures& pictures) {
  if (!pictures.renderer) return false;
  ++pictures.frames;
  const auto ink = ink_in(pictures.views);
  const bool begins = pictures.sheet.inked() == 0;
  if (ink && draw_ink(pictures, *ink)) return begins;
  draw_views(pictures, ink);
  return true;
}

void settle(ViewPictures& pictures, bool fine) {
  pictures.pause.stop();
  for (PaneState& state : pictures.states) {
    state.drawn = state.drawn && !state.moving && (state.fine || !fine);
    state.fine = state.fine || fine;
    state.moving = false;
  }
  pictures.views.widget.update();
}

bool settled(const ViewPictures& pictures) {
  return !pictures.views.objects.busy() && !pictures.uploading &&
         std::ranges::none_of(pictures.views.tools, [](const Tool* tool) { return tool->state().busy; });
}

}  // namespace croquis::app
