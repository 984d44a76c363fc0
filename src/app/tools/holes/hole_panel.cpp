// SPDX-License-Identifier: GPL-3.0-or-later
#include <QAction>
#include <QBoxLayout>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QPushButton>
#include <QSlider>
#include <QSpinBox>
#include <algorithm>
#include <cmath>
#include <utility>

#include "app/panels/panel.h"
#include "app/tools/holes/hole_plan.h"
#include "app/tools/holes/hole_table.h"
#include "app/tools/holes/scan_holes.h"
#include "app/tools/holes/surface_check.h"
#include "app/window/language.h"
#include "app/window/theme.h"
#include "croquis/remeshing/remesh.h"

namespace croquis::app {
namespace {

/// For a triangle of the scan, with cubes as large as its edges: a rough figure on the safe side. The shipped scan of
/// 20,000 triangles took half of it.
constexpr double seconds_per_face = 40e-6;

double number(const Studio& studio, const Node& node, const char* name, double otherwise) {
  const ParameterValue value = filling_value(studio, node, name);
  if (const auto* found = std::get_if<double>(&value)) return *found;
  if (const auto* found = std::get_if<std::int64_t>(&value)) return static_cast<double>(*found);
  return otherwise;
}

QString seconds(double count) {
  if (count < 1) return Panel::tr("a second");
  if (count < 90) return Panel::tr("%1 s").arg(std::lround(count));
  return Panel::tr("%1 min").arg(std::lround(count / 60));
}

QString bytes(std::size_t count) {
  const double megabytes = static_cast<double>(count) * 1e-6;
  if (megabytes < 1000) return Panel::tr("%1 MB").arg(std::lround(megabytes));
  return Panel::tr("%1 GB").arg(megabytes * 1e-3, 0, 'f', 1);
}

constexpr int bulge_steps = 100;  // of the slider on either side
constexpr int most_trimmed = 3;

/// "27 holes: 25 filled, 1 border left open, 1 failed".
QString summary_of(const std::vector<HoleRow>& holes) {
  const auto tr = [](const char* text) { return Panel::tr(text); };
  if (holes.empty()) return tr("No holes");
  const auto count = [&](FillAction state, bool border) {
    return std::ranges::count_if(holes, [&](const HoleRow& hole) {
      return hole.state == state && (state != FillAction::Leave || hole.is_border() == border);
    });
  };
  QStringList parts;
  const auto add = [&parts](std::ptrdiff_t number, const QString& one, const QString& many) {
    if (number > 0) parts << (number == 1 ? one : many).arg(number);
  };
  add(count(FillAction::Fill, false), tr("%1 filled"), tr("%1 filled"));
  add(count(FillAction::Leave, false), tr("%1 open"), tr("%1 open"));
  add(count(FillAction::Leave, true), tr("%1 border left open"), tr("%1 borders left open"));
  add(count(FillAction::Failed, false), tr("%1 failed"), tr("%1 failed"));
  return (holes.size() == 1 ? tr("1 hole: ") : tr("%1 holes: ").arg(holes.size())) + parts.join(", ");
}

/// A button that does what the window's action does.
QPushButton* action_button(QWidget* panel, const ScanHoles& holes, const char* action, const QString& text) {
  QAction* does = holes.host.action(action);
  auto* button = new QPushButton(text, panel);
  button->setObjectName(does->objectName() + "-button");
  button->setFocusPolicy(Qt::NoFocus);  // keys belong to the views
  const QString keys = does->shortcut().toString(QKeySequence::NativeText);
  button->setToolTip(does->text().remove('&') + (keys.isEmpty() ? QString() : " (" + keys + ")"));
  QObject::connect(button, &QPushButton::clicked, does, &QAction::trigger);
  QObject::connect(does, &QAction::changed, button, [button, does] {
    button->setEnabled(does->isEnabled());
    if (does->isCheckable()) button->setChecked(does->isChecked());
  });
  button->setCheckable(does->isCheckable());
  return button;
}

/// Its choices are as wide as they are at first.
QComboBox* named(QComboBox* box, const QString& name) {
  box->setAccessibleName(name);
  box->setSizeAdjustPolicy(QComboBox::AdjustToContentsOnFirstShow);
  return box;
}

LeftOpen left_open(const std::vector<HoleRow>& rows) {
  LeftOpen left;
  for (const HoleRow& row : rows) {
    if (row.state == FillAction::Fill) continue;
    ++(row.is_border() ? left.borders : left.holes);
    if (row.state == FillAction::Failed) ++left.failed;
    (row.is_border() ? left.border_edges : left.hole_edges) += row.edges;
  }
  return left;
}

QString fill_text(std::size_t count, double limit) {
  return Panel::tr("Fill %1 up to %2").arg(count).arg(number_words(limit));
}

bool is_remeshed(const WorkObject& object) {
  const FillResult* found = result_of<FillResult>(object.result.get());
  return found != nullptr && found->remeshed;
}

const ParameterDescription* parameter(const ScanHoles& holes, const std::string& name) {
  const OperationDescription* operation = holes.studio().description(filling_operation);
  return operation == nullptr ? nullptr : find_parameter(operation->parameters, name);
}

/// "About 9 s and 1.1 GB": what remeshing a scan costs with the parameters of a `fill` operation, before it begins.
QString estimate_sentence(const Studio& studio, const Node& node, const PolyMesh& scan) {
  remeshing::RemeshOptions options;
  options.cell = std::max(number(studio, node, "cell", options.cell), 1e-3);
  options.refine = static_cast<int>(number(studio, node, "refine", options.refine));
  options.adaptive = number(studio, node, "adaptive", options.adaptive);
  options.overlap = number(studio, node, "overlap", options.overlap);
  const double finer = 1 / (options.cell * options.cell);
  const double time = seconds_per_face * static_cast<double>(scan.face_count()) * std::max(finer, 0.3);
  return Panel::tr("About %1, and %2 of memory at most; every vertex of the model will be another one.")
      .arg(seconds(time), bytes(remeshing::predicted_remesh_bytes(scan, options)));
}

/// What was found, and what a check of it says.
void add_head(Panel& panel, ScanHoles& holes) {
  QLabel* summary = panel.label({});
  summary->setObjectName("hole-summary");
  QFont bold = summary->font();
  bold.setBold(true);
  summary->setFont(bold);
  QLabel* checked = panel.label({});
  checked->setObjectName("hole-check");
  checked->hide();
  auto* table = new HoleTable(&panel);
  for (QLabel* label : {summary, checked}) {
    label->setWordWrap(true);
    panel.column()->addWidget(label);
  }
  panel.column()->addWidget(table, 1);
  QObject::connect(table, &HoleTable::holes_chosen, &panel,
                   [&holes](const std::vector<Index>& chosen) { holes.select(chosen); });
  QObject::connect(table, &HoleTable::hole_opened, &panel, [&holes](Index hole) {
    holes.select({hole});
    frame_holes(holes);
  });
  QObject::connect(table, &HoleTable::accepted, holes.host.action("fill-selected"), &QAction::trigger);
  auto* check = new SurfaceCheck(&panel);
  QObject::connect(check, &SurfaceCheck::changed, &panel, [&holes, check, checked] {
    const auto& found = check->found();
    checked->setVisible(found.has_value() || check->busy());
    const LeftOpen left = left_open(holes.rows);
    checked->setText(found ? sentence_of(*found, left) : Panel::tr("Checking …"));
    const bool fine = found && is_as_wanted(*found, left);
    set_tone(*checked, !found ? "" : fine ? "good" : "warning");
  });
  panel.also([&panel, &holes, summary, table, check] {
    const Studio& studio = holes.studio();
    const bool there = holes.works();
    panel.setEnabled(there);
    summary->setText(!there                                ? Panel::tr("No mesh is being worked on")
                     : holes.rows.empty() && studio.busy() ? Panel::tr("Looking for holes …")
                                                           : summary_of(holes.rows));
    table->name_unit(QString::fromStdString(studio.unit()));
    table->show_holes(holes.rows);
    table->show_selection(holes.selected());
    const WorkObject* object = studio.active();
    const bool filled = there && object->quality == Quality::Final && object->result && !object->result->failed &&
                        !holes.filled().empty();
    const bool remeshed = filled && is_remeshed(*object);  // what is shown, whatever is being computed
    check->follow(filled ? object->mesh : nullptr, filled && !remeshed ? holes.scan() : nullptr);
  });
}

void add_buttons(Panel& panel, const ScanHoles& holes) {
  const auto button = [&](const char* action, const QString& text) {
    return action_button(&panel, holes, action, text);
  };
  panel.row({button("fill-selected", Panel::tr("Fill")), button("reopen-selected", Panel::tr("Reopen")),
             button("bridge-holes", Panel::tr("Bridge")), button("frame-selection", Panel::tr("Frame"))});
  panel.row({button("fill-inner", Panel::tr("Fill all inner")),
             button("fill-all-but-largest", Panel::tr("All but largest"))});
}

QString fill_tip(bool any_inner, double limit, std::size_t count) {
  if (!any_inner) return Panel::tr("There is no hole inside a border");
  if (limit <= 0) return Panel::tr("Drag the slider first: it sets the largest diameter");
  if (count == 0) return Panel::tr("No hole that small is open");
  return Panel::tr("Fills the open inner holes with a diameter of at most %1; filled holes stay filled")
      .arg(number_words(limit));
}

void add_sizes(Panel& panel, ScanHoles& holes) {
  auto* sizes = new SizeSlider(&panel);
  QPushButton* fill = panel.button("fill-sizes", {}, {}, [&holes, sizes] { fill_up_to(holes, sizes->diameter()); });
  fill->setFocusPolicy(Qt::NoFocus);
  // Of one width for all numbers, so that the slider beside it stays under the pointer.
  const int widest = fill->fontMetrics().horizontalAdvance(fill_text(9999, 0.000012345));
  fill->setFixedWidth(widest + 2 * fill->fontMetrics().averageCharWidth());
  panel.row({{sizes, 1}, fill});
  const auto follow = [&holes, sizes, fill] {
    std::vector<double> diameters;
    for (const HoleRow& row : holes.rows) {
      if (!row.is_border()) diameters.push_back(row.diameter);
    }
    sizes->show_sizes(diameters);
    const double limit = sizes->diameter();
    const std::size_t count = limit > 0 ? open_up_to(holes, limit).size() : 0;
    fill->setEnabled(count > 0);
    fill->setText(limit > 0 ? fill_text(count, limit) : Panel::tr("Fill up to size"));
    fill->setToolTip(fill_tip(!diameters.empty(), limit, count));
  };
  QObject::connect(sizes, &SizeSlider::moved, &panel, [&holes, follow](double diameter) {
    holes.select(open_up_to(holes, diameter));
    follow();
  });
  panel.also(follow);
}

void add_methods(Panel& panel, ScanHoles& holes) {
  using Choice = Panel::Choice;
  QLabel* of_all = panel.label(Panel::tr("Preset, of all holes:"));
  if (const ParameterDescription* described = parameter(holes, "preset"))
    of_all->setToolTip(shown_text(described->sentence));
  const std::vector<Choice> presets{{Panel::tr("Automatic"), "auto"},
                                    {Panel::tr("Standard"), "standard"},
                                    {Panel::tr("Sharp: machined parts"), "sharp"},
                                    {Panel::tr("Noisy: rough scans"), "noisy"},
                                    {Panel::tr("Paper: as Yoo 2005 has it"), "paper"}};
  QComboBox* preset = panel.choice_of_values(
      "hole-preset", presets, [&holes] { return text_parameter(holes, "preset"); },
      [&holes](const std::string& value) { set_preset(holes, value); }, of_all->toolTip());
  panel.row({of_all, {named(preset, Panel::tr("Preset")), 1}});
  QLabel* title = panel.text("way-of", [&holes] {
    const std::vector<Index>& chosen = holes.selected();
    return chosen.empty()       ? Panel::tr("Patches of all holes:")
           : chosen.size() == 1 ? Panel::tr("Patch of hole %1:").arg(chosen.front())
                                : Panel::tr("Patches of holes %1:").arg(numbers_of({chosen.begin(), chosen.end()}));
  });
  title->setWordWrap(false);
  panel.column()->addWidget(title);
  const std::vector<Choice> methods{{Panel::tr("Automatic"), "auto"},
                                    {Panel::tr("Continue the surface"), "rbf"},
                                    {Panel::tr("Continue its slope"), "smooth"},
                                    {Panel::tr("Flat"), "flat"}};
  std::vector<Choice> kernels;
  if (const ParameterDescription* described = parameter(holes, "kernel")) {
    for (std::size_t i = 0; i < described->choices.size(); ++i)
      kernels.push_back({shown_text(described->choice_titles[i]), QString::fromStdString(described->choices[i])});
  }
  QComboBox* fairness = panel.choice_of_values(
      "hole-way", methods, [&holes] { return method_of_selected(holes).fairness; },
      [&holes](const std::string& value) { set_method(holes, {.fairness = value}); },
      Panel::tr("Automatic: flat where an open surface ends, elsewhere the surface is continued"));
  QComboBox* kernel = panel.choice_of_values(
      "hole-kernel", kernels, [&holes] { return method_of_selected(holes).kernel; },
      [&holes](const std::string& value) { set_method(holes, {.kernel = value}); },
      Panel::tr("Of the functions that continue the surface"));
  panel.also([&holes, kernel] {
    const std::string method = method_of_selected(holes).fairness;
    kernel->setEnabled(method == "rbf" || method == "auto");
  });
  panel.row({{named(fairness, Panel::tr("Method")), 1}, {named(kernel, Panel::tr("Function")), 1}});
}

void add_shape(Panel& panel, ScanHoles& holes) {
  QLabel* name = panel.label(Panel::tr("Bulge"));
  name->setToolTip(Panel::tr("Turns the slope at the rim: out above 0, in below"));
  // While the slider is held down it is one change.
  QSlider* slider = panel.slider(
      "bulge-slider", -bulge_steps, bulge_steps,
      [&holes] { return static_cast<int>(std::lround(method_of_selected(holes).bulge * bulge_steps)); },
      [&holes](int value, bool drags) {
        set_method(holes, {.bulge = static_cast<double>(value) / bulge_steps}, drags);
      });
  slider->setAccessibleName(name->text());
  QDoubleSpinBox* bulge = panel.number(
      "bulge", {-1, 1, 2}, [&holes] { return Panel::Number{method_of_selected(holes).bulge}; },
      [&holes](double value) { set_method(holes, {.bulge = value}); });
  bulge->setAccessibleName(name->text());
  bulge->setSingleStep(0.05);
  auto* trim = new QSpinBox(&panel);
  trim->setObjectName("trim-rim");
  trim->setAccessibleName(Panel::tr("Rings of faces taken off the rim"));
  trim->setToolTip(Panel::tr("Rings of faces taken off the rim before it is filled: frayed borders of scans"));
  trim->setRange(0, most_trimmed);
  trim->setPrefix(Panel::tr("Trim "));
  trim->setSuffix(Panel::tr(" rings"));
  QObject::connect(trim, &QSpinBox::valueChanged, &panel, [&panel, &holes](int rings) {
    if (!panel.following()) set_method(holes, {.trim_rim = rings});
  });
  panel.also([&holes, trim] { trim->setValue(method_of_selected(holes).trim_rim); });
  share_keys(bulge);
  share_keys(trim);
  panel.row({name, {slider, 1}, bulge, trim});
}

/// Patches come back at once; remeshing begins after its estimate was shown.
void add_mode(Panel& panel, ScanHoles& holes) {
  std::vector<Panel::Choice> modes;
  if (const ParameterDescription* described = parameter(holes, "mode")) {
    for (const std::string& choice : described->choices) {
      modes.push_back({choice == "remesh" ? Panel::tr("Remesh the whole model") : Panel::tr("Patches, rest unchanged"),
                       QString::fromStdString(choice)});
    }
  }
  QPushButton* start = panel.button("start-remesh", Panel::tr("Start"), {}, [&holes] { set_mode(holes, "remesh"); });
  start->setFocusPolicy(Qt::NoFocus);
  QLabel* estimate = panel.label({});
  estimate->setObjectName("remesh-estimate");
  estimate->setWordWrap(true);
  const auto show_estimate = [&holes, start, estimate](const std::string& mode) {
    const Node* node = holes.node();
    const WorkObject* object = holes.studio().active();
    const bool wanted = mode == "remesh" && node != nullptr && object->cage_mesh;
    const bool runs = wanted && text_parameter(holes, "mode") == "remesh";
    start->setVisible(wanted && !runs);
    estimate->setVisible(wanted && !(runs && !holes.studio().busy()));
    if (wanted) estimate->setText(estimate_sentence(holes.studio(), *node, *object->cage_mesh));
  };
  QComboBox* mode = panel.choice_of_values(
      "hole-mode", modes, [&holes] { return holes.works() ? text_parameter(holes, "mode") : std::string("patch"); },
      [&holes, show_estimate](const std::string& chosen) {
        chosen == "remesh" ? show_estimate(chosen) : set_mode(holes, chosen);
      });
  panel.row({{named(mode, Panel::tr("Mode")), 1}, start});
  panel.column()->addWidget(estimate);
  panel.also([mode, show_estimate] { show_estimate(mode->currentData().toString().toStdString()); });
}

}  // namespace

Panel* make_hole_panel(ScanHoles& holes) {
  auto* panel = new Panel("hole-panel");
  panel->column()->setContentsMargins(6, 4, 6, 4);
  panel->column()->setSpacing(4);
  add_head(*panel, holes);
  add_buttons(*panel, holes);
  add_sizes(*panel, holes);
  add_methods(*panel, holes);
  add_shape(*panel, holes);
  const auto button = [&](const char* action, const QString& text) {
    return action_button(panel, holes, action, text);
  };
  panel->row({button("clear-handles", Panel::tr("Clear handles")), button("tint-patches", Panel::tr("Confidence")),
              button("zebra", Panel::tr("Zebra"))});
  add_mode(*panel, holes);
  return panel;
}

}  // namespace croquis::app
