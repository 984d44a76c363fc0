// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/tools/surface/surface_panel.h"

#include <QAction>
#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QGridLayout>
#include <QGroupBox>
#include <QLabel>
#include <QToolButton>
#include <algorithm>
#include <numbers>

#include "app/panels/number_box.h"

namespace croquis::app {
namespace {

constexpr double farthest = 1e9;
constexpr double per_degree = std::numbers::pi / 180;

/// What people type there isn't overwritten.
void put_number(QDoubleSpinBox& box, double value) {
  if (!box.hasFocus() || box.value() != value) box.setValue(value);
}

QComboBox* add_choice(QWidget* parent, const QString& name, const QStringList& texts) {
  auto* box = new QComboBox(parent);
  box->setObjectName(name);
  box->addItems(texts);
  box->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
  return box;
}

QGroupBox* add_group(QBoxLayout* column, const QString& title, QGridLayout*& grid) {
  auto* group = new QGroupBox(title);
  grid = new QGridLayout(group);
  grid->setContentsMargins(6, 4, 6, 4);
  grid->setVerticalSpacing(4);
  column->addWidget(group);
  return group;
}

/// "Patch f1", "3 patches".
QString counted_ids(const std::vector<std::string>& ids, const QString& one, const QString& many) {
  return ids.size() == 1 ? one.arg(QString::fromStdString(ids.front())) : many.arg(ids.size());
}

QString quality_number(double value) { return number_words(value, 3); }

}  // namespace

SurfacePanel::SurfacePanel(NetworkInteraction& network, const std::function<QAction*(const QString&)>& action)
    : network_(network) {
  setObjectName("surface-panel");
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(8, 6, 8, 6);
  make_buttons(column, action);
  make_faces(column);
  make_curves(column);
  make_points(column);
  quality_ = new QLabel(this);
  quality_->setObjectName("surface-quality");
  quality_->setWordWrap(true);
  quality_->setTextInteractionFlags(Qt::TextSelectableByMouse);
  column->addWidget(quality_);
  column->addStretch(1);
}

void SurfacePanel::make_buttons(QBoxLayout* column, const std::function<QAction*(const QString&)>& action) {
  auto* grid = new QGridLayout;
  grid->setSpacing(3);
  const std::array<const char*, 6> names{"fill-loop",    "split-element",  "merge-patches",
                                         "turn-patches", "mirror-network", "symmetric-edit"};
  for (int i = 0; i < static_cast<int>(names.size()); ++i) {
    auto* button = new QToolButton(this);
    button->setDefaultAction(action(names[static_cast<std::size_t>(i)]));
    button->setObjectName(QString("button-") + names[static_cast<std::size_t>(i)]);
    button->setToolButtonStyle(Qt::ToolButtonTextOnly);
    button->setFocusPolicy(Qt::NoFocus);
    button->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);
    grid->addWidget(button, i / 3, i % 3);
  }
  column->addLayout(grid);
}

void SurfacePanel::make_faces(QBoxLayout* column) {
  QGridLayout* grid = nullptr;
  faces_ = add_group(column, tr("Patches"), grid);
  mode_ = add_choice(this, "surface-mode", {tr("smooth"), tr("from positions"), tr("as in the paper")});
  mode_->setToolTip(
      tr("How a patch is made from its curves: with common tangent planes at smooth curves, from the "
         "curves' positions alone, or by the formulas of the paper"));
  connect(mode_, &QComboBox::activated, this, [this](int index) {
    FaceSetting setting;
    setting.mode = static_cast<AttributeMode>(index);
    set_faces(setting);
  });
  grid->addWidget(new QLabel(tr("Mode"), this), 0, 0);
  grid->addWidget(mode_, 0, 1);
  fullness_ = make_number_box(this, "surface-fullness", {-1, 2, 2});
  fullness_->setSingleStep(0.1);
  fullness_->setToolTip(tr("How far the middle follows the slopes of the sides: 0 flat, 1 full"));
  connect(fullness_, &QDoubleSpinBox::valueChanged, this, [this](double value) {
    FaceSetting setting;
    setting.fullness = value;
    set_faces(setting);
  });
  grid->addWidget(new QLabel(tr("Fullness"), this), 1, 0);
  grid->addWidget(fullness_, 1, 1);
  domain_ = add_choice(this, "surface-domain", {tr("by the curves' lengths"), tr("uniform")});
  domain_->setToolTip(tr("The plane polygon that a patch is a map of"));
  connect(domain_, &QComboBox::activated, this, [this](int index) {
    FaceSetting setting;
    setting.domain = static_cast<AttributeDomain>(index);
    set_faces(setting);
  });
  grid->addWidget(new QLabel(tr("Domain"), this), 2, 0);
  grid->addWidget(domain_, 2, 1);
}

void SurfacePanel::make_curves(QBoxLayout* column) {
  QGridLayout* grid = nullptr;
  curves_ = add_group(column, tr("Curves"), grid);
  join_ = add_choice(this, "surface-join", {tr("crease"), tr("smooth")});
  join_->setToolTip(tr("How the two patches beside a curve meet in it (S)"));
  connect(join_, &QComboBox::activated, this, [this](int index) {
    network_.act(
        [&](SurfaceTool& tool) { return tool.set_join(tool.selected().curves, static_cast<CurveJoin>(index)); });
  });
  grid->addWidget(new QLabel(tr("Join"), this), 0, 0);
  grid->addWidget(join_, 0, 1);
  profile_ = add_choice(this, "surface-inner-profile", {tr("round"), tr("ridge")});
  profile_->setToolTip(tr("What the patch does along a curve inside it"));
  connect(profile_, &QComboBox::activated, this, [this](int index) {
    InnerSetting setting;
    setting.profile = static_cast<InnerProfile>(index);
    for (const std::string& curve : network_.tool().selected().curves)
      network_.act([&](SurfaceTool& tool) { return tool.set_inner(curve, setting); });
  });
  grid->addWidget(new QLabel(tr("Inner curve"), this), 1, 0);
  grid->addWidget(profile_, 1, 1);
  for (std::size_t i = 0; i < slopes_.size(); ++i) {
    SlopeRow& slope = slopes_[i];
    slope.title = new QLabel(this);
    slope.magnitude = make_number_box(this, QString("surface-slope-%1").arg(i), {0, 100, 2});
    slope.magnitude->setSingleStep(0.1);
    slope.magnitude->setToolTip(tr("How strongly the patch leaves the curve"));
    connect(slope.magnitude, &QDoubleSpinBox::valueChanged, this, [this, &slope](double value) {
      if (following_) return;
      SlopeHandle handle{slope.shown.at, {}, value};
      if (slope.shown.automatic) handle.normal = slope.shown.frame.normal;
      network_.act([&](SurfaceTool& tool) { return tool.set_slope(slope.shown.side, handle); });
    });
    grid->addWidget(slope.title, 2 + static_cast<int>(i), 0);
    grid->addWidget(slope.magnitude, 2 + static_cast<int>(i), 1);
  }
}

void SurfacePanel::make_points(QBoxLayout* column) {
  QGridLayout* grid = nullptr;
  points_ = add_group(column, tr("Points"), grid);
  const std::array<const char*, 3> axes{"x", "y", "z"};
  for (std::size_t i = 0; i < 3; ++i) {
    place_[i] = make_number_box(this, QString("surface-point-") + axes[i], {-farthest, farthest, 4});
    connect(place_[i], &QDoubleSpinBox::valueChanged, this, [this, i](double value) { tell_point(i, value); });
    grid->addWidget(place_[i], 0, static_cast<int>(i) + 1);
    normal_[i] = make_number_box(this, QString("surface-normal-") + axes[i], {-1, 1, 3});
    connect(normal_[i], &QDoubleSpinBox::valueChanged, this, [this] { tell_normal(); });
    grid->addWidget(normal_[i], 2, static_cast<int>(i) + 1);
  }
  grid->addWidget(new QLabel(tr("Place"), this), 0, 0);
  radius_ = make_number_box(this, "surface-radius", {0, farthest, 4});
  radius_->setSpecialValueText(tr("automatic"));
  radius_->setToolTip(tr("How far the point pulls: about where the surface is moved half as far as the point"));
  connect(radius_, &QDoubleSpinBox::valueChanged, this, [this](double value) {
    PointSetting setting;
    setting.radius = value > 0 ? std::optional(value) : std::optional<double>();
    set_points(setting);
  });
  grid->addWidget(new QLabel(tr("Radius"), this), 1, 0);
  grid->addWidget(radius_, 1, 1);
  tip_ = add_choice(this, "surface-profile", {tr("round"), tr("tip")});
  connect(tip_, &QComboBox::activated, this, [this](int index) {
    PointSetting setting;
    setting.profile = static_cast<PointProfile>(index);
    set_points(setting);
  });
  grid->addWidget(tip_, 1, 2, 1, 2);
  has_normal_ = new QCheckBox(tr("Normal"), this);
  has_normal_->setObjectName("surface-has-normal");
  has_normal_->setToolTip(tr("The surface's direction at the point is given"));
  connect(has_normal_, &QCheckBox::clicked, this, [this] { tell_normal(); });
  grid->addWidget(has_normal_, 2, 0);
}

// ---- What people say

/// The selected patches, else all.
std::vector<std::string> SurfacePanel::faces_meant() const {
  const NetworkElements selected = network_.tool().selected();
  return selected.faces.empty() ? element_ids(network_.network(), NetworkElement::Face) : selected.faces;
}

void SurfacePanel::set_faces(const FaceSetting& setting) {
  const std::vector<std::string> faces = faces_meant();
  if (following_ || faces.empty()) return;
  network_.act([&](SurfaceTool& tool) { return tool.set_faces(faces, setting); });
}

void SurfacePanel::set_points(const PointSetting& setting) {
  const std::vector<std::string> points = network_.tool().selected().points;
  if (following_ || points.empty()) return;
  network_.act([&](SurfaceTool& tool) { return tool.set_points(points, setting); });
}

/// The other coordinates stay exactly as they are.
void SurfacePanel::tell_point(std::size_t axis, double value) {
  const PointAttribute* point = first_point();
  if (point == nullptr || network_.tool().selected().points.size() != 1) return;
  PointSetting setting;
  setting.point = point->point;
  (*setting.point)[static_cast<Eigen::Index>(axis)] = value;
  set_points(setting);
}

/// A normal that is asked for begins as the surface's own.
void SurfacePanel::tell_normal() {
  const PointAttribute* point = first_point();
  if (following_ || point == nullptr) return;
  Vec3 normal(normal_[0]->value(), normal_[1]->value(), normal_[2]->value());
  const SurfaceSight* sight = network_.sight();
  if (!(normal.norm() > 0) && sight != nullptr) normal = sight->normal_at(point->id).value_or(Vec3::UnitY());
  if (!(normal.norm() > 0)) return;
  PointSetting setting;
  setting.normal = has_normal_->isChecked() ? std::optional(normal) : std::optional<Vec3>();
  set_points(setting);
}

// ---- What is shown

const PointAttribute* SurfacePanel::first_point() const {
  const NetworkElements selected = network_.tool().selected();
  const Index point = selected.points.empty()
                          ? no_index
                          : find_element(network_.network(), NetworkElement::Point, selected.points.front());
  return point == no_index ? nullptr : &network_.network().points[point];
}

const InnerCurve* SurfacePanel::first_inner(const NetworkElements& selected) const {
  const Index curve = selected.curves.empty()
                          ? no_index
                          : find_element(network_.network(), NetworkElement::Curve, selected.curves.front());
  for (const AttributeFace& face : network_.network().faces) {
    const auto inner = std::ranges::find(face.inner, curve, &InnerCurve::curve);
    if (inner != face.inner.end()) return &*inner;
  }
  return nullptr;
}

void SurfacePanel::follow() {
  following_ = true;
  const NetworkElements selected = network_.tool().selected();
  follow_faces(selected);
  follow_curves(selected);
  follow_points(selected);
  quality_->setText(quality_text());
  following_ = false;
}

void SurfacePanel::follow_faces(const NetworkElements& selected) {
  const std::vector<std::string> meant = faces_meant();
  faces_->setEnabled(!meant.empty());
  faces_->setTitle(selected.faces.empty() ? tr("All patches")
                                          : counted_ids(selected.faces, tr("Patch %1"), tr("%1 patches")));
  if (meant.empty()) return;
  const AttributeFace& face =
      network_.network().faces[find_element(network_.network(), NetworkElement::Face, meant.front())];
  mode_->setCurrentIndex(static_cast<int>(face.mode));
  domain_->setCurrentIndex(static_cast<int>(face.domain));
  put_number(*fullness_, face.fullness);
}

void SurfacePanel::follow_curves(const NetworkElements& selected) {
  const InnerCurve* inner = first_inner(selected);
  curves_->setEnabled(!selected.curves.empty());
  curves_->setTitle(selected.curves.empty() ? tr("Curves")
                                            : counted_ids(selected.curves, tr("Curve %1"), tr("%1 curves")));
  profile_->setEnabled(inner != nullptr);
  if (inner != nullptr) profile_->setCurrentIndex(static_cast<int>(inner->profile));
  if (!selected.curves.empty()) {
    const Index curve = find_element(network_.network(), NetworkElement::Curve, selected.curves.front());
    if (curve != no_index) join_->setCurrentIndex(static_cast<int>(network_.network().curves[curve].join));
  }
  follow_slopes();
}

/// One for each patch along the curve; the middle handle tells of all.
void SurfacePanel::follow_slopes() {
  std::vector<SlopeTip> sides;
  for (const SlopeTip& tip : network_.tool().slopes()) {
    const auto known = std::ranges::find(sides, tip.side, &SlopeTip::side);
    if (known == sides.end()) sides.push_back(tip);
  }
  for (std::size_t i = 0; i < slopes_.size(); ++i) {
    SlopeRow& slope = slopes_[i];
    slope.title->setVisible(i < sides.size());
    slope.magnitude->setVisible(i < sides.size());
    if (i >= sides.size()) continue;
    slope.shown = sides[i];
    slope.title->setText(tr("Slope of %1").arg(QString::fromStdString(sides[i].side.face)));
    put_number(*slope.magnitude, sides[i].magnitude);
  }
}

void SurfacePanel::follow_points(const NetworkElements& selected) {
  const PointAttribute* point = first_point();
  points_->setEnabled(point != nullptr);
  points_->setTitle(selected.points.empty() ? tr("Points")
                                            : counted_ids(selected.points, tr("Point %1"), tr("%1 points")));
  for (std::size_t i = 0; i < 3; ++i) {
    const auto axis = static_cast<Eigen::Index>(i);
    place_[i]->setEnabled(selected.points.size() == 1);
    put_number(*place_[i], point == nullptr ? 0 : point->point[axis]);
    normal_[i]->setEnabled(point != nullptr && point->normal.has_value());
    put_number(*normal_[i], point != nullptr && point->normal ? point->normal->normalized()[axis] : 0);
  }
  put_number(*radius_, point == nullptr ? 0 : point->radius.value_or(0));
  tip_->setCurrentIndex(point == nullptr ? 0 : static_cast<int>(point->profile));
  has_normal_->setChecked(point != nullptr && point->normal.has_value());
}

/// How far the surfaces miss what they are made from.
QString SurfacePanel::quality_text() const {
  const ShownSurface& shown = network_.shown();
  if (!shown) return {};
  const SurfaceMeasures& measures = shown.found->measures;
  double points = 0;
  for (const auto& error : measures.point_errors) points = std::max(points, error.value_or(0));
  const QString units = QString::fromStdString(network_.network().units);
  const auto length = [&](double value) { return (quality_number(value) + " " + units).trimmed(); };
  QStringList lines;
  lines << tr("Curves are met within %1").arg(length(measures.boundary_error));
  if (!measures.point_errors.empty()) lines << tr("Points are met within %1").arg(length(points));
  const bool any_smooth = std::ranges::any_of(measures.normal_jumps, [](const auto& jump) { return jump.has_value(); });
  if (any_smooth)
    lines
        << tr("Largest angle along smooth curves: %1°").arg(quality_number(measures.largest_normal_jump / per_degree));
  lines << tr("Tolerance of ends: %1").arg(length(shown.surface().tolerance));
  return lines.join('\n');
}

}  // namespace croquis::app
