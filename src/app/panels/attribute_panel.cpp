// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/panels/attribute_panel.h"

#include <QFormLayout>
#include <QLabel>

#include "app/panels/parameter_field.h"

namespace croquis::app {

AttributePanel::AttributePanel(QWidget* parent) : QWidget(parent), layout_(new QFormLayout(this)) {
  setObjectName("attributes");
  layout_->setRowWrapPolicy(QFormLayout::WrapLongRows);
  layout_->setVerticalSpacing(3);
  layout_->setFieldGrowthPolicy(QFormLayout::AllNonFixedFieldsGrow);
}

void AttributePanel::show_node(const Node* node, const OperationDescription* description) {
  if (node == nullptr || description == nullptr) {
    node_ = 0;
    clear();
    return;
  }
  node_ = node->id;
  if (description->id != operation_) make_fields(*description);
  for (const ParameterDescription& parameter : description->parameters) {
    if (!fields_.contains(parameter.name)) continue;
    const auto given = node->parameters.find(parameter.name);
    fields_.at(parameter.name)->show_value(given == node->parameters.end() ? parameter.default_value : given->second);
  }
}

ParameterField* AttributePanel::field(const std::string& parameter) const {
  const auto found = fields_.find(parameter);
  return found == fields_.end() ? nullptr : found->second;
}

void AttributePanel::clear() {
  while (layout_->rowCount() > 0) layout_->removeRow(0);
  fields_.clear();
  operation_.clear();
}

void AttributePanel::make_fields(const OperationDescription& description) {
  clear();
  operation_ = description.id;
  for (const ParameterDescription& parameter : description.parameters) {
    if (parameter.name == description.list_flag) continue;  // for hosts that only want the list
    ParameterField* field = make_parameter_field(parameter, this);
    connect(field, &ParameterField::edited, this,
            [this, name = parameter.name](const ParameterValue& value, bool drag) {
              emit parameter_edited(node_, name, value, drag);
            });
    auto* label = new QLabel(parameter_title(parameter), this);
    label->setToolTip(QString::fromStdString(parameter.sentence));
    label->setBuddy(field);
    layout_->addRow(label, field);
    fields_[parameter.name] = field;
  }
}

}  // namespace croquis::app
