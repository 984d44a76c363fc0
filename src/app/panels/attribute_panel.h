// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>
#include <map>
#include <string>

#include "croquis/base/parameter.h"
#include "croquis/document/document.h"
#include "croquis/document/operation.h"

class QFormLayout;
class QListWidget;

namespace croquis::app {

class ParameterField;

/// Fields for the parameters of a node, made from its operation's description alone; those for experts where people ask
/// for them.
class AttributePanel : public QWidget {
  Q_OBJECT

 public:
  explicit AttributePanel(QWidget* parent = nullptr);

  /// Shows the node's parameters; fields are replaced only when the operation is another one. Null shows none.
  void show_node(const Node* node, const OperationDescription* description);

  /// The field of a parameter, or null: for callers that know it by name.
  ParameterField* field(const std::string& parameter) const;

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
