// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <memory>
#include <span>

#include "croquis/render/mesh_item.h"

namespace croquis::render {

/// Faces of a mesh item in a colour of their own: selected, hovered, matched … They are the surface's own triangles
/// drawn once more, so nothing flickers; light, hollows and contours stay.
struct FaceHighlight {
  MeshItemPtr mesh;
  SharedArray<std::uint32_t> triangles;                    ///< #T * 3, indices into the item's vertices
  Color color;                                             ///< alpha is the strength over the faces' own colour
  std::shared_ptr<const FaceHighlight> reduced = nullptr;  ///< of the item's reduced surface, where it has one
};

using FaceHighlightPtr = std::shared_ptr<const FaceHighlight>;

/// Highlights faces.
/// @param faces of the mesh that the item was made from, in any order
/// @throws Error (E_INDEX, malformed) naming each face that the mesh doesn't have
/// O(faces highlighted).
FaceHighlightPtr make_face_highlight(const MeshItemPtr& mesh, std::span<const Index> faces, const Color& color);

}  // namespace croquis::render
