// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/tools/silhouette/sketch_chip.h"

#include <QApplication>
#include <QDoubleSpinBox>
#include <QFrame>
#include <QHBoxLayout>
#include <QMouseEvent>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <set>
#include <utility>

#include <Eigen/Geometry>

#include "app/panels/number_box.h"
#include "app/views/viewport.h"
#include "app/window/theme.h"
#include "croquis/silhouette/stroke_data.h"
#include "croquis/tools/silhouette/stroke_edit.h"
#include "croquis/tools/silhouette/stroke_setting.h"

namespace croquis::app {
namespace {

constexpr int chip_size = 22;  // logical pixels
constexpr int chip_icon_size = 14;
constexpr int number_decimals = 2;
constexpr double number_step = 0.05;

QString style_of(SketchChip::Look::Strength strength) {
  struct Colors {
    const char *background, *text, *border, *hovered;
  };
  static constexpr std::array<Colors, 4> by_strength{{{"white", "#3c4654", "1px solid #7a8698", "#ffe2c2"},
                                                      {"#cfe0f7", "#2b3f5c", "1px solid #4d7cba", "#e2edfb"},
                                                      {"#f28c28", "#1c1c1e", "1px solid #a85a10", "#f7a552"},
                                                      {"#fff4df", "#7a4a00", "2px dashed #d08a1e", "#ffe2a8"}}};
  const Colors& look = by_strength[static_cast<std::size_t>(strength)];
  return QString(
             "QToolButton { background: %1; color: %2; border: %3; border-radius: 11px; padding: 0 3px;"
             " font-size: 12px } QToolButton:hover { background: %4 }")
      .arg(look.background, look.text, look.border, look.hovered);
}

constexpr double above_outline = 20;           // logical pixels
constexpr double pixels_per_thickness = 100;   // a drag so far up makes a part e times as thick
constexpr double least_depth_in_view = 12;     // logical pixels; less can't be aimed at
constexpr double least_share_of_depth = 0.01;  // a front dragged through the back stays before it

}  // namespace

using silhouette::is_set_behind;
using silhouette::StrokeKind;

std::vector<NestedStroke> nested_outlines(const InflateResult& inflated, const Drawing& drawing) {
  std::vector<NestedStroke> outlines;
  for (NestedStroke nested : inflated.nested) {
    const Stroke* stroke = find_stroke(drawing, nested.stroke);
    if (stroke == nullptr) continue;
    const auto kind = silhouette::stroke_kind(*stroke);
    if (kind == StrokeKind::Hole || kind == StrokeKind::Part) {
      nested.hole = kind == StrokeKind::Hole;
      nested.chosen = true;
    }
    outlines.push_back(std::move(nested));
  }
  return outlines;
}

std::vector<StrokesInView> crossings_in_view(const InflateResult& inflated, const Drawing& drawing) {
  std::vector<StrokesInView> crossings;
  std::set<std::pair<std::string, std::string>> seen;
  for (StrokesInView crossing : inflated.crossings_in_view) {
    const Stroke* front = find_stroke(drawing, crossing.front);
    const Stroke* behind = find_stroke(drawing, crossing.behind);
    if (front == nullptr || behind == nullptr || !seen.insert(std::minmax(crossing.front, crossing.behind)).second)
      continue;
    const bool was_taken_back = crossing.chosen && !is_set_behind(*behind, *front);
    if (is_set_behind(*front, *behind) || was_taken_back) {
      std::swap(crossing.front, crossing.behind);
      crossing.chosen = !was_taken_back;
    }
    crossings.push_back(std::move(crossing));
  }
  return crossings;
}

std::vector<ReadStroke> read_strokes(const InflateResult& inflated, const Drawing& drawing,
                                     const std::vector<std::string>& selected) {
  constexpr std::size_t most_shown = 12;
  std::vector<ReadStroke> chosen, others;
  for (const auto& [id, found] : inflated.kinds) {
    const Stroke* stroke = find_stroke(drawing, id);
    if (stroke == nullptr || stroke->samples.empty()) continue;
    const StrokeKind chosen_kind = silhouette::stroke_kind(*stroke).value_or(StrokeKind::Visible);
    const bool is_chosen = chosen_kind != StrokeKind::Visible;
    const StrokeKind kind = is_chosen ? chosen_kind : found;
    const ReadStroke read{id, kind, is_chosen, stroke->samples[stroke->samples.size() / 2].position};
    const bool has_chip = kind == StrokeKind::Hole || kind == StrokeKind::Part || kind == StrokeKind::Blob;
    if (std::ranges::find(selected, id) != selected.end())
      chosen.push_back(read);
    else if (kind != StrokeKind::Contour && kind != StrokeKind::Hidden && !has_chip)
      others.push_back(read);
  }
  if (others.size() > most_shown) others.clear();
  chosen.insert(chosen.end(), others.begin(), others.end());
  return chosen;
}

ChosenPart chosen_part(const InflateResult& inflated, const Drawing& drawing,
                       const std::vector<std::string>& selected) {
  const auto is_in = [](const std::vector<std::string>& ids, const std::string& id) {
    return std::ranges::find(ids, id) != ids.end();
  };
  const InflatedObject* chosen = nullptr;
  for (const InflatedObject& object : inflated.objects) {
    if (std::ranges::none_of(object.strokes, [&](const std::string& id) { return is_in(selected, id); })) continue;
    if (chosen != nullptr) return {};
    chosen = &object;
  }
  ChosenPart part;
  if (chosen == nullptr) return part;
  part.object = chosen->name;
  Eigen::AlignedBox2d box;
  for (const Stroke& stroke : drawing.strokes) {
    if (!is_in(chosen->strokes, stroke.id)) continue;
    if (part.stroke.empty()) part.stroke = stroke.id;
    for (const StrokeSample& sample : stroke.samples) box.extend(sample.position);
  }
  if (!box.isEmpty()) part.at = {box.center().x(), box.max().y()};
  return part;
}

SketchChip::SketchChip(QWidget* views) : QToolButton(views) {
  setFocusPolicy(Qt::NoFocus);
  setIconSize({chip_icon_size, chip_icon_size});
  setFixedHeight(chip_size);
  hide();
}

void SketchChip::set_look(const Look& look) {
  const QString style = style_of(look.strength);
  if (styleSheet() != style) setStyleSheet(style);
  setIcon(paper_icon(look.icon));
  setText(look.text);
  setToolButtonStyle(look.text.isEmpty() ? Qt::ToolButtonIconOnly : Qt::ToolButtonTextBesideIcon);
  setFixedWidth(look.text.isEmpty() ? chip_size : sizeHint().width());
  setToolTip(look.tooltip);
  setAccessibleName(look.tooltip);
}

void SketchChip::mousePressEvent(QMouseEvent* event) {
  if (event->button() == Qt::LeftButton) pressed_at_ = event->globalPosition();
  QToolButton::mousePressEvent(event);
}

void SketchChip::mouseMoveEvent(QMouseEvent* event) {
  if (!pressed_at_ || !draggable_) return QToolButton::mouseMoveEvent(event);
  const QPointF by = event->globalPosition() - *pressed_at_;
  dragging_ = dragging_ || by.manhattanLength() >= QApplication::startDragDistance() / 2.0;
  if (dragging_) emit dragged(by);
}

void SketchChip::mouseReleaseEvent(QMouseEvent* event) {
  pressed_at_.reset();
  if (event->button() == Qt::RightButton) emit asked();
  if (!std::exchange(dragging_, false)) return QToolButton::mouseReleaseEvent(event);
  setDown(false);
  emit dropped();
}

ChipRow::ChipRow(QWidget* views, const QString& name, bool draggable)
    : QObject(views), views_(views), name_(name), draggable_(draggable) {}

void ChipRow::add_button() {
  auto* button = new SketchChip(views_);
  const std::size_t number = buttons_.size();
  button->setObjectName(name_ + "-" + QString::number(number));
  button->set_draggable(draggable_);
  connect(button, &QToolButton::clicked, this, [this, number] { emit clicked(number); });
  connect(button, &SketchChip::dragged, this, [this, number](const QPointF& by) { emit dragged(number, by); });
  connect(button, &SketchChip::dropped, this, [this, number] { emit dropped(number); });
  connect(button, &SketchChip::asked, this, [this, number] { emit asked(number); });
  buttons_.push_back(button);
}

void ChipRow::show(std::vector<Chip> chips) {
  chips_ = std::move(chips);
  while (buttons_.size() < chips_.size()) add_button();
  for (std::size_t i = 0; i < chips_.size(); ++i) buttons_[i]->set_look(chips_[i].look);
  for (std::size_t i = chips_.size(); i < buttons_.size(); ++i) buttons_[i]->hide();
}

void ChipRow::place(ChipPlaces& places, bool shown, bool drawn_through) {
  const ViewPane& pane = places.layout().pane(SketchView);
  for (std::size_t i = 0; i < chips_.size(); ++i) {
    SketchChip& button = *buttons_[i];
    button.setAttribute(Qt::WA_TransparentForMouseEvents, drawn_through);
    const Vec2 pixel = pane.sketch_frame().to_pixel(chips_[i].at);
    const QPointF at = pane.rect.topLeft() + QPointF(pixel.x(), pixel.y() - chips_[i].above);
    if (shown && pane.visible() && pane.rect.contains(at))
      places.put(button, at - QPointF(button.width(), button.height()) / 2, pane.rect);
    else
      button.hide();
  }
}

double chip_number(double value) {
  const double steps = std::pow(10, number_decimals);
  return std::round(value * steps) / steps;
}

QString chip_text(double value) { return number_words(chip_number(value)); }

void ask_number(SketchChip& chip, const QString& name, double value, double low, double high,
                const std::function<void(double)>& take) {
  auto* window = new QFrame(&chip, Qt::Popup);
  window->setAttribute(Qt::WA_DeleteOnClose);
  QDoubleSpinBox* box = make_number_box(window, name, {low, high, number_decimals});
  box->setSingleStep(number_step);
  box->setValue(value);
  auto* layout = new QHBoxLayout(window);
  layout->setContentsMargins(4, 4, 4, 4);
  layout->addWidget(box);
  QObject::connect(box, &QDoubleSpinBox::valueChanged, &chip, take);
  QObject::connect(box, &QDoubleSpinBox::editingFinished, window, &QWidget::close);
  window->move(chip.mapToGlobal(QPoint(0, chip.height() + 2)));
  window->show();
  box->setFocus();
  box->selectAll();
}

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
  const auto seen = own_frame_of(views_.views(), view_).project(place);
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
