// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/tools/subdivision/subdivision_tool.h"

#include <QAction>
#include <QMenu>
#include <algorithm>
#include <limits>
#include <numbers>

#include "app/replay/replay_lookup.h"
#include "app/tools/subdivision/chain_table.h"
#include "app/tools/subdivision/smoothing.h"
#include "app/views/viewport.h"
#include "app/window/action_list.h"
#include "app/window/panel_docks.h"
#include "croquis/geometry/mesh_topology.h"
#include "croquis/mesh_editing/mesh_edit.h"
#include "croquis/operators/subdivide_result.h"

namespace croquis::app {
namespace {

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

}  // namespace

SubdivisionTool::SubdivisionTool(ToolHost& host)
    : Tool(host), comparison_(host.studio(), host.viewport().objects().threads(), nullptr) {
  connect(&comparison_, &Comparison::changed, this, [this] { emit changed_in(ComparisonView); });
}

void SubdivisionTool::make_actions(ActionList& actions) {
  QMenu* menu = actions.menu(tr("&Subdivision"));
  const auto add_view = [&](const QString& name, const QString& text, const QString& key, ChainView view) {
    actions_ << actions.add(menu, name, text, {QKeySequence(key)}, [this, view] {
      show_smooth(studio(), view);
      host().refresh();
    });
  };
  add_view("show-cage", tr("&Cage"), "1", ChainView::Cage);
  add_view("show-both", tr("Cage and smooth &surface"), "2", ChainView::Both);
  add_view("show-smooth", tr("&Smooth surface"), "3", ChainView::Result);
  menu->addSeparator();
  actions_ << actions.add(menu, "finer", tr("&Finer"), {QKeySequence(Qt::Key_PageUp)},
                          [this] { change_level(studio(), 1); });
  actions_ << actions.add(menu, "coarser", tr("C&oarser"), {QKeySequence(Qt::Key_PageDown)},
                          [this] { change_level(studio(), -1); });
  menu->addSeparator();
  QMenu* schemes = menu->addMenu(tr("Sc&heme"));
  auto* compared = new QMenu(tr("Compare &with"), menu);
  make_scheme_actions(actions, schemes, compared);
  QAction* side = actions.add(menu, "compare", tr("Side by side with another scheme"), {QKeySequence("L")},
                              [this] { compare(host().action("compare")->isChecked()); });
  side->setCheckable(true);
  actions_ << side;
  menu->addMenu(compared);
  menu->addSeparator();
  const auto add_keep = [&](const QString& name, const QString& text, KeptShape kept) {
    actions_ << actions.add(menu, name, text, {}, [this, kept] {
      host().attempt([&] { host().show_message(keep_selected_faces(studio(), kept)); });
    });
  };
  add_keep("keep-shape", tr("&Keep the shape of the selected faces"), KeptShape::Faces);
  add_keep("keep-outline", tr("Keep their &outline"), KeptShape::Outline);
  actions_ << actions.add(menu, "freeze", tr("F&reeze as a mesh of its own"), {},
                          [this] { host().attempt([this] { freeze_level(studio()); }); });
}

void SubdivisionTool::make_scheme_actions(ActionList& actions, QMenu* schemes, QMenu* compared) {
  const OperationDescription* operation = studio().description("subdivide");
  for (const ParameterDescription& parameter :
       operation == nullptr ? std::vector<ParameterDescription>() : operation->parameters) {
    if (parameter.name != "scheme" && parameter.name != "preset") continue;
    for (std::size_t i = 0; i < parameter.choices.size(); ++i) {
      const std::string& choice = parameter.choices[i];
      const QString text = QString::fromStdString(parameter.choice_titles[i]);
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

QString SubdivisionTool::offer(const WorkObject& object) const {
  if (object.cage == 0 || shown_level(studio()) < 0) return {};
  return tr("1 cage, 2 both, 3 smooth · Page Up and Down change the level · F10 picks edges to sharpen");
}

QString SubdivisionTool::status() const { return ChainTable::summary(studio().active()); }

void SubdivisionTool::compare(bool shown) {
  comparison_.show(shown);
  Viewport& views = host().viewport();
  const bool sketched = !studio().drawing().strokes.empty();
  views.arrange(shown ? Arrangement::Compare : sketched ? Arrangement::SketchAndSolid : Arrangement::Four);
  if (!shown && !sketched) views.show_alone(PerspectiveView);
  views.show_scene();
}

void SubdivisionTool::select_chain(int chain) {
  const WorkObject* object = studio().active();
  if (object == nullptr || !object->cage_mesh) return;
  host().pick(ComponentKind::Edge, edges_of(MeshTopology(*object->cage_mesh), chains_->cage_edges(chain)));
}

void SubdivisionTool::adjust(ObjectScenes::Wanted& wanted, int view) const {
  if (view != ComparisonView) return;
  wanted.replaced = comparison_.object();
  wanted.by = comparison_.item();
}

QString SubdivisionTool::view_title(int view) const { return view == ComparisonView ? comparison_.title() : QString(); }

Expectations SubdivisionTool::expectations() {
  Expectations own;
  own.ranges["dihedral"] = [this](const std::string& node) { return dihedral_range(object_named(studio(), node)); };
  return own;
}

}  // namespace croquis::app
