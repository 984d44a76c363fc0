// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/panels/object_list.h"

#include <QContextMenuEvent>
#include <QHeaderView>
#include <QLocale>
#include <QMenu>
#include <QSignalBlocker>
#include <algorithm>
#include <set>

#include "app/panels/object_names.h"
#include "app/window/theme.h"

namespace croquis::app {
namespace {

constexpr int strokes_role = Qt::UserRole;
constexpr int node_role = Qt::UserRole + 1;
constexpr int set_role = Qt::UserRole + 2;
constexpr int name_role = Qt::UserRole + 3;  // as it is shown
constexpr int step_in = 14;                  // pixels

bool is_selected(const Selection& selection, const QStringList& strokes) {
  return !strokes.isEmpty() && std::any_of(selection.begin(), selection.end(), [&](const SelectedItem& item) {
    return strokes.contains(QString::fromStdString(item.part));
  });
}

std::vector<std::string> strokes_of(const QTreeWidgetItem* row) {
  std::vector<std::string> strokes;
  for (const QString& stroke : row->data(0, strokes_role).toStringList()) strokes.push_back(stroke.toStdString());
  return strokes;
}

}  // namespace

ObjectList::ObjectList(QWidget* parent) : QTreeWidget(parent) {
  setObjectName("objects");
  setAccessibleName(tr("Objects"));
  setColumnCount(2);
  setHeaderHidden(true);
  setRootIsDecorated(false);
  setIndentation(step_in);
  setSelectionMode(QAbstractItemView::ExtendedSelection);
  setEditTriggers(QAbstractItemView::DoubleClicked | QAbstractItemView::EditKeyPressed);
  header()->setSectionResizeMode(0, QHeaderView::Stretch);
  header()->setSectionResizeMode(1, QHeaderView::ResizeToContents);
  header()->setStretchLastSection(false);
  connect(this, &QTreeWidget::itemClicked, this, &ObjectList::take_click);
  connect(this, &QTreeWidget::itemChanged, this, &ObjectList::take_change);
  connect(this, &QTreeWidget::itemExpanded, this, [this](QTreeWidgetItem* row) {
    if (!set_of(row).empty()) opened_.insert(node_of(row));
  });
  connect(this, &QTreeWidget::itemCollapsed, this, [this](QTreeWidgetItem* row) {
    if (!set_of(row).empty()) opened_.erase(node_of(row));
  });
}

NodeId ObjectList::node_of(const QTreeWidgetItem* row) { return row->data(0, node_role).toULongLong(); }

std::string ObjectList::set_of(const QTreeWidgetItem* row) { return row->data(0, set_role).toString().toStdString(); }

void ObjectList::show_objects(Studio& studio) {
  if (state() == QAbstractItemView::EditingState) return;  // a name is being typed
  const QSignalBlocker quiet(this);
  clear();
  add_sketch(studio);
  const Selection& selection = studio.session().selection();
  for (const StudioObject& object : studio.objects()) {
    if (object.node == studio.solid_node()) continue;
    const bool selected = std::any_of(selection.begin(), selection.end(), [&](const SelectedItem& item) {
      return item.part.empty() && (item.node == object.node || item.node == object.cage);
    });
    add_mesh(object, selected, studio);
  }
}

QTreeWidgetItem* ObjectList::add_row(const QString& name, const QString& info) {
  auto* row = new QTreeWidgetItem(this, {name, info});
  row->setForeground(1, colors::guide);
  return row;
}

void ObjectList::add_sketch(const Studio& studio) {
  std::set<std::string> used;
  const auto add = [&](const QString& name, const QString& info, const QStringList& strokes, bool solid) {
    QTreeWidgetItem* row = add_row(name, info);
    row->setData(0, strokes_role, strokes);
    row->setToolTip(0, strokes.join(", "));
    if (!solid) row->setForeground(0, colors::guide);
    row->setSelected(is_selected(studio.session().selection(), strokes));
    for (const QString& stroke : strokes) used.insert(stroke.toStdString());
  };
  for (const Body& body : bodies_of(studio)) {
    QStringList strokes;
    for (const std::string& stroke : body.strokes) strokes << QString::fromStdString(stroke);
    add(body.name, strokes.size() == 1 ? tr("1 stroke") : tr("%1 strokes").arg(strokes.size()), strokes, true);
  }
  for (const Stroke& stroke : studio.drawing().strokes) {
    const QString name = QString::fromStdString(stroke.id);
    if (!used.contains(stroke.id)) add(name, {}, {name}, false);
  }
}

/// One row for all patches, and in it one for each.
void ObjectList::add_sets(QTreeWidgetItem* row, const StudioObject& object, Studio& studio) {
  const Selection& selection = studio.session().selection();
  QTreeWidgetItem* all = nullptr;
  for (const FaceSet& set : studio.face_sets().of(object)) {
    auto* own = new QTreeWidgetItem(all == nullptr ? row : all);
    own->setText(0, QString::fromStdString(set.name));
    own->setText(
        1, set.faces.size() == 1 ? tr("1 face") : tr("%1 faces").arg(QLocale().toString(qulonglong(set.faces.size()))));
    own->setData(0, node_role, qulonglong(object.node));
    own->setData(0, set_role, QString::fromStdString(set.name));
    own->setToolTip(0, tr("Click to select these faces; F frames them"));
    own->setForeground(1, colors::guide);
    own->setSelected(std::binary_search(selection.begin(), selection.end(), SelectedItem{object.node, set.name}));
    if (all == nullptr) all = own;
  }
  row->setExpanded(true);
  if (all != nullptr) all->setExpanded(opened_.contains(object.node));
}

void ObjectList::add_mesh(const StudioObject& object, bool selected, Studio& studio) {
  const auto& mesh = object.shown();
  const QString info = mesh ? tr("%1 faces").arg(QLocale().toString(qulonglong(mesh->face_count()))) : QString("…");
  QTreeWidgetItem* row = add_row(shown_name(object), info);
  row->setData(0, name_role, shown_name(object));
  row->setData(0, node_role, qulonglong(object.node));
  row->setFlags(row->flags() | Qt::ItemIsEditable | Qt::ItemIsUserCheckable);
  row->setCheckState(0, object.visible ? Qt::Checked : Qt::Unchecked);
  row->setToolTip(0, tr("Click the eye to hide or show, double click to rename"));
  if (!object.visible) row->setForeground(0, colors::guide);
  row->setSelected(selected);
  add_sets(row, object, studio);
}

void ObjectList::take_click(QTreeWidgetItem* row) {
  if (node_of(row) == 0) {
    emit strokes_chosen(strokes_of(row));
    return;
  }
  if (!set_of(row).empty()) {
    std::vector<std::string> names;
    for (const QTreeWidgetItem* selected : selectedItems()) {
      if (node_of(selected) == node_of(row) && !set_of(selected).empty()) names.push_back(set_of(selected));
    }
    emit sets_chosen(node_of(row), names);
    return;
  }
  std::vector<NodeId> nodes;
  for (const QTreeWidgetItem* selected : selectedItems()) {
    if (node_of(selected) != 0 && set_of(selected).empty()) nodes.push_back(node_of(selected));
  }
  emit objects_chosen(nodes);
}

void ObjectList::take_change(QTreeWidgetItem* row, int column) {
  const NodeId node = node_of(row);
  if (node == 0 || column != 0 || !set_of(row).empty()) return;
  // Shown names are not those of the document: only what was typed becomes one.
  const bool typed = row->text(0) != row->data(0, name_role).toString();
  const std::string name = row->text(0).toStdString();
  const bool visible = row->checkState(0) == Qt::Checked;
  // Receivers show all rows again.
  QMetaObject::invokeMethod(
      this,
      [this, node, name, typed, visible] {
        if (typed) emit renamed(node, name);
        emit shown(node, visible);
      },
      Qt::QueuedConnection);
}

void ObjectList::contextMenuEvent(QContextMenuEvent* event) {
  QTreeWidgetItem* row = itemAt(event->pos());
  if (row == nullptr || node_of(row) == 0 || !set_of(row).empty()) return;
  const NodeId node = node_of(row);
  QMenu menu(this);
  menu.addAction(tr("Rename"), this, [this, row] { editItem(row, 0); });
  menu.addAction(tr("Delete"), this, [this, node] { emit removed(node); });
  menu.exec(event->globalPos());
}

}  // namespace croquis::app
