// SPDX-License-Identifier: GPL-3.0-or-later
// Recorded steps of the surface tool, and what replays can expect of it.
#include <algorithm>

#include "app/replay/replay_lookup.h"
#include "app/tools/surface/surface_drawing_tool.h"

namespace croquis::app {
namespace {

const ShownSurface& required_surface(const NetworkInteraction& network) {
  if (!network.shown()) refuse_replay("The surfaces aren't computed yet");
  return network.shown();
}

const DomainComparison& required_comparison(const UniformGhost& ghost) {
  if (ghost.compared() == nullptr) refuse_replay("The uniform domain isn't shown");
  return ghost.compared()->comparison;
}

}  // namespace

std::vector<const recorded::StepKind*> SurfaceDrawingTool::steps() const { return recorded::surface_steps().kinds(); }

bool SurfaceDrawingTool::replay(const recorded::Step& step) {
  if (!is_there()) host().action("new-surface")->trigger();
  network_.follow_document();
  network_.tool().replay(step);
  network_.follow_document();
  return true;
}

Expectations SurfaceDrawingTool::expectations() {
  Expectations own;
  const auto count = [this](auto member) {
    return [this, member](const std::string&) -> std::size_t { return (network_.network().*member).size(); };
  };
  own.counts["surface-nodes"] = count(&AttributeNetwork::nodes);
  own.counts["surface-curves"] = count(&AttributeNetwork::curves);
  own.counts["surface-faces"] = count(&AttributeNetwork::faces);
  own.counts["surface-points"] = count(&AttributeNetwork::points);
  own.counts["surface-selected"] = [this](const std::string&) {
    const NetworkElements selected = network_.tool().selected();
    return selected.nodes.size() + selected.curves.size() + selected.faces.size() + selected.points.size();
  };
  own.counts["surface-patches-made"] = [this](const std::string&) -> std::size_t {
    return static_cast<std::size_t>(std::ranges::count_if(
        required_surface(network_).surface().faces, [](const SurfaceFace& face) { return face.surface != nullptr; }));
  };
  own.counts["surface-nearer-dents"] = [this](const std::string&) -> std::size_t {
    return static_cast<std::size_t>(
        std::ranges::count_if(required_comparison(ghost_).points, [](const ComparedPoint& point) {
          return point.own && point.uniform && point.own->offset < point.uniform->offset;
        }));
  };
  own.ranges["surface-boundary-error"] = [this](const std::string&) {
    return std::pair(0.0, required_surface(network_).found->measures.boundary_error);
  };
  own.ranges["surface-point-errors"] = [this](const std::string&) {
    double greatest = 0;
    for (const auto& error : required_surface(network_).found->measures.point_errors) {
      if (!error) refuse_replay("A point isn't met by its patch");
      greatest = std::max(greatest, *error);
    }
    return std::pair(0.0, greatest);
  };
  return own;
}

}  // namespace croquis::app
