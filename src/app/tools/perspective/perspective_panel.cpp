// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/tools/perspective/perspective_panel.h"

#include <QAction>
#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QGridLayout>
#include <QHeaderView>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <QSlider>
#include <QToolButton>
#include <QTreeWidget>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "app/panels/number_box.h"
#include "app/tools/perspective/group_looks.h"
#include "app/tools/perspective/sheet_size_field.h"
#include "croquis/tools/perspective/sheet_units.h"

namespace croquis::app {
namespace {

constexpr double degree = std::numbers::pi / 180;
constexpr double weak_deviation = 0.15;  // of the focal length: as VP_WEAK
constexpr std::size_t most_lines = 60;

void show_value(QDoubleSpinBox& box, double value) {
  if (!box.hasFocus() || box.value() != value) box.setValue(value);
}

}  // namespace

PerspectivePanel::PerspectivePanel(SheetInteraction& sheet, const std::function<QAction*(const QString&)>& action)
    : sheet_(sheet) {
  setObjectName("perspective-panel");
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(8, 6, 8, 6);
  make_groups(column, action);
  make_camera(column);
  sheet_size_ = new SheetSizeField(this);
  connect(sheet_size_, &SheetSizeField::size_wanted, this, &PerspectivePanel::sheet_size_wanted);
  column->addWidget(sheet_size_);
  make_known(column);
  make_lines(column);
}

void PerspectivePanel::make_groups(QBoxLayout* column, const std::function<QAction*(const QString&)>& action) {
  auto* grid = new QGridLayout;
  grid->setSpacing(3);
  const std::array<const char*, 8> names{"group-x",        "group-y",        "group-z",        "group-auto",
                                         "group-normal-x", "group-normal-y", "group-normal-z", "construction"};
  for (int i = 0; i < 8; ++i) {
    auto* button = new QToolButton(this);
    button->setDefaultAction(action(names[static_cast<std::size_t>(i)]));
    button->setObjectName(QString("button-") + names[static_cast<std::size_t>(i)]);
    button->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    button->setFocusPolicy(Qt::NoFocus);
    button->setMinimumWidth(number_box_width);
    button->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);
    grid->addWidget(button, i / 4, i % 4);
  }
  column->addLayout(grid);
}

void PerspectivePanel::make_camera(QBoxLayout* column) {
  camera_ = new QLabel(this);
  camera_->setObjectName("perspective-camera");
  camera_->setWordWrap(true);
  column->addWidget(camera_);
  deviation_ = new QProgressBar(this);
  deviation_->setObjectName("perspective-deviation");
  deviation_->setRange(0, 100);
  deviation_->setTextVisible(true);
  deviation_->setMaximumHeight(16);
  deviation_->setToolTip(tr("How far the focal length may be off: one standard deviation"));
  column->addWidget(deviation_);
  make_mode(column);
  auto* row = new QHBoxLayout;
  row->addWidget(new QLabel(tr("Field of view"), this));
  field_ = make_number_box(this, "perspective-field", {0, 170, 2});
  field_->setSpecialValueText(tr("not known"));
  field_->setSuffix(QStringLiteral("°"));
  connect(field_, &QDoubleSpinBox::valueChanged, this, [this](double degrees) {
    if (!following_) emit field_of_view_wanted(degrees > 0 ? std::optional(degrees * degree) : std::optional<double>());
  });
  row->addWidget(field_);
  column->addLayout(row);
  make_overlay(column);
}

/// What the operation is told of the camera.
void PerspectivePanel::make_mode(QBoxLayout* column) {
  auto* row = new QHBoxLayout;
  row->addWidget(new QLabel(tr("Vanishing points"), this));
  mode_ = new QComboBox(this);
  mode_->setObjectName("perspective-mode");
  mode_->addItem(tr("automatic"), "auto");
  for (const char* count : {"3", "2", "1"}) mode_->addItem(count, count);
  mode_->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
  mode_->setToolTip(tr("How many vanishing points aren't at infinity"));
  connect(mode_, &QComboBox::activated, this,
          [this] { emit parameter_wanted("mode", mode_->currentData().toString().toStdString()); });
  row->addWidget(mode_);
  column->addLayout(row);
  flip_ = new QCheckBox(tr("Turn x and y round"), this);
  flip_->setObjectName("perspective-flip");
  flip_->setToolTip(tr("Lets x and y point the other way: a drawing doesn't tell which"));
  connect(flip_, &QCheckBox::clicked, this, [this](bool on) { emit parameter_wanted("flip", on); });
  column->addWidget(flip_);
}

void PerspectivePanel::make_overlay(QBoxLayout* column) {
  auto* row = new QHBoxLayout;
  row->addWidget(new QLabel(tr("Drawing over the solid"), this));
  auto* overlay = new QSlider(Qt::Horizontal, this);
  overlay->setObjectName("perspective-overlay");
  overlay->setRange(0, 100);
  overlay->setValue(60);
  overlay->setToolTip(tr("How strongly the drawing is seen over the solid while you look through it"));
  connect(overlay, &QSlider::valueChanged, this, [this](int percent) { emit overlay_wanted(percent / 100.0); });
  row->addWidget(overlay);
  column->addLayout(row);
}

void PerspectivePanel::make_known(QBoxLayout* column) {
  auto* row = new QHBoxLayout;
  pick_ = new QPushButton(tr("Known point"), this);
  pick_->setObjectName("perspective-pick-point");
  pick_->setCheckable(true);
  pick_->setToolTip(tr("Click a corner of the drawing whose coordinates are known and type them (K)"));
  connect(pick_, &QPushButton::clicked, this,
          [this](bool on) { sheet_.pick(on ? SheetInteraction::Pick::Point : SheetInteraction::Pick::None); });
  row->addWidget(pick_, 1);
  forget_ = new QPushButton(QStringLiteral("✕"), this);
  forget_->setObjectName("perspective-forget-point");
  forget_->setToolTip(tr("No point is known"));
  forget_->setMaximumWidth(28);
  connect(forget_, &QPushButton::clicked, this, [this] { emit known_point_wanted(std::nullopt); });
  row->addWidget(forget_);
  column->addLayout(row);
  row = new QHBoxLayout;
  const std::array<const char*, 3> names{"perspective-point-x", "perspective-point-y", "perspective-point-z"};
  for (std::size_t i = 0; i < 3; ++i) {
    point_[i] = make_number_box(this, names[i], {-1e6, 1e6, 3});
    connect(point_[i], &QDoubleSpinBox::valueChanged, this, [this] { tell_point(); });
    row->addWidget(point_[i]);
  }
  column->addLayout(row);
  make_length(column);
}

void PerspectivePanel::make_length(QBoxLayout* column) {
  auto* second = new QHBoxLayout;
  length_of_ = new QLabel(this);
  second->addWidget(length_of_, 1);
  length_ = make_number_box(this, "perspective-length", {0, 1e9, 3});
  length_->setSpecialValueText(tr("not known"));
  connect(length_, &QDoubleSpinBox::valueChanged, this, [this](double length) {
    const std::vector<std::string> ids = sheet_.tool().selected();
    if (following_ || ids.size() != 1) return;
    emit known_length_wanted(ids.front(), length > 0 ? std::optional(length) : std::optional<double>());
  });
  second->addWidget(length_);
  column->addLayout(second);
  size_ = new QLabel(this);
  size_->setObjectName("perspective-size");
  size_->setWordWrap(true);
  size_->setTextInteractionFlags(Qt::TextSelectableByMouse);
  column->addWidget(size_);
  second = new QHBoxLayout;
  second->addWidget(new QLabel(tr("Unit of lengths"), this), 1);
  unit_ = new QComboBox(this);
  unit_->setObjectName("perspective-unit");
  unit_->addItem(tr("no unit"), "");
  for (const std::string& unit : length_units()) {
    const QString name = QString::fromStdString(unit);
    unit_->addItem(unit == "in" ? tr("inch") : name, name);
  }
  unit_->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
  unit_->setToolTip(tr("Of all lengths and coordinates; known ones keep their size when it changes"));
  connect(unit_, &QComboBox::activated, this,
          [this] { emit unit_wanted(unit_->currentData().toString().toStdString()); });
  second->addWidget(unit_);
  column->addLayout(second);
}

void PerspectivePanel::make_lines(QBoxLayout* column) {
  lines_ = new QTreeWidget(this);
  lines_->setObjectName("perspective-lines");
  lines_->setRootIsDecorated(false);
  lines_->setHeaderLabels({tr("Line"), tr("Along"), tr("Off by")});
  lines_->header()->setSectionResizeMode(QHeaderView::ResizeToContents);
  lines_->setMinimumHeight(90);
  connect(lines_, &QTreeWidget::itemClicked, this,
          [this](QTreeWidgetItem* item) { emit stroke_wanted(item->text(0).toStdString()); });
  column->addWidget(lines_, 1);
}

void PerspectivePanel::tell_point() {
  const auto& known = sheet_.drawing().known_point;
  if (following_ || !known) return;
  emit known_point_wanted(KnownPoint{known->at, {point_[0]->value(), point_[1]->value(), point_[2]->value()}});
}

void PerspectivePanel::follow() {
  following_ = true;
  follow_camera();
  sheet_size_->follow(sheet_.drawing().image_size);
  follow_mode();
  follow_known();
  follow_size();
  follow_lines();
  following_ = false;
}

void PerspectivePanel::follow_camera() {
  const PerspectiveResult* result = sheet_.result();
  deviation_->setVisible(result != nullptr);
  show_value(*field_, sheet_.drawing().field_of_view.value_or(0) / degree);
  if (result == nullptr) {
    camera_->setText(tr("No camera yet: draw two lines along each axis"));
    return;
  }
  const double field = 2 * std::atan(sheet_.drawing().image_size.x() / (2 * result->camera.focal_length)) / degree;
  camera_->setText(tr("%1-point perspective, field of view %2°").arg(result->mode).arg(field, 0, 'f', 1));
  const double share = result->focal_deviation / result->camera.focal_length;
  deviation_->setValue(static_cast<int>(std::clamp(100 * share / (2 * weak_deviation), 0.0, 100.0)));
  deviation_->setFormat(tr("camera certain within %1 %").arg(100 * share, 0, 'f', 1));
}

void PerspectivePanel::follow_known() {
  const PerspectiveDrawing& drawing = sheet_.drawing();
  pick_->setChecked(sheet_.picks() == SheetInteraction::Pick::Point);
  forget_->setEnabled(drawing.known_point.has_value());
  for (int i = 0; i < 3; ++i) {
    QDoubleSpinBox& box = *point_[static_cast<std::size_t>(i)];
    box.setEnabled(drawing.known_point.has_value());
    show_value(box, drawing.known_point ? drawing.known_point->point[i] : 0);
  }
  const std::vector<std::string> ids = sheet_.tool().selected();
  length_->setEnabled(ids.size() == 1);
  length_of_->setText(ids.size() == 1 ? tr("Length of %1").arg(QString::fromStdString(ids.front()))
                                      : tr("Length: select one stroke"));
  double length = 0;
  for (const KnownLength& known : drawing.known_lengths) {
    if (ids.size() == 1 && known.stroke == ids.front()) length = known.length;
  }
  show_value(*length_, length);
}

void PerspectivePanel::follow_mode() {
  const QString mode = QString::fromStdString(sheet_.parameter_text("mode"));
  mode_->setCurrentIndex(std::max(0, mode_->findData(mode)));
  flip_->setChecked(sheet_.parameter_flag("flip"));
}

/// The box about the solid's corners.
void PerspectivePanel::follow_size() {
  const QString unit = QString::fromStdString(sheet_.drawing().unit);
  unit_->setCurrentIndex(std::max(0, unit_->findData(unit)));
  const PerspectiveResult* result = sheet_.result();
  const BoundingBox box = result == nullptr ? BoundingBox() : bounds_of(result->network);
  size_->setVisible(box.has_value());
  if (!box) return;
  const Vec3 size = (*box)[1] - (*box)[0];
  const auto text = [&](int axis) { return number_words(size[axis]); };
  size_->setText(tr("Size %1 × %2 × %3 %4").arg(text(0), text(1), text(2), unit).trimmed());
}

void PerspectivePanel::follow_lines() {
  std::vector<PerspectiveStrokeResult> shown;
  if (const PerspectiveResult* result = sheet_.result()) {
    for (const PerspectiveStrokeResult& stroke : result->strokes) {
      if (stroke.residual) shown.push_back(stroke);
    }
  }
  std::ranges::sort(shown, [](const auto& a, const auto& b) { return *a.residual > *b.residual; });
  shown.resize(std::min(shown.size(), most_lines));
  lines_->clear();
  for (const PerspectiveStrokeResult& stroke : shown) {
    auto* item = new QTreeWidgetItem(lines_, {QString::fromStdString(stroke.id), group_letter(stroke.group),
                                              tr("%1 px").arg(*stroke.residual, 0, 'f', 1)});
    item->setForeground(1, group_color(stroke.group));
    const QColor heat = residual_color(*stroke.residual);
    item->setBackground(2, heat);
    item->setForeground(2, heat.lightness() > 120 ? QColor(20, 20, 22) : QColor(250, 249, 246));
  }
}

}  // namespace croquis::app
