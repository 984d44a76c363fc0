// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/tools/surface/surface_drawing_tool.h"

#include <QAction>
#include <QDockWidget>
#include <QMetaObject>
#include <QScrollArea>
#include <algorithm>
#include <array>
#include <map>
#include <utility>

#include "app/replay/replays.h"
#include "app/tools/surface/network_scene.h"
#include "app/tools/surface/surface_panel.h"
#include "app/views/render_color.h"
#include "app/views/viewport.h"
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

const ShownSurface& required_surface(const NetworkInteraction& network) {
  if (!network.shown()) refuse_replay("The surfaces aren't computed yet");
  return network.shown();
}

const DomainComparison& required_comparison(const UniformGhost& ghost) {
  if (ghost.compared() == nullptr) refuse_replay("The uniform domain isn't shown");
  return ghost.compared()->comparison;
}

}  // namespace

std::vector<const OperationDescription*> CurveTaking::ways() const {
  std::vector<const OperationDescription*> found;
  for (const OperationDescription& operation : studio_.registry().descriptions()) {
    const PortDescription* output = main_output(operation);
    if (output != nullptr && output->type == ValueType::AttributeNetwork) found.push_back(&operation);
  }
  return found;
}

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

bool CurveTaking::can_take(const OperationDescription& operation) const { return source_for(operation).has_value(); }

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

SurfaceDrawingTool::SurfaceDrawingTool(ToolHost& host)
    : Tool(host, "Surfaces from curves"),
      network_(host.studio(), host.viewport()),
      taking_(host.studio()),
      chips_(network_, ghost_, host.viewport()) {
  connect(&network_, &NetworkInteraction::changed, this, [this] {
    if (domain_panel_ != nullptr && is_there()) domain_panel_->follow();
    emit Tool::changed();
  });
  connect(&network_, &NetworkInteraction::committed, this, &Tool::committed);
  connect(&network_, &NetworkInteraction::told, this, &Tool::told);
  connect(&network_, &NetworkInteraction::state_changed, this, [this] {
    refresh();
    emit state_changed();
  });
  connect(&ghost_, &UniformGhost::changed, this, [this] {
    follow_panels();
    emit Tool::changed();
  });
  connect(&chips_, &SurfaceChips::patch_wanted, this, [this] { this->host().action("fill-loop")->trigger(); });
  connect(&taking_, &CurveTaking::failed, this,
          [this](const Findings& findings) { this->host().show_message(findings); });
  connect(&taking_, &CurveTaking::taken, this, [this] {
    show_in_space();
    this->host().set_mode(select_mode);
    this->host().refresh();
  });
  connect(&chips_, &SurfaceChips::elements_wanted, this, &SurfaceDrawingTool::look_at);
}

void SurfaceDrawingTool::make_panels(PanelDocks& docks) {
  const auto action = [this](const QString& name) { return host().action(name); };
  panel_ = make_surface_panel(network_, action);
  domain_panel_ = new DomainPanel(network_, ghost_, host().action("compare-uniform"));
  docks_ = &docks;
  dock_ = docks.add(tr("Surface"), scrolled(panel_), "surface");
  domain_dock_ = docks.add(tr("Domain"), domain_panel_, "domain");
  docks.tabify("attributes", dock_);
  docks.tabify("findings", domain_dock_);
  docks.set_useful(dock_, false);
  docks.set_useful(domain_dock_, false);
}

// ---- The hand

void SurfaceDrawingTool::set_mode(const QString& mode) {
  Tool::set_mode(mode);
  const auto own = surface_mode(mode);
  network_.set_mode(own.value_or(SurfaceMode::Select));
}

bool SurfaceDrawingTool::works_in(int) const { return is_there() && surface_mode(mode()).has_value(); }

/// What draws on patches or pulls them does nothing beside them, and says so.
void SurfaceDrawingTool::take(const PointerEvent& event) {
  const bool begins = event.action == PointerEvent::Action::Press && event.buttons.left && !network_.down();
  const bool needs_patch =
      mode() == "inner-curve" ||
      (mode() == "surface-point" && !network_.tool().preview().hovered && network_.tool().selected().points.empty());
  const bool on_patch = network_.sight() != nullptr &&
                        network_.sight()->patch_under(network_.frame_of(event.view).ray(event.position)).has_value();
  if (needs_patch && begins && !on_patch) {
    emit told(network_.network().faces.empty() ? no_patch_help()
              : mode() == "inner-curve"        ? tr("Begin on a patch: the curve lies on it and pulls it")
                                               : tr("Press on a patch: the drag pulls it"));
    return;
  }
  network_.take(event);
}

ViewUse SurfaceDrawingTool::use_of(int) const {
  return {mode() == select_mode ? Qt::ArrowCursor : Qt::CrossCursor, network_.tool().mode() == SurfaceMode::Draw};
}

QString SurfaceDrawingTool::no_patch_help() {
  return tr("There is no patch yet: draw curves that close a loop, then Enter, or P and a click inside it, makes one");
}

QString SurfaceDrawingTool::help() const {
  const bool needs_patch = mode() == "inner-curve" || mode() == "surface-point";
  if (needs_patch && network_.network().faces.empty()) return no_patch_help();
  if (mode() == "inner-curve") return tr("Draw on a patch: the surface goes through the curve · Q selects and drags");
  switch (network_.tool().mode()) {
    case SurfaceMode::Patch:
      return tr("Click inside a loop of curves: it becomes a smooth patch · T puts points on it");
    case SurfaceMode::Point:
      return tr("Click on a patch and drag: the point pulls it along its normal, with Ctrl across the view");
    case SurfaceMode::Select: break;
    case SurfaceMode::Draw:
      if (!chips_.offered().empty())
        return tr("Enter makes a patch of the closed loop · go on drawing curves · Q selects");
      return tr("Draw curves from node to node · P fills loops · I draws on a patch · Q selects · Alt+drag rotates");
  }
  const NetworkElements selected = network_.tool().selected();
  if (selected.curves.size() > 1) return tr("Enter makes a patch of the selected curves · S smooth or crease · Delete");
  if (!selected.curves.empty())
    return tr("Drag squares to bend it, blue handles to turn the slope · S smooth or crease · Delete removes");
  if (!selected.points.empty())
    return tr("Drag the point, or its ring for the radius · U compares with a uniform domain");
  return tr("Click or drag a box: curves, nodes, points, patches · Shift adds · D draws · P fills a loop · T points");
}

// ---- Keys

bool SurfaceDrawingTool::command(EditCommand command) {
  const bool works = works_in(PerspectiveView);
  if (command == EditCommand::SelectAll && works) {
    NetworkElements all;
    for (const NetworkElement kind : {NetworkElement::Node, NetworkElement::Curve, NetworkElement::Point})
      all.of(kind) = element_ids(network_.network(), kind);
    host().set_mode(select_mode);
    network_.act(recorded::SurfaceChoice{all});
    return true;
  }
  if (command == EditCommand::Accept && works && host().action("fill-loop")->isEnabled()) {
    host().action("fill-loop")->trigger();
    return true;
  }
  const bool deletes = command == EditCommand::Delete;
  if (!has_selection() || !(deletes || command == EditCommand::SelectNone)) return false;
  if (deletes)
    network_.act(recorded::SurfaceDelete{network_.tool().selected()});
  else
    network_.act(recorded::SurfaceChoice{});
  return true;
}

bool SurfaceDrawingTool::has_selection() const { return is_there() && !network_.tool().selected().empty(); }

bool SurfaceDrawingTool::open_step(const Node& step) {
  const OperationDescription* operation = studio().description(step.operation);
  const PortDescription* input = operation == nullptr ? nullptr : main_input(*operation);
  const bool is_network = source_of<AttributeNetwork>(&step) != nullptr;
  const bool goes_on = input != nullptr && input->type == ValueType::AttributeNetwork && is_there();
  if (!is_network && !goes_on) return false;
  if (!surface_mode(mode())) host().set_mode(select_mode);
  return true;
}

// ---- The eye

void SurfaceDrawingTool::adjust(ObjectScenes::Wanted& wanted, int) const {
  if (is_there()) wanted.outlines = false;
}

void SurfaceDrawingTool::add_to(render::Scene& scene, int view) {
  if (!is_there()) return;
  if (const UniformGhost::Compared* compared = ghost_.compared(); compared != nullptr && compared->item)
    scene.meshes.emplace_back(compared->item, render::Emphasis{}, render::MeshStyle::translucent(ghost_opacity));
  const bool on_ground = mode() == "draw" && network_.tool().settings().plane == SurfacePlane::Ground;
  if (on_ground && view == PerspectiveView)
    scene.lines.emplace_back(ground_lines(network_.scene().bounds(), network_.to_world()));
  network_.add_to(scene, view);
}

/// Patches are framed by themselves.
render::Bounds SurfaceDrawingTool::bounds_in(int) const {
  const bool alone = is_there() && network_.network().faces.empty();
  return alone ? network_.scene().bounds() : render::Bounds();
}

std::optional<SelectionFrame> SurfaceDrawingTool::selection_frame(int) const {
  if (!is_there()) return std::nullopt;
  const AttributeNetwork& network = network_.network();
  const Affine3 to_world = network_.to_world();
  const NetworkElements selected = network_.tool().selected();
  SelectionFrame frame;
  const auto add_curve = [&](Index curve) {
    for (const Vec3& place : traced_curve(network, curve)) frame.bounds.add(to_glm(to_world(place)));
  };
  for (const std::string& id : selected.curves) add_curve(require_element(network, NetworkElement::Curve, id));
  for (const std::string& id : selected.faces) {
    const AttributeFace& face = network.faces[require_element(network, NetworkElement::Face, id)];
    for (const AttributeSide& side : face.loop) add_curve(side.curve);
  }
  for (const std::string& id : selected.nodes)
    frame.bounds.add(to_glm(to_world(network.nodes[require_element(network, NetworkElement::Node, id)].point)));
  for (const std::string& id : selected.points)
    frame.bounds.add(to_glm(to_world(network.points[require_element(network, NetworkElement::Point, id)].point)));
  if (frame.bounds.empty()) return std::nullopt;
  const glm::dvec3 middle = frame.bounds.center();
  const auto& all = network_.scene().bounds();
  const glm::dvec3 around = around_elements / 2 * (all.max - all.min);
  frame.bounds.add(middle - around);
  frame.bounds.add(middle + around);
  return frame;
}

void SurfaceDrawingTool::place_chips(ChipPlaces& places) { chips_.place(places, is_there()); }

// ---- The flow

void SurfaceDrawingTool::follow(Change change) {
  if (change == Change::Opened) return show_opened();
  if (change == Change::Scenes) return;
  change == Change::Document ? network_.follow_document() : network_.follow_result();
  ghost_.follow(is_there() ? network_.shown() : ShownSurface());
  chips_.follow();
  follow_panels();
}

void SurfaceDrawingTool::follow_panels() {
  if (panel_ == nullptr || !is_there()) return;
  panel_->follow();
  domain_panel_->follow();
}

/// A network that is opened is looked at in space, and selected from.
void SurfaceDrawingTool::show_opened() {
  const NodeId now = studio().network_node();
  if (std::exchange(opened_, now) == now || now == 0) return;
  show_in_space();
  if (!network_.network().faces.empty()) host().set_mode(select_mode);
}

void SurfaceDrawingTool::show_in_space() {
  dock_->raise();
  domain_dock_->raise();
  host().viewport().arrange(Arrangement::Four);
  host().viewport().show_alone(PerspectiveView);
  host().viewport().frame_all();
}

bool SurfaceDrawingTool::show_finding(const NodeFinding& found) {
  if (!is_there() || found.node != network_.tool().operation_node()) return false;
  look_at(elements_in(found.finding, network_.network()));
  return true;
}

void SurfaceDrawingTool::look_at(const NetworkElements& elements) {
  if (elements.empty()) return;
  if (mode() != select_mode) host().set_mode(select_mode);
  network_.act(recorded::SurfaceChoice{elements});
  host().viewport().frame_selection();
}

QString SurfaceDrawingTool::status() const {
  if (!is_there()) return {};
  const AttributeNetwork& network = network_.network();
  const auto counted = [](std::size_t count, const QString& one, const QString& many) {
    return count == 1 ? one : many.arg(count);
  };
  return QStringList{counted(network.curves.size(), tr("1 curve"), tr("%1 curves")),
                     counted(network.faces.size(), tr("1 patch"), tr("%1 patches")),
                     counted(network.points.size(), tr("1 point"), tr("%1 points"))}
      .join(", ");
}

// Recorded steps of the surface tool, and what replays can expect of it.

void SurfaceDrawingTool::make_replays(Replays& replays) {
  for (const recorded::StepKind* kind : recorded::surface_steps().kinds()) {
    replays.plays[kind].push_back([this](const recorded::Step& step) {
      if (!is_there()) host().action("new-surface")->trigger();
      network_.follow_document();
      network_.tool().take(step);
      network_.follow_document();
      return true;
    });
  }
  add_counts(replays);
}

void SurfaceDrawingTool::add_counts(Replays& replays) {
  const auto count = [this](auto member) {
    return [this, member](const std::string&) -> std::size_t { return (network_.network().*member).size(); };
  };
  replays.counts["surface-nodes"] = count(&AttributeNetwork::nodes);
  replays.counts["surface-curves"] = count(&AttributeNetwork::curves);
  replays.counts["surface-faces"] = count(&AttributeNetwork::faces);
  replays.counts["surface-points"] = count(&AttributeNetwork::points);
  replays.counts["surface-selected"] = [this](const std::string&) {
    const NetworkElements selected = network_.tool().selected();
    return selected.nodes.size() + selected.curves.size() + selected.faces.size() + selected.points.size();
  };
  replays.counts["surface-patches-made"] = [this](const std::string&) -> std::size_t {
    return static_cast<std::size_t>(std::ranges::count_if(
        required_surface(network_).surface().faces, [](const SurfaceFace& face) { return face.surface != nullptr; }));
  };
  replays.counts["surface-nearer-dents"] = [this](const std::string&) -> std::size_t {
    return static_cast<std::size_t>(
        std::ranges::count_if(required_comparison(ghost_).points, [](const ComparedPoint& point) {
          return point.own && point.uniform && point.own->offset < point.uniform->offset;
        }));
  };
  replays.ranges["surface-boundary-error"] = [this](const std::string&) {
    return std::pair(0.0, required_surface(network_).found->measures.boundary_error);
  };
  replays.ranges["surface-point-errors"] = [this](const std::string&) {
    double greatest = 0;
    for (const auto& error : required_surface(network_).found->measures.point_errors) {
      if (!error) refuse_replay("A point isn't met by its patch");
      greatest = std::max(greatest, *error);
    }
    return std::pair(0.0, greatest);
  };
}

}  // namespace croquis::app
