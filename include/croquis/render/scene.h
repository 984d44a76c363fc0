// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "croquis/render/line_item.h"
#include "croquis/render/mark_item.h"
#include "croquis/render/mesh_item.h"
#include "croquis/render/picture_item.h"
#include "croquis/render/point_item.h"

namespace croquis::render {

/// What sets an item apart from the others; they add up. The colours stand in RenderOptions.
struct Emphasis {
  bool selected = false;
  bool hovered = false;
  bool stale = false;     ///< older than what it is made from: faded
  bool outlined = false;  ///< surfaces: a line around what is seen of it, in the colour of what is selected

  bool operator==(const Emphasis&) const = default;
};

/// An item and its emphasis, which changes without touching the item.
template <typename Item>
struct Shown {
  std::shared_ptr<const Item> item;  ///< null ones are left out
  Emphasis emphasis;
  glm::dmat4 placement = glm::dmat4(1);  ///< from the item's model coordinates to the scene's; affine, no mirror

  Shown() = default;
  /// So that lists can be filled with items alone.
  Shown(std::shared_ptr<const Item> shown_item, Emphasis how = {})  // NOLINT(google-explicit-constructor)
      : item(std::move(shown_item)), emphasis(how) {}

  bool operator==(const Shown&) const = default;
};

/// What is seen of a mesh's faces.
enum class SurfaceLook {
  Filled,  ///< as in RenderOptions
  Covers,  ///< nothing, but they hide what is behind them: wire with hidden lines left out
  None     ///< nothing at all
};

/// How a mesh is drawn in one view; changes without touching the item.
struct MeshStyle {
  SurfaceLook surface = SurfaceLook::Filled;
  std::optional<bool> wire;          ///< none: as RenderOptions::wire, and always where faces are not filled
  std::optional<Color> wire_color;   ///< none: as RenderOptions; alpha is the strength
  std::optional<double> wire_width;  ///< none: as RenderOptions
  double covered_wire = 0;  ///< SurfaceLook::None: share of the wire's strength left behind other surfaces, in [0, 1]
  bool fades_where_dense = false;  ///< the wire, as on filled faces, where it does so anyway
  /// Of filled faces, in [0, 1], where they are seen straight on. Below 1 they are drawn over all others, the farthest
  /// mesh first, and cover neither these nor each other: a preview. They have no contours, darken no hollows, cover no
  /// lines and marks, and their highlights are left out.
  double opacity = 1;
  bool goes_on = false;  ///< one surface with the mesh before it in the list: no contour where they meet

  static MeshStyle shaded() { return {SurfaceLook::Filled, false, {}, {}, 0}; }
  static MeshStyle shaded_wire() { return {SurfaceLook::Filled, true, {}, {}, 0}; }
  static MeshStyle wire_only() { return {SurfaceLook::None, true, {}, {}, 0}; }
  static MeshStyle hidden_lines_removed() { return {SurfaceLook::Covers, true, {}, {}, 0}; }
  /// Wire around another surface: its edges win where they lie in that surface, and shine through faintly behind it.
  /// It fades where it is dense, as wire on filled faces does.
  static MeshStyle cage(const Color& color) { return {SurfaceLook::None, true, color, 1.2, 0.25, true}; }

  /// A preview: faces alone.
  static MeshStyle translucent(double opacity = 0.55) {
    return {SurfaceLook::Filled, false, {}, {}, 0, false, opacity};
  }

  bool operator==(const MeshStyle&) const = default;
};

/// A mesh, its emphasis and its style. Emphasis tints filled faces; without them it colours the wire.
template <>
struct Shown<MeshItem> {
  MeshItemPtr item;  ///< null ones are left out
  Emphasis emphasis;
  MeshStyle style;
  glm::dmat4 placement = glm::dmat4(1);  ///< as of the others; its highlights go with it

  Shown() = default;
  Shown(MeshItemPtr shown_item, Emphasis how = {}, MeshStyle look = {})  // NOLINT(google-explicit-constructor)
      : item(std::move(shown_item)), emphasis(how), style(look) {}

  bool operator==(const Shown&) const = default;
};

/// Everything one view shows: pictures, surfaces with their highlighted faces, then lines, points and marks, each in
/// the order of its list. Items compare by identity: equal scenes look the same.
struct Scene {
  std::vector<Shown<MeshItem>> meshes;
  std::vector<Shown<LineItem>> lines;
  std::vector<Shown<MarkItem>> marks;
  std::vector<Shown<PointItem>> points = {};
  std::vector<FaceHighlightPtr> highlights = {};  ///< of meshes that are in the list, later ones over earlier ones
  std::vector<ShownPicture> pictures = {};        ///< behind everything, later ones over earlier ones

  bool operator==(const Scene&) const = default;
};

/// The box of the item where it is placed; empty without an item.
template <typename Item>
Bounds bounds_of(const Shown<Item>& shown) {
  if (!shown.item) return {};
  return shown.placement == glm::dmat4(1) ? shown.item->bounds : placed(shown.item->bounds, shown.placement);
}

/// The box of all items but pictures; empty for none.
Bounds bounds_of(const Scene& scene);

/// Every vertex, corner and mark (pictures have none), in model coordinates: what `frame` puts into the picture.
std::vector<glm::dvec3> points_of(const Scene& scene);

}  // namespace croquis::render
