// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/tools/silhouette/silhouette_tool.h"

#include <QAction>
#include <QMenu>
#include <algorithm>

#include "app/panels/finding_elements.h"
#include "app/studio/own_space.h"
#include "app/tools/silhouette/bodies.h"
#include "app/views/ink_sheet.h"
#include "app/views/render_color.h"
#include "app/views/viewport.h"
#include "app/window/action_list.h"
#include "app/window/theme.h"
#include "croquis/operators/inflate_result.h"
#include "croquis/tools/recording/general_steps.h"
#include "croquis/workspace/chain.h"

namespace croquis::app {
namespace {

constexpr const char* hint_style = "color: #8a93a0; background: transparent; font-size: 15px";
constexpr double hint_height = 60;  // above the view's lower border

SketchMode sketch_mode(const QString& mode) {
  if (mode == "draw") return SketchMode::Draw;
  return mode == "erase" ? SketchMode::Erase : SketchMode::Select;
}

}  // namespace

SilhouetteTool::SilhouetteTool(ToolHost& host)
    : Tool(host),
      sketch_(host.studio(), host.viewport().pane(SketchView), nullptr),
      chips_(host.studio(), sketch_.tool(), host.viewport()),
      hint_(make_chip_label(host.viewport(), hint_style)) {
  host.viewport().objects().set_painter(paint_of_bodies);
  hint_->setObjectName("hint");
  hint_->setText(tr("Trace me: one closed line becomes a solid"));
  connect(&sketch_, &SketchInteraction::changed, this, [this] { emit changed_in(SketchView); });
  connect(&sketch_, &SketchInteraction::inked, this, &Tool::inked);
  connect(&sketch_, &SketchInteraction::committed, this, &Tool::committed);
  connect(&chips_, &SketchChips::committed, this, &Tool::committed);
}

void SilhouetteTool::make_actions(ActionList& actions) {
  QMenu* edit = actions.menu(tr("&Edit"));
  QAction* join =
      actions.add(edit, "join-limbs", tr("&Join limbs"), {QKeySequence("J")}, [this] { chips_.join_all(); });
  edit->insertAction(actions.find("delete"), join);
  actions.menu(tr("&Object"))->addSeparator();
  QMenu* added = actions.menu(tr("&Object"))->addMenu(tr("Add s&ketch"));
  const auto add_plane = [&](const QString& name, const QString& text, const QList<QKeySequence>& keys,
                             const DrawingPlane& plane) {
    actions.add(added, name, text, keys, [this, plane] { add_sketch(plane); });
  };
  add_plane("add-sketch", tr("Seen from the &front"), {QKeySequence("Ctrl+Shift+N")}, {});
  add_plane("add-sketch-top", tr("Seen from the &top"), {}, {Vec3::Zero(), Vec3::UnitX(), -Vec3::UnitZ()});
  add_plane("add-sketch-side", tr("Seen from the &side"), {}, {Vec3::Zero(), -Vec3::UnitZ(), Vec3::UnitY()});
  QMenu* menu = actions.menu(tr("&Tool"));
  const auto add_mode = [&](const QString& mode, const QString& text, const QString& key) {
    actions.add_mode(menu, mode, text, key, [this, mode] { host().set_mode(mode); });
  };
  add_mode("draw", tr("&Draw"), "D");
  add_mode("erase", tr("&Erase"), "X");
  add_mode(select_mode, tr("&Select and reshape"), "Q");
}

void SilhouetteTool::refresh() {
  const WorkObject* object = studio().active();
  const bool mesh = object != nullptr && object->cage != 0;
  host().action("erase")->setEnabled(studio().network_node() == 0 && (!studio().drawing().strokes.empty() || !mesh));
}

void SilhouetteTool::set_mode(const QString& mode) {
  Tool::set_mode(mode);
  sketch_.set_mode(sketch_mode(mode));
  Viewport& views = host().viewport();
  if (draws() && studio().network_node() == 0 && !views.pane(SketchView).visible())
    views.arrange(Arrangement::SketchAndSolid);
}

bool SilhouetteTool::works_in(int view) const {
  return has_view(view) && (draws() || (mode() == select_mode && is_paper(view)));
}

/// The sketch view shows sketches unless it is the sheet of a drawing in perspective, or a view of a network.
bool SilhouetteTool::has_view(int view) const {
  return view == SketchView && studio().sheet_node() == 0 && studio().network_node() == 0;
}

bool SilhouetteTool::is_paper(int view) const {
  return has_view(view) && (sketch_.scene().has_strokes() || !studio().has_cage());
}

Qt::CursorShape SilhouetteTool::cursor(int) const { return draws() ? Qt::CrossCursor : Qt::ArrowCursor; }

void SilhouetteTool::add_all_to(Selection& selection) const {
  for (const Stroke& stroke : studio().drawing().strokes) selection.push_back({studio().drawing_node(), stroke.id});
}

bool SilhouetteTool::delete_selection() {
  if (sketch_.tool().selected().empty()) return false;
  host().record(recorded::Action{"delete"});
  return sketch_.tool().delete_selected() == Verdict::Commit;
}

bool SilhouetteTool::open_step(const Node& step) {
  const OperationDescription* operation = studio().description(step.operation);
  const PortDescription* input = operation == nullptr ? nullptr : main_input(*operation);
  if (!source_of<Drawing>(&step) && (input == nullptr || input->type != ValueType::Drawing)) return false;
  const bool works = draws() || mode() == select_mode;
  if (!works) host().set_mode(first_mode);
  Viewport& views = host().viewport();
  if (!views.pane(SketchView).visible()) views.arrange(Arrangement::SketchAndSolid);
  return true;
}

/// Empty, with the solid that will be made of it; the pen draws in it at once.
void SilhouetteTool::add_sketch(const DrawingPlane& plane) {
  Drawing drawing;
  drawing.plane = plane;
  const Document& before = studio().session().document();
  SketchToolOptions options = studio().tool_options();
  options.name = free_name(before, options.name);
  const NodeId node = before.next_id();
  studio().session().edit("Add sketch",
                          add_drawing(before, std::make_shared<const Drawing>(std::move(drawing)), options));
  studio().session().select({{node, ""}});
  host().set_mode(first_mode);
  host().refresh();
}

QString SilhouetteTool::help() const {
  switch (sketch_.mode()) {
    case SketchMode::Select:
      return tr("Drag a square to reshape the line, drag a line to move it, Shift adds · Delete removes · D draws");
    case SketchMode::Erase: return tr("Drag over lines to cut pieces out of them · D draws");
    case SketchMode::Draw: break;
  }
  if (!sketch_.scene().has_strokes()) return tr("Draw a closed outline with the pen or the mouse");
  return tr(
      "Draw: a line stops where it passes behind another · the right button draws behind · Q selects · Ctrl+Z undoes");
}

void SilhouetteTool::adjust(ObjectScenes::Wanted& wanted, int view) const {
  if (!has_view(view)) return;
  wanted.only_with_cage = true;
  wanted.nothing = !studio().drawing().plane.is_default();  // it shows the sketch's own plane then
}

void SilhouetteTool::add_to(render::Scene& scene, int view) {
  if (!has_view(view)) {
    for (const WorkObject& object : studio().objects()) {
      const auto lines = lines_.find(object.node);
      if (lines == lines_.end() || !object.visible) continue;
      const PlacedPart part(scene, object.placement.map());
      scene.lines.emplace_back(lines->second);
    }
    return;
  }
  const render::Scene sketch = sketch_.scene().scene();
  scene.lines.insert(scene.lines.end(), sketch.lines.begin(), sketch.lines.end());
  scene.marks.insert(scene.marks.end(), sketch.marks.begin(), sketch.marks.end());
}

/// Of solids as they were drawn: what is refined or cut after that has another surface.
void SilhouetteTool::follow_lines() {
  lines_.clear();
  for (const WorkObject& object : studio().objects()) {
    if (!object.result || result_of<InflateResult>(object.result.get()) == nullptr) continue;
    const auto lines = object.result->outputs.find("lines");
    if (lines == object.result->outputs.end()) continue;
    const auto& mesh = lines->second.get<PolyMesh>();
    std::vector<render::LinePath> paths;
    for (std::size_t l = 0; l < mesh.line_count(); ++l) {
      render::LinePath path;
      for (const Index v : mesh.line(l)) {
        const Vec3& at = mesh.positions[v];
        path.points.push_back({{at.x(), at.y(), at.z()}, 1, {}});
      }
      paths.push_back(std::move(path));
    }
    const render::LineStyle style{ink_width, to_color(colors::ink), {}, render::LineDepth::Tested};
    if (!paths.empty()) lines_[object.node] = render::make_line_item(paths, style);
  }
}

std::optional<Ink> SilhouetteTool::ink() const {
  if (!sketch_.inking()) return std::nullopt;
  return Ink{SketchView, &sketch_.ink(), sketch_.inks_behind()};
}

render::Bounds SilhouetteTool::bounds_in(int view) const {
  return has_view(view) && sketch_.scene().has_strokes() ? sketch_.scene().bounds(false) : render::Bounds();
}

std::optional<SelectionFrame> SilhouetteTool::selection_frame(int) const {
  return SelectionFrame{sketch_.scene().bounds(true), std::nullopt, false};
}

QString SilhouetteTool::view_title(int view) const {
  const bool sketched = sketch_.scene().has_strokes() || sketch_.scene().invites();
  return has_view(view) && sketched ? tr("Sketch") : QString();
}

void SilhouetteTool::place_chips(ChipPlaces& places) {
  const ViewPane& pane = places.layout().pane(SketchView);
  if (sketch_.scene().invites() && has_view(SketchView) && pane.visible() && !sketch_.down()) {
    hint_->adjustSize();
    places.put(*hint_, QPointF(pane.rect.center().x() - hint_->width() / 2.0, pane.rect.bottom() - hint_height));
  } else {
    hint_->hide();
  }
  chips_.place(places, has_view(SketchView) && !sketch_.down());
}

void SilhouetteTool::follow_document() {
  sketch_.follow_document();
  chips_.follow();
}

void SilhouetteTool::follow_result() {
  sketch_.follow_result();
  follow_lines();
  chips_.follow();
}

bool SilhouetteTool::show_finding(const NodeFinding& found) {
  if (found.node != studio().solid_node()) return false;
  Selection selection;
  for (const std::string& stroke : strokes_of(found.finding)) selection.push_back({studio().drawing_node(), stroke});
  studio().session().select(std::move(selection));
  return true;
}

}  // namespace croquis::app
