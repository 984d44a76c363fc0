// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/tools/surface/surface_drawing_tool.h"

#include <QAction>
#include <QDockWidget>
#include <QScrollArea>
#include <array>
#include <map>
#include <utility>

#include "app/tools/surface/domain_panel.h"
#include "app/tools/surface/network_paths.h"
#include "app/tools/surface/surface_panel.h"
#include "app/views/viewport.h"
#include "app/window/panel_docks.h"
#include "croquis/tools/recording/general_steps.h"
#include "croquis/workspace/chain.h"

namespace croquis::app {
namespace {

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

QScrollArea* scrolled(QWidget* panel) {
  auto* scroll = new QScrollArea;
  scroll->setWidgetResizable(true);
  scroll->setFrameShape(QFrame::NoFrame);
  scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  scroll->setWidget(panel);
  return scroll;
}

}  // namespace

SurfaceDrawingTool::SurfaceDrawingTool(ToolHost& host)
    : Tool(host),
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
  panel_ = new SurfacePanel(network_, action);
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

bool SurfaceDrawingTool::needs_every_move() const { return network_.tool().mode() == SurfaceMode::Draw; }

Qt::CursorShape SurfaceDrawingTool::cursor(int) const {
  return mode() == select_mode ? Qt::ArrowCursor : Qt::CrossCursor;
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

bool SurfaceDrawingTool::select_all() {
  if (!works_in(PerspectiveView)) return false;
  NetworkElements all;
  for (const NetworkElement kind : {NetworkElement::Node, NetworkElement::Curve, NetworkElement::Point})
    all.of(kind) = element_ids(network_.network(), kind);
  host().set_mode(select_mode);
  network_.act([&](SurfaceTool& tool) { return tool.choose(all); });
  return true;
}

bool SurfaceDrawingTool::select_none() {
  if (!is_there() || network_.tool().selected().empty()) return false;
  network_.act([](SurfaceTool& tool) { return tool.choose({}); });
  return true;
}

bool SurfaceDrawingTool::delete_selection() {
  if (!is_there() || network_.tool().selected().empty()) return false;
  network_.act([](SurfaceTool& tool) { return tool.delete_selected(); });
  return true;
}

bool SurfaceDrawingTool::has_selection() const { return is_there() && !network_.tool().selected().empty(); }

bool SurfaceDrawingTool::accept() {
  if (!works_in(PerspectiveView) || !host().action("fill-loop")->isEnabled()) return false;
  host().action("fill-loop")->trigger();
  return true;
}

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
  const bool on_ground = mode() == "draw" && network_.tool().plane() == SurfacePlane::Ground;
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
    for (const Vec3& place : traced_curve(network, curve)) frame.bounds.add(world_place(to_world(place)));
  };
  for (const std::string& id : selected.curves) add_curve(require_element(network, NetworkElement::Curve, id));
  for (const std::string& id : selected.faces) {
    const AttributeFace& face = network.faces[require_element(network, NetworkElement::Face, id)];
    for (const AttributeSide& side : face.loop) add_curve(side.curve);
  }
  for (const std::string& id : selected.nodes)
    frame.bounds.add(world_place(to_world(network.nodes[require_element(network, NetworkElement::Node, id)].point)));
  for (const std::string& id : selected.points)
    frame.bounds.add(world_place(to_world(network.points[require_element(network, NetworkElement::Point, id)].point)));
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

void SurfaceDrawingTool::follow_document() {
  network_.follow_document();
  follow_surfaces();
}

void SurfaceDrawingTool::follow_result() {
  network_.follow_result();
  follow_surfaces();
}

void SurfaceDrawingTool::follow_surfaces() {
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
void SurfaceDrawingTool::opened() {
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
  network_.act([&](SurfaceTool& tool) { return tool.choose(elements); });
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

}  // namespace croquis::app
