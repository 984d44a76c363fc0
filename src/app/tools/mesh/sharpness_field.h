// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QDoubleSpinBox>

namespace croquis::app {

/// A sharpness: 0 for none … 10, whose last step is infinite.
class SharpnessField : public QDoubleSpinBox {
  Q_OBJECT

 public:
  explicit SharpnessField(QWidget* parent);

  void show_sharpness(double sharpness);  ///< without a signal
  double sharpness() const;               ///< infinite at its end

 protected:
  QString textFromValue(double value) const override;
  double valueFromText(const QString& text) const override;
  QValidator::State validate(QString& text, int& position) const override;
};

}  // namespace croquis::app
