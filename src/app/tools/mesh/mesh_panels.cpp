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
#include <algorithm>
#include <cmath>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "app/panels/attribute_panel.h"
#include "app/panels/panel.h"
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

/// A sharpness: 0 for none … 10, whose last step is infinite.
class SharpnessField : public QDoubleSpinBox {
 public:
  SharpnessField(QWidget* parent, const QString& name) : QDoubleSpinBox(parent) {
    setObjectName(name);
    setRange(0, greatest_sharpness);
    setSingleStep(0.5);
    setDecimals(2);
    setKeyboardTracking(false);
    setAccessibleName(tr("Sharpness"));
  }

  /// Without a signal.
  void show_sharpness(double sharpness) {
    const QSignalBlocker quiet(this);
    setValue(std::min(sharpness, greatest_sharpness));
  }
  double sharpness() const { return value() >= greatest_sharpness ? infinite_sharpness : value(); }

 protected:
  QString textFromValue(double value) const override {
    return value >= greatest_sharpness ? infinity_sign : QDoubleSpinBox::textFromValue(value);
  }
  double valueFromText(const QString& text) const override {
    return means_infinity(text) ? greatest_sharpness : QDoubleSpinBox::valueFromText(text);
  }
  QValidator::State validate(QString& text, int& position) const override {
    if (means_infinity(text)) return QValidator::Acceptable;
    if (QStringLiteral("inf").startsWith(text.trimmed().toLower())) return QValidator::Intermediate;
    return QDoubleSpinBox::validate(text, position);
  }
};

constexpr double first_angle = 60;

QString elements(ComponentKind kind, std::size_t count) {
  switch (kind) {
    case ComponentKind::Vertex: return counted_words(count, Panel::tr("1 vertex"), Panel::tr("%1 vertices"));
    case ComponentKind::Edge: return counted_words(count, Panel::tr("1 edge"), Panel::tr("%1 edges"));
    case ComponentKind::Face: break;
  }
  return counted_words(count, Panel::tr("1 face"), Panel::tr("%1 faces"));
}

/// Sharpness of what is selected as a number.
void add_selected_sharpness(Panel& panel, MeshEditingTool& mesh, const Studio& studio) {
  QLabel* selected = panel.label({});
  auto* sharpness = new SharpnessField(&panel, "selected-sharpness");
  sharpness->setToolTip(Panel::tr("Sharpness of the selected edges in levels: 0 smooth, 10 and more always sharp"));
  QObject::connect(sharpness, &QDoubleSpinBox::valueChanged, &panel,
                   [&mesh, sharpness] { take_step(mesh, recorded::Tag{.sharpness = sharpness->sharpness()}); });
  panel.row({selected, {sharpness, 1}});
  panel.also([&panel, &mesh, &studio, selected, sharpness] {
    const ComponentSelection& selection = studio.session().components();
    EditableMesh& editable = mesh.tool().editable();
    panel.setEnabled(editable.mesh() != nullptr);
    const bool edges = selection.node == editable.node() && selection.kind == ComponentKind::Edge && !selection.empty();
    selected->setText(selection.empty() ? Panel::tr("Sharpness") : elements(selection.kind, selection.elements.size()));
    sharpness->setEnabled(!selection.empty());
    const bool known = edges && selection.elements.front() < editable.edge_sharpness().size();
    sharpness->show_sharpness(known ? editable.edge_sharpness()[selection.elements.front()] : 0);
  });
}

/// Selects the edges whose faces meet at a greater angle. @return how many there are
std::size_t choose_by_angle(MeshEditingTool& mesh, double degrees) {
  const PreparedMesh* now = mesh.tool().editable().prepared();
  const Elements edges = now == nullptr ? Elements() : edges_sharper_than(*now->topology, *now->mesh, degrees);
  if (mesh.tool().selection().mode() != MeshMode::Edge) mesh.set_mesh_mode(MeshMode::Edge);
  mesh.act([&edges](MeshTool& tool) {
    return edges.empty() ? tool.selection().select_none() : tool.selection().choose(ComponentKind::Edge, edges);
  });
  return edges.size();
}

/// Edges chosen by their angle with their count while one drags.
void add_angle(Panel& panel, MeshEditingTool& mesh) {
  QLabel* name = panel.label(Panel::tr("By angle"));
  name->setToolTip(Panel::tr("Drag: edges whose faces meet at a greater angle are selected and counted"));
  auto* slider = new QSlider(Qt::Horizontal, &panel);
  slider->setObjectName("angle-slider");
  slider->setRange(0, 180);
  slider->setValue(static_cast<int>(first_angle));
  QDoubleSpinBox* angle = make_number_box(&panel, "angle", {0, 180, 1});
  angle->setSuffix("°");
  angle->setValue(first_angle);
  for (QWidget* field : {static_cast<QWidget*>(slider), static_cast<QWidget*>(angle)})
    field->setAccessibleName(Panel::tr("Least angle of edges to select"));
  QLabel* count = panel.label({});
  count->setObjectName("angle-count");
  const auto choose = [&mesh, slider, angle, count](double degrees) {
    const QSignalBlocker quiet_slider(slider);
    const QSignalBlocker quiet_box(angle);
    slider->setValue(static_cast<int>(degrees + 0.5));
    angle->setValue(degrees);
    count->setText(QString::number(choose_by_angle(mesh, degrees)));
  };
  QObject::connect(slider, &QSlider::valueChanged, &panel, choose);
  QObject::connect(angle, &QDoubleSpinBox::valueChanged, &panel, choose);
  const QString tip = Panel::tr("Makes all edges sharp whose faces meet at a greater angle");
  QPushButton* tag = panel.button("tag-by-angle", Panel::tr("Sharp"), tip, [&mesh, angle] {
    take_step(mesh, recorded::Tag{.edges = "sharper-than", .degrees = angle->value(), .sharpness = infinite_sharpness});
  });
  panel.row({name, {slider, 1}, angle, count, tag});
}

constexpr int set_name_role = Qt::UserRole;

std::string name_of(const QTreeWidgetItem* row) { return row->data(0, set_name_role).toString().toStdString(); }

/// The names of the chosen sets.
std::vector<std::string> chosen_sets(const QTreeWidget& list) {
  std::vector<std::string> names;
  for (const QTreeWidgetItem* row : list.selectedItems()) names.push_back(name_of(row));
  return names;
}

/// Of the first chosen set; empty for none.
std::string chosen_set(const QTreeWidget& list) {
  const std::vector<std::string> names = chosen_sets(list);
  return names.empty() ? std::string() : names.front();
}

void show_sets(QTreeWidget& list, const MeshTags& tags) {
  const std::string before = chosen_set(list);
  const QSignalBlocker quiet(&list);
  bool same = static_cast<std::size_t>(list.topLevelItemCount()) == tags.sets.size();
  for (std::size_t i = 0; same && i < tags.sets.size(); ++i) {
    same = name_of(list.topLevelItem(static_cast<int>(i))) == tags.sets[i].name;
  }
  if (!same) list.clear();
  for (std::size_t i = 0; i < tags.sets.size(); ++i) {
    const CreaseSet& set = tags.sets[i];
    const QString name = QString::fromStdString(set.name);
    QTreeWidgetItem* row = same ? list.topLevelItem(static_cast<int>(i)) : new QTreeWidgetItem(&list, {name, {}});
    row->setData(0, set_name_role, name);
    row->setFlags(row->flags() | Qt::ItemIsEditable);
    const QString sharpness = std::isinf(set.sharpness) ? infinity_sign : number_words(set.sharpness);
    row->setText(1, set.edges.empty() ? Panel::tr("%1 pins").arg(set.pins.size())
                                      : Panel::tr("%1 edges, %2").arg(set.edges.size()).arg(sharpness));
    if (!same && set.name == before) row->setSelected(true);
  }
}

QTreeWidget* make_set_list(Panel& panel, MeshEditingTool& mesh) {
  auto* list = new QTreeWidget(&panel);
  list->setObjectName("crease-set-list");
  list->setAccessibleName(Panel::tr("Crease sets"));
  list->setColumnCount(2);
  list->setHeaderHidden(true);
  list->setRootIsDecorated(false);
  list->setSelectionMode(QAbstractItemView::ExtendedSelection);
  list->header()->setSectionResizeMode(0, QHeaderView::Stretch);
  list->header()->setStretchLastSection(false);
  QObject::connect(list, &QTreeWidget::itemSelectionChanged, &panel, [&panel] { panel.follow(); });
  QObject::connect(list, &QTreeWidget::itemChanged, &panel, [&panel, &mesh](QTreeWidgetItem* row) {
    const recorded::TagSet renamed{.how = "rename", .name = name_of(row), .other = row->text(0).toStdString()};
    if (renamed.name == renamed.other) return;
    // Receivers show all rows again.
    QMetaObject::invokeMethod(
        &panel, [&mesh, renamed] { take_step(mesh, renamed); }, Qt::QueuedConnection);
  });
  return list;
}

void merge_sets(MeshEditingTool& mesh, const std::vector<std::string>& names) {
  for (std::size_t i = 1; i < names.size(); ++i)
    take_step(mesh, recorded::TagSet{.how = "merge", .name = names.front(), .other = names[i]});
}

/// The named sets of tagged edges and pins of the mesh that is worked on: made from the selection, renamed, given a
/// sharpness, selected, merged, removed.
Panel* make_set_panel(MeshEditingTool& mesh) {
  auto* panel = new Panel("crease-sets");
  panel->column()->setContentsMargins(4, 2, 4, 4);
  panel->column()->setSpacing(3);
  QTreeWidget* list = make_set_list(*panel, mesh);
  panel->column()->addWidget(list, 1);
  auto* sharpness = new SharpnessField(panel, "set-sharpness");
  QObject::connect(sharpness, &QDoubleSpinBox::valueChanged, panel, [&mesh, list, sharpness] {
    take_step(mesh,
              recorded::TagSet{.how = "sharpness", .name = chosen_set(*list), .sharpness = sharpness->sharpness()});
  });
  const auto button = [panel](const QString& name, const QString& text, const QString& tip, auto work) {
    QPushButton* made = panel->button(name, text, tip, work);
    made->setStyleSheet("padding: 2px 6px");
    return made;
  };
  const auto take = [&mesh, list](const char* how) {
    return [&mesh, list, how] { take_step(mesh, recorded::TagSet{.how = how, .name = chosen_set(*list)}); };
  };
  QPushButton* fresh = button("set-new", Panel::tr("New"), Panel::tr("A set of the selected edges or vertices"),
                              [&mesh] { make_crease_set(mesh); });
  QPushButton* select =
      button("set-select", Panel::tr("Select"), Panel::tr("Selects the set's edges or vertices"), take("select"));
  QPushButton* merge = button("set-merge", Panel::tr("Merge"), Panel::tr("Puts all chosen sets into the first one"),
                              [&mesh, list] { merge_sets(mesh, chosen_sets(*list)); });
  QPushButton* remove = button("set-delete", Panel::tr("Delete"),
                               Panel::tr("Forgets the set; its edges stay as sharp as they are"), take("remove"));
  panel->row({fresh, sharpness, select, merge, remove})->setSpacing(3);
  panel->also([&mesh, list, sharpness] {
    const bool editing = list->findChild<QWidget*>("qt_edit") != nullptr;
    if (editing) return;
    const auto now = mesh.tool().editable().mesh();
    static const MeshTags none;
    const MeshTags& tags = now ? now->tags : none;
    show_sets(*list, tags);
    const CreaseSet* set = find_set(tags, chosen_set(*list));
    sharpness->setEnabled(set != nullptr && !set->edges.empty());
    sharpness->show_sharpness(set == nullptr ? 0 : set->sharpness);
  });
  return panel;
}

/// The newest change, where it is an edit with parameters; else null.
const EditLine* adjustable_edit(MeshEditingTool& mesh) {
  const EditLine* line = mesh.tool().edits().last();
  return line == nullptr || find_edit(line->edit)->description.parameters.empty() ? nullptr : line;
}

void adjust_edit(MeshEditingTool& mesh, const std::string& parameter, const ParameterValue& value) {
  mesh.act([&](MeshTool& tool) {
    const EditLine* last = tool.edits().last();
    if (last == nullptr) return Verdict::Continue;
    ParameterValues parameters = last->parameters;
    parameters[parameter] = value;
    return tool.edits().adjust(std::move(parameters));
  });
}

/// The last edit with its parameters, as fields made from its description: a change applies it again instead of what
/// it was.
Panel* make_edit_panel(MeshEditingTool& mesh) {
  auto* panel = new Panel("last-edit");
  panel->column()->setContentsMargins(6, 4, 6, 2);
  QLabel* title = panel->label({});
  title->setObjectName("last-edit-title");
  panel->column()->addWidget(title);
  auto* form = new QFormLayout;
  form->setVerticalSpacing(3);
  panel->column()->addLayout(form);
  panel->column()->setSpacing(3);
  using Fields = std::map<std::string, ParameterField*>;
  panel->also([panel, &mesh, title, form, shown = std::string(), fields = Fields()]() mutable {
    const EditLine* line = adjustable_edit(mesh);
    if (line == nullptr) return;
    const EditDescription& edit = find_edit(line->edit)->description;
    if (std::exchange(shown, edit.id) != edit.id) {
      while (form->rowCount() > 0) form->removeRow(0);
      fields.clear();
      for (const ParameterDescription& parameter : edit.parameters) {
        const auto take = [panel, &mesh, name = parameter.name](const ParameterValue& value, bool) {
          adjust_edit(mesh, name, value);
          panel->follow();  // a value that was refused goes back to what it was
        };
        fields[parameter.name] = add_parameter_row(*form, parameter, take);
      }
    }
    title->setText(localized(mesh.tool().edits().label_of(*line)));
    for (const auto& [name, value] : complete(edit.parameters, line->parameters)) fields.at(name)->show_value(value);
  });
  return panel;
}

}  // namespace

/// Sharp edges and crease sets lie below the attributes, in one place.
std::function<void(bool useful)> make_mesh_panels(MeshEditingTool& mesh, const Studio& studio, PanelDocks& docks) {
  auto* tags = new Panel("tags");
  tags->column()->setContentsMargins(6, 4, 6, 2);
  tags->column()->setSpacing(3);
  add_selected_sharpness(*tags, mesh, studio);
  add_angle(*tags, mesh);
  Panel* sets = make_set_panel(mesh);
  Panel* last_edit = make_edit_panel(mesh);
  QDockWidget* edges_dock = docks.add_column(QObject::tr("Sharp edges"), tags, "edges");
  QDockWidget* sets_dock = docks.add(QObject::tr("Crease sets"), sets, "sets");
  docks.split_below("attributes", edges_dock);
  docks.tabify("edges", sets_dock);
  edges_dock->raise();
  QDockWidget* edit_dock = docks.add_column(QObject::tr("Last edit"), last_edit, "last-edit");
  const auto show_last_edit = [&mesh, &docks, last_edit, edit_dock] {
    last_edit->follow();
    docks.set_useful(edit_dock, adjustable_edit(mesh) != nullptr);
  };
  QObject::connect(&mesh, &Tool::committed, last_edit, show_last_edit);
  return [&docks, tags, sets, edges_dock, sets_dock, show_last_edit](bool useful) {
    tags->follow();
    sets->follow();
    show_last_edit();
    docks.set_useful(edges_dock, useful);
    docks.set_useful(sets_dock, useful);
  };
}

}  // namespace croquis::app
