// SPDX-License-Identifier: GPL-3.0-or-later
#include <QCheckBox>
#include <QComboBox>
#include <QGridLayout>
#include <QGroupBox>
#include <QLabel>
#include <algorithm>
#include <numbers>

#include "app/tools/surface/surface_drawing_tool.h"
#include "app/window/language.h"

namespace croquis::app {
namespace {

constexpr double farthest_point = 1e9;
constexpr double per_degree = std::numbers::pi / 180;

/// "Patch f1", "3 patches".
QString counted_ids(const std::vector<std::string>& ids, const QString& one, const QString& many) {
  return ids.size() == 1 ? one.arg(with_numbers(ids.front(), network_ids)) : many.arg(ids.size());
}

QString quality_number(double value) { return number_words(value, 3); }

/// The selected patches, else all.
std::vector<std::string> faces_meant(DrawnNetwork& network) {
  const NetworkElements selected = network.tool.selected();
  return selected.faces.empty() ? element_ids(network.network(), NetworkElement::Face) : selected.faces;
}

/// The first of some elements; null where there is none.
template <class Element>
const Element* first_of(const std::vector<Element>& elements, const DrawnNetwork& network, NetworkElement kind,
                        const std::vector<std::string>& ids) {
  const Index found = ids.empty() ? no_index : find_element(network.network(), kind, ids.front());
  return found == no_index ? nullptr : &elements[found];
}

const AttributeFace* first_face(DrawnNetwork& network) {
  return first_of(network.network().faces, network, NetworkElement::Face, faces_meant(network));
}

const PointAttribute* first_point(DrawnNetwork& network) {
  return first_of(network.network().points, network, NetworkElement::Point, network.tool.selected().points);
}

const AttributeCurve* first_curve(DrawnNetwork& network) {
  return first_of(network.network().curves, network, NetworkElement::Curve, network.tool.selected().curves);
}

/// The first selected curve, where it runs inside a patch.
const InnerCurve* first_inner(DrawnNetwork& network) {
  const AttributeCurve* curve = first_curve(network);
  for (const AttributeFace& face : network.network().faces) {
    const auto inner = std::ranges::find_if(
        face.inner, [&](const InnerCurve& one) { return &network.network().curves[one.curve] == curve; });
    if (inner != face.inner.end()) return &*inner;
  }
  return nullptr;
}

/// One for each patch along the selected curve; the middle handle stands for all.
std::vector<SlopeTip> slopes_of(DrawnNetwork& network) {
  std::vector<SlopeTip> sides;
  for (const SlopeTip& tip : slopes_of(network.tool)) {
    if (std::ranges::find(sides, tip.side, &SlopeTip::side) == sides.end()) sides.push_back(tip);
  }
  return sides;
}

template <class Value>
void set_faces(DrawnNetwork& network, std::optional<Value> FaceSetting::*member, const Value& value) {
  FaceSetting setting;
  setting.*member = value;
  const std::vector<std::string> faces = faces_meant(network);
  if (!faces.empty()) network.act(recorded::SurfaceFaceSetting{faces, setting, false});
}

template <class Value>
void set_points(DrawnNetwork& network, std::optional<Value> PointSetting::*member, const Value& value) {
  PointSetting setting;
  setting.*member = value;
  const std::vector<std::string> points = network.tool.selected().points;
  if (!points.empty()) network.act(recorded::SurfacePointSetting{points, setting});
}

/// The place of a choice in its list: what an element has, if it is there.
template <class Element, class Choice>
std::optional<int> choice_of(const Element* element, Choice Element::*member) {
  return element == nullptr ? std::nullopt : std::optional(static_cast<int>(element->*member));
}

/// A normal that is asked for begins as the surface's own.
void set_normal(DrawnNetwork& network, bool is_given, Vec3 normal) {
  const PointAttribute* point = first_point(network);
  if (point == nullptr) return;
  const SurfaceSight* sight = network.sight.get();
  if (!(normal.norm() > 0) && sight != nullptr) normal = sight->normal_at(point->id).value_or(Vec3::UnitY());
  if (!(normal.norm() > 0)) return;
  set_points(network, &PointSetting::normal, is_given ? std::optional(normal) : std::optional<Vec3>());
}

/// What is shown of the first selected point's normal.
Vec3 shown_normal(DrawnNetwork& network) {
  const PointAttribute* point = first_point(network);
  return point != nullptr && point->normal ? Vec3(point->normal->normalized()) : Vec3(Vec3::Zero());
}

/// A titled group of the panel; its fields are laid out in a grid.
QGridLayout* add_group(Panel& panel, std::function<QString()> title, std::function<bool()> is_there) {
  auto* group = new QGroupBox;
  auto* grid = new QGridLayout(group);
  grid->setContentsMargins(6, 4, 6, 4);
  grid->setVerticalSpacing(4);
  panel.column()->addWidget(group);
  panel.also([group, title = std::move(title), is_there = std::move(is_there)] {
    group->setTitle(title());
    group->setEnabled(is_there());
  });
  return grid;
}

void add_labelled(QGridLayout& grid, int row, QWidget* label, QWidget* field) {
  grid.addWidget(label, row, 0);
  grid.addWidget(field, row, 1);
}

void add_faces(Panel& panel, DrawnNetwork& network) {
  QGridLayout* grid = add_group(
      panel,
      [&network] {
        const std::vector<std::string> faces = network.tool.selected().faces;
        return faces.empty() ? Panel::tr("All patches")
                             : counted_ids(faces, Panel::tr("Patch %1"), Panel::tr("%1 patches"));
      },
      [&network] { return !faces_meant(network).empty(); });
  const auto read = [&network](auto member) {
    return [&network, member] { return choice_of(first_face(network), member); };
  };
  add_labelled(*grid, 0, panel.label(Panel::tr("Mode")),
               panel.choice(
                   "surface-mode", {Panel::tr("smooth"), Panel::tr("from positions"), Panel::tr("as in the paper")},
                   read(&AttributeFace::mode),
                   [&network](int index) { set_faces(network, &FaceSetting::mode, static_cast<AttributeMode>(index)); },
                   Panel::tr("How a patch is made from its curves: with common tangent planes at smooth curves, from "
                             "the curves' positions alone, or by the formulas of the paper")));
  QDoubleSpinBox* fullness = panel.number(
      "surface-fullness", {-1, 2, 2},
      [&network] {
        const AttributeFace* face = first_face(network);
        return face == nullptr ? Panel::Number() : Panel::Number{face->fullness};
      },
      [&network](double value) { set_faces(network, &FaceSetting::fullness, value); },
      Panel::tr("How far the middle follows the slopes of the sides: 0 flat, 1 full"));
  fullness->setSingleStep(0.1);
  add_labelled(*grid, 1, panel.label(Panel::tr("Fullness")), fullness);
  add_labelled(
      *grid, 2, panel.label(Panel::tr("Domain")),
      panel.choice(
          "surface-domain", {Panel::tr("by lengths"), Panel::tr("uniform")}, read(&AttributeFace::domain),
          [&network](int index) { set_faces(network, &FaceSetting::domain, static_cast<AttributeDomain>(index)); },
          Panel::tr("The plane polygon that a patch is a map of")));
}

/// How strongly a patch leaves the selected curve, of the first or second patch beside it.
void add_slope(Panel& panel, DrawnNetwork& network, QGridLayout& grid, std::size_t side) {
  QLabel* title = panel.label({});
  QDoubleSpinBox* magnitude = panel.number(
      QString("surface-slope-%1").arg(side), {0, 100, 2},
      [&network, side] {
        const std::vector<SlopeTip> sides = slopes_of(network);
        return side < sides.size() ? Panel::Number{sides[side].magnitude} : Panel::Number();
      },
      [&network, side](double value) {
        const std::vector<SlopeTip> sides = slopes_of(network);
        if (side >= sides.size()) return;
        SlopeHandle handle{sides[side].at, {}, value};
        if (sides[side].automatic) handle.normal = sides[side].frame.normal;
        network.act(recorded::SurfaceSlope{sides[side].side, handle});
      },
      Panel::tr("How strongly the patch leaves the curve"));
  magnitude->setSingleStep(0.1);
  panel.also([&network, side, title, magnitude] {
    const std::vector<SlopeTip> sides = slopes_of(network);
    const bool is_there = side < sides.size();
    title->setVisible(is_there);
    magnitude->setVisible(is_there);
    if (is_there) title->setText(Panel::tr("Slope of %1").arg(QString::fromStdString(sides[side].side.face)));
  });
  add_labelled(grid, 2 + static_cast<int>(side), title, magnitude);
}

void add_curves(Panel& panel, DrawnNetwork& network) {
  QGridLayout* grid = add_group(
      panel,
      [&network] {
        const std::vector<std::string> curves = network.tool.selected().curves;
        return curves.empty() ? Panel::tr("Curves")
                              : counted_ids(curves, Panel::tr("Curve %1"), Panel::tr("%1 curves"));
      },
      [&network] { return !network.tool.selected().curves.empty(); });
  add_labelled(*grid, 0, panel.label(Panel::tr("Join")),
               panel.choice(
                   "surface-join", {Panel::tr("crease"), Panel::tr("smooth")},
                   [&network] { return choice_of(first_curve(network), &AttributeCurve::join); },
                   [&network](int index) {
                     network.act(recorded::SurfaceJoin{network.tool.selected().curves, static_cast<CurveJoin>(index)});
                   },
                   Panel::tr("How the two patches beside a curve meet in it (S)")));
  add_labelled(*grid, 1, panel.label(Panel::tr("Inner curve")),
               panel.choice(
                   "surface-inner-profile", {Panel::tr("round"), Panel::tr("ridge")},
                   [&network] { return choice_of(first_inner(network), &InnerCurve::profile); },
                   [&network](int index) {
                     InnerSetting setting;
                     setting.profile = static_cast<InnerProfile>(index);
                     for (const std::string& curve : network.tool.selected().curves)
                       network.act(recorded::SurfaceInner{curve, {}, false, setting});
                   },
                   Panel::tr("What the patch does along a curve inside it")));
  for (std::size_t side = 0; side < 2; ++side) add_slope(panel, network, *grid, side);
}

/// Place and normal of the first selected point.
void add_coordinates(Panel& panel, DrawnNetwork& network, QGridLayout& grid) {
  grid.addWidget(panel.label(Panel::tr("Place")), 0, 0);
  for (int axis = 0; axis < 3; ++axis) {
    const QChar letter('x' + axis);
    grid.addWidget(panel.number(
                       QString("surface-point-") + letter, {-farthest_point, farthest_point, 4},
                       [&network, axis] {
                         const PointAttribute* point = first_point(network);
                         return Panel::Number{point == nullptr ? 0 : point->point[axis],
                                              network.tool.selected().points.size() == 1};
                       },
                       // The other coordinates stay exactly as they are.
                       [&network, axis](double value) {
                         const PointAttribute* point = first_point(network);
                         if (point == nullptr || network.tool.selected().points.size() != 1) return;
                         Vec3 place = point->point;
                         place[axis] = value;
                         set_points(network, &PointSetting::point, place);
                       }),
                   0, axis + 1);
    grid.addWidget(panel.number(
                       QString("surface-normal-") + letter, {-1, 1, 3},
                       [&network, axis] {
                         const PointAttribute* point = first_point(network);
                         return Panel::Number{shown_normal(network)[axis], point != nullptr && point->normal};
                       },
                       [&network, axis](double value) {
                         Vec3 normal = shown_normal(network);
                         normal[axis] = value;
                         set_normal(network, true, normal);
                       }),
                   2, axis + 1);
  }
}

void add_points(Panel& panel, DrawnNetwork& network) {
  QGridLayout* grid = add_group(
      panel,
      [&network] {
        const std::vector<std::string> points = network.tool.selected().points;
        return points.empty() ? Panel::tr("Points")
                              : counted_ids(points, Panel::tr("Point %1"), Panel::tr("%1 points"));
      },
      [&network] { return first_point(network) != nullptr; });
  add_coordinates(panel, network, *grid);
  QDoubleSpinBox* radius = panel.number(
      "surface-radius", {0, farthest_point, 4},
      [&network] {
        const PointAttribute* point = first_point(network);
        return Panel::Number{point == nullptr ? 0 : point->radius.value_or(0)};
      },
      [&network](double value) {
        set_points(network, &PointSetting::radius, value > 0 ? std::optional(value) : std::optional<double>());
      },
      Panel::tr("How far the point pulls: about where the surface is moved half as far as the point"));
  radius->setSpecialValueText(Panel::tr("automatic"));
  add_labelled(*grid, 1, panel.label(Panel::tr("Radius")), radius);
  grid->addWidget(
      panel.choice(
          "surface-profile", {Panel::tr("round"), Panel::tr("tip")},
          [&network] { return choice_of(first_point(network), &PointAttribute::profile).value_or(0); },
          [&network](int index) { set_points(network, &PointSetting::profile, static_cast<PointProfile>(index)); }),
      1, 2, 1, 2);
  grid->addWidget(panel.flag(
                      "surface-has-normal", Panel::tr("Normal"),
                      [&network] {
                        const PointAttribute* point = first_point(network);
                        return point != nullptr && point->normal.has_value();
                      },
                      [&network](bool on) { set_normal(network, on, shown_normal(network)); },
                      Panel::tr("The surface's direction at the point is given")),
                  2, 0);
}

/// How far the surfaces miss what they are made from.
QString quality_text(const DrawnNetwork& network) {
  const ShownSurface& shown = network.shown;
  if (!shown) return {};
  const SurfaceMeasures& measures = shown.found->measures;
  double points = 0;
  for (const auto& error : measures.point_errors) points = std::max(points, error.value_or(0));
  const QString units = QString::fromStdString(network.network().units);
  const auto length = [&](double value) { return (quality_number(value) + " " + units).trimmed(); };
  QStringList lines;
  lines << Panel::tr("Curves are met within %1").arg(length(measures.boundary_error));
  if (!measures.point_errors.empty()) lines << Panel::tr("Points are met within %1").arg(length(points));
  const bool any_smooth = std::ranges::any_of(measures.normal_jumps, [](const auto& jump) { return jump.has_value(); });
  if (any_smooth) {
    lines << Panel::tr("Largest angle along smooth curves: %1°")
                 .arg(quality_number(measures.largest_normal_jump / per_degree));
  }
  lines << Panel::tr("Tolerance of ends: %1").arg(length(shown.surface().tolerance));
  return lines.join('\n');
}

}  // namespace

Panel* make_surface_panel(DrawnNetwork& network) {
  auto* panel = new Panel("surface-panel");
  panel->buttons({"fill-loop", "split-element", "merge-patches", "turn-patches", "mirror-network", "symmetric-edit"}, 3,
                 Qt::ToolButtonTextOnly, [&network](const QString& name) { return network.host.action(name); });
  add_faces(*panel, network);
  add_curves(*panel, network);
  add_points(*panel, network);
  QLabel* quality = panel->text("surface-quality", [&network] { return quality_text(network); });
  quality->setTextInteractionFlags(Qt::TextSelectableByMouse);
  panel->column()->addWidget(quality);
  panel->column()->addStretch(1);
  return panel;
}

}  // namespace croquis::app
