// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QDoubleSpinBox>
#include <QWidget>
#include <functional>
#include <map>
#include <string>

#include "croquis/base/parameter.h"
#include "croquis/edits/edit.h"
#include "croquis/session/session.h"

class QDockWidget;
class QDoubleSpinBox;
class QFormLayout;
class QLabel;
class QPushButton;
class QSlider;
class QTreeWidget;

namespace croquis::app {

class MeshEditingTool;
class PanelDocks;

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

/// Sharpness of what is selected as a number, and edges chosen by their angle with their count while one drags.
class TagPanel : public QWidget {
  Q_OBJECT

 public:
  TagPanel(MeshEditingTool& mesh, QWidget* parent);

  /// After the document or the selection has changed.
  void follow(const ComponentSelection& selection);

  /// Chooses the edges whose faces meet at a greater angle. @param degrees 0..180
  void choose_by_angle(double degrees);

 private:
  QWidget* make_angle_row();

  MeshEditingTool& mesh_;
  QLabel* selected_;
  SharpnessField* sharpness_;
  QSlider* angle_slider_;
  QDoubleSpinBox* angle_;
  QLabel* count_;
};

/// The named sets of tagged edges and pins of the mesh that is worked on: made from the selection, renamed, given a
/// sharpness, selected, merged, removed.
class CreaseSetPanel : public QWidget {
  Q_OBJECT

 public:
  CreaseSetPanel(MeshEditingTool& mesh, QWidget* parent);

  /// After the document or the selection has changed.
  void follow();

 private:
  QWidget* make_buttons();
  QPushButton* add_button(QWidget* row, const QString& name, const QString& text, const QString& tip,
                          std::function<void()> work);
  std::string chosen() const;  ///< the name of the first chosen set; empty for none
  void merge();

  MeshEditingTool& mesh_;
  QTreeWidget* sets_;
  SharpnessField* sharpness_;
};

class ParameterField;

/// The last edit with its parameters, as fields made from its description: a change applies it again instead of what
/// it was.
class EditPanel : public QWidget {
  Q_OBJECT

 public:
  EditPanel(MeshEditingTool& mesh, QWidget* parent);

  /// After the document or the selection has changed.
  void follow();

  /// Whether the newest change is an edit with parameters.
  bool useful() const;

 private:
  void make_fields(const EditDescription& edit);
  void adjust(const std::string& parameter, const ParameterValue& value);

  MeshEditingTool& mesh_;
  QFormLayout* layout_;
  QLabel* title_;
  std::string edit_;  ///< that the fields are of
  std::map<std::string, ParameterField*> fields_;
};

/// All of them, in their docks.
class MeshPanels {
 public:
  MeshPanels(MeshEditingTool& mesh, PanelDocks& docks);

  /// After the document or the selection has changed. @param useful there is a mesh to be worked on
  void follow(const ComponentSelection& selection, bool useful);
  void show_last_edit();

 private:
  PanelDocks& docks_;
  TagPanel* tags_;
  CreaseSetPanel* sets_;
  EditPanel* last_edit_;
  QDockWidget* edges_dock_;
  QDockWidget* sets_dock_;
  QDockWidget* last_edit_dock_;
};

}  // namespace croquis::app
