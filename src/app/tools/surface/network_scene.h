// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QColor>
#include <QString>
#include <vector>

#include "app/tools/surface/shown_surface.h"
#include "croquis/render/scene.h"
#include "croquis/tools/surface/surface_tool.h"

namespace croquis::app {

/// A sentence or number that stands at a place of the world.
struct PlacedText {
  Vec3 at = Vec3::Zero();
  QString text;
  QColor color;
};

/// A finding and where it stands in the world.
struct NetworkMark {
  Vec3 at = Vec3::Zero();
  QString sentence;
  bool error = false;
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
  const std::vector<NetworkMark>& marks() const { return marks_; }
  const std::vector<PlacedText>& numbers() const { return numbers_; }  ///< degrees along smooth curves

 private:
  std::vector<render::LineItemPtr> curves_;
  render::LineItemPtr failed_, selected_, polygons_, slopes_, ring_, jumps_;
  render::LineItemPtr ink_, loop_, hovered_;
  render::MarkItemPtr nodes_, points_, handles_, tips_, findings_, snap_;
  render::Bounds bounds_;
  std::vector<NetworkMark> marks_;
  std::vector<PlacedText> numbers_;
};

/// The colour of an angle between patches: green where nobody sees it, red from two degrees on.
QColor jump_color(double degrees);

}  // namespace croquis::app
