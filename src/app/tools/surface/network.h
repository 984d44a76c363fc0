// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <optional>

#include "app/tools/surface/network_scene.h"
#include "app/tools/tool.h"
#include "app/views/object_picker.h"
#include "croquis/tools/mesh/mesh_pick.h"
#include "croquis/tools/surface/surface_sight.h"

namespace croquis::app {

/// The surfaces as they were computed last, for the tool that draws on them.
class NetworkSight final : public SurfaceSight {
 public:
  /// @param object whose surfaces these are. @param meshes of the other objects, which curves can be drawn on
  NetworkSight(ShownSurface shown, NodeId object, const Studio& studio, MeshPickers& meshes)
      : shown_(std::move(shown)), object_(object), studio_(studio), meshes_(meshes) {}

  std::optional<SurfaceHit> patch_under(const Ray& ray) const override;
  std::optional<MeshHit> mesh_under(const Ray& ray) const override;
  std::optional<Vec3> normal_at(const std::string& point) const override;
  std::optional<double> radius_of(const std::string& point) const override;
  std::vector<Vec3> ring_of(const std::string& point, double radius) const override;
  std::optional<SlopeFrame> slope_at(const std::string& face, const std::string& curve, double at) const override;

 private:
  /// A point attribute as its face has it.
  struct Placed {
    const FaceSurface* face = nullptr;
    std::size_t index = 0;

    const PlacedPoint& point() const { return face->points()[index]; }
  };
  std::optional<Placed> placed(const std::string& point) const;
  const FaceSurface* surface_of(Index face) const;
  MeshPicker& picker() const;
  std::optional<Vec2> domain_place(const SurfacePart& part, Index triangle, const Vec3& place) const;

  ShownSurface shown_;
  NodeId object_;
  const Studio& studio_;
  MeshPickers& meshes_;
  mutable std::unique_ptr<MeshPicker> picker_;  ///< made when it is first needed
};

/// The network of curves that is worked on, with its surfaces and what is shown of it. Its actions, panels and chips
/// are functions of it.
struct DrawnNetwork {
  DrawnNetwork(Tool& tool_of_window, ToolHost& window);

  bool is_there() const { return host.studio().network_node() != 0; }

  /// Of the active object; an empty one while there is none.
  const AttributeNetwork& network() const { return *content; }
  Findings findings() const { return shown.result ? shown.result->findings : Findings(); }
  const Affine3& to_world() const { return shown.to_world; }

  /// How a view sees the network's own space.
  ViewFrame frame_of(int view) const;

  /// Does a step of the tool; what it did is recorded, why it did nothing is said.
  void act(const recorded::Step& step);
  void finish(Verdict verdict);

  void show_preview();
  void show_jumps(bool on);
  void follow_document();
  void follow_result();

  Tool& owner;
  ToolHost& host;
  SurfaceTool tool;
  MeshPickers meshes;  ///< of the other objects
  NetworkScene scene;
  std::shared_ptr<const AttributeNetwork> content;
  ShownSurface shown;
  std::shared_ptr<const SurfaceSight> sight;  ///< null before the first one
  bool jumps = false;                         ///< angles along smooth curves are shown
  std::vector<std::string> offered = {};      ///< the curves of a closed loop without a patch, if nothing is selected
};

/// Selects elements, and frames them.
void look_at(DrawnNetwork& network, const NetworkElements& elements);

}  // namespace croquis::app
