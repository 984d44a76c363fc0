// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <QWidget>

#include "croquis/base/parameter.h"

namespace croquis::app {

/// The widget of one parameter. Which kind it is follows from the description's type: a slider beside a number, a
/// number alone where there is no range, a list of choices, a check box, a line of text.
class ParameterField : public QWidget {
  Q_OBJECT

 public:
  using QWidget::QWidget;

  /// Shows a value without a signal.
  virtual void show_value(const ParameterValue& value) = 0;

 signals:
  void edited(const croquis::ParameterValue& value, bool dragging);
};

/// Its object name is the parameter's name.
ParameterField* make_parameter_field(const ParameterDescription& description, QWidget* parent);

/// "Smooth arcs (unit)"; of a parameter without a title "Weight curvature (unit)".
QString parameter_title(const ParameterDescription& description);

}  // namespace croquis::app
