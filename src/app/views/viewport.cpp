// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/views/viewport.h"

#include <QOpenGLContext>
#include <QOpenGLFunctions>
#include <algorithm>
#include <cmath>
#include <utility>

#include "app/views/offscreen_pictures.h"
#include "app/views/own_space.h"
#include "app/views/render_color.h"
#include "croquis/base/error.h"

namespace croquis::app {
namespace {

constexpr int settle_ms = 180;
constexpr int patience_ms = 700;
constexpr int long_press_ms = 400;
constexpr double affordable_ms = 90;               // a frame that takes longer is a visible delay
constexpr std::size_t upload_budget = 24'000'000;  // bytes a frame: more is a visible delay
constexpr int picture_height = 1600;
constexpr QSize least_size(502, 240);  // two views beside each other can be worked in

bool has_mesh(const Studio& studio) {
  return std::ranges::any_of(studio.objects(), [](const WorkObject& object) { return object.begins_with_mesh; });
}

}  // namespace

Viewport::Viewport(Studio& studio, QWidget* parent)
    : QOpenGLWidget(parent), studio_(studio), objects_(studio, nullptr), chips_(studio, this), marking_menu_(this) {
  setObjectName("viewport");
  setAccessibleName(tr("Views"));
  setMouseTracking(true);
  setTabletTracking(true);
  setAttribute(Qt::WA_AcceptTouchEvents);
  setFocusPolicy(Qt::StrongFocus);
  setMinimumSize(least_size);
  for (const int view : {SketchView, TopView, SideView}) navigation_.set_flat(view, true);
  clock_.start();
  // What isn't drawn again stays as it was.
  setUpdateBehavior(QOpenGLWidget::PartialUpdate);
  // On X11 Qt drops all waiting moves but the last one, and a circle becomes a polygon. The platform of the application
  // object turns that on, so it can't be turned off before.
  QCoreApplication::setAttribute(Qt::AA_CompressHighFrequencyEvents, false);
  settle_.setSingleShot(true);
  patience_.setSingleShot(true);
  long_press_.setSingleShot(true);
  long_press_.setInterval(long_press_ms);
  connect_parts();
}

Viewport::~Viewport() {
  makeCurrent();
  renderer_.reset();
  doneCurrent();
}

void Viewport::connect_parts() {
  connect(&settle_, &QTimer::timeout, this, [this] { settle(affordable_); });
  connect(&patience_, &QTimer::timeout, this, [this] {
    stale_ = true;
    redraw_all();
  });
  connect(&long_press_, &QTimer::timeout, this, [this] {
    if (abandon()) open_marking_menu(pressed_at_);
  });
  connect(&studio_, &Studio::busy_changed, this, &Viewport::note_busy);
  connect(&studio_, &Studio::loaded, this, &Viewport::follow_load);
  connect(&studio_, &Studio::changed, this, &Viewport::follow_document);
  connect(&studio_, &Studio::result_changed, this, &Viewport::follow_result);
  connect(&objects_, &ObjectScenes::changed, this, [this] {
    for (Tool* tool : tools_) tool->follow(Change::Scenes);
    keep_in_view();
    redraw_all();
  });
}

void Viewport::connect_tool(Tool& tool) {
  connect(&tool, &Tool::changed, this, [this](int view) {
    if (view == every_view) return redraw_all();
    view == ink_alone ? update() : redraw(view);
  });
  connect(&tool, &Tool::committed, this, &Viewport::committed);
  connect(&tool, &Tool::state_changed, this, &Viewport::help_changed);
}

void Viewport::set_tools(std::vector<Tool*> tools) {
  tools_ = std::move(tools);
  for (Tool* tool : tools_) connect_tool(*tool);
  set_mode(mode_);
}

Tool* Viewport::tool_in(int view) const {
  const auto found = std::ranges::find_if(tools_, [&](const Tool* tool) {
    const ViewUse use = tool->use_of(view);
    return use.works && (use.on_drawings || !is_drawn_on(view));
  });
  return found == tools_.end() ? nullptr : *found;
}

bool Viewport::is_drawn_on(int view) const {
  return std::ranges::any_of(tools_, [&](const Tool* tool) { return !tool->use_of(view).bounds.empty(); });
}

bool Viewport::is_paper(int view) const {
  return std::ranges::any_of(tools_, [&](const Tool* tool) { return tool->use_of(view).paper; });
}

std::optional<Ink> Viewport::ink() const {
  for (const Tool* tool : tools_) {
    if (auto ink = tool->state().ink) return ink;
  }
  return std::nullopt;
}

void Viewport::set_mode(const QString& mode) {
  mode_ = mode;
  for (Tool* tool : tools_) tool->set_mode(mode);
  show_cursor(under_pointer_);
  redraw_all();
  navigation_.something_done();
  emit help_changed();
}

ViewFrame Viewport::frame_of(int view) const {
  render::Scene scene;
  scene.meshes = objects_.surfaces();
  if (const WorkObject* object = studio_.active()) {
    const PlacedPart part(scene, object->placement.map());
    scene.meshes.emplace_back(objects_.cage_item(object->cage));
  }
  render::Bounds bounds = render::bounds_of(scene);
  if (bounds.empty()) bounds = {{-1, -1, -1}, {1, 1, 1}};
  return layout_.pane(view).view_frame(bounds);
}

ViewFrame Viewport::own_frame_of(int view) const {
  const WorkObject* object = studio_.active();
  return object == nullptr ? frame_of(view) : seen_from(frame_of(view), object->placement.map());
}

void Viewport::set_look(MeshLook look) {
  look_ = look;
  redraw_all();
}

void Viewport::set_flat(bool flat) { objects_.set_flat(flat); }

void Viewport::set_zebra(bool zebra) {
  zebra_ = zebra;
  redraw_all();
}

void Viewport::after_layout() {
  layout_.resize(QSizeF(width(), height()));
  clear_ = true;
  frame_new_views();
  redraw_all();
}

void Viewport::toggle_layout() {
  layout_.show_alone(layout_.alone() < 0 ? under_pointer_ : -1);
  after_layout();
}

void Viewport::arrange(Arrangement arrangement) {
  layout_.arrange(arrangement);
  after_layout();
}

QString Viewport::graphics() {
  makeCurrent();
  QOpenGLContext* graphics = QOpenGLContext::currentContext();
  const auto* words = graphics == nullptr ? nullptr : graphics->functions()->glGetString(GL_RENDERER);
  const QString text = words == nullptr ? tr("unknown") : QString::fromUtf8(reinterpret_cast<const char*>(words));
  doneCurrent();
  return text;
}

/// Those that people chose.
QPointF Viewport::pane_shares() const {
  const QPointF shares = layout_.shares();
  return shares.x() == suggested_share_ ? QPointF(even_share, shares.y()) : shares;
}

void Viewport::suggest_share(double across) {
  if (layout_.shares().x() != suggested_share_) return;
  set_pane_shares({across, layout_.shares().y()});
  suggested_share_ = across;
}

void Viewport::set_pane_shares(const QPointF& shares) {
  suggested_share_ = even_share;
  layout_.set_shares(shares);
  after_layout();
}

void Viewport::show_alone(int view) {
  layout_.show_alone(view);
  after_layout();
}

void Viewport::show_scene() {
  ViewPane& pane = layout_.pane(PerspectiveView);
  if (!pane.fits(objects_.scene({}))) pane.frame(objects_.scene({}));
}

bool Viewport::abandon() {
  return std::ranges::any_of(tools_, [](Tool* tool) { return tool->abandon(); });
}

bool Viewport::any_down() const {
  return std::ranges::any_of(tools_, [](const Tool* tool) { return tool->down(); });
}

bool Viewport::settled() const {
  return !objects_.busy() && !uploading_ &&
         std::ranges::none_of(tools_, [](const Tool* tool) { return tool->state().busy; });
}

void Viewport::export_picture(OffscreenPictures& pictures, const QString& path) const {
  const ViewPane& pane = layout_.pane(PerspectiveView);
  const double aspect = pane.visible() ? pane.rect.width() / pane.rect.height() : 1;
  const QSize size(static_cast<int>(picture_height * aspect), picture_height);
  if (!pictures.draw(objects_.surfaces(), pane.camera, render::RenderOptions{}, size).save(path, "PNG")) {
    throw Error(make_error(Category::Io, "E_WRITE", "\"" + path.toStdString() + "\" can't be written"));
  }
}

QPointF Viewport::sketch_to_widget(const Vec2& place) const {
  const ViewPane& pane = layout_.pane(SketchView);
  const Vec2 pixel = pane.sketch_frame().to_pixel(place);
  return pane.rect.topLeft() + QPointF(pixel.x(), pixel.y());
}

QPointF Viewport::model_to_widget(const Vec3& place, int view) const {
  const auto seen = frame_of(view).project(place);
  const Vec2 pixel = seen ? seen->pixel : Vec2(0, 0);
  return layout_.pane(view).rect.topLeft() + QPointF(pixel.x(), pixel.y());
}

void Viewport::follow_load() {
  for (int view = 0; view < view_count; ++view) {
    ViewPane& pane = layout_.pane(view);
    if (view != SketchView) pane.camera = first_pane(pane.kind).camera;
  }
  framed_ = {};
  known_.clear();
  affordable_ = true;
  turned_ = false;
  had_meshes_ = false;
}

void Viewport::follow_document() {
  objects_.follow();
  for (Tool* tool : tools_) tool->follow(Change::Document);
  const bool has_meshes = has_mesh(studio_);
  if (has_meshes && !had_meshes_ && !is_drawn_on(SketchView)) {
    // A document of meshes begins with the perspective view; Space shows the others.
    layout_.arrange(Arrangement::Four);
    show_alone(PerspectiveView);
    set_mode(select_mode);
  }
  if (!has_meshes && layout_.alone() == PerspectiveView && studio_.objects().empty()) {
    arrange(Arrangement::SketchAndSolid);
  }
  had_meshes_ = has_meshes;
  navigation_.something_done();
  emit help_changed();
}

void Viewport::follow_result() {
  objects_.follow();  // signals when it has changed: views are framed then
  for (Tool* tool : tools_) tool->follow(Change::Result);
  redraw_all();
  emit help_changed();
}

void Viewport::note_busy(bool busy) {
  if (busy) {
    if (!patience_.isActive()) patience_.start(patience_ms);
    return;
  }
  patience_.stop();
  const bool stale = std::any_of(studio_.objects().begin(), studio_.objects().end(),
                                 [](const WorkObject& object) { return object.result && object.result->stale; });
  if (stale_ != stale) redraw_all();
  stale_ = stale;
}

// ---- Drawing

void Viewport::initializeGL() {
  try {
    renderer_ = std::make_unique<render::Renderer>();
  } catch (const Error& error) {
    chips_.say(QString::fromStdString(error.what()) + tr(". Try croquis --software-gl"));
  }
}

void Viewport::resizeGL(int, int) { after_layout(); }

void Viewport::settle(bool fine) {
  settle_.stop();
  for (PaneState& state : states_) {
    state.drawn = state.drawn && !state.moving && (state.fine || !fine);
    state.fine = state.fine || fine;
    state.moving = false;
  }
  update();
}

void Viewport::redraw_moved(int view) {
  redraw(view);
  states_[static_cast<std::size_t>(view)].moving = true;
  settle_.start(settle_ms);
}

void Viewport::redraw(int view) {
  PaneState& state = states_[static_cast<std::size_t>(view)];
  state.drawn = false;
  // During a stroke views wait: its ink must be seen at once.
  const auto inked = ink();
  if (!inked) {
    update();
    if (view == sheet_view_) sheet_.drop();
  }
  if (is_paper(view)) return;  // it is always fine
  state.fine = false;
  if (affordable_) settle_.start(settle_ms);
}

void Viewport::redraw_all() {
  for (int view = 0; view < view_count; ++view) redraw(view);
}

void Viewport::paintGL() {
  if (!renderer_) return;
  if (!draw_ink()) draw_views();
  ++frames_;
  if (input_time_ms_ >= 0) {
    latency_ms_ = static_cast<double>(clock_.nsecsElapsed()) * 1e-6 - input_time_ms_;
    input_time_ms_ = -1;
  }
}

/// The stroke under way, where nothing else has to be drawn for it.
bool Viewport::draw_ink() {
  const auto inked = ink();
  if (!inked || clear_ || inked->view != sheet_view_ || !sheet_.fits(layout_.pane(inked->view))) return false;
  const bool begins = sheet_.inked() == 0;
  sheet_.draw_new_ink(*renderer_, *inked->samples, inked->pale, place_of(layout_.pane(inked->view)));
  states_[static_cast<std::size_t>(inked->view)].picture.reset();
  if (begins) place_chips();
  return true;
}

void Viewport::hold_camera() {
  ViewPane& pane = layout_.pane(PerspectiveView);
  const auto camera = pane.visible() ? looked_through() : std::nullopt;
  if (camera) pane.camera = camera->in(pane);
}

void Viewport::draw_views() {
  QElapsedTimer watch;
  watch.start();
  const bool clears = std::exchange(clear_, false);
  if (clears) {
    QOpenGLFunctions* gl = QOpenGLContext::currentContext()->functions();
    gl->glClearColor(0.22F, 0.23F, 0.25F, 1);
    gl->glClear(GL_COLOR_BUFFER_BIT);
    for (PaneState& state : states_) state.picture.reset();
  }
  hold_camera();
  layout_.pane(ComparisonView).camera = layout_.pane(PerspectiveView).camera;
  const auto inked = ink();
  bool fine = false;
  uploading_ = false;
  for (const int view : layout_.shown()) {
    PaneState& state = states_[static_cast<std::size_t>(view)];
    if (state.drawn || (inked && view != inked->view && !clears)) continue;
    const bool drew = draw_view(view);
    uploading_ = uploading_ || !state.drawn;
    fine = fine || (drew && state.fine);
  }
  if (uploading_) update();
  // The graphics card, or who does its work, begins long after the calls that describe the picture.
  if (fine) QOpenGLContext::currentContext()->functions()->glFinish();
  if (fine) affordable_ = static_cast<double>(watch.elapsed()) < affordable_ms;
  place_chips();
}

render::Scene Viewport::scene_of(int view) {
  ObjectScenes::Wanted wanted;
  wanted.look = look_;
  wanted.stale = stale_;
  wanted.outlines = true;
  for (const Tool* tool : tools_) tool->adjust(wanted, view);
  render::Scene scene = objects_.scene(wanted);
  for (Tool* tool : tools_) tool->add_to(scene, view);
  return scene;
}

/// Drawings in perspective and networks have z upwards: the cross says so while they are worked on.
static std::array<glm::dvec3, 3> upright_axes() {
  std::array<glm::dvec3, 3> axes;
  const Affine3 placement = upright_placement();
  for (int axis = 0; axis < 3; ++axis) {
    axes[static_cast<std::size_t>(axis)] = to_glm(placement.linear.col(axis));
  }
  return axes;
}

render::RenderOptions Viewport::options_of(int view, bool fine) const {
  const bool paper = is_paper(view);
  auto options = paper  ? render::RenderOptions::paper()
                 : fine ? render::RenderOptions{}
                        : render::RenderOptions::interactive();
  if (!paper) {
    options.supersampling = std::min(options.supersampling, 2);
    options.axis_cross.shown = true;
    if (studio_.sheet_node() != 0 || studio_.network_node() != 0) options.axis_cross.axes = upright_axes();
    if (layout_.pane(view).flat()) options.grid.kind = render::GridKind::Lines;
  }
  if (zebra_ && !paper) options.shading = render::Shading::Zebra;
  options.pixel_ratio = devicePixelRatioF();
  options.upload_budget = upload_budget;
  options.reduced = states_[static_cast<std::size_t>(view)].moving;
  return options;
}

render::PixelRect Viewport::place_of(const ViewPane& pane) const {
  const double ratio = devicePixelRatioF();
  const auto pixels = [ratio](double length) { return static_cast<int>(std::lround(length * ratio)); };
  render::PixelRect target;
  target.x = pixels(pane.rect.left());
  target.y = pixels(height() - pane.rect.bottom());
  target.width = pixels(pane.rect.width());
  target.height = pixels(pane.rect.height());
  return target;
}

/// @return whether it had to be drawn: not where it would look as before
bool Viewport::draw_view(int view) {
  const ViewPane& pane = layout_.pane(view);
  PaneState& state = states_[static_cast<std::size_t>(view)];
  state.drawn = !pane.visible();
  if (state.drawn) return false;
  // A finer picture of the same stays.
  const bool fine = state.fine || is_paper(view);
  const bool finer = fine || (state.picture && state.picture->fine);
  Picture picture{scene_of(view), options_of(view, finer), pane.camera, pane.rect, finer};
  const auto inked = ink();
  if (is_paper(view)) {
    // What a stroke is drawn over, should one begin.
    sheet_.keep(picture.scene, picture.options, pane, inked && inked->view == view ? inked->samples->size() : 0);
    sheet_view_ = view;
  }
  if (inked && inked->view == view) picture.scene.lines.emplace_back(ink_item(*inked->samples, inked->pale));
  state.drawn = state.picture == picture;
  if (state.drawn) state.fine = finer;
  if (state.drawn) return false;
  picture.fine = fine;
  picture.options = options_of(view, fine);
  state.picture.reset();  // what only the old one shows needs no room any more
  renderer_->draw(picture.scene, pane.camera, picture.options, place_of(pane));
  ++state.drawn_count;
  state.triangles = renderer_->triangles_drawn();
  state.drawn = !renderer_->pending();
  if (state.drawn) state.picture = std::move(picture);
  return true;
}

void Viewport::place_chips() {
  ChipPlaces places(layout_, *this);
  std::array<QString, view_count> titles;
  for (int view = 0; view < view_count; ++view) {
    for (const Tool* tool : tools_) {
      if (titles[static_cast<std::size_t>(view)].isEmpty())
        titles[static_cast<std::size_t>(view)] = tool->use_of(view).title;
    }
  }
  if (const auto camera = looked_through()) titles[PerspectiveView] = tr("Camera of %1").arg(camera->name);
  chips_.place(places, titles);
  for (Tool* tool : tools_) tool->place_chips(places);
}

}  // namespace croquis::app
