// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>
#include <map>
#include <string>

#include "app/tools/mesh/mesh_interaction.h"

class QFormLayout;
class QLabel;

namespace croquis::app {

class ParameterField;

/// The last edit with its parameters, as fields made from its description: a change applies it again instead of what
/// it was.
class EditPanel : public QWidget {
  Q_OBJECT

 public:
  EditPanel(MeshInteraction& mesh, QWidget* parent);

  /// After the document or the selection has changed.
  void follow();

  /// Whether the newest change is an edit with parameters.
  bool useful() const;

 private:
  void make_fields(const EditDescription& edit);
  void adjust(const std::string& parameter, const ParameterValue& value);

  MeshInteraction& mesh_;
  QFormLayout* layout_;
  QLabel* title_;
  std::string edit_;  ///< that the fields are of
  std::map<std::string, ParameterField*> fields_;
};

}  // namespace croquis::app
