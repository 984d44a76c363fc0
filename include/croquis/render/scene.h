// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <utility>
#include <vector>

#include "croquis/render/line_item.h"
#include "croquis/render/mark_item.h"
#include "croquis/render/mesh_item.h"

namespace croquis::render {

/// What sets an item apart from the others; they add up. The colours stand in RenderOptions.
struct Emphasis {
  bool selected = false;
  bool hovered = false;
  bool stale = false;  ///< older than what it is made from: faded

  bool operator==(const Emphasis&) const = default;
};

/// An item and its emphasis, which changes without touching the item.
template <typename Item>
struct Shown {
  std::shared_ptr<const Item> item;  ///< null ones are left out
  Emphasis emphasis;

  Shown() = default;
  /// So that lists can be filled with items alone.
  Shown(std::shared_ptr<const Item> shown_item, Emphasis how = {})  // NOLINT(google-explicit-constructor)
      : item(std::move(shown_item)), emphasis(how) {}
};

/// Everything one view shows: surfaces, then lines, then marks, each in the order of its list.
struct Scene {
  std::vector<Shown<MeshItem>> meshes;
  std::vector<Shown<LineItem>> lines;
  std::vector<Shown<MarkItem>> marks;
};

/// The box of all items; empty for none.
Bounds bounds_of(const Scene& scene);

/// Every vertex, corner and mark, in model coordinates: what `frame` puts into the picture.
std::vector<glm::dvec3> points_of(const Scene& scene);

}  // namespace croquis::render
