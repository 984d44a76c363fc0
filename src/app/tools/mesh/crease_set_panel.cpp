// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/tools/mesh/crease_set_panel.h"

#include <QHBoxLayout>
#include <QHeaderView>
#include <QPushButton>
#include <QSignalBlocker>
#include <QTreeWidget>
#include <QVBoxLayout>
#include <cmath>

#include "app/panels/number_box.h"
#include "app/tools/mesh/sharpness_field.h"

namespace croquis::app {
namespace {

constexpr int set_name_role = Qt::UserRole;

std::string name_of(const QTreeWidgetItem* row) { return row->data(0, set_name_role).toString().toStdString(); }

}  // namespace

CreaseSetPanel::CreaseSetPanel(MeshInteraction& mesh, QWidget* parent)
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
          if (before != after) mesh_.act([&](MeshTool& tool) { return tool.tags().rename_set(before, after); });
        },
        Qt::QueuedConnection);
  });
  sharpness_->setObjectName("set-sharpness");
  connect(sharpness_, &QDoubleSpinBox::valueChanged, this, [this] {
    mesh_.act([&](MeshTool& tool) { return tool.tags().set_set_sharpness(chosen(), sharpness_->sharpness()); });
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
  add_button(row, "set-new", tr("New"), tr("A set of the selected edges or vertices"), [this] {
    mesh_.act([](MeshTool& tool) {
      const auto mesh = tool.editable().mesh();
      return mesh ? tool.tags().make_set(new_set_name(mesh->tags)) : Verdict::Continue;
    });
  });
  layout->addWidget(sharpness_);
  add_button(row, "set-select", tr("Select"), tr("Selects the set's edges or vertices"),
             [this] { mesh_.act([this](MeshTool& tool) { return tool.tags().select_set(chosen()); }); });
  add_button(row, "set-merge", tr("Merge"), tr("Puts all chosen sets into the first one"), [this] { merge(); });
  add_button(row, "set-delete", tr("Delete"), tr("Forgets the set; its edges stay as sharp as they are"),
             [this] { mesh_.act([this](MeshTool& tool) { return tool.tags().remove_set(chosen(), false); }); });
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
    mesh_.act([&](MeshTool& tool) { return tool.tags().merge_sets(names.front(), names[i]); });
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

}  // namespace croquis::app
