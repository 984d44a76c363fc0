// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/tools/holes/hole_panel.h"

#include <QAction>
#include <QBoxLayout>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QFormLayout>
#include <QLabel>
#include <QPushButton>
#include <QSignalBlocker>
#include <QSlider>
#include <QSpinBox>
#include <algorithm>
#include <cmath>
#include <utility>

#include "app/panels/number_box.h"
#include "app/panels/number_keys.h"
#include "app/panels/size_slider.h"
#include "app/tools/holes/filling.h"
#include "app/tools/holes/hole_table.h"
#include "app/tools/holes/remesh_estimate.h"

namespace croquis::app {
namespace {

constexpr int bulge_steps = 100;  // of the slider on either side
constexpr int most_trimmed = 3;

struct Choice {
  const char* value;
  const char* text;
};
constexpr std::array<Choice, 4> ways{{{"auto", QT_TRANSLATE_NOOP("HolePanel", "Automatic")},
                                      {"rbf", QT_TRANSLATE_NOOP("HolePanel", "Continue the surface")},
                                      {"smooth", QT_TRANSLATE_NOOP("HolePanel", "Continue its slope")},
                                      {"flat", QT_TRANSLATE_NOOP("HolePanel", "Flat")}}};

constexpr std::array<Choice, 5> presets{{{"auto", QT_TRANSLATE_NOOP("HolePanel", "Automatic")},
                                         {"standard", QT_TRANSLATE_NOOP("HolePanel", "Standard")},
                                         {"sharp", QT_TRANSLATE_NOOP("HolePanel", "Sharp: machined parts")},
                                         {"noisy", QT_TRANSLATE_NOOP("HolePanel", "Noisy: rough scans")},
                                         {"paper", QT_TRANSLATE_NOOP("HolePanel", "Paper: as Yoo 2005 has it")}}};

QBoxLayout* add_row(QBoxLayout* column) {
  auto* row = new QHBoxLayout;
  row->setSpacing(4);
  column->addLayout(row);
  return row;
}

void show_choice(QComboBox* box, const std::string& value) {
  const QSignalBlocker quiet(box);
  box->setCurrentIndex(box->findData(QString::fromStdString(value)));
}

LeftOpen left_open(const std::vector<HoleRow>& rows) {
  LeftOpen left;
  for (const HoleRow& row : rows) {
    if (row.state == HoleState::Filled) continue;
    ++(row.is_border() ? left.borders : left.holes);
    if (row.state == HoleState::Failed) ++left.failed;
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

const ParameterDescription* parameter(const Studio& studio, const std::string& name) {
  const OperationDescription* operation = studio.description("fill");
  if (operation == nullptr) return nullptr;
  for (const ParameterDescription& description : operation->parameters) {
    if (description.name == name) return &description;
  }
  return nullptr;
}

}  // namespace

HolePanel::HolePanel(Studio& studio, HoleInteraction& holes, std::function<QAction*(const QString&)> action,
                     QWidget* parent)
    : QWidget(parent),
      studio_(studio),
      holes_(holes),
      action_(std::move(action)),
      check_(nullptr),
      summary_(new QLabel(this)),
      checked_(new QLabel(this)),
      table_(new HoleTable(this)),
      sizes_(new SizeSlider(this)) {
  setObjectName("hole-panel");
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(6, 4, 6, 4);
  column->setSpacing(4);
  make_head(column);
  make_buttons(column);
  make_sizes(column);
  make_preset(column);
  make_way(column);
  make_shape(column);
  make_mode(column);
  connect(&check_, &SurfaceCheck::changed, this, &HolePanel::follow_check);
}

void HolePanel::make_head(QBoxLayout* column) {
  summary_->setObjectName("hole-summary");
  QFont bold = summary_->font();
  bold.setBold(true);
  summary_->setFont(bold);
  summary_->setWordWrap(true);
  checked_->setObjectName("hole-check");
  checked_->setWordWrap(true);
  checked_->hide();
  column->addWidget(summary_);
  column->addWidget(checked_);
  column->addWidget(table_, 1);
  connect(table_, &HoleTable::holes_chosen, this, [this](const std::vector<Index>& chosen) { holes_.select(chosen); });
  connect(table_, &HoleTable::hole_opened, this, [this](Index hole) {
    holes_.select({hole});
    emit frame_wanted();
  });
}

QPushButton* HolePanel::action_button(const QString& name, const QString& text, QBoxLayout* row) {
  auto* button = new QPushButton(text, this);
  button->setObjectName(name + "-button");
  button->setFocusPolicy(Qt::NoFocus);  // keys belong to the views
  QAction* does = action_(name);
  const QString keys = does->shortcut().toString(QKeySequence::NativeText);
  button->setToolTip(does->text().remove('&') + (keys.isEmpty() ? QString() : " (" + keys + ")"));
  connect(button, &QPushButton::clicked, does, &QAction::trigger);
  connect(does, &QAction::changed, button, [button, does] {
    button->setEnabled(does->isEnabled());
    if (does->isCheckable()) button->setChecked(does->isChecked());
  });
  button->setCheckable(does->isCheckable());
  if (does->isCheckable()) button->setStyleSheet("QPushButton:checked { background: #6a4a26 }");
  row->addWidget(button);
  return button;
}

void HolePanel::make_buttons(QBoxLayout* column) {
  QBoxLayout* chosen = add_row(column);
  action_button("fill-selected", tr("Fill"), chosen);
  action_button("reopen-selected", tr("Reopen"), chosen);
  action_button("bridge-holes", tr("Bridge"), chosen);
  action_button("frame-selection", tr("Frame"), chosen);
  QBoxLayout* all = add_row(column);
  action_button("fill-inner", tr("Fill all inner"), all);
  action_button("fill-all-but-largest", tr("All but largest"), all);
}

void HolePanel::make_sizes(QBoxLayout* column) {
  QBoxLayout* row = add_row(column);
  row->addWidget(sizes_, 1);
  fill_sizes_ = new QPushButton(this);
  fill_sizes_->setObjectName("fill-sizes");
  fill_sizes_->setFocusPolicy(Qt::NoFocus);
  // Of one width for all numbers, so that the slider beside it stays under the pointer.
  const int widest = fill_sizes_->fontMetrics().horizontalAdvance(fill_text(9999, 0.000012345));
  fill_sizes_->setFixedWidth(widest + 2 * fill_sizes_->fontMetrics().averageCharWidth());
  row->addWidget(fill_sizes_);
  connect(sizes_, &SizeSlider::moved, this, [this](double diameter) {
    holes_.select_by_size(diameter);
    follow_sizes();
  });
  connect(fill_sizes_, &QPushButton::clicked, this, [this] { holes_.fill_up_to(sizes_->diameter()); });
}

void HolePanel::make_preset(QBoxLayout* column) {
  QBoxLayout* row = add_row(column);
  auto* name = new QLabel(tr("Preset, of all holes:"), this);
  preset_ = new QComboBox(this);
  preset_->setObjectName("hole-preset");
  preset_->setAccessibleName(tr("Preset"));
  for (const Choice& choice : presets) preset_->addItem(tr(choice.text), QString(choice.value));
  if (const ParameterDescription* described = parameter(studio_, "preset")) {
    name->setToolTip(QString::fromStdString(described->sentence));
    preset_->setToolTip(name->toolTip());
  }
  row->addWidget(name);
  row->addWidget(preset_, 1);
  connect(preset_, &QComboBox::activated, this,
          [this] { holes_.set_preset(preset_->currentData().toString().toStdString()); });
}

void HolePanel::make_way(QBoxLayout* column) {
  way_of_ = new QLabel(this);
  way_of_->setObjectName("way-of");
  column->addWidget(way_of_);
  QBoxLayout* row = add_row(column);
  fairness_ = new QComboBox(this);
  fairness_->setObjectName("hole-way");
  fairness_->setAccessibleName(tr("Method"));
  fairness_->setToolTip(tr("Automatic: flat where an open surface ends, elsewhere the surface is continued"));
  for (const Choice& choice : ways) fairness_->addItem(tr(choice.text), QString(choice.value));
  kernel_ = new QComboBox(this);
  kernel_->setObjectName("hole-kernel");
  kernel_->setAccessibleName(tr("Function"));
  kernel_->setToolTip(tr("Of the functions that continue the surface"));
  if (const ParameterDescription* kernels = parameter(studio_, "kernel")) {
    for (std::size_t i = 0; i < kernels->choices.size(); ++i)
      kernel_->addItem(QString::fromStdString(kernels->choice_titles[i]), QString::fromStdString(kernels->choices[i]));
  }
  row->addWidget(fairness_, 1);
  row->addWidget(kernel_, 1);
  connect(fairness_, &QComboBox::activated, this,
          [this] { holes_.set_fairness(fairness_->currentData().toString().toStdString()); });
  connect(kernel_, &QComboBox::activated, this,
          [this] { holes_.set_kernel(kernel_->currentData().toString().toStdString()); });
}

void HolePanel::make_shape(QBoxLayout* column) {
  QBoxLayout* row = add_row(column);
  auto* name = new QLabel(tr("Bulge"), this);
  name->setToolTip(tr("Turns the slope at the rim: out above 0, in below"));
  bulge_slider_ = new QSlider(Qt::Horizontal, this);
  bulge_slider_->setObjectName("bulge-slider");
  bulge_slider_->setAccessibleName(tr("Bulge"));
  bulge_slider_->setRange(-bulge_steps, bulge_steps);
  bulge_ = make_number_box(this, "bulge", {-1, 1, 2});
  bulge_->setAccessibleName(tr("Bulge"));
  bulge_->setSingleStep(0.05);
  trim_ = new QSpinBox(this);
  trim_->setObjectName("trim-rim");
  trim_->setAccessibleName(tr("Rings of faces taken off the rim"));
  trim_->setToolTip(tr("Rings of faces taken off the rim before it is filled: frayed borders of scans"));
  trim_->setRange(0, most_trimmed);
  trim_->setPrefix(tr("Trim "));
  trim_->setSuffix(tr(" rings"));
  share_keys(bulge_);
  share_keys(trim_);
  row->addWidget(name);
  row->addWidget(bulge_slider_, 1);
  row->addWidget(bulge_);
  row->addWidget(trim_);
  connect(bulge_slider_, &QSlider::valueChanged, this, [this](int value) {
    holes_.set_bulge(static_cast<double>(value) / bulge_steps, bulge_slider_->isSliderDown());
  });
  connect(bulge_slider_, &QSlider::sliderReleased, this,
          [this] { holes_.set_bulge(static_cast<double>(bulge_slider_->value()) / bulge_steps, false); });
  connect(bulge_, &QDoubleSpinBox::valueChanged, this, [this](double value) { holes_.set_bulge(value, false); });
  connect(trim_, &QSpinBox::valueChanged, this, [this](int rings) { holes_.set_trim(rings); });
  QBoxLayout* looks = add_row(column);
  action_button("clear-handles", tr("Clear handles"), looks);
  action_button("tint-patches", tr("Confidence"), looks);
  action_button("zebra", tr("Zebra"), looks);
}

void HolePanel::make_mode(QBoxLayout* column) {
  QBoxLayout* row = add_row(column);
  mode_ = new QComboBox(this);
  mode_->setObjectName("hole-mode");
  mode_->setAccessibleName(tr("Mode"));
  if (const ParameterDescription* mode = parameter(studio_, "mode")) {
    for (const std::string& choice : mode->choices) {
      mode_->addItem(choice == "remesh" ? tr("Remesh the whole model") : tr("Patches, rest unchanged"),
                     QString::fromStdString(choice));
    }
  }
  start_ = new QPushButton(tr("Start"), this);
  start_->setObjectName("start-remesh");
  start_->setFocusPolicy(Qt::NoFocus);
  estimate_ = new QLabel(this);
  estimate_->setObjectName("remesh-estimate");
  estimate_->setWordWrap(true);
  row->addWidget(mode_, 1);
  row->addWidget(start_);
  column->addWidget(estimate_);
  connect(mode_, &QComboBox::activated, this, [this] {
    // Patches come back at once; remeshing begins after its estimate was shown.
    if (mode_->currentData() == "remesh") return follow_mode();
    holes_.set_mode(mode_->currentData().toString().toStdString());
  });
  connect(start_, &QPushButton::clicked, this, [this] { holes_.set_mode("remesh"); });
}

void HolePanel::follow() {
  const bool there = holes_.active() && filling_node(studio_) != nullptr;
  setEnabled(there);
  const bool looking = there && holes_.rows().empty() && studio_.busy();
  summary_->setText(!there    ? tr("No mesh is being worked on")
                    : looking ? tr("Looking for holes …")
                              : summary_of(holes_.rows()));
  table_->name_unit(QString::fromStdString(studio_.unit()));
  table_->show_holes(holes_.rows());
  table_->show_selection(holes_.selected());
  follow_sizes();
  follow_way();
  show_choice(mode_, std::get<std::string>(there ? filling_value(studio_, *filling_node(studio_), "mode")
                                                 : ParameterValue(std::string("patch"))));
  follow_mode();
  const WorkObject* object = studio_.active();
  const bool filled = there && object->quality == Quality::Final && object->result && !object->result->failed &&
                      std::any_of(holes_.rows().begin(), holes_.rows().end(),
                                  [](const HoleRow& row) { return row.state == HoleState::Filled; });
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

void HolePanel::follow_way() {
  const HoleInteraction::Way way = holes_.way();
  const std::vector<Index>& chosen = holes_.selected();
  way_of_->setText(chosen.empty()       ? tr("Patches of all holes:")
                   : chosen.size() == 1 ? tr("Patch of hole %1:").arg(chosen.front())
                                        : tr("Patches of holes %1:").arg(numbers_of({chosen.begin(), chosen.end()})));
  show_choice(preset_, holes_.preset());
  show_choice(fairness_, way.fairness);
  show_choice(kernel_, way.kernel);
  kernel_->setEnabled(way.fairness == "rbf" || way.fairness == "auto");
  const QSignalBlocker quiet_slider(bulge_slider_);
  const QSignalBlocker quiet_bulge(bulge_);
  const QSignalBlocker quiet_trim(trim_);
  // While it is held down, the slider leads.
  if (!bulge_slider_->isSliderDown()) bulge_slider_->setValue(static_cast<int>(std::lround(way.bulge * bulge_steps)));
  bulge_->setValue(way.bulge);
  trim_->setValue(way.trim_rim);
}

void HolePanel::follow_mode() {
  const Node* node = filling_node(studio_);
  const WorkObject* object = studio_.active();
  const bool wanted = mode_->currentData() == "remesh" && node != nullptr && object->cage_mesh;
  const bool runs = wanted && std::get<std::string>(filling_value(studio_, *node, "mode")) == "remesh";
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
