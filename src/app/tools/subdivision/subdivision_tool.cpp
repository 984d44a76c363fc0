// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/tools/subdivision/subdivision_tool.h"

#include <QAction>
#include <QHeaderView>
#include <QMenu>
#include <algorithm>
#include <limits>
#include <numbers>
#include <utility>

#include "app/panels/number_box.h"
#include "app/replay/replays.h"
#include "app/tools/action_rows.h"
#include "app/views/viewport.h"
#include "app/window/language.h"
#include "app/window/panel_docks.h"
#include "croquis/base/error.h"
#include "croquis/geometry/mesh_topology.h"
#include "croquis/mesh_editing/mesh_edit.h"
#include "croquis/operators/subdivide_result.h"
#include "croquis/subdivision/shape_keeping.h"
#include "croquis/workspace/node_values.h"
#include "croquis/workspace/object_names.h"

namespace croquis::app {
namespace {

const std::vector<SharpChain>& chains_of(const WorkObject* object) {
  static const std::vector<SharpChain> none;
  const SubdivideResult* found = object == nullptr ? nullptr : result_of<SubdivideResult>(object->result.get());
  return found == nullptr ? none : found->chains;
}

QString chain_angle(double angle) { return number_words(angle * (180 / std::numbers::pi), 6) + "°"; }

/// An id that no document reaches.
constexpr NodeId compared_node = NodeId{1} << 62;

/// The first choice is compared with the second, every other one with the first.
std::string another_choice(const ParameterDescription& parameter, const std::string& value) {
  const bool first = value == parameter.choices.front();
  return parameter.choices[first && parameter.choices.size() > 1 ? 1 : 0];
}

const std::string smoothing_operation = "subdivide";
const std::string level_parameter = "levels";
constexpr int finest_shown = 6;  // finer levels are for files

const Node* smoothing_node(const Studio& studio) {
  const Node* node = active_operation(studio);
  return node == nullptr || node->operation != smoothing_operation ? nullptr : node;
}

const ParameterDescription* level_description(const Studio& studio) {
  const OperationDescription* operation = studio.description(smoothing_operation);
  if (operation == nullptr) return nullptr;
  return find_parameter(operation->parameters, level_parameter);
}

/// Of the chains of sharp edges, in degrees.
std::pair<double, double> dihedral_range(const WorkObject& object) {
  const SubdivideResult* subdivided = result_of<SubdivideResult>(object.result.get());
  if (subdivided == nullptr || subdivided->chains.empty()) refuse_replay("There are no chains of sharp edges");
  constexpr double degrees = 180 / std::numbers::pi;
  double least = std::numeric_limits<double>::infinity();
  double greatest = 0;
  for (const SharpChain& chain : subdivided->chains) {
    least = std::min(least, chain.least_angle * degrees);
    greatest = std::max(greatest, chain.greatest_angle * degrees);
  }
  return {least, greatest};
}

// The subdivision of the active object, as keys and menus change it: an operation between its cage and what is seen,
// so nothing is lost. Everything but what keys 1 to 3 show is one step of the history.

/// Shows the cage, both, or the smooth surface; for all but the cage the object gets the operation if it has none.
void show_smooth(Studio& studio, ChainView view) {
  const WorkObject* object = studio.active();
  if (object == nullptr || object->cage == 0) return;
  NodeId node = object->node;
  if (object->is_source()) {
    if (view == ChainView::Cage) return;
    const std::string label = "Smooth " + readable_name(object->name);
    AddedNode added = with_step(studio.session().document(), studio.registry(), object->cage, smoothing_operation);
    node = added.node;
    studio.session().edit(label, std::move(added.document));
    studio.set_active(node);
  }
  studio.set_view(node, view);
}

/// Nothing where there is no such operation.
void set_smoothing(Studio& studio, const std::string& parameter, const ParameterValue& value) {
  if (const Node* node = smoothing_node(studio)) studio.set_parameter(node->id, parameter, value, false);
}

/// One level finer or coarser, within what the operation allows.
void change_level(Studio& studio, int by) {
  const ParameterDescription* level = level_description(studio);
  const int shown = shown_level(studio);
  if (shown < 0) return;
  const int finest = std::min(std::max(finest_shown, shown), static_cast<int>(level->maximum));
  const int wanted = std::clamp(shown + by, static_cast<int>(level->minimum), finest);
  if (wanted != shown) set_smoothing(studio, level_parameter, std::int64_t{wanted});
}

/// What is computed, a level or a scan with filled holes, becomes a mesh of its own, with its tags and patches; the old
/// object is hidden.
/// @throws Error (E_EMPTY) when nothing computed is seen, or it isn't finished
void freeze_level(Studio& studio) {
  const WorkObject* object = studio.active();
  const bool finished = object != nullptr && !object->is_source() && object->cage != 0 && object->mesh &&
                        object->result && !object->result->failed && object->quality == Quality::Final;
  if (!finished) {
    throw Error(
        make_error(Category::Usage, "E_EMPTY", "There is no finished mesh to freeze: press 3 or fill holes first"));
  }
  const Document& before = studio.session().document();
  const int level = shown_level(studio);
  const std::string name = object->name + (level < 0 ? " filled" : " level " + std::to_string(level));
  Node hidden = *before.find(object->node);
  hidden.visible = false;
  Node frozen;
  frozen.name = free_name(before, name);
  frozen.source = object->mesh;
  frozen.placement = object->placement;
  frozen.group = object->group;
  const NodeId id = before.next_id();
  studio.session().edit("Freeze " + name, before.with(std::move(hidden)).with(std::move(frozen)));
  studio.set_active(id);
  studio.session().select({{id, ""}});
}

enum class KeptShape { Faces, Outline };

/// Makes the active object's selected faces stay as they are on every level, or only their outline, by tags and pins;
/// bent faces are cut into triangles first. One step of the history.
/// @return what had to be done to the faces
/// @throws Error (E_EMPTY) when no faces are selected
Findings keep_selected_faces(Studio& studio, KeptShape kept) {
  const WorkObject* object = studio.active();
  const ComponentSelection& selected = studio.session().components();
  const bool has_faces = object != nullptr && object->cage_mesh && selected.node == object->cage &&
                         selected.kind == ComponentKind::Face && !selected.empty();
  if (!has_faces) {
    throw Error(make_error(Category::Usage, "E_EMPTY", "No faces are selected: pick those to keep first (F11)"));
  }
  const Document& before = studio.session().document();
  Node cage = *before.find(object->cage);
  if (!cage.source) {
    throw Error(make_error(Category::Usage, "E_INPUT", "The mesh is computed: freeze its last step first"));
  }
  Findings notices;
  PolyMesh mesh;
  if (kept == KeptShape::Faces) {
    subdivision::KeptRegion region = subdivision::keep_region(*object->cage_mesh, selected.elements);
    notices = std::move(region.notices);
    mesh = std::move(region.mesh);
  } else {
    mesh = subdivision::keep_outline(*object->cage_mesh, selected.elements);
  }
  cage.source = std::make_shared<const PolyMesh>(std::move(mesh));
  studio.session().edit(kept == KeptShape::Faces ? "Keep the shape of faces" : "Keep the outline of faces",
                        before.with(std::move(cage)));
  return notices;
}

}  // namespace

int shown_level(const Studio& studio) {
  const Node* node = smoothing_node(studio);
  if (node == nullptr || level_description(studio) == nullptr) return -1;
  return static_cast<int>(integer_of(values_of(*node, *studio.description(smoothing_operation)), level_parameter));
}

ChainTable::ChainTable(QWidget* parent) : QTableWidget(parent) {
  setTabKeyNavigation(false);
  setObjectName("chains");
  setAccessibleName(tr("Chains of sharp edges"));
  setToolTip(tr("Angles at which the surface folds along the chain, on the level that is seen"));
  setColumnCount(5);
  setHorizontalHeaderLabels({tr("Chain"), tr("Edges"), tr("Closed"), tr("Least"), tr("Greatest")});
  horizontalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
  horizontalHeader()->setStretchLastSection(true);
  verticalHeader()->hide();
  verticalHeader()->setDefaultSectionSize(22);
  setSelectionBehavior(QAbstractItemView::SelectRows);
  setEditTriggers(QAbstractItemView::NoEditTriggers);
  setShowGrid(false);
  connect(this, &QTableWidget::cellClicked, this, [this](int row, int) { emit chain_chosen(row); });
}

void ChainTable::show_chains(const WorkObject* object) {
  const std::vector<SharpChain>& chains = chains_of(object);
  setRowCount(static_cast<int>(chains.size()));
  cage_edges_.clear();
  for (int row = 0; row < rowCount(); ++row) {
    const SharpChain& chain = chains[static_cast<std::size_t>(row)];
    cage_edges_.push_back(chain.cage_edges);
    const QStringList cells{QString::number(row + 1), QString::number(chain.edges), chain.closed ? tr("yes") : tr("no"),
                            chain_angle(chain.least_angle), chain_angle(chain.greatest_angle)};
    for (int column = 0; column < cells.size(); ++column) {
      if (item(row, column) == nullptr) setItem(row, column, new QTableWidgetItem);
      item(row, column)->setText(cells[column]);
    }
  }
}

std::vector<std::array<Index, 2>> ChainTable::cage_edges(int chain) const {
  return cage_edges_.at(static_cast<std::size_t>(chain));
}

QString ChainTable::summary(const WorkObject* object) {
  const std::vector<SharpChain>& chains = chains_of(object);
  if (chains.empty()) return {};
  QStringList parts{chains.size() == 1 ? tr("1 crease") : tr("%1 creases").arg(chains.size())};
  const auto& mesh = object->cage_mesh;
  if (mesh && !mesh->tags.pins.empty())
    parts << (mesh->tags.pins.size() == 1 ? tr("1 pin") : tr("%1 pins").arg(mesh->tags.pins.size()));
  return parts.join(", ");
}

Comparison::Comparison(Studio& studio, QThreadPool& threads, QObject* parent)
    : QObject(parent), studio_(studio), item_(threads) {
  connect(&item_, &LiveItem::ready, this, &Comparison::changed);
}

void Comparison::show(bool shown) {
  shown_ = shown;
  follow();
}

void Comparison::choose(const std::string& parameter, const std::string& value) {
  parameter_ = parameter;
  value_ = value;
  follow();
}

void Comparison::follow() {
  const Node* node = active_operation(studio_);
  const OperationDescription* operation = node == nullptr ? nullptr : studio_.description(node->operation);
  const ParameterDescription* parameter =
      operation == nullptr ? nullptr : find_parameter(operation->parameters, parameter_);
  if (!shown_ || parameter == nullptr || parameter->choices.empty()) {
    object_ = 0;
    live_.reset();
    item_.show(nullptr, {});
    return;
  }
  object_ = node->id;
  const std::string shown =
      value_.empty() ? another_choice(*parameter, text_of(values_of(*node, *operation), parameter_)) : value_;
  const auto chosen = std::ranges::find(parameter->choices, shown) - parameter->choices.begin();
  const bool is_titled = chosen < std::ssize(parameter->choice_titles);
  title_ = shown_text(is_titled ? parameter->choice_titles[static_cast<std::size_t>(chosen)] : shown);
  Node other = *node;
  other.id = compared_node;
  other.parameters[parameter_] = shown;
  if (!live_) {
    live_ = studio_.live_beside(compared_node, [this] { take(); });
  }
  live_->follow(studio_.session().document().with(std::move(other)));
}

void Comparison::take() {
  const Node* node = studio_.session().document().find(object_);
  const OperationDescription* operation = node == nullptr ? nullptr : studio_.description(node->operation);
  if (operation == nullptr || !live_ || !live_->result()) return;
  item_.show(mesh_of(*live_->result(), *operation), {});
  emit changed();
}

SubdivisionTool::SubdivisionTool(ToolHost& host)
    : Tool(host, "Subdivision"), comparison_(host.studio(), host.viewport().objects().threads(), nullptr) {
  connect(&comparison_, &Comparison::changed, this, [this] { emit changed(ComparisonView); });
}

void SubdivisionTool::make_actions(ActionList& actions) {
  QMenu* menu = actions.menu(MenuId::Mesh)->addMenu(tr("Subdivision"));
  const auto add_view = [&](const QString& name, const QString& text, const QString& key, ChainView view) {
    actions_ << actions.add(menu, name, text, {QKeySequence(key)}, [this, view] {
      show_smooth(studio(), view);
      host().refresh();
    });
  };
  add_view("show-cage", tr("Cage"), "1", ChainView::Cage);
  add_view("show-both", tr("Cage and smooth surface"), "2", ChainView::Both);
  add_view("show-smooth", tr("Smooth surface"), "3", ChainView::Result);
  menu->addSeparator();
  actions_ << actions.add(menu, "finer", tr("Finer"), {QKeySequence(Qt::Key_PageUp)},
                          [this] { change_level(studio(), 1); });
  actions_ << actions.add(menu, "coarser", tr("Coarser"), {QKeySequence(Qt::Key_PageDown)},
                          [this] { change_level(studio(), -1); });
  menu->addSeparator();
  QMenu* schemes = menu->addMenu(tr("Scheme"));
  auto* compared = new QMenu(tr("Compare with"), menu);
  make_scheme_actions(actions, schemes, compared);
  actions_ << add_toggle(actions, menu, "compare", tr("Side by side with another scheme"), {QKeySequence("L")},
                         [this](bool on) { compare(on); });
  menu->addMenu(compared);
  menu->addSeparator();
  const auto add_keep = [&](const QString& name, const QString& text, KeptShape kept) {
    actions_ << actions.add(menu, name, text, {}, [this, kept] {
      host().attempt([&] { host().show_message(keep_selected_faces(studio(), kept)); });
    });
  };
  add_keep("keep-shape", tr("Keep the shape of the selected faces"), KeptShape::Faces);
  add_keep("keep-outline", tr("Keep their outline"), KeptShape::Outline);
  actions_ << actions.add(actions.menu(MenuId::Create), "freeze", tr("Mesh from what is shown"), {},
                          [this] { host().attempt([this] { freeze_level(studio()); }); });
}

void SubdivisionTool::make_scheme_actions(ActionList& actions, QMenu* schemes, QMenu* compared) {
  const OperationDescription* operation = studio().description("subdivide");
  for (const ParameterDescription& parameter :
       operation == nullptr ? std::vector<ParameterDescription>() : operation->parameters) {
    if (parameter.name != "scheme" && parameter.name != "preset") continue;
    for (std::size_t i = 0; i < parameter.choices.size(); ++i) {
      const std::string& choice = parameter.choices[i];
      const QString text = shown_text(parameter.choice_titles[i]);
      const QString id = QString::fromStdString(choice);
      actions_ << actions.add(schemes, QString::fromStdString(parameter.name) + "-" + id, text, {},
                              [this, name = parameter.name, choice] { set_smoothing(studio(), name, choice); });
      actions_ << actions.add(compared, "compare-" + id, text, {}, [this, name = parameter.name, choice] {
        comparison_.choose(name, choice);
        host().action("compare")->setChecked(true);
        compare(true);
      });
    }
    schemes->addSeparator();
    compared->addSeparator();
  }
}

void SubdivisionTool::make_panels(PanelDocks& panels) {
  chains_ = new ChainTable(nullptr);
  panels.add_to_column("edges", chains_);
  connect(chains_, &ChainTable::chain_chosen, this, &SubdivisionTool::select_chain);
}

void SubdivisionTool::refresh() {
  const WorkObject* object = studio().active();
  for (QAction* action : actions_) action->setEnabled(object != nullptr && object->cage != 0);
  chains_->show_chains(object);
}

QString SubdivisionTool::offer() const {
  if (studio().active() == nullptr || studio().active()->cage == 0 || shown_level(studio()) < 0) return {};
  return tr("1 cage, 2 both, 3 smooth · Page Up and Down change the level · F10 picks edges to sharpen");
}

void SubdivisionTool::compare(bool shown) {
  // One of them has the second view.
  if (QAction* versions = host().action("compare-version"); shown && versions->isChecked()) versions->trigger();
  comparison_.show(shown);
  Views& views = host().views();
  const bool sketched = !studio().drawing().strokes.empty();
  views.layout.arrange(shown ? Arrangement::Compare : sketched ? Arrangement::SketchAndSolid : Arrangement::Four);
  if (!shown && !sketched) views.layout.show_alone(PerspectiveView);
  show_scene(views);
}

void SubdivisionTool::select_chain(int chain) {
  const WorkObject* object = studio().active();
  if (object == nullptr || !object->cage_mesh) return;
  pick(host(), ComponentKind::Edge, edges_of(MeshTopology(*object->cage_mesh), chains_->cage_edges(chain)));
}

void SubdivisionTool::adjust(ObjectScenes::Wanted& wanted, int view) const {
  if (view != ComparisonView) return;
  wanted.replaced = comparison_.object();
  wanted.by = comparison_.item();
}

ViewUse SubdivisionTool::use_of(int view) const {
  return {.title = view == ComparisonView ? comparison_.title() : QString()};
}

void SubdivisionTool::follow(Change change) {
  if (change == Change::Document) comparison_.follow();
}

void SubdivisionTool::make_replays(Replays& replays) {
  replays.ranges["dihedral"] = [this](const std::string& node) { return dihedral_range(object_named(studio(), node)); };
}

}  // namespace croquis::app
