// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/tools/surface/surface_drawing_tool.h"

#include <QAction>
#include <QDockWidget>
#include <QMenu>
#include <QMetaObject>
#include <QScrollArea>
#include <algorithm>
#include <map>
#include <utility>

#include "app/replay/replays.h"
#include "app/views/own_space.h"
#include "app/views/viewport.h"
#include "app/window/action_list.h"
#include "app/window/panel_docks.h"
#include "croquis/tools/recording/general_steps.h"
#include "croquis/tools/surface/surface_tool.h"
#include "croquis/workspace/chain.h"

namespace croquis::app {
namespace {

/// Where the operation stands in the document that is evaluated for it; comparisons and previews stand elsewhere.
constexpr NodeId taking_node = NodeId{1} << 60;

/// The network that an evaluation gives, or null.
std::shared_ptr<const AttributeNetwork> network_in(const Evaluation& evaluation) {
  for (const auto& [port, value] : evaluation.outputs) {
    if (auto network = value.as<AttributeNetwork>()) return network;
  }
  return nullptr;
}

constexpr int surface_panel_width = 330;
constexpr double ghost_opacity = 0.4;
constexpr double around_elements = 0.35;  // of the network's size, at least, where elements are looked at

std::optional<SurfaceMode> surface_mode(const QString& mode) {
  static const std::map<QString, SurfaceMode> modes{{"draw", SurfaceMode::Draw},
                                                    {"inner-curve", SurfaceMode::Draw},
                                                    {select_mode, SurfaceMode::Select},
                                                    {"patch", SurfaceMode::Patch},
                                                    {"surface-point", SurfaceMode::Point}};
  const auto found = modes.find(mode);
  return found == modes.end() ? std::nullopt : std::optional(found->second);
}

const ShownSurface& required_surface(const DrawnNetwork& network) {
  if (!network.shown) refuse_replay("The surfaces aren't computed yet");
  return network.shown;
}

const DomainComparison& required_comparison(const UniformGhost& ghost) {
  if (ghost.compared() == nullptr) refuse_replay("The uniform domain isn't shown");
  return ghost.compared()->comparison;
}

QString no_patch_help() {
  return SurfaceDrawingTool::tr(
      "There is no patch yet: draw curves that close a loop, then Enter, or P and a click inside it, makes one");
}

QString help_of(const DrawnNetwork& network, const QString& mode) {
  const auto tr = [](const char* text) { return SurfaceDrawingTool::tr(text); };
  const bool needs_patch = mode == "inner-curve" || mode == "surface-point";
  if (needs_patch && network.network().faces.empty()) return no_patch_help();
  if (mode == "inner-curve") return tr("Draw on a patch: the surface goes through the curve · Q selects and drags");
  switch (network.tool.mode()) {
    case SurfaceMode::Patch:
      return tr("Click inside a loop of curves: it becomes a smooth patch · T puts points on it");
    case SurfaceMode::Point:
      return tr("Click on a patch and drag: the point pulls it along its normal, with Ctrl across the view");
    case SurfaceMode::Select: break;
    case SurfaceMode::Draw:
      if (!network.offered.empty())
        return tr("Enter makes a patch of the closed loop · go on drawing curves · Q selects");
      return tr("Draw curves from node to node · P fills loops · I draws on a patch · Q selects · Alt+drag rotates");
  }
  const NetworkElements selected = network.tool.selected();
  if (selected.curves.size() > 1) return tr("Enter makes a patch of the selected curves · S smooth or crease · Delete");
  if (!selected.curves.empty())
    return tr("Drag squares to bend it, blue handles to turn the slope · S smooth or crease · Delete removes");
  if (!selected.points.empty())
    return tr("Drag the point, or its ring for the radius · U compares with a uniform domain");
  return tr("Click or drag a box: curves, nodes, points, patches · Shift adds · D draws · P fills a loop · T points");
}

void choose_all(DrawnNetwork& network) {
  NetworkElements all;
  for (const NetworkElement kind : {NetworkElement::Node, NetworkElement::Curve, NetworkElement::Point})
    all.of(kind) = element_ids(network.network(), kind);
  network.host.set_mode(select_mode);
  network.act(recorded::SurfaceChoice{all});
}

/// "12 curves, 3 patches, 1 point".
QString size_of(const AttributeNetwork& network) {
  const auto tr = [](const char* text) { return SurfaceDrawingTool::tr(text); };
  return QStringList{counted_words(network.curves.size(), tr("1 curve"), tr("%1 curves")),
                     counted_words(network.faces.size(), tr("1 patch"), tr("%1 patches")),
                     counted_words(network.points.size(), tr("1 point"), tr("%1 points"))}
      .join(", ");
}

/// What replays can ask of networks.
void add_counts(Replays& replays, const DrawnNetwork& drawn, const UniformGhost& ghost) {
  const auto count = [&drawn](auto member) {
    return [&drawn, member](const std::string&) -> std::size_t { return (drawn.network().*member).size(); };
  };
  replays.counts["surface-nodes"] = count(&AttributeNetwork::nodes);
  replays.counts["surface-curves"] = count(&AttributeNetwork::curves);
  replays.counts["surface-faces"] = count(&AttributeNetwork::faces);
  replays.counts["surface-points"] = count(&AttributeNetwork::points);
  replays.counts["surface-selected"] = [&drawn](const std::string&) {
    const NetworkElements selected = drawn.tool.selected();
    return selected.nodes.size() + selected.curves.size() + selected.faces.size() + selected.points.size();
  };
  replays.counts["surface-patches-made"] = [&drawn](const std::string&) -> std::size_t {
    return static_cast<std::size_t>(std::ranges::count_if(
        required_surface(drawn).surface().faces, [](const SurfaceFace& face) { return face.surface != nullptr; }));
  };
  replays.counts["surface-nearer-dents"] = [&ghost](const std::string&) -> std::size_t {
    return static_cast<std::size_t>(
        std::ranges::count_if(required_comparison(ghost).points, [](const ComparedPoint& point) {
          return point.own && point.uniform && point.own->offset < point.uniform->offset;
        }));
  };
  replays.ranges["surface-boundary-error"] = [&drawn](const std::string&) {
    return std::pair(0.0, required_surface(drawn).found->measures.boundary_error);
  };
  replays.ranges["surface-point-errors"] = [&drawn](const std::string&) {
    double greatest = 0;
    for (const auto& error : required_surface(drawn).found->measures.point_errors) {
      if (!error) refuse_replay("A point isn't met by its patch");
      greatest = std::max(greatest, *error);
    }
    return std::pair(0.0, greatest);
  };
}

}  // namespace

/// The step nearest to the chain's end that gives what the operation takes.
std::optional<Link> CurveTaking::source_for(const OperationDescription& operation) const {
  const PortDescription* input = main_input(operation);
  const WorkObject* object = studio_.active();
  if (input == nullptr || object == nullptr) return std::nullopt;
  for (auto step = object->chain.rbegin(); step != object->chain.rend(); ++step) {
    const Node* node = studio_.session().document().find(*step);
    const auto link = node == nullptr ? std::nullopt : link_to(*node, studio_.registry(), input->type);
    if (link) return link;
  }
  return std::nullopt;
}

void CurveTaking::take(const std::string& id) {
  const OperationDescription* operation = studio_.description(id);
  const auto source = operation == nullptr ? std::nullopt : source_for(*operation);
  if (!source) return;
  Node node;
  node.id = taking_node;
  node.name = operation->id;
  node.operation = operation->id;
  node.version = operation->version;
  node.inputs[main_input(*operation)->name] = *source;
  placement_ = studio_.active()->placement;
  name_ = "Curves of " + studio_.active()->name;
  live_ = studio_.live_beside(taking_node, [this] { follow(); });
  live_->follow(studio_.session().document().with(std::move(node)));
}

void CurveTaking::follow() {
  if (!live_ || !live_->result() || live_->busy()) return;
  const auto result = live_->result();
  // Not from inside of its own call.
  QMetaObject::invokeMethod(
      this, [gone = std::shared_ptr<LiveNode>(std::move(live_))] { (void)gone; }, Qt::QueuedConnection);
  const auto network = result->failed ? nullptr : network_in(*result);
  if (!network) {
    emit failed(result->findings);
    return;
  }
  SurfaceToolOptions options = studio_.network_options();
  const Document& document = studio_.session().document();
  options.name = free_name(document, name_);
  const NodeId node = document.next_id();
  AttributeNetwork lying = transformed(*network, inverse_of(upright_placement()));
  Document taken_from = studio_.with_network(document, std::move(lying), options);
  Node placed = *taken_from.find(node);
  placed.placement = placement_;
  studio_.session().edit("Take curves", taken_from.with(std::move(placed)));
  studio_.session().select({{node, ""}});
  emit taken();
}

render::Bounds bounds_of_selected(const DrawnNetwork& drawn) {
  const AttributeNetwork& network = drawn.network();
  const NetworkElements selected = drawn.tool.selected();
  render::Bounds bounds;
  const auto add = [&](const Vec3& place) { bounds.add(to_glm(drawn.to_world()(place))); };
  const auto add_curve = [&](Index curve) { std::ranges::for_each(traced_curve(network, curve), add); };
  for (const std::string& id : selected.curves) add_curve(require_element(network, NetworkElement::Curve, id));
  for (const std::string& id : selected.faces) {
    for (const AttributeSide& side : network.faces[require_element(network, NetworkElement::Face, id)].loop)
      add_curve(side.curve);
  }
  for (const std::string& id : selected.nodes)
    add(network.nodes[require_element(network, NetworkElement::Node, id)].point);
  for (const std::string& id : selected.points)
    add(network.points[require_element(network, NetworkElement::Point, id)].point);
  return bounds;
}

SurfaceDrawingTool::SurfaceDrawingTool(ToolHost& host)
    : Tool(host, "Surfaces from curves"), network_(*this, host), taking_(host.studio()), chips_(network_, ghost_) {
  connect(this, &Tool::changed, this, [this] {
    if (domain_panel_ != nullptr && network_.is_there()) domain_panel_->follow();
  });
  connect(&ghost_, &UniformGhost::changed, this, [this] {
    follow_panels();
    emit changed();
  });
  connect(&taking_, &CurveTaking::failed, this,
          [this](const Findings& findings) { this->host().show_message(findings); });
  connect(&taking_, &CurveTaking::taken, this, [this] {
    show_in_space();
    this->host().set_mode(select_mode);
    this->host().refresh();
  });
}

void SurfaceDrawingTool::make_actions(ActionList& actions) {
  QMenu* file = actions.menu(MenuId::File);
  QAction* fresh = actions.add(file, "new-surface", tr("New surface"), {}, [this] {
    if (host().start_with(studio().with_network(Document(), {}, studio().network_options()))) show_in_space();
  });
  file->insertAction(actions.find("open"), fresh);
  add_surface_actions(network_, ghost_, taking_, actions, keys);
}

void SurfaceDrawingTool::make_panels(PanelDocks& docks) {
  panel_ = make_surface_panel(network_);
  domain_panel_ = make_domain_panel(network_, ghost_);
  docks_ = &docks;
  dock_ = docks.add(tr("Surface"), scrolled(panel_), "surface");
  domain_dock_ = docks.add(tr("Domain"), domain_panel_, "domain");
  docks.tabify("attributes", dock_);
  docks.tabify("findings", domain_dock_);
  docks.keep_in_front(domain_dock_);
  docks.set_useful(dock_, false);
  docks.set_useful(domain_dock_, false);
}

void SurfaceDrawingTool::refresh() {
  chips_.follow();
  refresh_surface_actions(network_, ghost_, taking_);
  if (docks_ == nullptr) return;
  docks_->set_useful(domain_dock_, network_.is_there());
  docks_->show_tool_panel(dock_, network_.is_there(), surface_panel_width);
  follow_panels();
}

void SurfaceDrawingTool::set_mode(const QString& mode) {
  Tool::set_mode(mode);
  network_.tool.set_mode(surface_mode(mode).value_or(SurfaceMode::Select));
  studio().hold_results(false);
  network_.show_preview();
}

// ---- How it stands

/// Patches are framed by themselves.
ViewUse SurfaceDrawingTool::use_of(int) const {
  ViewUse use{.works = network_.is_there() && surface_mode(mode_).has_value(),
              .menu = {"fill-loop", "toggle-join", "surface-point", "split-element", "merge-patches", "symmetric-edit",
                       "draw", "select"},
              .cursor = mode_ == select_mode ? Qt::ArrowCursor : Qt::CrossCursor,
              .every_move = network_.tool.mode() == SurfaceMode::Draw};
  if (network_.is_there() && network_.network().faces.empty()) use.bounds = network_.scene.bounds();
  return use;
}

ToolWords SurfaceDrawingTool::words() const {
  return {.help = help_of(network_, mode_),
          .tooltip = under_pointer_,
          .status = network_.is_there() ? size_of(network_.network()) : QString()};
}

ToolState SurfaceDrawingTool::state() const {
  const auto& moved = network_.tool.preview().moved;
  return {.has_selection = network_.is_there() && !network_.tool.selected().empty(),
          .busy = ghost_.busy() || taking_.busy(),
          .beside_pointer = moved ? way_text(*moved, studio()) : QString()};
}

// ---- The pointer

/// What draws on patches or pulls them does nothing beside them, and says so.
void SurfaceDrawingTool::take(const PointerEvent& event) {
  const bool begins = event.action == PointerEvent::Action::Press && event.buttons.left && !down();
  const bool needs_patch = mode_ == "inner-curve" || (mode_ == "surface-point" && !network_.tool.preview().hovered &&
                                                      network_.tool.selected().points.empty());
  const bool on_patch = network_.sight != nullptr &&
                        network_.sight->patch_under(network_.frame_of(event.view).ray(event.position)).has_value();
  if (!needs_patch || !begins || on_patch) return Tool::take(event);
  host().say(network_.network().faces.empty() ? no_patch_help()
             : mode_ == "inner-curve"         ? tr("Begin on a patch: the curve lies on it and pulls it")
                                              : tr("Press on a patch: the drag pulls it"));
}

void SurfaceDrawingTool::feed(const std::vector<PenStep>& steps) {
  SurfaceTool& tool = network_.tool;
  const bool was_active = tool.active();
  for (const PenStep& step : steps) {
    gesture_view_ = step.view;
    const PenSample& at = step.sample;
    try {
      const Verdict verdict =
          tool.handle({step.kind, at.position, step.modifiers, network_.frame_of(step.view), at.time});
      if (step.kind == PenStep::Kind::End || step.kind == PenStep::Kind::Cancel) network_.finish(verdict);
    } catch (const Error& error) {
      host().say(sentences_of(error.findings()));
    }
  }
  // Nothing else changes under a pen that draws: what is computed meanwhile is shown when the stroke has ended.
  studio().hold_results(tool.active() && tool.mode() == SurfaceMode::Draw);
  network_.show_preview();
  if (was_active == tool.active()) return;
  refresh();
  emit state_changed();
}

void SurfaceDrawingTool::hover(const PointerEvent& event) {
  if (event.action == PointerEvent::Action::Leave) {
    under_pointer_.clear();
    if (network_.tool.leave()) network_.show_preview();
    return;
  }
  gesture_view_ = event.view;
  under_pointer_ = sentences_at(network_.scene.marks(), frame_of(host().views(), event.view), event.position);
  if (network_.tool.hover(event.position, network_.frame_of(event.view))) network_.show_preview();
}

bool SurfaceDrawingTool::command(EditCommand command) {
  const bool works = use_of(PerspectiveView).works;
  if (command == EditCommand::SelectAll && works) {
    choose_all(network_);
    return true;
  }
  if (command == EditCommand::Accept && works && host().action("fill-loop")->isEnabled()) {
    host().action("fill-loop")->trigger();
    return true;
  }
  const bool deletes = command == EditCommand::Delete;
  if (!state().has_selection || !(deletes || command == EditCommand::SelectNone)) return false;
  network_.act(deletes ? recorded::Step(recorded::SurfaceDelete{network_.tool.selected()}) : recorded::SurfaceChoice{});
  return true;
}

bool SurfaceDrawingTool::show(const Target& target) {
  if (const auto* step = std::get_if<const Node*>(&target)) {
    const bool is_network = source_of<AttributeNetwork>(*step) != nullptr;
    const bool goes_on = network_.is_there() && works_on(studio(), **step, ValueType::AttributeNetwork);
    if (!is_network && !goes_on) return false;
    if (!surface_mode(mode_)) host().set_mode(select_mode);
    return true;
  }
  const auto* found = std::get_if<NodeFinding>(&target);
  if (found == nullptr || !network_.is_there() || found->node != network_.tool.operation_node()) return false;
  look_at(network_, elements_in(found->finding, network_.network()));
  return true;
}

// ---- The views

void SurfaceDrawingTool::adjust(ObjectScenes::Wanted& wanted, int) const {
  if (network_.is_there()) wanted.outlines = false;
}

void SurfaceDrawingTool::add_to(render::Scene& scene, int view) {
  if (!network_.is_there()) return;
  if (const UniformGhost::Compared* compared = ghost_.compared(); compared != nullptr && compared->item)
    scene.meshes.emplace_back(compared->item, render::Emphasis{}, render::MeshStyle::translucent(ghost_opacity));
  const bool on_ground = mode_ == "draw" && network_.tool.settings().plane == SurfacePlane::Ground;
  if (on_ground && view == PerspectiveView)
    scene.lines.emplace_back(ground_lines(network_.scene.bounds(), network_.to_world()));
  network_.scene.add_to(scene);
  const auto& box = network_.tool.preview().box;
  if (box && view == gesture_view_) add_box(*box, frame_of(host().views(), view), scene);
}

std::optional<SelectionFrame> SurfaceDrawingTool::selection_frame(int) const {
  if (!network_.is_there()) return std::nullopt;
  const render::Bounds& all = network_.scene.bounds();
  return frame_around(bounds_of_selected(network_), around_elements * (all.max - all.min));
}

void SurfaceDrawingTool::place_chips(ChipPlaces& places) { chips_.place(places, network_.is_there()); }

// ---- The flow

void SurfaceDrawingTool::follow(Change change) {
  if (change == Change::Scenes) return;
  if (change == Change::Opened) {
    // A network that is opened is looked at in space, and selected from.
    const NodeId now = studio().network_node();
    if (std::exchange(opened_, now) == now || now == 0) return;
    show_in_space();
    if (!network_.network().faces.empty()) host().set_mode(select_mode);
    return;
  }
  change == Change::Document ? network_.follow_document() : network_.follow_result();
  ghost_.follow(network_.is_there() ? network_.shown : ShownSurface());
  chips_.follow();
  follow_panels();
}

void SurfaceDrawingTool::follow_panels() {
  if (panel_ == nullptr || !network_.is_there()) return;
  panel_->follow();
  domain_panel_->follow();
}

void SurfaceDrawingTool::show_in_space() {
  dock_->raise();
  domain_dock_->raise();
  host().views().layout.arrange(Arrangement::Four);
  host().views().layout.show_alone(PerspectiveView);
  frame_all(host().views());
}

void SurfaceDrawingTool::make_replays(Replays& replays) {
  for (const recorded::StepKind* kind : recorded::surface_steps().kinds()) {
    replays.plays[kind].push_back([this](const recorded::Step& step) {
      if (!network_.is_there()) host().action("new-surface")->trigger();
      network_.follow_document();
      network_.tool.take(step);
      network_.follow_document();
      return true;
    });
  }
  add_counts(replays, network_, ghost_);
}

}  // namespace croquis::app
