// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/panels/attribute_panel.h"

#include <QCheckBox>
#include <QFormLayout>
#include <QLabel>
#include <QListWidget>

#include "app/panels/parameter_field.h"
#include "croquis/base/error.h"
#include "croquis/edits/edit_line.h"
#include "croquis/workspace/node_values.h"

namespace croquis::app {
namespace {

bool lists_edits(const OperationDescription& operation, const ParameterDescription& parameter) {
  return operation.edits_input && operation.edits_input->lines == parameter.name;
}

}  // namespace

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
  const ParameterValues values = values_of(*node, *description);
  for (const ParameterDescription& parameter : description->parameters) {
    const auto shown = fields_.find(parameter.name);
    if (shown != fields_.end()) shown->second->show_value(values.at(parameter.name));
    if (lists_edits(*description, parameter)) show_edits(to_text(values.at(parameter.name)));
  }
}

/// Lines that can't be read are told of in Findings.
void AttributePanel::show_edits(const std::string& lines) {
  if (std::exchange(shown_edits_, lines) == lines) return;
  edits_->clear();
  try {
    for (const EditLine& line : parse_edit_lines(lines, all_edits())) {
      edits_->addItem(QString::fromStdString(label_of(line, std::string("all ") + plural(line.target.kind))));
    }
  } catch (const Error&) {
    edits_->addItem(tr("The edits can't be read"));
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
  shown_edits_.clear();
}

void AttributePanel::make_fields(const OperationDescription& description) {
  clear();
  operation_ = description.id;
  std::vector<QWidget*> expert;
  for (const ParameterDescription& parameter : description.parameters) {
    if (lists_edits(description, parameter)) {
      edits_ = new QListWidget(this);
      edits_->setObjectName("edit-lines");
      layout_->addRow(edits_);
      continue;
    }
    // The flag is for hosts that only want the list.
    if (parameter.place == ParameterPlace::Nowhere || parameter.name == description.list_flag) continue;
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
    if (parameter.place == ParameterPlace::Expert) expert.push_back(field);
  }
  if (expert.empty()) return;
  auto* all = new QCheckBox(tr("Expert"), this);
  all->setObjectName("expert");
  all->setToolTip(tr("Shows everything that can be set"));
  layout_->addRow(all);
  connect(all, &QCheckBox::toggled, this, [this, expert](bool on) {
    shows_all_ = on;
    for (QWidget* field : expert) layout_->setRowVisible(field, on);
  });
  all->setChecked(shows_all_);
  if (!shows_all_) emit all->toggled(false);
}

}  // namespace croquis::app
