// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/tools/holes/hole_panel.h"

#include <QAction>
#include <QBoxLayout>
#include <QComboBox>
#include <QCoreApplication>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QPushButton>
#include <QSlider>
#include <QSpinBox>
#include <algorithm>
#include <cmath>
#include <utility>

#include "app/tools/holes/hole_plan.h"
#include "app/tools/holes/hole_table.h"
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
  if (count < 1) return QCoreApplication::translate("Holes", "a second");
  if (count < 90) return QCoreApplication::translate("Holes", "%1 s").arg(std::lround(count));
  return QCoreApplication::translate("Holes", "%1 min").arg(std::lround(count / 60));
}

QString bytes(std::size_t count) {
  const double megabytes = static_cast<double>(count) * 1e-6;
  if (megabytes < 1000) return QCoreApplication::translate("Holes", "%1 MB").arg(std::lround(megabytes));
  return QCoreApplication::translate("Holes", "%1 GB").arg(megabytes * 1e-3, 0, 'f', 1);
}

constexpr int bulge_steps = 100;  // of the slider on either side
constexpr int most_trimmed = 3;

/// A button that does what the window's action does.
QPushButton* action_button(QWidget* panel, QAction* does, const QString& text) {
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
  if (does->isCheckable()) button->setStyleSheet("QPushButton:checked { background: #6a4a26 }");
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
  return HolePanel::tr("Fill %1 up to %2").arg(count).arg(measure(limit));
}

bool is_remeshed(const WorkObject& object) {
  const FillResult* found = result_of<FillResult>(object.result.get());
  return found != nullptr && found->remeshed;
}

std::string mode_of_holes(const Studio& studio, const Node& node) {
  return std::get<std::string>(filling_value(studio, node, "mode"));
}

const ParameterDescription* parameter(const Studio& studio, const std::string& name) {
  const OperationDescription* operation = studio.description("fill");
  if (operation == nullptr) return nullptr;
  for (const ParameterDescription& description : operation->parameters) {
    if (description.name == name) return &description;
  }
  return nullptr;
}

}  // namespace

QString estimate_sentence(const Studio& studio, const Node& node, const PolyMesh& scan) {
  remeshing::RemeshOptions options;
  options.cell = std::max(number(studio, node, "cell", options.cell), 1e-3);
  options.refine = static_cast<int>(number(studio, node, "refine", options.refine));
  options.adaptive = number(studio, node, "adaptive", options.adaptive);
  options.overlap = number(studio, node, "overlap", options.overlap);
  const double finer = 1 / (options.cell * options.cell);
  const double time = seconds_per_face * static_cast<double>(scan.face_count()) * std::max(finer, 0.3);
  return QCoreApplication::translate(
             "Holes", "About %1, and %2 of memory at most; every vertex of the model will be another one.")
      .arg(seconds(time), bytes(remeshing::predicted_remesh_bytes(scan, options)));
}

HolePanel::HolePanel(Studio& studio, HoleInteraction& holes, const Action& action)
    : Panel("hole-panel"),
      studio_(studio),
      holes_(holes),
      check_(nullptr),
      summary_(label({})),
      checked_(label({})),
      table_(new HoleTable(this)),
      sizes_(new SizeSlider(this)) {
  column()->setContentsMargins(6, 4, 6, 4);
  column()->setSpacing(4);
  make_head();
  make_buttons(action);
  make_sizes();
  make_way();
  make_shape();
  row({action_button(this, action("clear-handles"), tr("Clear handles")),
       action_button(this, action("tint-patches"), tr("Confidence")),
       action_button(this, action("zebra"), tr("Zebra"))});
  make_mode();
  connect(&check_, &SurfaceCheck::changed, this, &HolePanel::follow_check);
}

bool HolePanel::is_there() const { return holes_.active() && filling_node(studio_) != nullptr; }

void HolePanel::make_head() {
  summary_->setObjectName("hole-summary");
  QFont bold = summary_->font();
  bold.setBold(true);
  summary_->setFont(bold);
  summary_->setWordWrap(true);
  checked_->setObjectName("hole-check");
  checked_->setWordWrap(true);
  checked_->hide();
  column()->addWidget(summary_);
  column()->addWidget(checked_);
  column()->addWidget(table_, 1);
  connect(table_, &HoleTable::holes_chosen, this, [this](const std::vector<Index>& chosen) { holes_.select(chosen); });
  connect(table_, &HoleTable::hole_opened, this, [this](Index hole) {
    holes_.select({hole});
    emit frame_wanted();
  });
  also([this] { follow_head(); });
}

void HolePanel::make_buttons(const Action& action) {
  const auto button = [&](const char* name, const QString& text) { return action_button(this, action(name), text); };
  row({button("fill-selected", tr("Fill")), button("reopen-selected", tr("Reopen")),
       button("bridge-holes", tr("Bridge")), button("frame-selection", tr("Frame"))});
  row({button("fill-inner", tr("Fill all inner")), button("fill-all-but-largest", tr("All but largest"))});
}

void HolePanel::make_sizes() {
  fill_sizes_ = new QPushButton(this);
  fill_sizes_->setObjectName("fill-sizes");
  fill_sizes_->setFocusPolicy(Qt::NoFocus);
  // Of one width for all numbers, so that the slider beside it stays under the pointer.
  const int widest = fill_sizes_->fontMetrics().horizontalAdvance(fill_text(9999, 0.000012345));
  fill_sizes_->setFixedWidth(widest + 2 * fill_sizes_->fontMetrics().averageCharWidth());
  row({{sizes_, 1}, fill_sizes_});
  connect(sizes_, &SizeSlider::moved, this, [this](double diameter) {
    holes_.select_by_size(diameter);
    follow_sizes();
  });
  connect(fill_sizes_, &QPushButton::clicked, this, [this] { holes_.fill_up_to(sizes_->diameter()); });
  also([this] { follow_sizes(); });
}

void HolePanel::make_way() {
  QLabel* of_all = label(tr("Preset, of all holes:"));
  if (const ParameterDescription* described = parameter(studio_, "preset"))
    of_all->setToolTip(QString::fromStdString(described->sentence));
  const std::vector<Choice> presets{{tr("Automatic"), "auto"},
                                    {tr("Standard"), "standard"},
                                    {tr("Sharp: machined parts"), "sharp"},
                                    {tr("Noisy: rough scans"), "noisy"},
                                    {tr("Paper: as Yoo 2005 has it"), "paper"}};
  QComboBox* preset = choice_of_values(
      "hole-preset", presets, [this] { return holes_.preset(); },
      [this](const std::string& value) { holes_.set_preset(value); }, of_all->toolTip());
  row({of_all, {named(preset, tr("Preset")), 1}});
  QLabel* title = text("way-of", [this] {
    const std::vector<Index>& chosen = holes_.selected();
    return chosen.empty()       ? tr("Patches of all holes:")
           : chosen.size() == 1 ? tr("Patch of hole %1:").arg(chosen.front())
                                : tr("Patches of holes %1:").arg(numbers_of({chosen.begin(), chosen.end()}));
  });
  title->setWordWrap(false);
  column()->addWidget(title);
  const std::vector<Choice> methods{{tr("Automatic"), "auto"},
                                    {tr("Continue the surface"), "rbf"},
                                    {tr("Continue its slope"), "smooth"},
                                    {tr("Flat"), "flat"}};
  std::vector<Choice> kernels;
  if (const ParameterDescription* described = parameter(studio_, "kernel")) {
    for (std::size_t i = 0; i < described->choices.size(); ++i)
      kernels.push_back(
          {QString::fromStdString(described->choice_titles[i]), QString::fromStdString(described->choices[i])});
  }
  QComboBox* fairness = choice_of_values(
      "hole-way", methods, [this] { return holes_.way().fairness; },
      [this](const std::string& value) { holes_.set_way({.fairness = value}); },
      tr("Automatic: flat where an open surface ends, elsewhere the surface is continued"));
  QComboBox* kernel = choice_of_values(
      "hole-kernel", kernels, [this] { return holes_.way().kernel; },
      [this](const std::string& value) { holes_.set_way({.kernel = value}); },
      tr("Of the functions that continue the surface"));
  also([this, kernel] {
    const std::string method = holes_.way().fairness;
    kernel->setEnabled(method == "rbf" || method == "auto");
  });
  row({{named(fairness, tr("Method")), 1}, {named(kernel, tr("Function")), 1}});
}

void HolePanel::make_shape() {
  QLabel* name = label(tr("Bulge"));
  name->setToolTip(tr("Turns the slope at the rim: out above 0, in below"));
  auto* slider = new QSlider(Qt::Horizontal, this);
  slider->setObjectName("bulge-slider");
  slider->setAccessibleName(tr("Bulge"));
  slider->setRange(-bulge_steps, bulge_steps);
  const auto slide = [this, slider](bool dragging) {
    if (!following()) holes_.set_way({.bulge = static_cast<double>(slider->value()) / bulge_steps}, dragging);
  };
  connect(slider, &QSlider::valueChanged, this, [slide, slider] { slide(slider->isSliderDown()); });
  connect(slider, &QSlider::sliderReleased, this, [slide] { slide(false); });
  QDoubleSpinBox* bulge = number(
      "bulge", {-1, 1, 2}, [this] { return Number{holes_.way().bulge}; },
      [this](double value) { holes_.set_way({.bulge = value}); });
  bulge->setAccessibleName(tr("Bulge"));
  bulge->setSingleStep(0.05);
  auto* trim = new QSpinBox(this);
  trim->setObjectName("trim-rim");
  trim->setAccessibleName(tr("Rings of faces taken off the rim"));
  trim->setToolTip(tr("Rings of faces taken off the rim before it is filled: frayed borders of scans"));
  trim->setRange(0, most_trimmed);
  trim->setPrefix(tr("Trim "));
  trim->setSuffix(tr(" rings"));
  connect(trim, &QSpinBox::valueChanged, this, [this](int rings) {
    if (!following()) holes_.set_way({.trim_rim = rings});
  });
  share_keys(bulge);
  share_keys(trim);
  row({name, {slider, 1}, bulge, trim});
  also([this, slider, trim] {
    const HoleInteraction::Way way = holes_.way();
    // While it is held down, the slider leads.
    if (!slider->isSliderDown()) slider->setValue(static_cast<int>(std::lround(way.bulge * bulge_steps)));
    trim->setValue(way.trim_rim);
  });
}

void HolePanel::make_mode() {
  std::vector<Choice> modes;
  if (const ParameterDescription* described = parameter(studio_, "mode")) {
    for (const std::string& choice : described->choices) {
      modes.push_back({choice == "remesh" ? tr("Remesh the whole model") : tr("Patches, rest unchanged"),
                       QString::fromStdString(choice)});
    }
  }
  mode_ = choice_of_values(
      "hole-mode", modes,
      [this] { return is_there() ? mode_of_holes(studio_, *filling_node(studio_)) : std::string("patch"); },
      [this](const std::string& mode) {
        // Patches come back at once; remeshing begins after its estimate was shown.
        if (mode == "remesh") return follow_estimate();
        holes_.set_mode(mode);
      });
  start_ = new QPushButton(tr("Start"), this);
  start_->setObjectName("start-remesh");
  start_->setFocusPolicy(Qt::NoFocus);
  connect(start_, &QPushButton::clicked, this, [this] { holes_.set_mode("remesh"); });
  estimate_ = label({});
  estimate_->setObjectName("remesh-estimate");
  estimate_->setWordWrap(true);
  row({{named(mode_, tr("Mode")), 1}, start_});
  column()->addWidget(estimate_);
  also([this] { follow_estimate(); });
}

void HolePanel::follow_head() {
  const bool there = is_there();
  setEnabled(there);
  const bool looking = there && holes_.rows().empty() && studio_.busy();
  summary_->setText(!there    ? tr("No mesh is being worked on")
                    : looking ? tr("Looking for holes …")
                              : summary_of(holes_.rows()));
  table_->name_unit(QString::fromStdString(studio_.unit()));
  table_->show_holes(holes_.rows());
  table_->show_selection(holes_.selected());
  const WorkObject* object = studio_.active();
  const bool filled =
      there && object->quality == Quality::Final && object->result && !object->result->failed &&
      std::ranges::any_of(holes_.rows(), [](const HoleRow& row) { return row.state == FillAction::Fill; });
  const bool remeshed = filled && is_remeshed(*object);  // what is shown, whatever is being computed
  check_.follow(filled ? object->mesh : nullptr, filled && !remeshed ? holes_.scan() : nullptr);
}

void HolePanel::follow_sizes() {
  std::vector<double> diameters;
  for (const HoleRow& row : holes_.rows()) {
    if (!row.is_border()) diameters.push_back(row.diameter);
  }
  sizes_->show_sizes(diameters);
  const double limit = sizes_->diameter();
  const std::size_t count = limit > 0 ? holes_.open_up_to(limit).size() : 0;
  fill_sizes_->setEnabled(count > 0);
  fill_sizes_->setText(limit > 0 ? fill_text(count, limit) : tr("Fill up to size"));
  fill_sizes_->setToolTip(diameters.empty() ? tr("There is no hole inside a border")
                          : limit <= 0      ? tr("Drag the slider first: it sets the largest diameter")
                          : count == 0
                              ? tr("No hole that small is open")
                              : tr("Fills the open inner holes with a diameter of at most %1; filled holes stay filled")
                                    .arg(measure(limit)));
}

void HolePanel::follow_estimate() {
  const Node* node = filling_node(studio_);
  const WorkObject* object = studio_.active();
  const bool wanted = mode_->currentData() == "remesh" && node != nullptr && object->cage_mesh;
  const bool runs = wanted && mode_of_holes(studio_, *node) == "remesh";
  start_->setVisible(wanted && !runs);
  const bool done = runs && !studio_.busy();
  estimate_->setVisible(wanted && !done);
  if (wanted) estimate_->setText(estimate_sentence(studio_, *node, *object->cage_mesh));
}

void HolePanel::follow_check() {
  const auto& found = check_.found();
  checked_->setVisible(found.has_value() || check_.busy());
  const LeftOpen left = left_open(holes_.rows());
  checked_->setText(found ? sentence_of(*found, left) : tr("Checking …"));
  const bool fine = found && is_as_wanted(*found, left);
  checked_->setStyleSheet(!found ? "" : fine ? "color: #6fd3b0" : "color: #ffb65c");
}

}  // namespace croquis::app
