// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QDoubleSpinBox>
#include <QString>

class QAbstractSpinBox;

namespace croquis::app {

constexpr int number_box_width = 62;  ///< logical pixels, the least; not that of the longest number

/// A number with the digits that it needs and no more than these: 0.0005, 164.6, 2, 1e-07.
/// @param figures that count, at least 1
QString number_words(double value, int figures = 4);

/// How many there are: one in words of its own ("1 edge"), or many ("%1 edges").
inline QString counted_words(std::size_t count, const QString& one, const QString& many) {
  return count == 1 ? one : many.arg(count);
}

/// The numbers that people may type.
struct NumberRange {
  double low = 0;
  double high = 1;   ///< >= low
  int decimals = 2;  ///< of numbers of usual size; smaller ones keep four figures
};

/// How a value reads beside its number.
struct NumberNote {
  QString instead = {};  ///< of the number: "auto", "no limit"; empty: the number
  double length = 0;     ///< that 1 comes to, model units; 0: that isn't known, or is no other number
  QString unit = {};     ///< of lengths: "mm", or empty
};

/// A box for numbers of any size, as number_words shows them.
class NumberBox : public QDoubleSpinBox {
 public:
  NumberBox(QWidget* parent, const NumberRange& range);

  QString textFromValue(double value) const override;
  double valueFromText(const QString& text) const override;
  QValidator::State validate(QString& text, int& position) const override;
  void stepBy(int steps) override;

  /// Shows a value as "0.2 (2.4 mm)", "auto (2.4 mm)", "no limit". The note stays when people give another value.
  void show_value(double value, const NumberNote& note);

 private:
  NumberNote note_;
  double noted_ = 0;  ///< the value that `instead` is for
  int shown_decimals_;
};

/// A box for a number in a panel. It reports its value when the typing is done, not with every digit.
/// @param parent owns it
/// @param name   of the object, by which tests and recordings find it
QDoubleSpinBox* make_number_box(QWidget* parent, const QString& name, const NumberRange& range);

/// Lets the window have the keys that a field of numbers has no use for: letters, which choose tools, Ctrl with letters
/// that aren't the clipboard's, and undo and redo unless something is being typed. Without this they would have no
/// effect once a field had been clicked.
void share_keys(QAbstractSpinBox* field);

}  // namespace croquis::app
