// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/panels/parameter_field.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QHBoxLayout>
#include <QLineEdit>
#include <QSignalBlocker>
#include <QSlider>
#include <QSpinBox>
#include <cmath>

#include "app/panels/number_box.h"
#include "app/panels/number_keys.h"

namespace croquis::app {
namespace {

QHBoxLayout* tight_row(QWidget* owner) {
  auto* row = new QHBoxLayout(owner);
  row->setContentsMargins(0, 0, 0, 4);
  return row;
}

/// A slider over a range of decades moves by factors: at its left end a weight of 0.001 and one of 0.002 are apart.
class NumberField : public ParameterField {
 public:
  NumberField(const ParameterDescription& description, QWidget* parent)
      : ParameterField(parent),
        low_(description.minimum),
        high_(description.maximum),
        by_factors_(low_ > 0 && high_ / low_ >= 100),
        box_(new NumberBox(this, {low_, high_, 3})) {
    QHBoxLayout* row = tight_row(this);
    if (std::isfinite(high_ - low_)) {
      box_->setSingleStep((high_ - low_) / 100);
    } else {
      box_->setStepType(QAbstractSpinBox::AdaptiveDecimalStepType);  // no step fits small and large models
    }
    box_->setAccessibleName(parameter_title(description));
    share_keys(box_);
    if (std::isfinite(high_ - low_)) row->addWidget(make_slider(description), 1);
    row->addWidget(box_);
    setFocusProxy(box_);
    connect(box_, &QDoubleSpinBox::valueChanged, this, [this](double value) {
      place_slider(value);
      emit edited(value, false);
    });
  }

  void show_value(const ParameterValue& value) override {
    const QSignalBlocker quiet(box_);
    box_->setValue(std::get<double>(value));
    // While it is held down, the slider leads.
    if (slider_ != nullptr && !slider_->isSliderDown()) place_slider(std::get<double>(value));
  }

 private:
  static constexpr int positions = 1000;

  QSlider* make_slider(const ParameterDescription& description) {
    slider_ = new QSlider(Qt::Horizontal, this);
    slider_->setRange(0, positions);
    slider_->setAccessibleName(parameter_title(description));
    slider_->setToolTip(QString::fromStdString(description.sentence));
    connect(slider_, &QSlider::valueChanged, this, [this](int position) {
      const double value = number_words(value_at(position), 3).toDouble();
      const QSignalBlocker quiet(box_);
      box_->setValue(value);
      emit edited(box_->value(), slider_->isSliderDown());
    });
    connect(slider_, &QSlider::sliderReleased, this, [this] { emit edited(box_->value(), false); });
    return slider_;
  }

  double value_at(int position) const {
    const double part = static_cast<double>(position) / positions;
    return by_factors_ ? low_ * std::pow(high_ / low_, part) : low_ + part * (high_ - low_);
  }

  void place_slider(double value) {
    if (slider_ == nullptr) return;
    const double part = by_factors_ ? std::log(value / low_) / std::log(high_ / low_) : (value - low_) / (high_ - low_);
    const QSignalBlocker quiet(slider_);
    slider_->setValue(static_cast<int>(std::lround(part * positions)));
  }

  double low_, high_;
  bool by_factors_;
  QDoubleSpinBox* box_;
  QSlider* slider_ = nullptr;
};

class IntegerField : public ParameterField {
 public:
  IntegerField(const ParameterDescription& description, QWidget* parent)
      : ParameterField(parent), box_(new QSpinBox(this)) {
    tight_row(this)->addWidget(box_);
    constexpr double limit = 1e9;
    box_->setRange(static_cast<int>(std::max(description.minimum, -limit)),
                   static_cast<int>(std::min(description.maximum, limit)));
    box_->setKeyboardTracking(false);
    box_->setAccessibleName(parameter_title(description));
    share_keys(box_);
    setFocusProxy(box_);
    connect(box_, &QSpinBox::valueChanged, this, [this](int value) { emit edited(std::int64_t{value}, false); });
  }

  void show_value(const ParameterValue& value) override {
    const QSignalBlocker quiet(box_);
    box_->setValue(static_cast<int>(std::get<std::int64_t>(value)));
  }

 private:
  QSpinBox* box_;
};

class ChoiceField : public ParameterField {
 public:
  ChoiceField(const ParameterDescription& description, QWidget* parent)
      : ParameterField(parent), box_(new QComboBox(this)) {
    tight_row(this)->addWidget(box_);
    for (std::size_t i = 0; i < description.choices.size(); ++i) {
      const auto& words = description.choice_titles.empty() ? description.choices : description.choice_titles;
      box_->addItem(QString::fromStdString(words[i]), QString::fromStdString(description.choices[i]));
    }
    box_->setAccessibleName(parameter_title(description));
    setFocusProxy(box_);
    connect(box_, &QComboBox::currentIndexChanged, this,
            [this] { emit edited(box_->currentData().toString().toStdString(), false); });
  }

  void show_value(const ParameterValue& value) override {
    const QSignalBlocker quiet(box_);
    box_->setCurrentIndex(box_->findData(QString::fromStdString(std::get<std::string>(value))));
  }

 private:
  QComboBox* box_;
};

class FlagField : public ParameterField {
 public:
  FlagField(const ParameterDescription& description, QWidget* parent)
      : ParameterField(parent), box_(new QCheckBox(this)) {
    tight_row(this)->addWidget(box_);
    box_->setAccessibleName(parameter_title(description));
    setFocusProxy(box_);
    connect(box_, &QCheckBox::toggled, this, [this](bool on) { emit edited(on, false); });
  }

  void show_value(const ParameterValue& value) override {
    const QSignalBlocker quiet(box_);
    box_->setChecked(std::get<bool>(value));
  }

 private:
  QCheckBox* box_;
};

class TextField : public ParameterField {
 public:
  TextField(const ParameterDescription& description, QWidget* parent)
      : ParameterField(parent), line_(new QLineEdit(this)) {
    tight_row(this)->addWidget(line_);
    line_->setAccessibleName(parameter_title(description));
    setFocusProxy(line_);
    connect(line_, &QLineEdit::editingFinished, this, [this] {
      if (line_->text() == shown_) return;
      shown_ = line_->text();
      emit edited(shown_.toStdString(), false);
    });
  }

  void show_value(const ParameterValue& value) override {
    shown_ = QString::fromStdString(to_text(value));
    if (!line_->hasFocus() || !line_->isModified()) line_->setText(shown_);
  }

 private:
  QLineEdit* line_;
  QString shown_;
};

}  // namespace

ParameterField* make_parameter_field(const ParameterDescription& description, QWidget* parent) {
  ParameterField* field = nullptr;
  switch (description.type) {
    case ParameterType::Number: field = new NumberField(description, parent); break;
    case ParameterType::Integer: field = new IntegerField(description, parent); break;
    case ParameterType::Choice: field = new ChoiceField(description, parent); break;
    case ParameterType::Flag: field = new FlagField(description, parent); break;
    case ParameterType::Text:
    case ParameterType::File: field = new TextField(description, parent); break;
  }
  field->setObjectName(QString::fromStdString(description.name));
  field->setToolTip(QString::fromStdString(description.sentence));
  return field;
}

QString parameter_title(const ParameterDescription& description) {
  QString title = QString::fromStdString(title_of(description));
  if (!description.unit.empty()) title += " (" + QString::fromStdString(description.unit) + ")";
  return title;
}

}  // namespace croquis::app
