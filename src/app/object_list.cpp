// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/object_list.h"

#include <QContextMenuEvent>
#include <QHeaderView>
#include <QLocale>
#include <QMenu>
#include <QSignalBlocker>
#include <algorithm>
#include <set>

#include "app/theme.h"

namespace croquis::app {
namespace {

constexpr int strokes_role = Qt::UserRole;
constexpr int node_role = Qt::UserRole + 1;

QStringList names_of(const Report& list) {
  QStringList names;
  for (const Report& name : list.as_array()) names << QString::fromStdString(name.as_string());
  return names;
}

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
  setIndentation(0);
  setSelectionMode(QAbstractItemView::ExtendedSelection);
  setEditTriggers(QAbstractItemView::DoubleClicked | QAbstractItemView::EditKeyPressed);
  header()->setSectionResizeMode(0, QHeaderView::Stretch);
  header()->setSectionResizeMode(1, QHeaderView::ResizeToContents);
  header()->setStretchLastSection(false);
  connect(this, &QTreeWidget::itemClicked, this, &ObjectList::take_click);
  connect(this, &QTreeWidget::itemChanged, this, &ObjectList::take_change);
}

NodeId ObjectList::node_of(const QTreeWidgetItem* row) { return row->data(0, node_role).toULongLong(); }

void ObjectList::show_objects(const Studio& studio) {
  if (state() == QAbstractItemView::EditingState) return;  // a name is being typed
  const QSignalBlocker quiet(this);
  clear();
  add_sketch(studio);
  const Selection& selection = studio.session().selection();
  for (const StudioObject& object : studio.objects()) {
    if (object.node == studio.solid_node()) continue;
    const bool selected = std::any_of(selection.begin(), selection.end(), [&](const SelectedItem& item) {
      return item.node == object.node || item.node == object.cage;
    });
    add_mesh(object, selected);
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
    if (!solid) row->setForeground(0, colors::guide);
    row->setSelected(is_selected(studio.session().selection(), strokes));
    for (const QString& stroke : strokes) used.insert(stroke.toStdString());
  };
  const auto result = studio.result();
  const Report* details = report_of(result.get(), "details");
  const Report* objects = details == nullptr ? nullptr : details->find("objects");
  if (objects != nullptr) {
    for (const Report& object : objects->as_array()) {
      const QStringList strokes = names_of(object.at("strokes"));
      const QString name = QString::fromStdString(object.at("name").as_string());
      add(name, strokes.size() == 1 ? tr("1 stroke") : tr("%1 strokes").arg(strokes.size()), strokes, true);
    }
  }
  for (const Stroke& stroke : studio.drawing().strokes) {
    const QString name = QString::fromStdString(stroke.id);
    if (!used.contains(stroke.id)) add(name, {}, {name}, false);
  }
}

void ObjectList::add_mesh(const StudioObject& object, bool selected) {
  const auto& mesh = object.shown();
  const QString info = mesh ? tr("%1 faces").arg(QLocale().toString(qulonglong(mesh->face_count()))) : QString("…");
  QTreeWidgetItem* row = add_row(QString::fromStdString(object.name), info);
  row->setData(0, node_role, qulonglong(object.node));
  row->setFlags(row->flags() | Qt::ItemIsEditable | Qt::ItemIsUserCheckable);
  row->setCheckState(0, object.visible ? Qt::Checked : Qt::Unchecked);
  row->setToolTip(0, tr("Click the eye to hide or show, double click to rename"));
  if (!object.visible) row->setForeground(0, colors::guide);
  row->setSelected(selected);
}

void ObjectList::take_click(QTreeWidgetItem* row) {
  if (node_of(row) == 0) {
    emit strokes_chosen(strokes_of(row));
    return;
  }
  std::vector<NodeId> nodes;
  for (const QTreeWidgetItem* selected : selectedItems()) {
    if (node_of(selected) != 0) nodes.push_back(node_of(selected));
  }
  emit objects_chosen(nodes);
}

void ObjectList::take_change(QTreeWidgetItem* row, int column) {
  const NodeId node = node_of(row);
  if (node == 0 || column != 0) return;
  const std::string name = row->text(0).toStdString();
  const bool visible = row->checkState(0) == Qt::Checked;
  // Whoever hears it shows all rows anew.
  QMetaObject::invokeMethod(
      this,
      [this, node, name, visible] {
        emit renamed(node, name);
        emit shown(node, visible);
      },
      Qt::QueuedConnection);
}

void ObjectList::contextMenuEvent(QContextMenuEvent* event) {
  QTreeWidgetItem* row = itemAt(event->pos());
  if (row == nullptr || node_of(row) == 0) return;
  const NodeId node = node_of(row);
  QMenu menu(this);
  menu.addAction(tr("Rename"), this, [this, row] { editItem(row, 0); });
  menu.addAction(tr("Delete"), this, [this, node] { emit removed(node); });
  menu.exec(event->globalPos());
}

}  // namespace croquis::app
