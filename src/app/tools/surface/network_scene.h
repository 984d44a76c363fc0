// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QColor>
#include <QString>
#include <memory>
#include <string>
#include <vector>

#include "app/studio/studio.h"
#include "app/tools/scene_parts.h"
#include "croquis/attribute_surface/network_elements.h"
#include "croquis/geometry/affine3.h"
#include "croquis/operators/surface_result.h"
#include "croquis/render/line_item.h"
#include "croquis/render/mark_item.h"
#include "croquis/render/scene.h"
#include "croquis/tools/surface/surface_tool.h"

namespace croquis::app {

/// Squares on the plane z = 0 of the network's own space, around what is drawn: what strokes lie on that begin on
/// nothing.
render::LineItemPtr ground_lines(const render::Bounds& drawn, const Affine3& to_world);

/// What is known of the surfaces of a network, as they were computed last: maybe of the network as it was a moment ago.
struct ShownSurface {
  std::shared_ptr<const Evaluation> result;  ///< keeps all the rest
  const SurfaceResult* found = nullptr;      ///< null before the first one
  std::shared_ptr<const PolyMesh> mesh;      ///< in the object's space
  Affine3 to_result;                         ///< from the network's own space to the result's
  Affine3 to_mesh;                           ///< … to that of the mesh
  Affine3 to_world;                          ///< … to the model's, where the object stands

  explicit operator bool() const { return found != nullptr; }
  const AttributeNetwork& network() const { return *found->network; }
  const AttributeSurface& surface() const { return *found->surface; }

  /// An index into that network, no_index where it has no such element.
  Index find(NetworkElement kind, const std::string& id) const { return find_element(network(), kind, id); }
};

/// @param network source. @param operation that it goes to; 0 for none
ShownSurface shown_surface(const Studio& studio, NodeId network, NodeId operation);

/// Those that were tried and have no surface.
std::vector<Index> failed_faces(const AttributeNetwork& network, const ShownSurface& shown);

/// The inverse. @param map invertible
Affine3 inverse_of(const Affine3& map);

/// A sentence or number that stands at a place of the world.
struct PlacedText {
  Vec3 at = Vec3::Zero();
  QString text;
  QColor color;
};

/// What the views show of a network of curves over its surfaces. Items are kept until what they show changes.
class NetworkScene {
 public:
  void show_network(const AttributeNetwork& network, const ShownSurface& shown, const NetworkElements& selected);
  void show_handles(const SurfaceTool& tool, const AttributeNetwork& network, const Affine3& to_world);
  void show_findings(const AttributeNetwork& network, const Affine3& to_world, const Findings& findings);
  void show_preview(const SurfacePreview& preview, const AttributeNetwork& network, const Affine3& to_world);

  /// Smooth curves coloured by the angle between the patches beside them. @param on else none
  void show_jumps(const AttributeNetwork& network, const ShownSurface& shown, bool on);

  void add_to(render::Scene& scene) const;

  /// Of the network in the world.
  const render::Bounds& bounds() const { return bounds_; }
  const std::vector<FindingMark>& marks() const { return marks_; }
  const std::vector<PlacedText>& numbers() const { return numbers_; }  ///< degrees along smooth curves

 private:
  std::vector<render::LineItemPtr> curves_;
  render::LineItemPtr failed_, selected_, polygons_, slopes_, ring_, jumps_;
  render::LineItemPtr ink_, loop_, hovered_;
  render::MarkItemPtr nodes_, points_, handles_, tips_, findings_, snap_;
  render::Bounds bounds_;
  std::vector<FindingMark> marks_;
  std::vector<PlacedText> numbers_;
};

}  // namespace croquis::app
