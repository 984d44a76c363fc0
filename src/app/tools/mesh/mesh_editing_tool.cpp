// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/tools/mesh/mesh_editing_tool.h"

#include <QAction>
#include <QLabel>
#include <QToolBar>
#include <algorithm>
#include <cmath>

#include "app/panels/number_box.h"
#include "app/views/own_space.h"
#include "app/views/viewport.h"
#include "croquis/base/error.h"
#include "croquis/render/sharpness_color.h"
#include "croquis/tools/recording/general_steps.h"

namespace croquis::app {
namespace {

/// The modes that are about meshes, with what a drag does in them.
const std::map<QString, MeshHandles> mesh_modes{{select_mode, MeshHandles::Select},
                                                {"move", MeshHandles::Move},
                                                {"rotate", MeshHandles::Rotate},
                                                {"scale", MeshHandles::Scale},
                                                {"sharpen", MeshHandles::Sharpen}};

/// The colours of tagged edges with what they mean.
Legend* make_sharpness_legend(QWidget* views) {
  std::vector<Legend::Row> rows;
  for (const render::SharpnessSample& sample : render::sharpness_legend()) {
    const QPen pen(QColor(sample.color.r, sample.color.g, sample.color.b), render::sharpness_width(sample.sharpness),
                   Qt::SolidLine, Qt::RoundCap);
    rows.push_back({sample.label, [pen](QPainter& painter, int y) {
                      painter.setPen(pen);
                      const double middle = y + Legend::row_height / 2.0;
                      painter.drawLine(QPointF(10, middle), QPointF(32, middle));
                    }});
  }
  return new Legend(views, "sharpness-legend", QT_TR_NOOP("Sharpness"),
                    MeshEditingTool::tr("Colours of tagged edges by sharpness"), std::move(rows));
}

/// What a drag of a handle has done, as it stands at the pointer.
QString motion_text(const ManipulatorMotion& motion, MeshHandles handles, const Studio& studio) {
  if (handles == MeshHandles::Rotate) return number_words(motion.degrees) + QStringLiteral("°");
  if (handles == MeshHandles::Move) return way_text(motion.by, studio);
  const bool is_even = motion.factors.isApprox(Vec3::Constant(motion.factors.x()));
  return QStringLiteral("× ") + (is_even ? number_words(motion.factors.x()) : axes_text(motion.factors));
}

QString sharpness_text(double sharpness) {
  return std::isinf(sharpness) ? QStringLiteral("∞") : number_words(sharpness);
}

QString help_on_elements(MeshMode mode, bool selected) {
  const auto tr = [](const char* text) { return MeshEditingTool::tr(text); };
  if (mode == MeshMode::Edge) {
    return selected ? tr("H makes them sharp, Shift+H smooth · right button: the menu · W moves · Ctrl+Z undoes")
                    : tr("Click an edge, double click its loop · drag a box · Shift adds, Ctrl takes away");
  }
  if (mode == MeshMode::Vertex) {
    return selected ? tr("W moves, E rotates, R scales · P pins, Shift+P lets go · Delete dissolves")
                    : tr("Click a vertex or drag a box · Shift adds, Ctrl takes away");
  }
  return selected ? tr("Shift+E extrudes · W moves, E rotates, R scales · Delete removes")
                  : tr("Click a face, double click all that is connected · Shift adds, Ctrl takes away");
}

/// Of the drag of a handle under way; null without one.
const ManipulatorMotion* motion_of(const MeshTool& tool, const ObjectMover& mover) {
  const auto& of_elements = tool.preview().motion;
  return of_elements ? &*of_elements : mover.motion();
}

QString help_of(const MeshTool& tool, const ObjectMover& mover, ToolHost& host) {
  const auto tr = [](const char* text) { return MeshEditingTool::tr(text); };
  const Studio& studio = host.studio();
  if (const auto* motion = motion_of(tool, mover))
    return tr("%1 · Ctrl at the beginning snaps · Escape gives it up")
        .arg(motion_text(*motion, tool.handles(), studio));
  if (const auto& change = tool.preview().sharpness_change)
    return tr("Sharpness %1%2: drag sideways").arg(*change < 0 ? "" : "+").arg(*change, 0, 'f', 2);
  if (tool.loop_cut_armed()) return tr("Click an edge: the loop is cut there · Escape gives it up");
  if (tool.selection().mode() != MeshMode::Object)
    return help_on_elements(tool.selection().mode(), !studio.session().components().empty());
  if (const QString offer = studio.active() == nullptr ? QString() : app::offer(host); !offer.isEmpty()) return offer;
  if (mover.manipulator()) return tr("Drag a handle · Ctrl snaps · Shift picks several · Ctrl+D duplicates");
  return tr("O finds its holes · 3 makes it smooth · F9 vertices, F10 edges, F11 faces · Alt+drag rotates the view");
}

}  // namespace

MeshEditingTool::MeshEditingTool(ToolHost& host)
    : Tool(host, "Meshes"),
      tool_(host.studio().session(), &host.studio()),
      objects_(host.studio()),
      legend_(make_sharpness_legend(&host.viewport())) {
  drags_leave_views_ = true;
}

void MeshEditingTool::make_panels(PanelDocks& docks) {
  for (const char* name : {"show-cage", "show-both", "show-smooth"}) {
    // A mode that picks elements shows the cage again.
    connect(host().action(name), &QAction::triggered, this, [this, hides = std::string(name) == "show-smooth"] {
      cage_hidden_ = hides && !picks_objects();
      follow();
    });
  }
  show_panels_ = make_mesh_panels(*this, studio(), docks);
}

void MeshEditingTool::refresh() {
  const WorkObject* object = studio().active();
  const Tool* at_work = tool_in(host().views(), PerspectiveView);
  const bool useful = object != nullptr && object->cage != 0 && (at_work == nullptr || at_work == this);
  refresh_mesh_actions(actions_, tool_, host(), state().picks_elements);
  actions_.bar->setVisible(useful && host().shows_views());
  show_panels_(useful);
}

void MeshEditingTool::set_mode(const QString& mode) {
  Tool::set_mode(mode);
  const auto found = mesh_modes.find(mode);
  const MeshHandles handles = found == mesh_modes.end() ? MeshHandles::Select : found->second;
  studio().set_edits_elements(found != mesh_modes.end() && !picks_objects());
  tool_.set_handles(handles);
  objects_.mover().set_kind(manipulator_kind(handles));
  follow();
  emit state_changed();
}

void MeshEditingTool::set_mesh_mode(MeshMode mode) {
  if (!mesh_modes.contains(mode_)) host().set_mode(select_mode);
  enter_mesh_mode(mode);
}

void MeshEditingTool::enter_mesh_mode(MeshMode mode) {
  cage_hidden_ = false;
  studio().set_edits_elements(mode != MeshMode::Object);
  tool_.selection().set_mode(mode);
  follow();
  emit state_changed();
}

void MeshEditingTool::follow() {
  const WorkObject* object = studio().active();
  const NodeId cage = object == nullptr ? 0 : object->cage;
  if (tool_.editable().node() != cage && !tool_.active()) tool_.set_node(cage);
  overlay_.follow(tool_, studio().session().components(), object, host().viewport().objects().cage_item(cage),
                  !cage_hidden_);
  emit changed();
}

// ---- How it stands

/// Works while the mode is one of its own and there is something to work on. A single object that comes from a drawing
/// needs no picking: a plain drag rotates the view then. Objects aren't moved on the sheets that they are drawn on.
ViewUse MeshEditingTool::use_of(int) const {
  const std::size_t enough = mode_ == select_mode ? 2 : 1;
  const bool on_cage = has_cage(studio());
  return {.works = mesh_modes.contains(mode_) && (on_cage || studio().objects().size() >= enough),
          .on_drawings = on_cage,
          .menu = {"vertex-mode", "edge-mode", "sharp", "pin", "object-mode", "unpin", "smooth", "face-mode"}};
}

ToolState MeshEditingTool::state() const {
  const auto* motion = motion_of(tool_, objects_.mover());
  return {.has_selection = !studio().session().components().empty(),
          .picks_elements = use_of(PerspectiveView).works && !picks_objects(),
          .beside_pointer = motion             ? motion_text(*motion, tool_.handles(), studio())
                            : shows_sharpness_ ? sharpness_text(*tool_.preview().hovered_sharpness)
                                               : QString()};
}

ToolWords MeshEditingTool::words() const { return {help_of(tool_, objects_.mover(), host())}; }

// ---- The pointer

void MeshEditingTool::act(const std::function<Verdict(MeshTool&)>& work) {
  attempt(work);
  follow();
}

void MeshEditingTool::attempt(const std::function<Verdict(MeshTool&)>& work) {
  try {
    if (work(tool_) != Verdict::Commit) return;
    if (tool_.done()) emit committed(*tool_.done());
    host().say(sentences_of(tool_.notes()));
  } catch (const Error& error) {
    host().say(sentences_of(error.findings()));
  }
}

bool MeshEditingTool::abandon() {
  if (Tool::abandon()) return true;
  if (!tool_.loop_cut_armed()) return false;
  tool_.arm_loop_cut(false);
  follow();
  return true;
}

void MeshEditingTool::feed(const std::vector<PenStep>& steps) {
  for (const PenStep& step : steps)
    handle({step.kind, step.sample.position, step.modifiers, frame_in(step.view), step.sample.time}, step.view);
}

void MeshEditingTool::handle(const MeshEvent& event, int view) {
  gesture_view_ = view;
  attempt([&](MeshTool& tool) { return tool.handle(event); });
  const bool is_free = picks_objects() && !tool_.active();
  if (objects_.active() || (is_free && event.kind == PenStep::Kind::Begin)) {
    if (const auto done = objects_.handle(event, view)) emit committed(*done);
  }
  show_hover();
}

void MeshEditingTool::hover(const PointerEvent& event) {
  const bool leaves = event.action == PointerEvent::Action::Leave;
  const ViewFrame frame = frame_in(event.view);
  if (!leaves) gesture_view_ = event.view;
  ObjectMover& mover = objects_.mover();
  const bool on_handle = leaves ? mover.leave() : picks_objects() && mover.hover(event.position, frame);
  const bool moved = leaves ? tool_.leave() : tool_.hover(event.position, frame);
  const bool had_sharpness = std::exchange(shows_sharpness_, !leaves && tool_.preview().hovered_sharpness);
  if (moved || on_handle || had_sharpness || shows_sharpness_) show_hover();
}

void MeshEditingTool::show_hover() {
  overlay_.follow_hover(tool_, host().viewport().objects().cage_item(tool_.editable().node()));
  emit changed();
}

/// Elements lie in the space of their object, objects in the model's.
ViewFrame MeshEditingTool::frame_in(int view) const {
  return picks_objects() && !tool_.loop_cut_armed() ? frame_of(host().views(), view)
                                                    : own_frame_of(host().views(), view);
}

bool MeshEditingTool::command(EditCommand command) {
  if (command == EditCommand::SelectNone) {
    act([](MeshTool& tool) { return tool.selection().select_none(); });
    return false;  // objects are deselected, too
  }
  const bool selects = command == EditCommand::SelectAll;
  if (!state().picks_elements || !(selects || command == EditCommand::Delete)) return false;
  act([=](MeshTool& tool) { return selects ? tool.selection().select_all() : tool.take(recorded::Action{"delete"}); });
  return true;
}

bool MeshEditingTool::show(const Target& target) {
  if (const auto* step = std::get_if<const Node*>(&target)) {
    // Elements of meshes, and the cage of a step that another tool's panels are about.
    const bool has_elements = mesh_in(**step) != nullptr || works_on(studio(), **step, ValueType::Mesh);
    if (has_elements && !mesh_modes.contains(mode_)) host().set_mode(select_mode);
    return has_elements;
  }
  if (const auto* picked = std::get_if<PickedElements>(&target)) {
    if (picked->elements.empty()) return false;
    follow();
    set_mesh_mode(mode_of(picked->kind));
    follow();
    act([&](MeshTool& tool) { return tool.selection().pick(picked->kind, picked->elements); });
    return true;
  }
  const auto* found = std::get_if<NodeFinding>(&target);
  if (found == nullptr) return false;
  studio().set_active(found->node);
  follow();
  if (!tool_.editable().mesh()) return false;
  if (!show(elements_of(found->finding, *tool_.editable().topology()))) return false;
  frame_selection(host().views());
  return true;
}

// ---- The views

void MeshEditingTool::adjust(ObjectScenes::Wanted& wanted, int) const {
  if (!state().picks_elements) return;
  wanted.edited = tool_.editable().node();
  wanted.edited_cage = !cage_hidden_;
}

void MeshEditingTool::add_to(render::Scene& scene, int view) {
  const ViewUse use = use_of(view);
  const bool with_handles = use.works && (use.on_drawings || !is_drawn_on(host().views(), view));
  const WorkObject* object = studio().active();
  {
    const PlacedPart own(scene, object == nullptr ? Affine3() : object->placement.map());
    overlay_.add_to(scene, view != ComparisonView);
    if (with_handles) add_handles(manipulator_picture(tool_, own_frame_of(host().views(), view)), scene);
  }
  if (!with_handles) return;
  const ViewFrame frame = frame_of(host().views(), view);
  if (picks_objects()) add_handles(objects_.mover().manipulator_picture(frame), scene);
  const std::optional<PickBox>& box = objects_.box() ? objects_.box() : tool_.preview().box;
  if (box && view == gesture_view_) add_box(*box, frame, scene);
}

std::optional<SelectionFrame> MeshEditingTool::selection_frame(int) const {
  const render::Bounds& bounds = overlay_.selection_bounds();
  if (bounds.empty() || picks_objects()) return std::nullopt;
  return SelectionFrame{render::placed(bounds, matrix_of(studio().active()->placement.map())), std::nullopt, false};
}

void MeshEditingTool::place_chips(ChipPlaces& places) { places.put_legend(*legend_, overlay_.shows_tags()); }

}  // namespace croquis::app
