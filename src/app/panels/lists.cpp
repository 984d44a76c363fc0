// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/panels/lists.h"

#include <QContextMenuEvent>
#include <QHeaderView>
#include <QLocale>
#include <QPainter>
#include <QSignalBlocker>
#include <algorithm>

#include "app/window/language.h"
#include "app/window/theme.h"

namespace croquis::app {
namespace {

constexpr int parts_role = Qt::UserRole;
constexpr int node_role = Qt::UserRole + 1;
constexpr int step_role = Qt::UserRole + 2;
constexpr int name_role = Qt::UserRole + 3;    // as it is shown
constexpr int opened_role = Qt::UserRole + 4;  // as it first is
constexpr int group_role = Qt::UserRole + 5;
constexpr int step_in = 14;  // pixels

bool is_part(const QTreeWidgetItem* row) { return !row->data(0, parts_role).toStringList().isEmpty(); }

QString words_of(const ChainStep& step) {
  switch (step.state) {
    case StepState::Held: return ObjectList::tr("waits for %1").arg(localized(step.waits_for));
    case StepState::Computing: return ObjectList::tr("computing …");
    case StepState::Stale: return ObjectList::tr("failed, shows its last result");
    case StepState::Failed: return ObjectList::tr("failed");
    case StepState::NeedsAttention: return ObjectList::tr("needs attention");
    case StepState::Off: return ObjectList::tr("off");
    default: return {};
  }
}

QColor color_of(StepState state) {
  if (state == StepState::Computing) return theme_colors().warning;
  const bool bad = state == StepState::Stale || state == StepState::Failed || state == StepState::NeedsAttention;
  return bad ? theme_colors().error : theme_colors().faint;
}

QStringList to_list(const std::vector<std::string>& texts) {
  QStringList list;
  for (const std::string& text : texts) list << QString::fromStdString(text);
  return list;
}

/// What belongs into a list that is empty.
void draw_hint(QWidget& list, const QString& text) {
  QPainter painter(&list);
  painter.setPen(list.palette().color(QPalette::PlaceholderText));
  painter.drawText(list.rect().adjusted(6, 6, -6, -6), Qt::AlignTop | Qt::TextWordWrap, text);
}

bool is_selected(const Selection& selection, NodeId node) {
  return std::ranges::binary_search(selection, SelectedItem{node, ""});
}

}  // namespace

FindingsList::FindingsList(QWidget* parent) : QListWidget(parent) {
  setObjectName("findings");
  setAccessibleName(tr("Findings"));
  setWordWrap(true);
  setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  connect(this, &QListWidget::itemClicked, this, [this](QListWidgetItem* item) {
    const auto place = static_cast<std::size_t>(row(item));
    if (place >= rows_.size()) return;
    const Row chosen = rows_[place];  // receivers show all rows again
    if (chosen.fix == nullptr) return emit finding_chosen(chosen.finding);
    emit fix_chosen(chosen.finding, chosen.fix);
  });
}

void FindingsList::show_findings(const std::vector<NodeFinding>& findings,
                                 const std::function<QString(const NodeFinding&)>& owner,
                                 const std::function<std::vector<QAction*>(const NodeFinding&)>& fixes) {
  clear();
  rows_.clear();
  for (const NodeFinding& found : findings) {
    const QString sentence = localized(found.finding.message);
    const QString name = owner(found);
    auto* row = new QListWidgetItem(name.isEmpty() ? sentence : tr("%1: %2").arg(name, sentence), this);
    row->setForeground(sentence_color(found.finding.severity));
    row->setToolTip(QString::fromStdString(found.finding.code));
    rows_.push_back({found});
    for (QAction* fix : fixes(found)) {
      auto* offer = new QListWidgetItem(QStringLiteral("→ ") + fix->text().remove('&'), this);
      offer->setForeground(theme_colors().link);
      offer->setToolTip(fix->toolTip());
      rows_.push_back({found, fix});
    }
  }
}

void FindingsList::paintEvent(QPaintEvent* event) {
  QListWidget::paintEvent(event);
  if (count() == 0) draw_hint(*viewport(), tr("Nothing is wrong. Problems of drawings and meshes are listed here."));
}

HistoryList::HistoryList(QWidget* parent) : QListWidget(parent) {
  setObjectName("history");
  setAccessibleName(tr("History"));
  connect(this, &QListWidget::itemClicked, this, [this](QListWidgetItem* item) { emit step_chosen(row(item)); });
}

void HistoryList::show_history(const std::vector<std::string>& done, const std::vector<std::string>& undone) {
  const QSignalBlocker quiet(this);
  clear();
  addItem(tr("Start"));
  for (const std::string& label : done) addItem(localized(label));
  setCurrentRow(count() - 1);
  for (const std::string& label : undone) {
    addItem(localized(label));
    item(count() - 1)->setForeground(theme_colors().faint);
  }
  scrollToItem(currentItem());
}

ObjectList::ObjectList(Parts parts, QWidget* parent) : QTreeWidget(parent), parts_(std::move(parts)) {
  setObjectName("objects");
  setAccessibleName(tr("Objects"));
  setColumnCount(2);
  setHeaderHidden(true);
  setRootIsDecorated(true);
  setIndentation(step_in);
  setSelectionMode(QAbstractItemView::ExtendedSelection);
  setEditTriggers(QAbstractItemView::DoubleClicked | QAbstractItemView::EditKeyPressed);
  header()->setSectionResizeMode(0, QHeaderView::Stretch);
  header()->setSectionResizeMode(1, QHeaderView::ResizeToContents);
  header()->setStretchLastSection(false);
  connect(this, &QTreeWidget::itemClicked, this, &ObjectList::take_click);
  connect(this, &QTreeWidget::itemChanged, this, &ObjectList::take_change);
  connect(this, &QTreeWidget::itemExpanded, this, [this](QTreeWidgetItem* row) { take_opening(row, true); });
  connect(this, &QTreeWidget::itemCollapsed, this, [this](QTreeWidgetItem* row) { take_opening(row, false); });
}

NodeId ObjectList::node_of(const QTreeWidgetItem* row) { return row->data(0, node_role).toULongLong(); }

bool ObjectList::is_step(const QTreeWidgetItem* row) { return row->data(0, step_role).toBool(); }

std::vector<std::string> ObjectList::parts_of(const QTreeWidgetItem* row) {
  std::vector<std::string> parts;
  for (const QString& part : row->data(0, parts_role).toStringList()) parts.push_back(part.toStdString());
  return parts;
}

void ObjectList::show_objects(const Studio& studio) {
  if (state() == QAbstractItemView::EditingState) return;  // a name is being typed
  const QSignalBlocker quiet(this);
  clear();
  renames_.clear();
  for (const WorkObject& object : studio.objects()) add_object(object, studio);
  for (int i = 0; i < topLevelItemCount(); ++i) {
    QTreeWidgetItem* row = topLevelItem(i);
    if (row->data(0, group_role).isNull()) continue;
    bool all_selected = true, some_shown = false;
    for (int k = 0; k < row->childCount(); ++k) {
      all_selected = all_selected && row->child(k)->isSelected();
      some_shown = some_shown || row->child(k)->checkState(0) == Qt::Checked;
    }
    row->setText(1, tr("%1 objects").arg(row->childCount()));
    row->setCheckState(0, some_shown ? Qt::Checked : Qt::Unchecked);
    row->setSelected(all_selected);
    row->setExpanded(!turned_.contains({0, row->text(0)}));
  }
}

/// Made with the first object of the group.
QTreeWidgetItem* ObjectList::group_row(const std::string& group) {
  const QString name = QString::fromStdString(group);
  for (int i = 0; i < topLevelItemCount(); ++i) {
    if (topLevelItem(i)->data(0, group_role).toString() == name) return topLevelItem(i);
  }
  auto* row = new QTreeWidgetItem(this, {shown_name(group), QString()});
  row->setData(0, name_role, shown_name(group));
  row->setForeground(1, theme_colors().faint);
  row->setData(0, group_role, name);
  row->setFlags(row->flags() | Qt::ItemIsEditable | Qt::ItemIsUserCheckable);
  row->setToolTip(0, tr("A group: its objects are selected and moved together · Ctrl+Shift+G ungroups"));
  return row;
}

/// What a row of a group or an object stands for.
std::vector<NodeId> ObjectList::objects_of(const QTreeWidgetItem* row) const {
  if (row->data(0, group_role).isNull()) return {node_of(row)};
  std::vector<NodeId> nodes;
  for (int i = 0; i < row->childCount(); ++i) nodes.push_back(node_of(row->child(i)));
  return nodes;
}

void ObjectList::paintEvent(QPaintEvent* event) {
  QTreeWidget::paintEvent(event);
  if (topLevelItemCount() == 0) draw_hint(*viewport(), tr("What you draw or open is listed here."));
}

void ObjectList::add_object(const WorkObject& object, const Studio& studio) {
  const auto& mesh = object.shown();
  const QString info = mesh ? tr("%1 faces").arg(QLocale().toString(qulonglong(mesh->face_count()))) : QString();
  auto* row = object.group.empty() ? new QTreeWidgetItem(this) : new QTreeWidgetItem(group_row(object.group));
  row->setText(0, shown_name(object));
  row->setText(1, info);
  row->setForeground(1, theme_colors().faint);
  row->setData(0, name_role, shown_name(object));
  row->setData(0, node_role, qulonglong(object.node));
  row->setFlags(row->flags() | Qt::ItemIsEditable | Qt::ItemIsUserCheckable);
  row->setCheckState(0, object.visible ? Qt::Checked : Qt::Unchecked);
  row->setToolTip(0, tr("Click the eye to hide or show, double click to rename"));
  if (!object.visible) row->setForeground(0, theme_colors().faint);
  const Selection& selection = studio.session().selection();
  row->setSelected(is_selected(selection, object.node) || is_selected(selection, object.cage));
  add_parts(row, parts_(object, object.node), object.node, selection);
  if (object.chain.size() > 1) add_steps(row, object, studio);
  row->setExpanded(!turned_.contains({object.node, QString()}));
}

void ObjectList::add_steps(QTreeWidgetItem* row, const WorkObject& object, const Studio& studio) {
  std::vector<ChainStep> steps = steps_of(studio, object);
  std::ranges::reverse(steps);
  const Selection& selection = studio.session().selection();
  for (const ChainStep& step : steps) {
    const bool computed = step.state != StepState::Source;
    const QString name = computed ? shown_text(step.title) : source_words(studio.session().document().find(step.node));
    auto* own = new QTreeWidgetItem(row, {name, words_of(step)});
    own->setData(0, node_role, qulonglong(step.node));
    own->setData(0, step_role, true);
    own->setForeground(1, color_of(step.state));
    if (computed) {
      own->setFlags(own->flags() | Qt::ItemIsUserCheckable);
      own->setCheckState(0, step.state == StepState::Off ? Qt::Unchecked : Qt::Checked);
    }
    own->setToolTip(0, step.problem.empty() ? tr("A step: click shows its numbers, the right button what can be done")
                                            : localized(step.problem));
    own->setToolTip(1, own->toolTip(0));
    if (step.state == StepState::Off) own->setForeground(0, theme_colors().faint);
    own->setSelected(step.node != object.node && is_selected(selection, step.node));
    if (step.node == object.node) continue;
    add_parts(own, parts_(object, step.node), step.node, selection);
    own->setExpanded(!turned_.contains({step.node, QString()}));
  }
}

void ObjectList::add_parts(QTreeWidgetItem* below, const std::vector<ObjectRow>& rows, NodeId node,
                           const Selection& selection) {
  for (const ObjectRow& row : rows) {
    auto* own = new QTreeWidgetItem(below, {row.name, row.info});
    own->setData(0, node_role, qulonglong(node));
    own->setData(0, parts_role, to_list(row.parts));
    own->setData(0, opened_role, row.opened);
    own->setToolTip(0, row.tip);
    own->setForeground(1, theme_colors().faint);
    if (row.rename) {
      own->setFlags(own->flags() | Qt::ItemIsEditable);
      renames_[own] = row.rename;
    }
    if (!row.made) own->setForeground(0, theme_colors().faint);
    own->setSelected(std::ranges::any_of(row.parts, [&](const std::string& part) {
      return std::ranges::binary_search(selection, SelectedItem{node, part});
    }));
    add_parts(own, row.rows, node, selection);
    own->setExpanded(row.opened != turned_.contains({node, row.name}));
  }
}

void ObjectList::choose_parts(NodeId node) {
  std::vector<std::string> parts;
  for (const QTreeWidgetItem* selected : selectedItems()) {
    if (node_of(selected) != node) continue;
    for (std::string& part : parts_of(selected)) parts.push_back(std::move(part));
  }
  emit parts_chosen(node, parts);
}

void ObjectList::take_click(QTreeWidgetItem* row) {
  if (is_part(row)) {
    if (!row->isSelected()) row->setSelected(true);
    return choose_parts(node_of(row));
  }
  if (is_step(row)) return emit step_chosen(node_of(row));
  std::vector<NodeId> nodes;
  for (const QTreeWidgetItem* selected : selectedItems()) {
    if (is_part(selected) || is_step(selected)) continue;
    for (const NodeId node : objects_of(selected)) nodes.push_back(node);
  }
  emit objects_chosen(nodes);
}

void ObjectList::take_change(QTreeWidgetItem* row, int column) {
  // Receivers show all rows again: not while one is still being changed.
  const auto later = [this](auto work) { QMetaObject::invokeMethod(this, std::move(work), Qt::QueuedConnection); };
  const NodeId node = node_of(row);
  const QVariant group = row->data(0, group_role);
  if (const auto part = renames_.find(row); part != renames_.end() && column == 0)
    return later([rename = part->second, name = row->text(0).trimmed().toStdString()] { rename(name); });
  if ((node == 0 && group.isNull()) || column != 0 || is_part(row)) return;
  const bool checked = row->checkState(0) == Qt::Checked;
  if (is_step(row)) return later([this, node, checked] { emit step_enabled(node, checked); });
  // Shown names are not those of the document: only what was typed becomes one.
  const bool typed = row->text(0) != row->data(0, name_role).toString();
  later([this, node, typed, checked, name = row->text(0).toStdString(), group = group.toString().toStdString(),
         objects = objects_of(row)] {
    if (typed && group.empty()) emit renamed(node, name);
    if (typed && !group.empty()) emit group_renamed(group, name);
    if (!typed) emit shown(objects, checked);
  });
}

void ObjectList::take_opening(QTreeWidgetItem* row, bool opened) {
  const bool first = !is_part(row) || row->data(0, opened_role).toBool();
  const bool named = is_part(row) || !row->data(0, group_role).isNull();
  const std::pair<NodeId, QString> key{node_of(row), named ? row->text(0) : QString()};
  if (opened == first) {
    turned_.erase(key);
  } else {
    turned_.insert(key);
  }
}

void ObjectList::contextMenuEvent(QContextMenuEvent* event) {
  QTreeWidgetItem* row = itemAt(event->pos());
  if (row == nullptr || is_part(row)) return;
  if (!row->isSelected()) setCurrentItem(row);
  const NodeId node = node_of(row);
  const bool step = is_step(row);
  take_click(row);  // receivers show all rows again
  emit menu_wanted(node, step, event->globalPos());
}

}  // namespace croquis::app
