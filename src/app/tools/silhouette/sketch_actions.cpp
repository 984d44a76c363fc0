// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/tools/silhouette/sketch_actions.h"

#include <QActionGroup>
#include <QColorDialog>
#include <QMenu>
#include <algorithm>

#include "app/tools/action_rows.h"
#include "app/tools/silhouette/part_names.h"
#include "app/tools/silhouette/reading_strip.h"
#include "app/tools/silhouette/silhouette_tool.h"
#include "croquis/base/text.h"
#include "croquis/silhouette/stroke_data.h"
#include "croquis/tools/silhouette/stroke_setting.h"

namespace croquis::app {
namespace {

/// Empty, with the solid that will be made of it; the pen draws in it at once.
void add_sketch(ToolHost& host, const DrawingPlane& plane) {
  Studio& studio = host.studio();
  Drawing drawing;
  drawing.plane = plane;
  const Document& before = studio.session().document();
  SketchToolOptions options = studio.tool_options();
  options.name = free_name(before, options.name);
  const NodeId node = before.next_id();
  studio.session().edit("Add sketch",
                        add_drawing(before, std::make_shared<const Drawing>(std::move(drawing)), options));
  studio.session().select({{node, ""}});
  host.set_mode(first_mode);
  host.refresh();
}

/// Makes second ones of the selected parts, or else of the last one drawn, on the far side; takes away those that are.
void copy_to_far_side(const Studio& studio, const SketchTool& tool, SketchChips& chips) {
  const Drawing drawing = studio.drawing();
  const std::vector<Body> bodies = bodies_of(drawing, studio.result().get());
  std::vector<std::string> ids = tool.selected();
  if (ids.empty() && !drawing.strokes.empty()) ids.push_back(drawing.strokes.back().id);
  for (const std::string& id : ids) {
    const Body* body = body_with(bodies, {id});
    const std::vector<std::string> strokes = body == nullptr ? std::vector{id} : body->strokes;
    const auto copied = std::ranges::find_if(strokes, [&](const auto& each) { return has_far_copy(drawing, each); });
    const bool is_copied = copied != strokes.end();
    chips.set({.stroke = is_copied ? *copied : id, .far_copy = !is_copied});
  }
}

/// Asks for the colour of the selected parts, or else of the last one drawn.
void color_parts(Viewport& views, const Drawing& drawing, const SketchTool& tool, SketchChips& chips) {
  std::vector<std::string> ids = tool.selected();
  if (ids.empty() && !drawing.strokes.empty()) ids.push_back(drawing.strokes.back().id);
  if (ids.empty()) return;
  const QString before = QString::fromStdString(fill_of(drawing, ids.front()));
  const QColor color = QColorDialog::getColor(before.isEmpty() ? QColor(Qt::white) : QColor(before), &views,
                                              SilhouetteTool::tr("Colour of part"));
  if (!color.isValid()) return;
  for (const std::string& id : ids) chips.set({.stroke = id, .fill = color.name().toStdString()});
}

/// x of the line on both sides of which a drawing is the same: that of its strokes, else the middle of the largest one,
/// else of the view.
double mirror_axis(const Drawing& drawing, Viewport& views) {
  double axis = views.views().layout.pane(SketchView).camera.target.x, largest = 0;
  for (const Stroke& stroke : drawing.strokes) {
    if (const auto own = stroke.data.find(silhouette::mirror_key); own != stroke.data.end())
      return read_number(own->second, axis) ? axis : 0;
    Eigen::AlignedBox2d box;
    for (const StrokeSample& sample : stroke.samples) box.extend(sample.position);
    if (box.diagonal().norm() <= largest) continue;
    largest = box.diagonal().norm();
    axis = box.center().x();
  }
  return axis;
}

/// Makes the selected strokes symmetric, or ends that where all of them are.
void mirror_strokes(const Drawing& drawing, double axis, const SketchTool& tool, SketchChips& chips) {
  const auto is_mirrored = [&](const std::string& id) {
    return find_stroke(drawing, id)->data.contains(silhouette::mirror_key);
  };
  const std::vector<std::string> ids = tool.selected();
  const bool ends = std::ranges::all_of(ids, is_mirrored);
  for (const std::string& id : ids) {
    if (ends || !is_mirrored(id)) chips.set({.stroke = id, .mirror = ends ? "" : number_text(axis)});
  }
}

/// Beside the solid of the active sketch, which is hidden: both follow the drawing from then on.
void add_quad_cage(Studio& studio) {
  const WorkObject* object = studio.active();
  const Node* solid = object == nullptr ? nullptr : step_with(studio, *object, "inflate");
  if (solid == nullptr) return;
  const Document& before = studio.session().document();
  Node hidden = *before.find(object->node);
  hidden.visible = false;
  AddedNode added = with_step(before.with(std::move(hidden)), studio.registry(), solid->inputs.at("drawing").node,
                              "cage", solid->parameters);
  studio.session().edit("Make a quad cage of " + readable_name(object->name), std::move(added.document));
  studio.set_active(added.node);
  studio.session().select({{added.node, ""}});
}

}  // namespace

void add_sketch_actions(ToolHost& host, SketchTool& tool, SketchChips& chips, ReadingStrip& readings,
                        double& tube_share, ActionList& actions) {
  const auto tr = [](const char* text) { return SilhouetteTool::tr(text); };
  QMenu* added = actions.menu(MenuId::Create)->addMenu(tr("Sketch"));
  const auto add_plane = [&](const QString& name, const QString& text, const QList<QKeySequence>& keys,
                             const DrawingPlane& plane) {
    actions.add(added, name, text, keys, [&host, plane] { add_sketch(host, plane); });
  };
  add_plane("add-sketch", tr("Seen from the front"), {QKeySequence("Ctrl+Shift+N")}, {});
  add_plane("add-sketch-top", tr("Seen from the top"), {}, {Vec3::Zero(), Vec3::UnitX(), -Vec3::UnitZ()});
  add_plane("add-sketch-side", tr("Seen from the side"), {}, {Vec3::Zero(), -Vec3::UnitZ(), Vec3::UnitY()});
  actions.add(actions.menu(MenuId::Create), "quad-cage", tr("Quad cage"), {}, [&host] {
    host.attempt([&] { add_quad_cage(host.studio()); });
    host.refresh();
  });
  add_mode(host, actions, MenuId::Sketch, "draw", tr("Draw"), "D");
  add_mode(host, actions, MenuId::Sketch, "tube", tr("Draw tubes"), "Ctrl+Shift+D");
  add_mode(host, actions, MenuId::Sketch, "erase", tr("Erase"), "X");
  add_mode(host, actions, MenuId::Select, select_mode, tr("Select and reshape"), "Q");
  QMenu* sketch = actions.menu(MenuId::Sketch);
  actions.add(sketch, "join-limbs", tr("Join limbs"), {QKeySequence("J")}, [&chips] { chips.join_all(); });
  actions.add(
      sketch, "far-copy", tr("Second one on the far side"), {QKeySequence("C")},
      [&] { copy_to_far_side(host.studio(), tool, chips); }, Recorded::ByItself);
  actions.add(
      sketch, "readings", tr("Other readings"), {}, [&readings] { readings.open(); }, Recorded::ByItself);
  actions.add(
      sketch, "part-colour", tr("Colour of part…"), {},
      [&] { color_parts(host.viewport(), host.studio().drawing(), tool, chips); }, Recorded::ByItself);
  const auto axis = [&] { return mirror_axis(host.studio().drawing(), host.viewport()); };
  add_toggle(actions, sketch, "symmetric-drawing", tr("Symmetric drawing"), {QKeySequence("Y")},
             [&, axis](bool on) { tool.options().mirror = on ? std::optional(axis()) : std::nullopt; });
  actions.add(
      sketch, "mirror-strokes", tr("Mirror selected lines"), {QKeySequence("Shift+Y")},
      [&, axis] { mirror_strokes(host.studio().drawing(), axis(), tool, chips); }, Recorded::ByItself);
  QMenu* radii = sketch->addMenu(tr("Tube radius"));
  auto* choice = new QActionGroup(radii);
  for (const int percent : {1, 2, 3, 5, 8}) {
    const double share = percent / 100.0;
    QAction* action = actions.add(radii, QString("tube-radius-%1").arg(percent), tr("%1 % of the view").arg(percent),
                                  {}, [&tube_share, share] { tube_share = share; });
    action->setCheckable(true);
    action->setChecked(share == tube_share);
    choice->addAction(action);
  }
  sketch->addSeparator();
}

void enable_sketch_actions(ToolHost& host, const SketchTool& tool, bool has_view) {
  const Studio& studio = host.studio();
  const WorkObject* object = studio.active();
  host.action("quad-cage")->setEnabled(object != nullptr && step_with(studio, *object, "inflate") != nullptr);
  host.action("mirror-strokes")->setEnabled(has_view && !tool.selected().empty());
  for (const char* name : {"far-copy", "part-colour"})
    host.action(name)->setEnabled(has_view && !studio.drawing().strokes.empty());
}

}  // namespace croquis::app
