// SPDX-License-Identifier: GPL-3.0-or-later
#include <QCheckBox>
#include <QComboBox>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <QSlider>
#include <QToolButton>
#include <QTreeWidget>
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "app/tools/perspective/sheet.h"
#include "app/window/language.h"
#include "app/window/theme.h"
#include "croquis/tools/perspective/sheet_units.h"
#include "croquis/tools/recording/general_steps.h"

namespace croquis::app {
namespace {

struct SheetShape {
  const char* name;
  double aspect;  ///< width / height
};

constexpr std::array<SheetShape, 5> sheet_shapes{{{"4:3", 4.0 / 3},
                                                  {"3:2", 3.0 / 2},
                                                  {"16:9", 16.0 / 9},
                                                  {QT_TR_NOOP("A4 landscape"), std::numbers::sqrt2},
                                                  {QT_TR_NOOP("A4 portrait"), 1 / std::numbers::sqrt2}}};
constexpr double longest_sheet = 100'000;  // px

constexpr double degree = std::numbers::pi / 180;
constexpr double weak_deviation = 0.15;  // of the focal length: as VP_WEAK
constexpr std::size_t most_lines = 60;

/// 0 as a number says that nothing is known.
std::optional<double> known_number(double value) { return value > 0 ? std::optional(value) : std::nullopt; }

/// The value of a parameter of the operation that the drawing goes to; none where it has none of its own.
template <typename T>
std::optional<T> sheet_parameter(const Sheet& sheet, const std::string& name) {
  const Node* operation = sheet.host.studio().session().document().find(sheet.tool.operation_node());
  if (operation == nullptr || !operation->parameters.contains(name)) return std::nullopt;
  const T* value = std::get_if<T>(&operation->parameters.at(name));
  return value == nullptr ? std::nullopt : std::optional(*value);
}

/// One undo step, recorded.
void set_sheet_parameter(Sheet& sheet, const std::string& name, const ParameterValue& value) {
  const NodeId node = sheet.tool.operation_node();
  if (node == 0) return;
  sheet.host.studio().set_parameter(node, name, value, false);
  const Node* edited = sheet.host.studio().session().document().find(node);
  if (edited != nullptr) sheet.host.record(recorded::Set{edited->name, name, value});
}

QString camera_words(const Sheet& sheet) {
  const PerspectiveResult* result = sheet.result();
  if (result == nullptr) return Panel::tr("No camera yet: draw two lines along each axis");
  const double field = 2 * std::atan(sheet.drawing().image_size.x() / (2 * result->camera.focal_length)) / degree;
  return Panel::tr("%1-point perspective, field of view %2°").arg(result->mode).arg(field, 0, 'f', 1);
}

/// The box about the solid's corners.
QString size_words(const Sheet& sheet) {
  const PerspectiveResult* result = sheet.result();
  const BoundingBox box = result == nullptr ? BoundingBox() : bounds_of(result->network);
  if (!box) return {};
  const Vec3 size = (*box)[1] - (*box)[0];
  const auto text = [&](int axis) { return number_words(size[axis]); };
  const QString unit = QString::fromStdString(sheet.drawing().unit);
  return Panel::tr("Size %1 × %2 × %3 %4").arg(text(0), text(1), text(2), unit).trimmed();
}

QProgressBar* make_deviation(Panel& panel, const Sheet& sheet) {
  auto* bar = new QProgressBar(&panel);
  bar->setObjectName("perspective-deviation");
  bar->setRange(0, 100);
  bar->setTextVisible(true);
  bar->setMaximumHeight(16);
  bar->setToolTip(Panel::tr("How far the focal length may be off: one standard deviation"));
  panel.also([bar, &sheet] {
    const PerspectiveResult* result = sheet.result();
    bar->setVisible(result != nullptr);
    if (result == nullptr) return;
    const double share = result->focal_deviation / result->camera.focal_length;
    bar->setValue(static_cast<int>(std::clamp(100 * share / (2 * weak_deviation), 0.0, 100.0)));
    bar->setFormat(Panel::tr("camera certain within %1 %").arg(100 * share, 0, 'f', 1));
  });
  return bar;
}

void add_camera(Panel& panel, Sheet& sheet) {
  panel.column()->addWidget(panel.text("perspective-camera", [&sheet] { return camera_words(sheet); }));
  panel.column()->addWidget(make_deviation(panel, sheet));
  panel.row({panel.label(Panel::tr("Vanishing points")),
             panel.choice_of_values(
                 "perspective-mode", {{Panel::tr("automatic"), "auto"}, {"3", "3"}, {"2", "2"}, {"1", "1"}},
                 [&sheet] { return sheet_parameter<std::string>(sheet, "mode").value_or("auto"); },
                 [&sheet](const std::string& mode) { set_sheet_parameter(sheet, "mode", mode); },
                 Panel::tr("How many vanishing points aren't at infinity"))});
  panel.column()->addWidget(panel.flag(
      "perspective-flip", Panel::tr("Turn x and y round"),
      [&sheet] { return sheet_parameter<bool>(sheet, "flip").value_or(false); },
      [&sheet](bool on) { set_sheet_parameter(sheet, "flip", on); },
      Panel::tr("Lets x and y point the other way: a drawing doesn't show which")));
  QDoubleSpinBox* field = panel.number(
      "perspective-field", {0, 170, 2},
      [&sheet] { return Panel::Number{sheet.drawing().field_of_view.value_or(0) / degree}; },
      [&sheet](double degrees) {
        sheet.take(recorded::SheetCamera{known_number(degrees * degree), sheet.drawing().principal_point});
      });
  field->setSpecialValueText(Panel::tr("not known"));
  field->setSuffix(QStringLiteral("°"));
  panel.row({panel.label(Panel::tr("Field of view")), field});
  QSlider* overlay = panel.slider(
      "perspective-overlay", 0, 100, [&sheet] { return static_cast<int>(std::lround(100 * sheet.overlay)); },
      [&sheet](int percent, bool) {
        sheet.overlay = percent / 100.0;
        emit sheet.owner.changed(PerspectiveView);
      },
      Panel::tr("How strongly the drawing is seen over the solid while you look through it"));
  panel.row({panel.label(Panel::tr("Drawing over the solid")), overlay});
}

/// Width and height of the sheet, or one of the usual shapes.
void add_sheet(Panel& panel, Sheet& sheet) {
  QStringList words{Panel::tr("Other")};
  for (const SheetShape& shape : sheet_shapes) words << Panel::tr(shape.name);
  const auto shape_of = [&sheet] {
    const Vec2 size = sheet.drawing().image_size;
    // Sides are whole pixels: the shape is right up to one of them.
    const auto fits = [&](const SheetShape& shape) { return std::abs(size.x() - shape.aspect * size.y()) <= 1; };
    const auto found = std::ranges::find_if(sheet_shapes, fits);
    return found == sheet_shapes.end() ? 0 : 1 + static_cast<int>(found - sheet_shapes.begin());
  };
  const auto take_shape = [&sheet](int index) {
    if (index < 1) return;
    const double aspect = sheet_shapes[static_cast<std::size_t>(index - 1)].aspect;
    const double longer = sheet.drawing().image_size.maxCoeff();
    sheet.take(recorded::SheetSize{aspect > 1 ? Vec2(longer, std::round(longer / aspect))
                                              : Vec2(std::round(longer * aspect), longer)});
  };
  const auto side = [&](const char* name, int axis) {
    return panel.number(
        name, {1, longest_sheet, 0}, [&sheet, axis] { return Panel::Number{sheet.drawing().image_size[axis]}; },
        [&sheet, axis](double length) {
          Vec2 size = sheet.drawing().image_size;
          size[axis] = length;
          sheet.take(recorded::SheetSize{size});
        });
  };
  QComboBox* shape =
      panel.choice("sheet-shape", words, shape_of, take_shape,
                   Panel::tr("The shape of the sheet; its longer side stays as it is. Strokes keep their places"));
  panel.row({panel.label(Panel::tr("Sheet")), {shape, 1}, side("sheet-width", 0), side("sheet-height", 1)});
}

void add_known_point(Panel& panel, Sheet& sheet) {
  QPushButton* pick = panel.button(
      "perspective-pick-point", Panel::tr("Known point"),
      Panel::tr("Click a corner of the drawing whose coordinates are known and type them (K)"),
      [&sheet] { app::pick(sheet, sheet.picks == SheetPick::Point ? SheetPick::None : SheetPick::Point); });
  pick->setCheckable(true);
  auto* forget = new QToolButton(&panel);
  forget->setText(QStringLiteral("✕"));
  forget->setObjectName("perspective-forget-point");
  forget->setToolTip(Panel::tr("No point is known"));
  forget->setAccessibleName(forget->toolTip());
  QObject::connect(forget, &QToolButton::clicked, &panel, [&sheet] { sheet.take(recorded::SheetPoint{}); });
  panel.row({{pick, 1}, forget});
  panel.also([&sheet, pick, forget] {
    pick->setChecked(sheet.picks == SheetPick::Point);
    forget->setEnabled(sheet.drawing().known_point.has_value());
  });
  const auto coordinate = [&](const char* name, int axis) {
    return panel.number(
        name, {-1e6, 1e6, 3},
        [&sheet, axis] {
          const auto& known = sheet.drawing().known_point;
          return Panel::Number{known ? known->point[axis] : 0, known.has_value()};
        },
        [&sheet, axis](double value) {
          std::optional<KnownPoint> known = sheet.drawing().known_point;
          if (!known) return;
          known->point[axis] = value;
          sheet.take(recorded::SheetPoint{known});
        });
  };
  panel.row({coordinate("perspective-point-x", 0), coordinate("perspective-point-y", 1),
             coordinate("perspective-point-z", 2)});
}

void add_known_length(Panel& panel, Sheet& sheet) {
  QLabel* title = panel.label({});
  panel.also([&sheet, title] {
    const std::vector<std::string> ids = sheet.tool.selected();
    title->setText(ids.size() == 1 ? Panel::tr("Length of %1").arg(QString::fromStdString(ids.front()))
                                   : Panel::tr("Length: select one stroke"));
  });
  QDoubleSpinBox* length = panel.number(
      "perspective-length", {0, 1e9, 3},
      [&sheet] {
        const std::vector<std::string> ids = sheet.tool.selected();
        Panel::Number shown{0, ids.size() == 1};
        for (const KnownLength& known : sheet.drawing().known_lengths) {
          if (shown.enabled && known.stroke == ids.front()) shown.value = known.length;
        }
        return shown;
      },
      [&sheet](double value) {
        const std::vector<std::string> ids = sheet.tool.selected();
        if (ids.size() == 1) sheet.take(recorded::SheetLength{ids.front(), known_number(value)});
      });
  length->setSpecialValueText(Panel::tr("not known"));
  panel.row({{title, 1}, length});
  QLabel* size = panel.text("perspective-size", [&sheet] { return size_words(sheet); });
  size->setTextInteractionFlags(Qt::TextSelectableByMouse);
  panel.column()->addWidget(size);
  std::vector<Panel::Choice> units{{Panel::tr("no unit"), ""}};
  for (const std::string& unit : length_units()) {
    const QString name = QString::fromStdString(unit);
    units.push_back({unit == "in" ? Panel::tr("inch") : name, name});
  }
  panel.row({{panel.label(Panel::tr("Unit of lengths")), 1},
             panel.choice_of_values(
                 "perspective-unit", units, [&sheet] { return sheet.drawing().unit; },
                 [&sheet](const std::string& unit) { sheet.take(recorded::SheetUnit{unit}); },
                 Panel::tr("Of all lengths and coordinates; known ones keep their size when it changes"))});
}

/// The lines that miss their vanishing point most.
void show_lines(QTreeWidget& list, const PerspectiveResult* result) {
  std::vector<PerspectiveStrokeResult> shown;
  if (result != nullptr) {
    std::ranges::copy_if(result->strokes, std::back_inserter(shown),
                         [](const PerspectiveStrokeResult& stroke) { return stroke.residual.has_value(); });
  }
  std::ranges::sort(shown, [](const auto& a, const auto& b) { return *a.residual > *b.residual; });
  shown.resize(std::min(shown.size(), most_lines));
  list.clear();
  for (const PerspectiveStrokeResult& stroke : shown) {
    auto* item = new QTreeWidgetItem(&list, {with_numbers(stroke.id, stroke_ids), group_letter(stroke.group),
                                             Panel::tr("%1 px").arg(*stroke.residual, 0, 'f', 1)});
    for (const auto& [column, ground] :
         {std::pair{1, group_color(stroke.group)}, {2, residual_color(*stroke.residual)}}) {
      item->setBackground(column, ground);
      item->setForeground(column, text_color_on(ground));
    }
  }
}

void add_lines(Panel& panel, Sheet& sheet) {
  auto* list = new QTreeWidget(&panel);
  list->setObjectName("perspective-lines");
  list->setAccessibleName(Panel::tr("Lines"));
  list->setRootIsDecorated(false);
  list->setHeaderLabels({Panel::tr("Line"), Panel::tr("Along"), Panel::tr("Off by")});
  list->header()->setSectionResizeMode(QHeaderView::ResizeToContents);
  list->setMinimumHeight(90);
  QObject::connect(list, &QTreeWidget::itemClicked, &panel, [&sheet](QTreeWidgetItem* item) {
    if (!sheet.selects()) sheet.host.set_mode(select_mode);
    sheet.tool.select({item->text(0).toStdString()});
  });
  panel.column()->addWidget(list, 1);
  panel.also([list, &sheet] { show_lines(*list, sheet.result()); });
}

}  // namespace

Panel* make_perspective_panel(Sheet& sheet) {
  auto* panel = new Panel("perspective-panel");
  panel->buttons({"group-x", "group-y", "group-z", "group-auto", "group-normal-x", "group-normal-y", "group-normal-z",
                  "construction"},
                 4, Qt::ToolButtonTextBesideIcon, [&sheet](const QString& name) { return sheet.host.action(name); });
  for (auto* button : panel->findChildren<QToolButton*>()) button->setMinimumWidth(number_box_width);
  add_camera(*panel, sheet);
  add_sheet(*panel, sheet);
  add_known_point(*panel, sheet);
  add_known_length(*panel, sheet);
  add_lines(*panel, sheet);
  return panel;
}

}  // namespace croquis::app
