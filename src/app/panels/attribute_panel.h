// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <QWidget>
#include <array>
#include <functional>
#include <map>
#include <string>

#include "app/panels/number_box.h"
#include "app/studio/studio.h"
#include "croquis/base/parameter.h"
#include "croquis/document/document.h"
#include "croquis/document/operation.h"

class QCheckBox;
class QDoubleSpinBox;
class QFormLayout;
class QLabel;
class QListWidget;

namespace croquis::app {

/// The widget of one parameter. Which kind it is follows from the description's type: a slider beside a number, a
/// number alone where there is no range, a list of choices, a check box, a line of text.
class ParameterField : public QWidget {
  Q_OBJECT

 public:
  using QWidget::QWidget;

  /// Shows a value without a signal.
  void show_value(const ParameterValue& value, const NumberNote& note = {}) {
    note_ = note;
    show_(value);
  }
  const NumberNote& note() const { return note_; }  ///< of a number that is being shown
  void set_show(std::function<void(const ParameterValue& value)> show) { show_ = std::move(show); }

 signals:
  /// An empty text leaves a parameter of any type to the program again.
  void edited(const croquis::ParameterValue& value, bool dragging);

 private:
  NumberNote note_;
  std::function<void(const ParameterValue& value)> show_;
};

/// Adds a row to a form: the parameter's title and its field, which is called by the parameter's name.
/// @param take what people set, as ParameterField::edited says it
ParameterField* add_parameter_row(QFormLayout& form, const ParameterDescription& description,
                                  std::function<void(const ParameterValue& value, bool dragging)> take);

/// "Smooth arcs", with its unit where that is a short word; of a parameter without a title "Weight curvature".
QString parameter_title(const ParameterDescription& description);

/// Where the active object stands, as numbers: the middle of its box, its rotation in degrees, and its size along its
/// own axes.
class PlacementFields : public QWidget {
  Q_OBJECT

 public:
  explicit PlacementFields(QWidget* parent = nullptr);

  /// Of the active object; hidden without one that has a mesh.
  void follow(const Studio& studio);

 signals:
  /// People gave a number another value.
  void placed(croquis::NodeId object, const croquis::Placement& placement);

 private:
  enum Row { Position, Rotation, Size };

  void edit(Row row, int axis, double value);
  Vec3 shown_in(Row row) const;

  NodeId object_ = 0;
  Placement placement_;
  std::array<Vec3, 2> box_{};  ///< in the object's own space
  std::array<std::array<QDoubleSpinBox*, 3>, 3> boxes_{};
  std::array<QLabel*, 3> labels_{};
  QCheckBox* evenly_;
};

/// Fields for the parameters of a node, made from its operation's description alone; those for experts where people ask
/// for them.
class AttributePanel : public QWidget {
  Q_OBJECT

 public:
  explicit AttributePanel(QWidget* parent = nullptr);

  /// Shows the node's parameters; fields are replaced only when the operation is another one. Null shows none.
  void show_node(const Studio& studio, const Node* node);

  /// The field of a parameter, or null: for callers that know it by name.
  ParameterField* field(const std::string& parameter) const;

  /// Puts the keyboard into the field of a parameter, which may be one for experts.
  void show_parameter(const std::string& parameter);

 signals:
  /// The user gave a parameter another value. While a slider is held down, `dragging` is true; the last call of a drag
  /// has it false.
  void parameter_edited(croquis::NodeId node, const std::string& parameter, const croquis::ParameterValue& value,
                        bool dragging);

 private:
  void clear();
  void make_fields(const OperationDescription& description);
  void show_edits(const std::string& lines);

  NodeId node_ = 0;
  std::string operation_;
  QFormLayout* layout_;
  std::map<std::string, ParameterField*> fields_;
  QListWidget* edits_ = nullptr;  ///< what was done, in words
  std::string shown_edits_;
  bool shows_all_ = false;  ///< also what is for experts
};

}  // namespace croquis::app
