// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/tools/mesh/sharpness_field.h"

#include <QSignalBlocker>
#include <algorithm>

#include "croquis/geometry/mesh_tags.h"

namespace croquis::app {
namespace {

const QString infinity_sign = QStringLiteral("∞");

bool means_infinity(const QString& text) {
  return text.trimmed() == infinity_sign || text.trimmed().compare("inf", Qt::CaseInsensitive) == 0;
}

}  // namespace

SharpnessField::SharpnessField(QWidget* parent) : QDoubleSpinBox(parent) {
  setRange(0, greatest_sharpness);
  setSingleStep(0.5);
  setDecimals(2);
  setKeyboardTracking(false);
  setAccessibleName(tr("Sharpness"));
}

void SharpnessField::show_sharpness(double sharpness) {
  const QSignalBlocker quiet(this);
  setValue(std::min(sharpness, greatest_sharpness));
}

double SharpnessField::sharpness() const { return value() >= greatest_sharpness ? infinite_sharpness : value(); }

QString SharpnessField::textFromValue(double value) const {
  return value >= greatest_sharpness ? infinity_sign : QDoubleSpinBox::textFromValue(value);
}

double SharpnessField::valueFromText(const QString& text) const {
  return means_infinity(text) ? greatest_sharpness : QDoubleSpinBox::valueFromText(text);
}

QValidator::State SharpnessField::validate(QString& text, int& position) const {
  if (means_infinity(text)) return QValidator::Acceptable;
  if (QStringLiteral("inf").startsWith(text.trimmed().toLower())) return QValidator::Intermediate;
  return QDoubleSpinBox::validate(text, position);
}

}  // namespace croquis::app
