// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/viewport.h"

#include <QCursor>
#include <QMouseEvent>
#include <algorithm>
#include <cmath>
#include <utility>

#include "app/offscreen_pictures.h"
#include "app/pointer_events.h"
#include "croquis/base/error.h"

namespace croquis::app {
namespace {

constexpr double gap = 2;  // logical pixels between the views
constexpr int settle_ms = 180;
constexpr int patience_ms = 700;
constexpr double affordable_ms = 90;  // a frame that takes longer would be felt
constexpr int picture_height = 1600;
constexpr int joint_size = 18;
constexpr const char* joint_style =
    "QToolButton { background: white; color: #3c4654; border: 1px solid #7a8698; border-radius: 9px; padding: 0;"
    " font-size: 13px }"
    "QToolButton:hover { background: #ffe2c2 }"
    "QToolButton:checked { background: #f28c28; color: #1c1c1e; border: 1px solid #a85a10 }";

std::string attach_text(const Studio& studio) {
  const Node* operation = studio.solid_operation();
  if (operation == nullptr) return {};
  const auto attach = operation->parameters.find("attach");
  return attach == operation->parameters.end() ? "" : std::get<std::string>(attach->second);
}

}  // namespace

Viewport::Viewport(Studio& studio, QWidget* parent)
    : QOpenGLWidget(parent),
      studio_(studio),
      tool_(studio.session(), studio.tool_options()),
      panes_{sketch_pane(), perspective_pane()},
      hint_(new QLabel(tr("Trace me: one closed line becomes a solid"), this)) {
  setObjectName("viewport");
  setAccessibleName(tr("Sketch and solid"));
  setMouseTracking(true);
  setTabletTracking(true);
  setAttribute(Qt::WA_AcceptTouchEvents);
  setFocusPolicy(Qt::StrongFocus);
  setMinimumSize(320, 240);
  navigation_.set_flat(SketchView, true);
  clock_.start();
  settle_.setSingleShot(true);
  connect(&settle_, &QTimer::timeout, this, [this] { settle_now(); });
  connect(&pen_watch_, &QTimer::timeout, this, &Viewport::watch_pen);
  hint_->setAttribute(Qt::WA_TransparentForMouseEvents);
  hint_->setStyleSheet("color: #8a93a0; background: transparent; font-size: 15px");
  for (QLabel*& chip : finding_chips_) {
    chip = new QLabel(this);
    chip->setAttribute(Qt::WA_TransparentForMouseEvents);
    chip->setWordWrap(true);
    chip->setStyleSheet("background: #b3362f; color: white; border-radius: 6px; padding: 5px 8px");
    chip->hide();
  }
  // What isn't drawn anew stays as it was.
  setUpdateBehavior(QOpenGLWidget::PartialUpdate);
  patience_.setSingleShot(true);
  connect(&patience_, &QTimer::timeout, this, [this] {
    stale_ = true;
    redraw(PerspectiveView);
  });
  connect(&studio_, &Studio::busy_changed, this, &Viewport::note_busy);
  connect(&studio_, &Studio::loaded, this, [this] {
    panes_[PerspectiveView].camera = perspective_pane().camera;
    turned_ = false;
  });
  connect(&studio_, &Studio::changed, this, &Viewport::follow_document);
  connect(&studio_, &Studio::result_changed, this, &Viewport::follow_result);
  scenes_.show_drawing(studio_, tool_);
  set_mode(SketchMode::Draw);
}

Viewport::~Viewport() {
  makeCurrent();
  renderer_.reset();
  doneCurrent();
}

void Viewport::set_mode(SketchMode mode) {
  tool_.set_mode(mode);
  setCursor(mode == SketchMode::Select ? Qt::ArrowCursor : Qt::CrossCursor);
  scenes_.show_hovered(std::nullopt, studio_.drawing());
  scenes_.show_drawing(studio_, tool_);
  redraw_all();
  emit help_changed();
}

void Viewport::set_look(MeshLook look) {
  look_ = look;
  redraw_all();
}

void Viewport::frame_all() {
  lay_out();
  if (scenes_.has_strokes())
    panes_[SketchView].frame(scenes_.sketch_bounds(false));
  else
    panes_[SketchView].camera = sketch_pane().camera;
  panes_[PerspectiveView].frame(scenes_.solid_scene(false));
  turned_ = false;
  redraw_all();
}

void Viewport::frame_selection() {
  if (under_pointer_ == PerspectiveView) {
    panes_[PerspectiveView].frame(scenes_.solid_scene(false));
  } else {
    panes_[SketchView].frame(scenes_.sketch_bounds(true));
  }
  redraw_all();
}

void Viewport::toggle_layout() {
  alone_ = alone_ < 0 ? under_pointer_ : -1;
  lay_out();
  redraw_all();
}

void Viewport::delete_selection() { tool_.delete_selected(); }

bool Viewport::abandon() {
  if (!pen_.down()) return false;
  take_pen(pen_.cancel());
  return true;
}

QString Viewport::help() const {
  const Findings findings = studio_.findings();
  if (!findings.empty() && findings.front().severity == Severity::Error) {
    return QString::fromStdString(findings.front().message);
  }
  if (navigation_.alt_swallowed()) {
    return tr("Alt belongs to your desktop: hold Super, or the key left of 1, and drag to turn, shift and come nearer");
  }
  switch (tool_.mode()) {
    case SketchMode::Select:
      return tr("Drag a square to bend the line, drag a line to move it, Shift adds · Delete removes · D draws");
    case SketchMode::Erase: return tr("Drag over lines to erase them · D draws");
    case SketchMode::Draw: break;
  }
  if (!scenes_.has_strokes()) return tr("Draw a closed outline with the pen or the mouse");
  return tr("Draw: a line stops where it passes behind another · Q selects · Alt+drag turns the solid · Ctrl+Z undoes");
}

void Viewport::export_picture(OffscreenPictures& pictures, const QString& path) const {
  const render::Scene scene = scenes_.solid_scene(false);
  std::vector<render::MeshItemPtr> items;
  for (const auto& shown : scene.meshes) items.push_back(shown.item);
  const ViewPane& pane = panes_[PerspectiveView];
  const double aspect = pane.visible() ? pane.rect.width() / pane.rect.height() : 1;
  const QSize size(static_cast<int>(picture_height * aspect), picture_height);
  if (!pictures.draw(items, pane.camera, render::RenderOptions{}, size).save(path, "PNG")) {
    throw Error(make_error(Category::Io, "E_WRITE", "\"" + path.toStdString() + "\" can't be written"));
  }
}

QPointF Viewport::sketch_to_widget(const Vec2& place) const {
  const ViewPane& pane = panes_[SketchView];
  const Vec2 pixel = pane.sketch_frame().to_pixel(place);
  return pane.rect.topLeft() + QPointF(pixel.x(), pixel.y());
}

void Viewport::settle_now() {
  settle_.stop();
  settled_ = true;
  solid_drawn_ = false;
  update();
}

void Viewport::initializeGL() {
  try {
    renderer_ = std::make_unique<render::Renderer>();
  } catch (const Error& error) {
    hint_->setText(QString::fromStdString(error.what()) + tr(". Try croquis --software-gl"));
    hint_->adjustSize();
    hint_->show();
  }
}

void Viewport::resizeGL(int, int) {
  lay_out();
  redraw_all();
}

void Viewport::lay_out() {
  const double w = width();
  const double h = height();
  if (alone_ >= 0) {
    panes_[static_cast<std::size_t>(alone_)].rect = QRectF(0, 0, w, h);
    panes_[static_cast<std::size_t>(1 - alone_)].rect = QRectF();
    return;
  }
  const double left = std::round(w * divider_ - gap / 2);
  panes_[SketchView].rect = QRectF(0, 0, left, h);
  panes_[PerspectiveView].rect = QRectF(left + gap, 0, w - left - gap, h);
}

void Viewport::paintGL() {
  if (!renderer_) return;
  QElapsedTimer watch;
  watch.start();
  const bool was_drawn = solid_drawn_;
  auto sketch_look = render::RenderOptions::paper();
  sketch_look.pixel_ratio = devicePixelRatioF();
  draw_pane(panes_[SketchView], scenes_.sketch_scene(), sketch_look);
  if (!solid_drawn_) draw_pane(panes_[PerspectiveView], scenes_.solid_scene(stale_), solid_options());
  solid_drawn_ = true;
  if (settled_ && !was_drawn) affordable_ = static_cast<double>(watch.elapsed()) < affordable_ms;
  place_labels();
  ++frames_;
  if (input_time_ms_ >= 0) {
    latency_ms_ = static_cast<double>(clock_.nsecsElapsed()) * 1e-6 - input_time_ms_;
    input_time_ms_ = -1;
  }
}

render::RenderOptions Viewport::solid_options() const {
  auto options = settled_ ? render::RenderOptions{} : render::RenderOptions::interactive();
  options.supersampling = std::min(options.supersampling, 2);
  options.pixel_ratio = devicePixelRatioF();
  options.axis_cross.shown = true;
  options.wire = look_ != MeshLook::Shaded;
  if (look_ == MeshLook::Wire) options.shading = render::Shading::Flat;
  return options;
}

void Viewport::draw_pane(const ViewPane& pane, const render::Scene& scene, const render::RenderOptions& options) {
  if (!pane.visible()) return;
  const double ratio = devicePixelRatioF();
  const auto pixels = [ratio](double length) { return static_cast<int>(std::lround(length * ratio)); };
  render::Viewport target;
  target.x = pixels(pane.rect.left());
  target.y = pixels(height() - pane.rect.bottom());
  target.width = pixels(pane.rect.width());
  target.height = pixels(pane.rect.height());
  renderer_->draw(scene, pane.camera, options, target);
}

void Viewport::redraw(View view) {
  update();
  if (view == SketchView) return;
  solid_drawn_ = false;
  settled_ = false;
  if (affordable_) settle_.start(settle_ms);
}

void Viewport::redraw_all() {
  redraw(SketchView);
  redraw(PerspectiveView);
}

void Viewport::note_busy(bool busy) {
  if (busy) {
    if (!patience_.isActive()) patience_.start(patience_ms);
    return;
  }
  patience_.stop();
  const bool stale = studio_.result() && studio_.result()->stale;
  if (stale_ != stale) redraw(PerspectiveView);
  stale_ = stale;
}

void Viewport::follow_document() {
  const std::size_t meshes = scenes_.solid_scene(false).meshes.size();
  scenes_.show_drawing(studio_, tool_);
  scenes_.show_preview(tool_.preview(), studio_.drawing());
  if (scenes_.solid_scene(false).meshes.size() != meshes) redraw(PerspectiveView);
  redraw(SketchView);
  emit help_changed();
}

void Viewport::follow_result() {
  scenes_.show_result(studio_);
  show_joints();
  keep_solid_in_view();
  redraw_all();
  emit help_changed();
}

void Viewport::keep_solid_in_view() {
  // Without a solid there is nothing that anybody looks at: the next one is shown as if it were the first.
  if (!studio_.solid()) turned_ = false;
  if (!studio_.solid() || turned_) return;
  lay_out();
  ViewPane& pane = panes_[PerspectiveView];
  const render::Scene scene = scenes_.solid_scene(false);
  if (!pane.fits(scene)) pane.frame(scene);
}

void Viewport::place_labels() {
  const QRectF sketch = panes_[SketchView].rect;
  hint_->setVisible(!renderer_ || (scenes_.invites() && panes_[SketchView].visible() && !pen_.down()));
  hint_->adjustSize();
  hint_->move(static_cast<int>(sketch.center().x() - hint_->width() / 2.0), static_cast<int>(sketch.bottom() - 60));
  place_finding_chips();
  place_joint_chips();
}

void Viewport::place_finding_chips() {
  const QRectF sketch = panes_[SketchView].rect;
  std::size_t used = 0;
  for (const FindingMark& finding : scenes_.finding_marks()) {
    if (used == finding_chips_.size() || !panes_[SketchView].visible() || pen_.down()) break;
    if (!finding.error) continue;  // its mark is enough: the pen on it shows the sentence
    QLabel* chip = finding_chips_[used++];
    chip->setText(QString::fromStdString(finding.sentence));
    chip->setFixedWidth(std::min(300, static_cast<int>(sketch.width()) - 16));
    chip->setFixedHeight(chip->heightForWidth(chip->width()));
    const QPointF at = sketch_to_widget(finding.at) + QPointF(14, 10);
    chip->move(static_cast<int>(std::clamp(at.x(), sketch.left() + 4, sketch.right() - chip->width() - 4)),
               static_cast<int>(std::clamp(at.y(), sketch.top() + 4, sketch.bottom() - chip->height() - 4)));
    chip->show();
  }
  for (; used < finding_chips_.size(); ++used) finding_chips_[used]->hide();
}

void Viewport::show_joints() {
  joints_.clear();
  if (studio_.result()) joints_ = suggested_joints(*studio_.result(), attach_text(studio_));
  while (joint_chips_.size() < joints_.size()) {
    auto* chip = new QToolButton(this);
    const std::size_t place = joint_chips_.size();
    chip->setObjectName("joint-" + QString::number(place));
    chip->setCheckable(true);
    chip->setFixedSize(joint_size, joint_size);
    chip->setFocusPolicy(Qt::NoFocus);
    chip->setStyleSheet(joint_style);
    connect(chip, &QToolButton::clicked, this, [this, place] {
      const std::string text = toggled_joint(attach_text(studio_), joints_.at(place));
      studio_.set_parameter(studio_.solid_node(), "attach", text, false);
    });
    joint_chips_.push_back(chip);
  }
  for (std::size_t i = 0; i < joints_.size(); ++i) {
    const Joint& joint = joints_[i];
    const QString names = QString::fromStdString(joint.a) + " – " + QString::fromStdString(joint.b);
    joint_chips_[i]->setChecked(joint.attached);
    joint_chips_[i]->setText(joint.attached ? QStringLiteral("✓") : QStringLiteral("+"));
    joint_chips_[i]->setToolTip(joint.attached ? tr("%1 are one body: click to part them").arg(names)
                                               : tr("%1: click to make them one body").arg(names));
    joint_chips_[i]->setAccessibleName(joint_chips_[i]->toolTip());
  }
}

void Viewport::join_all() {
  std::string text = attach_text(studio_);
  for (const Joint& joint : joints_) {
    if (!joint.attached) text = toggled_joint(text, joint);
  }
  if (!joints_.empty()) studio_.set_parameter(studio_.solid_node(), "attach", text, false);
}

void Viewport::place_joint_chips() {
  const QRectF sketch = panes_[SketchView].rect;
  for (std::size_t i = 0; i < joint_chips_.size(); ++i) {
    QToolButton* chip = joint_chips_[i];
    const bool shown = i < joints_.size() && panes_[SketchView].visible() && !pen_.down();
    const QPointF at = shown ? sketch_to_widget(joints_[i].at) : QPointF();
    chip->setVisible(shown && sketch.contains(at));
    chip->move((at - QPointF(chip->width(), chip->height()) / 2).toPoint());
  }
}

}  // namespace croquis::app
