// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/panels/attribute_panel.h"

#include <QAction>
#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QFormLayout>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QSignalBlocker>
#include <QSlider>
#include <QSpinBox>
#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>

#include "app/panels/number_box.h"
#include "app/window/language.h"
#include "croquis/base/error.h"
#include "croquis/edits/edit_line.h"
#include "croquis/workspace/computed.h"
#include "croquis/workspace/node_values.h"

namespace croquis::app {
namespace {

/// What it does, and its unit.
QString parameter_help(const ParameterDescription& description) {
  const QString sentence = shown_text(description.sentence);
  if (description.unit.empty()) return sentence;
  return sentence + '\n' + QObject::tr("Unit: %1").arg(shown_text(description.unit));
}

/// Small words under the ends of a slider.
void add_ends(QSlider* slider, QHBoxLayout* row, const std::vector<std::string>& ends) {
  if (ends.empty()) return;
  constexpr double small = 0.8;
  auto* grid = new QGridLayout;
  grid->setVerticalSpacing(0);
  grid->setHorizontalSpacing(2);
  row->removeWidget(slider);
  row->insertLayout(0, grid, 1);
  grid->addWidget(slider, 0, 0, 1, 2);
  for (const int end : {0, 1}) {
    auto* words = new QLabel(shown_text(ends[static_cast<std::size_t>(end)]), slider->parentWidget());
    QFont font = words->font();
    font.setPointSizeF(font.pointSizeF() * small);
    words->setFont(font);
    grid->addWidget(words, 1, end, end == 0 ? Qt::AlignLeft : Qt::AlignRight);
  }
}

/// Puts the widget that people use into the field.
template <class Widget>
Widget* placed_in(ParameterField& field, Widget* widget, const ParameterDescription& description) {
  auto* row = static_cast<QHBoxLayout*>(field.layout());
  if (row == nullptr) {
    row = new QHBoxLayout(&field);
    row->setContentsMargins(0, 0, 0, 4);
  }
  row->addWidget(widget);
  widget->setAccessibleName(parameter_title(description));
  field.setFocusProxy(widget);
  return widget;
}

/// The values of a slider. Over a range of decades it moves by factors: at its left end a weight of 0.001 and one of
/// 0.002 are apart.
struct SliderScale {
  static constexpr int positions = 1000;
  double low, high;
  bool by_factors = low > 0 && high / low >= 100;

  double value_at(int position) const {
    const double part = static_cast<double>(position) / positions;
    return by_factors ? low * std::pow(high / low, part) : low + part * (high - low);
  }
  int position_of(double value) const {
    const double part = by_factors ? std::log(value / low) / std::log(high / low) : (value - low) / (high - low);
    return static_cast<int>(std::lround(part * positions));
  }
};

void place_slider(QSlider* slider, const SliderScale& scale, double value) {
  if (slider == nullptr) return;
  const QSignalBlocker quiet(slider);
  slider->setValue(scale.position_of(value));
}

void make_number(ParameterField& field, const ParameterDescription& description) {
  const SliderScale scale{description.minimum, description.maximum};
  constexpr double widest_range = 1e6;  // beyond this no place of a slider is what people look for
  const bool has_slider = scale.high - scale.low <= widest_range;
  auto* slider = has_slider ? placed_in(field, new QSlider(Qt::Horizontal, &field), description) : nullptr;
  auto* box = placed_in(field, new NumberBox(&field, {scale.low, scale.high, 3}), description);
  share_keys(box);
  if (has_slider) {
    box->setSingleStep((scale.high - scale.low) / 100);
    box->setButtonSymbols(QAbstractSpinBox::NoButtons);  // the slider is for that, and the words need the room
    static_cast<QHBoxLayout*>(field.layout())->setStretchFactor(slider, 1);
    add_ends(slider, static_cast<QHBoxLayout*>(field.layout()), description.choice_titles);
    slider->setRange(0, SliderScale::positions);
    slider->setFocusPolicy(Qt::ClickFocus);  // the Tab key leads to the box beside it
    slider->setToolTip(parameter_help(description));
    QObject::connect(slider, &QSlider::valueChanged, &field, [&field, box, slider, scale](int position) {
      const double value = number_words(scale.value_at(position), 3).toDouble();
      const QSignalBlocker quiet(box);
      box->setValue(value);
      emit field.edited(box->value(), slider->isSliderDown());
    });
    QObject::connect(slider, &QSlider::sliderReleased, &field,
                     [&field, box] { emit field.edited(box->value(), false); });
  } else {
    box->setStepType(QAbstractSpinBox::AdaptiveDecimalStepType);  // no step fits small and large models
  }
  QObject::connect(box, &QDoubleSpinBox::valueChanged, &field, [&field, slider, scale](double value) {
    place_slider(slider, scale, value);
    emit field.edited(value, false);
  });
  field.set_show([&field, box, slider, scale, description](const ParameterValue& value) {
    const QSignalBlocker quiet(box);
    box->show_value(std::get<double>(value), field.note());
    const bool hidden = !field.note().instead.isEmpty() && description.length != ParameterLength::None;
    const QString number = number_words(std::get<double>(value)) + ' ' + shown_text(description.unit);
    box->setToolTip(parameter_help(description) + (hidden ? '\n' + number : QString()));
    // While it is held down, the slider leads.
    if (slider != nullptr && !slider->isSliderDown()) place_slider(slider, scale, std::get<double>(value));
  });
}

void make_integer(ParameterField& field, const ParameterDescription& description) {
  constexpr double limit = 1e9;
  auto* box = placed_in(field, new QSpinBox(&field), description);
  box->setRange(static_cast<int>(std::max(description.minimum, -limit)),
                static_cast<int>(std::min(description.maximum, limit)));
  box->setKeyboardTracking(false);
  if (!description.default_title.empty() &&
      description.default_value == ParameterValue(static_cast<std::int64_t>(box->minimum())))
    box->setSpecialValueText(shown_text(description.default_title));
  share_keys(box);
  QObject::connect(box, &QSpinBox::valueChanged, &field,
                   [&field](int value) { emit field.edited(std::int64_t{value}, false); });
  field.set_show([box](const ParameterValue& value) {
    const QSignalBlocker quiet(box);
    box->setValue(static_cast<int>(std::get<std::int64_t>(value)));
  });
}

void make_choice(ParameterField& field, const ParameterDescription& description) {
  auto* box = placed_in(field, new QComboBox(&field), description);
  const auto& words = description.choice_titles.empty() ? description.choices : description.choice_titles;
  for (std::size_t i = 0; i < description.choices.size(); ++i)
    box->addItem(shown_text(words[i]), QString::fromStdString(description.choices[i]));
  QObject::connect(box, &QComboBox::currentIndexChanged, &field,
                   [&field, box] { emit field.edited(box->currentData().toString().toStdString(), false); });
  field.set_show([box](const ParameterValue& value) {
    const QSignalBlocker quiet(box);
    box->setCurrentIndex(box->findData(QString::fromStdString(std::get<std::string>(value))));
  });
}

void make_flag(ParameterField& field, const ParameterDescription& description) {
  auto* box = placed_in(field, new QCheckBox(&field), description);
  QObject::connect(box, &QCheckBox::toggled, &field, [&field](bool on) { emit field.edited(on, false); });
  field.set_show([box](const ParameterValue& value) {
    const QSignalBlocker quiet(box);
    box->setChecked(std::get<bool>(value));
  });
}

void make_text(ParameterField& field, const ParameterDescription& description) {
  auto* line = placed_in(field, new QLineEdit(&field), description);
  const auto shown = std::make_shared<QString>();
  QObject::connect(line, &QLineEdit::editingFinished, &field, [&field, line, shown] {
    if (std::exchange(*shown, line->text()) != line->text()) emit field.edited(shown->toStdString(), false);
  });
  field.set_show([line, shown](const ParameterValue& value) {
    *shown = QString::fromStdString(to_text(value));
    if (!line->hasFocus() || !line->isModified()) line->setText(*shown);
  });
}

ParameterField* make_parameter_field(const ParameterDescription& description, QWidget* parent) {
  auto* field = new ParameterField(parent);
  switch (description.type) {
    case ParameterType::Number: make_number(*field, description); break;
    case ParameterType::Integer: make_integer(*field, description); break;
    case ParameterType::Choice: make_choice(*field, description); break;
    case ParameterType::Flag: make_flag(*field, description); break;
    case ParameterType::Text:
    case ParameterType::File: make_text(*field, description); break;
  }
  auto* reset = new QAction(QObject::tr("Reset to default"), field);
  QObject::connect(reset, &QAction::triggered, field, [field] { emit field->edited(std::string(), false); });
  for (auto* part : field->findChildren<QWidget*>(QString(), Qt::FindDirectChildrenOnly)) {
    if (qobject_cast<QLineEdit*>(part) != nullptr) continue;  // whose text people delete
    part->addAction(reset);
    part->setContextMenuPolicy(Qt::ActionsContextMenu);
  }
  field->setObjectName(QString::fromStdString(description.name));
  field->setToolTip(parameter_help(description));
  return field;
}

/// What is shown beside the number, or instead of it.
NumberNote note_of(const Studio& studio, const Node& node, const ParameterDescription& parameter,
                   const ParameterValue& value) {
  NumberNote note{{}, length_of_one(studio, node, parameter), {}};
  const bool is_length = note.length > 0 || parameter.length == ParameterLength::Model;
  if (is_length) note.unit = QString::fromStdString(studio.unit());
  const bool is_given = node.parameters.contains(parameter.name);
  if (!parameter.default_title.empty() && value == parameter.default_value)
    note.instead = shown_text(parameter.default_title);
  else if (parameter.length > ParameterLength::Model && !is_given)
    note.instead = QObject::tr("auto");
  return note;
}

constexpr std::size_t longest_unit = 8;  ///< longer ones are in the help, so that titles stay short
constexpr int least_width = 52;          // three of them beside their title
constexpr double farthest = 1e12;

bool lists_edits(const OperationDescription& operation, const ParameterDescription& parameter) {
  return operation.edits_input && operation.edits_input->lines == parameter.name;
}

}  // namespace

ParameterField* add_parameter_row(QFormLayout& form, const ParameterDescription& description,
                                  std::function<void(const ParameterValue& value, bool dragging)> take) {
  ParameterField* field = make_parameter_field(description, form.parentWidget());
  QObject::connect(field, &ParameterField::edited, form.parentWidget(), std::move(take));
  auto* label = new QLabel(parameter_title(description), form.parentWidget());
  label->setToolTip(parameter_help(description));
  label->setBuddy(field);
  form.addRow(label, field);
  return field;
}

QString parameter_title(const ParameterDescription& description) {
  QString title = shown_text(title_of(description));
  const bool is_short = description.unit.size() <= longest_unit;
  if (description.unit == "degrees") return title + " (°)";
  if (!description.unit.empty() && is_short) title += " (" + shown_text(description.unit) + ")";
  return title;
}

PlacementFields::PlacementFields(QWidget* parent) : QWidget(parent), evenly_(new QCheckBox(tr("Keep proportions"))) {
  setObjectName("placement");
  auto* grid = new QGridLayout(this);
  grid->setVerticalSpacing(3);
  grid->setHorizontalSpacing(2);
  const std::array names{"position", "rotation", "size"};
  const std::array titles{tr("Position"), tr("Rotation"), tr("Size")};
  const std::array tips{tr("Where the middle of its box is: x, y, z"),
                        tr("Degrees about x, then y, then z, around its middle"),
                        tr("How far it reaches along its own x, y and z")};
  for (int row = 0; row < 3; ++row) {
    const auto at = static_cast<std::size_t>(row);
    labels_[at] = new QLabel(this);
    labels_[at]->setToolTip(tips[at]);
    grid->addWidget(labels_[at], row, 0);
    for (int axis = 0; axis < 3; ++axis) {
      const QString name = QString("%1-%2").arg(names[at]).arg(QChar('x' + axis));
      QDoubleSpinBox* box = make_number_box(this, name, {-farthest, farthest, 2});
      box->setMinimumWidth(least_width);
      box->setAccessibleName(QStringLiteral("%1 %2").arg(titles[at]).arg(QChar('x' + axis)));
      box->setButtonSymbols(QAbstractSpinBox::NoButtons);
      share_keys(box);
      connect(box, &QDoubleSpinBox::valueChanged, this,
              [this, row, axis](double value) { edit(static_cast<Row>(row), axis, value); });
      boxes_[at][static_cast<std::size_t>(axis)] = box;
      grid->addWidget(box, row, 1 + axis);
    }
  }
  evenly_->setObjectName("size-evenly");
  evenly_->setToolTip(tr("A size along one axis changes the others by the same factor"));
  grid->addWidget(evenly_, 3, 1, 1, 3);
}

Vec3 PlacementFields::shown_in(Row row) const {
  if (row == Position) return placement_.map()((box_[0] + box_[1]) / 2);
  return row == Rotation ? placement_.rotation : Vec3(placement_.scale.cwiseProduct(box_[1] - box_[0]));
}

void PlacementFields::follow(const Studio& studio) {
  const WorkObject* object = studio.active();
  const BoundingBox box = object == nullptr ? std::nullopt : studio.own_bounds(*object);
  setVisible(box.has_value());
  if (!box) return;
  object_ = object->node;
  placement_ = object->placement;
  box_ = *box;
  const QString unit = QString::fromStdString(studio.unit());
  labels_[Position]->setText(unit.isEmpty() ? tr("Position") : tr("Position, %1").arg(unit));
  labels_[Rotation]->setText(tr("Rotation, °"));
  labels_[Size]->setText(unit.isEmpty() ? tr("Size") : tr("Size, %1").arg(unit));
  // Of a place, a ten-thousandth of the size is as much as anybody reads.
  const double step = std::pow(10.0, std::floor(std::log10(std::max(shown_in(Size).norm(), 1e-9))) - 4);
  for (const Row row : {Position, Rotation, Size}) {
    Vec3 numbers = shown_in(row);
    if (row == Position) numbers = step * (numbers / step).array().round();
    for (int axis = 0; axis < 3; ++axis) {
      QDoubleSpinBox* field = boxes_[row][static_cast<std::size_t>(axis)];
      const QSignalBlocker quiet(field);
      field->setValue(numbers(axis));
      field->setEnabled(row != Size || numbers(axis) > 0);
    }
  }
}

void PlacementFields::edit(Row row, int axis, double value) {
  Placement changed = placement_;
  const Vec3 middle = (box_[0] + box_[1]) / 2;
  if (row == Position) {
    changed.position(axis) += value - shown_in(Position)(axis);
  } else if (row == Rotation) {
    changed.rotation(axis) = value;
  } else if (value > 0) {
    const double factor = value / shown_in(Size)(axis);
    for (int k = 0; k < 3; ++k) {
      if (evenly_->isChecked() && k != axis) changed.scale(k) *= factor;
    }
    changed.scale(axis) = value / (box_[1] - box_[0])(axis);
  }
  if (row != Position) changed = with_point_kept(changed, placement_, middle);
  emit placed(object_, changed);
}

AttributePanel::AttributePanel(QWidget* parent) : QWidget(parent), layout_(new QFormLayout(this)) {
  setObjectName("attributes");
  layout_->setRowWrapPolicy(QFormLayout::WrapLongRows);
  layout_->setVerticalSpacing(3);
  layout_->setFieldGrowthPolicy(QFormLayout::AllNonFixedFieldsGrow);
}

void AttributePanel::show_node(const Studio& studio, const Node* node) {
  const OperationDescription* description = node == nullptr ? nullptr : studio.description(node->operation);
  if (description == nullptr) {
    node_ = 0;
    clear();
    return;
  }
  node_ = node->id;
  if (description->id != operation_) make_fields(*description);
  const ParameterValues values = values_of(*node, *description);
  for (const ParameterDescription& parameter : description->parameters) {
    const auto shown = fields_.find(parameter.name);
    const ParameterValue& value = values.at(parameter.name);
    if (shown != fields_.end()) shown->second->show_value(value, note_of(studio, *node, parameter, value));
    if (lists_edits(*description, parameter)) show_edits(to_text(values.at(parameter.name)));
  }
}

/// Lines that can't be read are named in Findings.
void AttributePanel::show_edits(const std::string& lines) {
  if (std::exchange(shown_edits_, lines) == lines) return;
  edits_->clear();
  try {
    for (const EditLine& line : parse_edit_lines(lines)) {
      edits_->addItem(localized(label_of(line, std::string("all ") + plural(line.target.kind))));
    }
  } catch (const Error&) {
    edits_->addItem(tr("The edits can't be read"));
  }
}

ParameterField* AttributePanel::field(const std::string& parameter) const {
  const auto found = fields_.find(parameter);
  return found == fields_.end() ? nullptr : found->second;
}

void AttributePanel::show_parameter(const std::string& parameter) {
  ParameterField* wanted = field(parameter);
  if (wanted == nullptr) return;
  if (auto* all = findChild<QCheckBox*>("expert"); all != nullptr && wanted->isHidden()) all->setChecked(true);
  for (QWidget* part : wanted->findChildren<QWidget*>(QString(), Qt::FindDirectChildrenOnly)) {
    if (part->focusPolicy() != Qt::NoFocus) return part->setFocus(Qt::ShortcutFocusReason);
  }
}

void AttributePanel::clear() {
  while (layout_->rowCount() > 0) layout_->removeRow(0);
  fields_.clear();
  operation_.clear();
  shown_edits_.clear();
}

void AttributePanel::make_fields(const OperationDescription& description) {
  clear();
  operation_ = description.id;
  std::vector<QWidget*> expert;
  for (const ParameterDescription& parameter : description.parameters) {
    if (lists_edits(description, parameter)) {
      edits_ = new QListWidget(this);
      edits_->setObjectName("edit-lines");
      layout_->addRow(edits_);
      continue;
    }
    // The flag is for hosts that only want the list.
    if (parameter.place == ParameterPlace::Nowhere || parameter.name == description.list_flag) continue;
    ParameterField* field =
        add_parameter_row(*layout_, parameter, [this, name = parameter.name](const ParameterValue& value, bool drag) {
          emit parameter_edited(node_, name, value, drag);
        });
    fields_[parameter.name] = field;
    if (parameter.place == ParameterPlace::Expert) expert.push_back(field);
  }
  if (expert.empty()) return;
  auto* all = new QCheckBox(tr("Expert"), this);
  all->setObjectName("expert");
  all->setToolTip(tr("Shows everything that can be set"));
  layout_->addRow(all);
  connect(all, &QCheckBox::toggled, this, [this, expert](bool on) {
    shows_all_ = on;
    for (QWidget* field : expert) layout_->setRowVisible(field, on);
  });
  all->setChecked(shows_all_);
  if (!shows_all_) emit all->toggled(false);
}

}  // namespace croquis::app
