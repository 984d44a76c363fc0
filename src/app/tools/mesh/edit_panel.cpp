// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/tools/mesh/edit_panel.h"

#include <QFormLayout>
#include <QLabel>

#include "app/panels/parameter_field.h"

namespace croquis::app {

EditPanel::EditPanel(MeshInteraction& mesh, QWidget* parent)
    : QWidget(parent), mesh_(mesh), layout_(new QFormLayout(this)), title_(new QLabel(this)) {
  setObjectName("last-edit");
  title_->setObjectName("last-edit-title");
  layout_->setContentsMargins(6, 4, 6, 2);
  layout_->setVerticalSpacing(3);
  layout_->addRow(title_);
}

bool EditPanel::useful() const {
  const EditLine* line = mesh_.tool().edits().last();
  return line != nullptr && !all_edits().find(line->edit)->describe().parameters.empty();
}

void EditPanel::follow() {
  if (!useful()) return;
  const EditLine& line = *mesh_.tool().edits().last();
  const EditDescription edit = all_edits().find(line.edit)->describe();
  if (edit.id != edit_) make_fields(edit);
  title_->setText(QString::fromStdString(mesh_.tool().edits().label_of(line)));
  for (const auto& [name, value] : complete(edit.parameters, line.parameters)) fields_.at(name)->show_value(value);
}

void EditPanel::make_fields(const EditDescription& edit) {
  while (layout_->rowCount() > 1) layout_->removeRow(1);
  fields_.clear();
  edit_ = edit.id;
  for (const ParameterDescription& parameter : edit.parameters) {
    ParameterField* field = make_parameter_field(parameter, this);
    connect(field, &ParameterField::edited, this,
            [this, name = parameter.name](const ParameterValue& value, bool) { adjust(name, value); });
    auto* label = new QLabel(parameter_title(parameter), this);
    label->setToolTip(QString::fromStdString(parameter.sentence));
    label->setBuddy(field);
    layout_->addRow(label, field);
    fields_[parameter.name] = field;
  }
}

void EditPanel::adjust(const std::string& parameter, const ParameterValue& value) {
  mesh_.act([&](MeshTool& tool) {
    const EditLine* last = tool.edits().last();
    if (last == nullptr) return Verdict::Continue;
    ParameterValues parameters = last->parameters;
    parameters[parameter] = value;
    return tool.edits().adjust(std::move(parameters));
  });
  follow();  // a value that was refused goes back to what it was
}

}  // namespace croquis::app
