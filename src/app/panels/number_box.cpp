// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/panels/number_box.h"

#include <QAbstractSpinBox>
#include <QEvent>
#include <QKeyEvent>
#include <QLineEdit>
#include <algorithm>
#include <array>
#include <cmath>

namespace croquis::app {
namespace {

constexpr int kept_decimals = 15;  // of values; what is shown of them is another matter
constexpr int least_figures = 4;
constexpr int most_figures = 15;  // beyond these the digits are chance

/// Places before the decimal point; 0 and less for numbers below 1.
int places_before_point(double value) {
  return value == 0 ? 1 : static_cast<int>(std::floor(std::log10(std::abs(value)))) + 1;
}

class KeySharer : public QObject {
 public:
  explicit KeySharer(QAbstractSpinBox* field) : QObject(field), line_(field->findChild<QLineEdit*>()) {
    field->installEventFilter(this);
    connect(field, &QAbstractSpinBox::editingFinished, this, [this] { line_->setModified(false); });
  }

  bool eventFilter(QObject* field, QEvent* event) override {
    if (event->type() != QEvent::ShortcutOverride) return QObject::eventFilter(field, event);
    const auto* key = static_cast<QKeyEvent*>(event);
    if (!is_command(*key) && (!is_history(*key) || line_->isModified())) return QObject::eventFilter(field, event);
    event->ignore();
    return true;
  }

 private:
  /// A letter, or one with Ctrl that isn't for the clipboard or the history: fields know Ctrl+E as the end of a line.
  static bool is_command(const QKeyEvent& key) {
    if (key.key() < Qt::Key_A || key.key() > Qt::Key_Z) return false;
    if (!key.modifiers().testFlag(Qt::ControlModifier)) return !key.modifiers().testFlag(Qt::AltModifier);
    constexpr std::array own{Qt::Key_A, Qt::Key_C, Qt::Key_V, Qt::Key_X, Qt::Key_Y, Qt::Key_Z};
    return std::ranges::find(own, key.key()) == own.end();
  }
  static bool is_history(const QKeyEvent& key) {
    return key.modifiers().testFlag(Qt::ControlModifier) && (key.key() == Qt::Key_Z || key.key() == Qt::Key_Y);
  }

  QLineEdit* line_;
};

}  // namespace

QString number_words(double value, int figures) {
  constexpr int smallest_places = -6;
  constexpr int most_places = 9;
  const int places = places_before_point(value);
  if (!std::isfinite(value) || places < smallest_places || places > most_places)
    return QString::number(value, 'g', figures);
  QString text = QString::number(value, 'f', std::max(figures - places, 0));
  if (!text.contains('.')) return text;
  while (text.endsWith('0')) text.chop(1);
  if (text.endsWith('.')) text.chop(1);
  return text == QStringLiteral("-0") ? QStringLiteral("0") : text;
}

NumberBox::NumberBox(QWidget* parent, const NumberRange& range)
    : QDoubleSpinBox(parent), shown_decimals_(range.decimals) {
  setLocale(QLocale::c());
  setDecimals(kept_decimals);
  setRange(range.low, range.high);
  setKeyboardTracking(false);
  setMinimumWidth(number_box_width);
}

QString NumberBox::textFromValue(double value) const {
  const int figures = std::clamp(places_before_point(value) + shown_decimals_, least_figures, most_figures);
  const bool instead = !note_.instead.isEmpty() && value == noted_;
  const QString words = instead ? note_.instead : number_words(value, figures);
  const QString unit = note_.unit.isEmpty() ? QString() : ' ' + note_.unit;
  if (note_.length <= 0) return instead ? words : words + unit;
  return words + QStringLiteral(" (%1%2)").arg(number_words(value * note_.length, 2), unit);
}

void NumberBox::show_value(double value, const NumberNote& note) {
  note_ = note;
  setValue(value);
  noted_ = this->value();  // which is rounded
  setValue(noted_);
  constexpr int margins = 16;
  const int needed = fontMetrics().horizontalAdvance(textFromValue(noted_)) + margins;
  if (needed > minimumWidth()) setMinimumWidth(needed);
}

/// The number that is shown may have fewer digits than the one that is kept.
double NumberBox::valueFromText(const QString& text) const {
  QString number = text;
  if (!suffix().isEmpty() && number.endsWith(suffix())) number.chop(suffix().size());
  number = number.mid(number.startsWith(prefix()) ? prefix().size() : 0).trimmed();
  if (number == textFromValue(value())) return value();
  number = number.section(' ', 0, 0);  // the length behind it stays
  bool read = false;
  const double value = number.toDouble(&read);
  return read ? value : this->value();
}

QValidator::State NumberBox::validate(QString& text, int& position) const {
  text.replace(',', '.');
  if (text == textFromValue(value())) return QValidator::Acceptable;
  // A part of a note is left where people delete some of it; the number before it counts.
  const bool noted = !note_.instead.isEmpty() || !note_.unit.isEmpty() || note_.length > 0;
  if (!noted && !text.contains('e', Qt::CaseInsensitive)) return QDoubleSpinBox::validate(text, position);
  bool read = false;
  const double typed = (noted ? text.section(' ', 0, 0) : text).toDouble(&read);
  return read && typed >= minimum() && typed <= maximum() ? QValidator::Acceptable : QValidator::Intermediate;
}

/// From 0 no share of the value is a step.
void NumberBox::stepBy(int steps) {
  if (stepType() != AdaptiveDecimalStepType || value() != 0) return QDoubleSpinBox::stepBy(steps);
  setValue(steps * std::pow(10, -shown_decimals_));
}

QDoubleSpinBox* make_number_box(QWidget* parent, const QString& name, const NumberRange& range) {
  auto* box = new NumberBox(parent, range);
  box->setObjectName(name);
  return box;
}

void share_keys(QAbstractSpinBox* field) { new KeySharer(field); }

}  // namespace croquis::app
