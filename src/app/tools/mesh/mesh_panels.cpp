// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/tools/mesh/mesh_panels.h"

#include <QDockWidget>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QPushButton>
#include <QSignalBlocker>
#include <QSlider>
#include <QTreeWidget>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>

#include "app/panels/attribute_panel.h"
#include "app/panels/number_box.h"
#include "app/tools/mesh/mesh_editing_tool.h"
#include "app/window/language.h"
#include "app/window/panel_docks.h"
#include "croquis/mesh_editing/tag_edit.h"

namespace croquis::app {
namespace {

const QString infinity_sign = QStringLiteral("∞");

bool means_infinity(const QString& text) {
  return text.trimmed() == infinity_sign || text.trimmed().compare("inf", Qt::CaseInsensitive) == 0;
}

constexpr double first_angle = 60;

QString elements(ComponentKind kind, std::size_t count) {
  const auto number = static_cast<int>(count);
  switch (kind) {
    case ComponentKind::Vertex: return number == 1 ? TagPanel::tr("1 vertex") : TagPanel::tr("%1 vertices").arg(number);
    case ComponentKind::Edge: return number == 1 ? TagPanel::tr("1 edge") : TagPanel::tr("%1 edges").arg(number);
    case ComponentKind::Face: break;
  }
  return number == 1 ? TagPanel::tr("1 face") : TagPanel::tr("%1 faces").arg(number);
}

constexpr int set_name_role = Qt::UserRole;

std::string name_of(const QTreeWidgetItem* row) { return row->data(0, set_name_role).toString().toStdString(); }

}  // namespace

SharpnessField::SharpnessField(QWidget* parent) : QDoubleSpinBox(parent) {
  setRange(0, greatest_sharpness);
  setSingleStep(0.5);
  setDecimals(2);
  setKeyboardTracking(false);
  setAccessibleName(tr("Sharpness"));
}

void SharpnessField::show_sharpness(double sharpness) {
  const QSignalBlocker quiet(this);
  setValue(std::min(sharpness, greatest_sharpness));
}

double SharpnessField::sharpness() const { return value() >= greatest_sharpness ? infinite_sharpness : value(); }

QString SharpnessField::textFromValue(double value) const {
  return value >= greatest_sharpness ? infinity_sign : QDoubleSpinBox::textFromValue(value);
}

double SharpnessField::valueFromText(const QString& text) const {
  return means_infinity(text) ? greatest_sharpness : QDoubleSpinBox::valueFromText(text);
}

QValidator::State SharpnessField::validate(QString& text, int& position) const {
  if (means_infinity(text)) return QValidator::Acceptable;
  if (QStringLiteral("inf").startsWith(text.trimmed().toLower())) return QValidator::Intermediate;
  return QDoubleSpinBox::validate(text, position);
}

TagPanel::TagPanel(MeshEditingTool& mesh, QWidget* parent)
    : QWidget(parent), mesh_(mesh), selected_(new QLabel(this)), sharpness_(new SharpnessField(this)) {
  setObjectName("tags");
  sharpness_->setObjectName("selected-sharpness");
  sharpness_->setToolTip(tr("Sharpness of the selected edges in levels: 0 smooth, 10 and more always sharp"));
  connect(sharpness_, &QDoubleSpinBox::valueChanged, this,
          [this] { take_step(mesh_, recorded::Tag{.sharpness = sharpness_->sharpness()}); });
  auto* layout = new QFormLayout(this);
  layout->setContentsMargins(6, 4, 6, 2);
  layout->setVerticalSpacing(3);
  layout->addRow(selected_, sharpness_);
  layout->addRow(make_angle_row());
}

QWidget* TagPanel::make_angle_row() {
  auto* row = new QWidget(this);
  auto* layout = new QHBoxLayout(row);
  layout->setContentsMargins(0, 0, 0, 0);
  angle_slider_ = new QSlider(Qt::Horizontal, row);
  angle_slider_->setObjectName("angle-slider");
  angle_slider_->setAccessibleName(tr("Least angle of edges to select"));
  angle_slider_->setRange(0, 180);
  angle_slider_->setValue(static_cast<int>(first_angle));
  angle_ = make_number_box(row, "angle", {0, 180, 1});
  angle_->setAccessibleName(tr("Least angle of edges to select"));
  angle_->setSuffix("°");
  angle_->setValue(first_angle);
  count_ = new QLabel(row);
  count_->setObjectName("angle-count");
  auto* tag = new QPushButton(tr("Sharp"), row);
  tag->setObjectName("tag-by-angle");
  tag->setToolTip(tr("Makes all edges sharp whose faces meet at a greater angle"));
  connect(angle_slider_, &QSlider::valueChanged, this, [this](int value) { choose_by_angle(value); });
  connect(angle_, &QDoubleSpinBox::valueChanged, this, &TagPanel::choose_by_angle);
  connect(tag, &QPushButton::clicked, this, [this] {
    take_step(mesh_,
              recorded::Tag{.edges = "sharper-than", .degrees = angle_->value(), .sharpness = infinite_sharpness});
  });
  auto* name = new QLabel(tr("By angle"), row);
  name->setToolTip(tr("Drag: edges whose faces meet at a greater angle are selected and counted"));
  layout->addWidget(name);
  layout->addWidget(angle_slider_, 1);
  layout->addWidget(angle_);
  layout->addWidget(count_);
  layout->addWidget(tag);
  return row;
}

void TagPanel::choose_by_angle(double degrees) {
  {
    const QSignalBlocker quiet_slider(angle_slider_);
    const QSignalBlocker quiet_box(angle_);
    angle_slider_->setValue(static_cast<int>(degrees + 0.5));
    angle_->setValue(degrees);
  }
  const PreparedMesh* now = mesh_.tool().editable().prepared();
  const Elements edges = now == nullptr ? Elements() : edges_sharper_than(*now->topology, *now->mesh, degrees);
  count_->setText(QString::number(edges.size()));
  if (mesh_.tool().selection().mode() != MeshMode::Edge) mesh_.set_mesh_mode(MeshMode::Edge);
  mesh_.act([&edges](MeshTool& tool) {
    return edges.empty() ? tool.selection().select_none() : tool.selection().choose(ComponentKind::Edge, edges);
  });
}

void TagPanel::follow(const ComponentSelection& selection) {
  MeshTool& tool = mesh_.tool();
  setEnabled(tool.editable().mesh() != nullptr);
  const bool edges =
      selection.node == tool.editable().node() && selection.kind == ComponentKind::Edge && !selection.empty();
  selected_->setText(selection.empty() ? tr("Sharpness") : elements(selection.kind, selection.elements.size()));
  sharpness_->setEnabled(!selection.empty());
  const bool known = edges && selection.elements.front() < tool.editable().edge_sharpness().size();
  sharpness_->show_sharpness(known ? tool.editable().edge_sharpness()[selection.elements.front()] : 0);
}

CreaseSetPanel::CreaseSetPanel(MeshEditingTool& mesh, QWidget* parent)
    : QWidget(parent), mesh_(mesh), sets_(new QTreeWidget(this)), sharpness_(new SharpnessField(this)) {
  setObjectName("crease-sets");
  sets_->setObjectName("crease-set-list");
  sets_->setAccessibleName(tr("Crease sets"));
  sets_->setColumnCount(2);
  sets_->setHeaderHidden(true);
  sets_->setRootIsDecorated(false);
  sets_->setSelectionMode(QAbstractItemView::ExtendedSelection);
  sets_->header()->setSectionResizeMode(0, QHeaderView::Stretch);
  sets_->header()->setStretchLastSection(false);
  connect(sets_, &QTreeWidget::itemSelectionChanged, this, &CreaseSetPanel::follow);
  connect(sets_, &QTreeWidget::itemChanged, this, [this](QTreeWidgetItem* row) {
    const std::string before = name_of(row);
    const std::string after = row->text(0).toStdString();
    // Receivers show all rows again.
    QMetaObject::invokeMethod(
        this,
        [this, before, after] {
          if (before != after) take_step(mesh_, recorded::TagSet{.how = "rename", .name = before, .other = after});
        },
        Qt::QueuedConnection);
  });
  sharpness_->setObjectName("set-sharpness");
  connect(sharpness_, &QDoubleSpinBox::valueChanged, this, [this] {
    take_step(mesh_, recorded::TagSet{.how = "sharpness", .name = chosen(), .sharpness = sharpness_->sharpness()});
  });
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(4, 2, 4, 4);
  layout->setSpacing(3);
  layout->addWidget(sets_, 1);
  layout->addWidget(make_buttons());
}

QPushButton* CreaseSetPanel::add_button(QWidget* row, const QString& name, const QString& text, const QString& tip,
                                        std::function<void()> work) {
  auto* button = new QPushButton(text, row);
  button->setObjectName(name);
  button->setToolTip(tip);
  button->setStyleSheet("padding: 2px 6px");
  connect(button, &QPushButton::clicked, this, std::move(work));
  row->layout()->addWidget(button);
  return button;
}

QWidget* CreaseSetPanel::make_buttons() {
  auto* row = new QWidget(this);
  auto* layout = new QHBoxLayout(row);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(3);
  add_button(row, "set-new", tr("New"), tr("A set of the selected edges or vertices"),
             [this] { make_crease_set(mesh_); });
  layout->addWidget(sharpness_);
  add_button(row, "set-select", tr("Select"), tr("Selects the set's edges or vertices"),
             [this] { take_step(mesh_, recorded::TagSet{.how = "select", .name = chosen()}); });
  add_button(row, "set-merge", tr("Merge"), tr("Puts all chosen sets into the first one"), [this] { merge(); });
  add_button(row, "set-delete", tr("Delete"), tr("Forgets the set; its edges stay as sharp as they are"),
             [this] { take_step(mesh_, recorded::TagSet{.how = "remove", .name = chosen()}); });
  return row;
}

std::string CreaseSetPanel::chosen() const {
  const auto rows = sets_->selectedItems();
  return rows.isEmpty() ? std::string() : name_of(rows.front());
}

void CreaseSetPanel::merge() {
  std::vector<std::string> names;
  for (const QTreeWidgetItem* row : sets_->selectedItems()) names.push_back(name_of(row));
  for (std::size_t i = 1; i < names.size(); ++i) {
    take_step(mesh_, recorded::TagSet{.how = "merge", .name = names.front(), .other = names[i]});
  }
}

void CreaseSetPanel::follow() {
  const auto mesh = mesh_.tool().editable().mesh();
  const auto shown = sets_->selectedItems();
  const std::string before = shown.isEmpty() ? std::string() : name_of(shown.front());
  const bool editing = sets_->findChild<QWidget*>("qt_edit") != nullptr;
  if (editing) return;
  const MeshTags none;
  const MeshTags& tags = mesh ? mesh->tags : none;
  const QSignalBlocker quiet(sets_);
  bool same = static_cast<std::size_t>(sets_->topLevelItemCount()) == tags.sets.size();
  for (std::size_t i = 0; same && i < tags.sets.size(); ++i) {
    same = name_of(sets_->topLevelItem(static_cast<int>(i))) == tags.sets[i].name;
  }
  if (!same) sets_->clear();
  for (std::size_t i = 0; i < tags.sets.size(); ++i) {
    const CreaseSet& set = tags.sets[i];
    const QString name = QString::fromStdString(set.name);
    QTreeWidgetItem* row = same ? sets_->topLevelItem(static_cast<int>(i)) : new QTreeWidgetItem(sets_, {name, {}});
    row->setData(0, set_name_role, name);
    row->setFlags(row->flags() | Qt::ItemIsEditable);
    const QString sharpness = std::isinf(set.sharpness) ? QStringLiteral("∞") : number_words(set.sharpness);
    row->setText(1, set.edges.empty() ? tr("%1 pins").arg(set.pins.size())
                                      : tr("%1 edges, %2").arg(set.edges.size()).arg(sharpness));
    if (!same && set.name == before) row->setSelected(true);
  }
  const CreaseSet* set = find_set(tags, chosen());
  sharpness_->setEnabled(set != nullptr && !set->edges.empty());
  sharpness_->show_sharpness(set == nullptr ? 0 : set->sharpness);
}

EditPanel::EditPanel(MeshEditingTool& mesh, QWidget* parent)
    : QWidget(parent), mesh_(mesh), layout_(new QFormLayout(this)), title_(new QLabel(this)) {
  setObjectName("last-edit");
  title_->setObjectName("last-edit-title");
  layout_->setContentsMargins(6, 4, 6, 2);
  layout_->setVerticalSpacing(3);
  layout_->addRow(title_);
}

bool EditPanel::useful() const {
  const EditLine* line = mesh_.tool().edits().last();
  return line != nullptr && !find_edit(line->edit)->description.parameters.empty();
}

void EditPanel::follow() {
  if (!useful()) return;
  const EditLine& line = *mesh_.tool().edits().last();
  const EditDescription& edit = find_edit(line.edit)->description;
  if (edit.id != edit_) make_fields(edit);
  title_->setText(localized(mesh_.tool().edits().label_of(line)));
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
    label->setToolTip(parameter_help(parameter));
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

/// Sharp edges and crease sets lie below the attributes, in one place.
MeshPanels::MeshPanels(MeshEditingTool& mesh, PanelDocks& docks)
    : docks_(docks),
      tags_(new TagPanel(mesh, nullptr)),
      sets_(new CreaseSetPanel(mesh, nullptr)),
      last_edit_(new EditPanel(mesh, nullptr)),
      edges_dock_(docks.add_column(QObject::tr("Sharp edges"), tags_, "edges")),
      sets_dock_(docks.add(QObject::tr("Crease sets"), sets_, "sets")) {
  docks.split_below("attributes", edges_dock_);
  docks.tabify("edges", sets_dock_);
  edges_dock_->raise();
  last_edit_dock_ = docks.add_column(QObject::tr("Last edit"), last_edit_, "last-edit");
}

void MeshPanels::follow(const ComponentSelection& selection, bool useful) {
  tags_->follow(selection);
  sets_->follow();
  show_last_edit();
  docks_.set_useful(edges_dock_, useful);
  docks_.set_useful(sets_dock_, useful);
}

void MeshPanels::show_last_edit() {
  last_edit_->follow();
  docks_.set_useful(last_edit_dock_, last_edit_->useful());
}

}  // namespace croquis::app
