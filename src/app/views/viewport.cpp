// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/views/viewport.h"

#include <QOpenGLContext>
#include <QOpenGLFunctions>
#include <algorithm>
#include <cmath>
#include <utility>

#include "app/views/offscreen_pictures.h"
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

bool has_editable_mesh(const Studio& studio) {
  return std::any_of(studio.objects().begin(), studio.objects().end(),
                     [](const StudioObject& object) { return object.cage != 0; });
}

}  // namespace

Viewport::Viewport(Studio& studio, QWidget* parent)
    : QOpenGLWidget(parent),
      studio_(studio),
      objects_(studio, nullptr),
      sketch_(studio, layout_.pane(SketchView), nullptr),
      mesh_(studio, objects_, layout_, nullptr),
      holes_(
          studio, objects_, [this](int view) { return mesh_.frame_of(view); }, nullptr),
      comparison_(studio, objects_.threads(), nullptr),
      chips_(studio, this),
      marking_menu_(this),
      pins_(this) {
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
  set_tool(ToolKind::Draw);
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
    if (abandon()) marking_menu_.open(pressed_at_);
  });
  connect(&studio_, &Studio::busy_changed, this, &Viewport::note_busy);
  connect(&studio_, &Studio::loaded, this, &Viewport::follow_load);
  connect(&studio_, &Studio::changed, this, &Viewport::follow_document);
  connect(&studio_, &Studio::result_changed, this, &Viewport::follow_result);
  connect(&sketch_, &SketchInteraction::changed, this, [this] { redraw(SketchView); });
  connect(&sketch_, &SketchInteraction::inked, this, [this] { update(); });
  connect(&sketch_, &SketchInteraction::committed, this, &Viewport::committed);
  connect(&mesh_, &MeshInteraction::changed, this, &Viewport::redraw_all);
  connect(&mesh_, &MeshInteraction::committed, this, &Viewport::committed);
  connect(&mesh_, &MeshInteraction::mode_changed, this, &Viewport::help_changed);
  connect(&holes_, &HoleInteraction::changed, this, &Viewport::redraw_all);
  connect(&holes_, &HoleInteraction::committed, this, &Viewport::committed);
  connect(&holes_, &HoleInteraction::holes_changed, this, &Viewport::help_changed);
  connect(&objects_, &ObjectScenes::changed, this, [this] {
    mesh_.follow();
    keep_in_view();
    redraw_all();
  });
  connect(&comparison_, &Comparison::changed, this, [this] { redraw(ComparisonView); });
}

bool Viewport::edits_meshes() const {
  return kind_ != ToolKind::Draw && kind_ != ToolKind::Erase && kind_ != ToolKind::Holes && has_editable_mesh(studio_);
}

bool Viewport::sketches_in(int view) const {
  if (view != SketchView) return false;
  if (kind_ == ToolKind::Draw || kind_ == ToolKind::Erase) return true;
  return kind_ == ToolKind::Select && (sketch_.scene().has_strokes() || !has_editable_mesh(studio_));
}

void Viewport::set_tool(ToolKind tool) {
  kind_ = tool;
  sketch_.set_mode(tool == ToolKind::Draw    ? SketchMode::Draw
                   : tool == ToolKind::Erase ? SketchMode::Erase
                                             : SketchMode::Select);
  switch (tool) {
    case ToolKind::Move: mesh_.set_handles(MeshHandles::Move); break;
    case ToolKind::Rotate: mesh_.set_handles(MeshHandles::Rotate); break;
    case ToolKind::Scale: mesh_.set_handles(MeshHandles::Scale); break;
    case ToolKind::Sharpen: mesh_.set_handles(MeshHandles::Sharpen); break;
    default: mesh_.set_handles(MeshHandles::Select);
  }
  holes_.set_active(tool == ToolKind::Holes);
  show_patch_look();
  const bool draws = tool == ToolKind::Draw || tool == ToolKind::Erase;
  if (draws && !layout_.pane(SketchView).visible()) arrange(Arrangement::SketchAndSolid);
  show_cursor(under_pointer_);
  redraw_all();
  navigation_.something_done();
  emit help_changed();
}

void Viewport::set_look(MeshLook look) {
  look_ = look;
  redraw_all();
}

void Viewport::set_flat(bool flat) { objects_.set_flat(flat); }

void Viewport::set_tinted(bool tinted) {
  tinted_ = tinted;
  show_patch_look();
}

void Viewport::show_patch_look() {
  objects_.set_patch_look(tinted_ ? PatchLook::Confidence : holes_.active() ? PatchLook::Told : PatchLook::Plain);
}

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

void Viewport::set_pane_shares(const QPointF& shares) {
  layout_.set_shares(shares);
  after_layout();
}

void Viewport::show_alone(int view) {
  layout_.show_alone(view);
  after_layout();
}

void Viewport::compare(bool shown) {
  comparison_.show(shown);
  arrange(shown                           ? Arrangement::Compare
          : sketch_.scene().has_strokes() ? Arrangement::SketchAndSolid
                                          : Arrangement::Four);
  if (!shown && !sketch_.scene().has_strokes()) show_alone(PerspectiveView);
  ViewPane& pane = layout_.pane(PerspectiveView);
  if (!pane.fits(objects_.scene({}))) pane.frame(objects_.scene({}));
}

void Viewport::delete_selection() {
  if (holes_.active()) return holes_.reopen_selected();
  if (sketch_.tool().delete_selected() == Verdict::Commit) return;
  const Selection selection = studio_.session().selection();
  for (const SelectedItem& item : selection) {
    if (item.part.empty()) studio_.remove_object(item.node);
  }
}

bool Viewport::abandon() { return sketch_.abandon() || mesh_.abandon() || holes_.abandon(); }

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
  const auto seen = mesh_.frame_of(view).project(place);
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
  sketch_.follow_document();
  comparison_.follow();
  mesh_.follow();
  holes_.follow();
  const bool has_meshes = has_editable_mesh(studio_);
  if (has_meshes && !had_meshes_ && studio_.drawing_node() == 0) {
    // A document of meshes begins with the perspective view; Space shows the others.
    layout_.arrange(Arrangement::Four);
    show_alone(PerspectiveView);
    set_tool(ToolKind::Select);
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
  sketch_.follow_result();
  mesh_.follow();
  holes_.follow();
  chips_.show_joints();
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
                                 [](const StudioObject& object) { return object.result && object.result->stale; });
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
  if (!sketch_.inking()) {
    update();
    if (view == SketchView) sheet_.drop();
  }
  if (view == SketchView && !has_editable_mesh(studio_)) return;  // paper is always fine
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
  const ViewPane& pane = layout_.pane(SketchView);
  if (!sketch_.inking() || clear_ || !sheet_.fits(pane)) return false;
  const bool begins = sheet_.inked() == 0;
  sheet_.draw_new_ink(*renderer_, sketch_.ink(), place_of(pane));
  if (begins) place_chips();
  return true;
}

void Viewport::draw_views() {
  QElapsedTimer watch;
  watch.start();
  const bool clears = std::exchange(clear_, false);
  if (clears) {
    QOpenGLFunctions* gl = QOpenGLContext::currentContext()->functions();
    gl->glClearColor(0.22F, 0.23F, 0.25F, 1);
    gl->glClear(GL_COLOR_BUFFER_BIT);
  }
  layout_.pane(ComparisonView).camera = layout_.pane(PerspectiveView).camera;
  bool fine = false;
  uploading_ = false;
  for (const int view : layout_.shown()) {
    PaneState& state = states_[static_cast<std::size_t>(view)];
    if (state.drawn || (sketch_.inking() && view != SketchView && !clears)) continue;
    draw_view(view);
    state.drawn = !renderer_->pending();
    state.triangles = renderer_->triangles_drawn();
    uploading_ = uploading_ || renderer_->pending();
    fine = fine || state.fine;
  }
  if (uploading_) update();
  if (fine) affordable_ = static_cast<double>(watch.elapsed()) < affordable_ms;
  place_chips();
}

render::Scene Viewport::scene_of(int view) {
  ObjectScenes::Wanted wanted;
  wanted.look = look_;
  wanted.stale = stale_;
  wanted.outlines = !holes_.active();
  wanted.only_with_cage = view == SketchView;
  const bool elements = edits_meshes() && mesh_.tool().selection().mode() != MeshMode::Object;
  if (elements) wanted.edited = mesh_.tool().source().node();
  if (view == ComparisonView) {
    wanted.replaced = comparison_.object();
    wanted.by = comparison_.item();
  }
  render::Scene scene = objects_.scene(wanted);
  mesh_.overlay().add_to(scene, view != ComparisonView);
  if (edits_meshes()) mesh_.add_handles_to(scene, view);
  holes_.add_to(scene, view);
  if (view == SketchView) {
    const render::Scene sketch = sketch_.scene().scene();
    scene.lines.insert(scene.lines.end(), sketch.lines.begin(), sketch.lines.end());
    scene.marks.insert(scene.marks.end(), sketch.marks.begin(), sketch.marks.end());
  }
  return scene;
}

render::RenderOptions Viewport::options_of(int view) const {
  const bool paper = view == SketchView && (sketch_.scene().has_strokes() || !has_editable_mesh(studio_));
  const bool fine = states_[static_cast<std::size_t>(view)].fine;
  auto options = paper  ? render::RenderOptions::paper()
                 : fine ? render::RenderOptions{}
                        : render::RenderOptions::interactive();
  if (!paper) {
    options.supersampling = std::min(options.supersampling, 2);
    options.axis_cross.shown = true;
    if (layout_.pane(view).flat()) options.grid.kind = render::GridKind::Lines;
  }
  if (zebra_ && !paper) options.shading = render::Shading::Zebra;
  options.pixel_ratio = devicePixelRatioF();
  options.upload_budget = upload_budget;
  options.reduced = states_[static_cast<std::size_t>(view)].moving;
  return options;
}

render::Viewport Viewport::place_of(const ViewPane& pane) const {
  const double ratio = devicePixelRatioF();
  const auto pixels = [ratio](double length) { return static_cast<int>(std::lround(length * ratio)); };
  render::Viewport target;
  target.x = pixels(pane.rect.left());
  target.y = pixels(height() - pane.rect.bottom());
  target.width = pixels(pane.rect.width());
  target.height = pixels(pane.rect.height());
  return target;
}

void Viewport::draw_view(int view) {
  const ViewPane& pane = layout_.pane(view);
  if (!pane.visible()) return;
  render::Scene scene = scene_of(view);
  const render::RenderOptions options = options_of(view);
  if (view == SketchView) {
    sheet_.keep(scene, options, pane, sketch_.ink().size());
    scene.lines.emplace_back(ink_item(sketch_.ink()));
  }
  renderer_->draw(scene, pane.camera, options, place_of(pane));
}

void Viewport::place_chips() {
  ViewChips::Wanted wanted;
  wanted.sketch = &sketch_.scene();
  wanted.drawing = sketch_.down();
  wanted.legend = mesh_.overlay().shows_tags();
  wanted.comparison = comparison_.title();
  if (const auto& value = mesh_.hovered_value(); value && !mesh_.down()) {
    const QPointF in_view(value->pixel.x(), value->pixel.y());
    wanted.value = ViewChips::Wanted::Value{layout_.pane(value->view).rect.topLeft() + in_view, value->text};
  }
  wanted.confidence = tinted_ && holes_.active();
  chips_.place(layout_, wanted);
  place_pins();
}

void Viewport::place_pins() {
  HolePinView::Pins pins;
  for (const int view : holes_.active() ? layout_.shown() : std::vector<int>()) {
    if (!sketches_in(view)) pins.push_back({layout_.pane(view).rect, holes_.pins(view)});
  }
  pins_.show_pins(std::move(pins), holes_);
}

}  // namespace croquis::app
