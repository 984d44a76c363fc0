// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <utility>
#include <vector>

#include <glm/glm.hpp>

#include "croquis/geometry/poly_mesh.h"
#include "croquis/geometry/smooth_surface.h"
#include "croquis/render/bounds.h"
#include "croquis/render/color.h"

namespace croquis::render {

/// An array that never changes and that copies share: items of equal connectivity hold one, not two.
template <typename Value>
class SharedArray {
 public:
  SharedArray() = default;
  SharedArray(std::vector<Value> values)  // NOLINT(google-explicit-constructor): so that it is filled like a vector
      : values_(std::make_shared<const std::vector<Value>>(std::move(values))) {}

  std::size_t size() const { return values_ ? values_->size() : 0; }
  bool empty() const { return size() == 0; }
  const Value* data() const { return values_ ? values_->data() : nullptr; }
  const Value* begin() const { return data(); }
  const Value* end() const { return data() + size(); }
  const Value& operator[](std::size_t i) const { return (*values_)[i]; }

  /// The array itself, which lives as long as it is needed; null for one never filled.
  const std::shared_ptr<const std::vector<Value>>& shared() const { return values_; }

  friend bool operator==(const SharedArray& a, const SharedArray& b) {
    return a.values_ == b.values_ || (a.size() == b.size() && (a.empty() || *a.values_ == *b.values_));
  }

 private:
  std::shared_ptr<const std::vector<Value>> values_;
};

/// A corner of a triangle as the graphics card takes it: what changes while a shape is being moved.
struct SurfaceVertex {
  glm::vec3 position;  ///< in the item's own frame
  glm::vec3 normal;    ///< unit length, or 0 where all faces around have no area
};

/// The rest of it, which stays.
struct SurfacePaint {
  Color color;
  std::uint32_t patch = 0;  ///< the smooth patch it belongs to, 0-based; lines are drawn where patches meet

  friend bool operator==(const SurfacePaint&, const SurfacePaint&) = default;
};

/// An end of a line segment.
struct LineVertex {
  glm::vec3 position;  ///< in the item's own frame
  Color color;
};

/// How light falls on faces.
enum class FaceShading {
  Smooth,  ///< normals averaged by angle over the faces around a vertex, apart where the surface is sharp
  Flat     ///< every face by its own normal; costs a vertex per corner
};

/// How a mesh is made ready for display.
struct MeshItemOptions {
  double crease_angle =
      usual_crease_angle;                ///< radians in [0, pi]: faces that meet at more are shaded apart (60 degrees)
  Color line_color = {46, 58, 72, 255};  ///< of polylines without colours of their own
  FaceShading shading = FaceShading::Smooth;
  double split_sharpness =
      usual_split_sharpness;        ///< tagged edges of at least this sharpness are shaded apart at any angle
  bool use_normal_channel = false;  ///< takes the corners' (else vertices') "normal" channel instead, where it has one
};

class MeshPlan;

/// A mesh ready to be drawn: never changed once made, shared between scenes, undo steps and views.
///
/// Positions are kept relative to the box's centre and in units of its half diagonal, so that single precision serves
/// coordinates of any size. What depends on connectivity alone is shared with the items that update it.
struct MeshItem {
  glm::dvec3 origin = glm::dvec3(0);  ///< model coordinates = origin + scale * own coordinates
  double scale = 1;
  Bounds bounds;  ///< in model coordinates, of what is drawn
  std::vector<SurfaceVertex> vertices;
  SharedArray<SurfacePaint> paint;       ///< of each vertex
  SharedArray<std::uint32_t> triangles;  ///< #T * 3, indices into vertices, face after face
  SharedArray<std::uint32_t> edges;      ///< #E * 2, indices into vertices: the polygons' edges, each once
  std::vector<LineVertex> line_vertices;
  SharedArray<std::uint32_t> segments;  ///< #S * 2, indices into line_vertices
  std::uint32_t patch_count = 0;
  double edge_length = 0;                ///< mean of its edges (of many: of some), in model units
  std::shared_ptr<const MeshPlan> plan;  ///< what its updates and highlights reuse

  /// The same surface with fewer triangles, for `RenderOptions::reduced`; null for one of few triangles.
  std::shared_ptr<const MeshItem> reduced;
};

using MeshItemPtr = std::shared_ptr<const MeshItem>;

/// Makes a mesh ready: polygons (concave ones too) are cut into triangles, normals are averaged by angle over faces
/// that meet below the crease angle across an edge without a sharp tag, vertices at exactly equal places count as one.
///
/// Colours come from a "color" channel of the faces, corners or vertices; else from a palette by "object", by "group",
/// or by connected component, the first of these that distinguishes at least two. A missing (NaN) colour falls back to
/// the palette.
/// @throws Error when `validate(mesh)` finds indices, offsets or coordinates that can't be drawn; faces without area
///         are accepted
/// O(n log n), and O(k^2) for a polygon of k corners.
MeshItemPtr make_mesh_item(const PolyMesh& mesh, const MeshItemOptions& options = {});

/// The item of a mesh that differs from the previous item's in its positions: for every event of a drag.
///
/// Triangles, edges, colours and which faces are shaded as one stay as they were, even where a face turned concave or
/// an edge has passed the crease angle; positions and normals are new. Wherever none of this would come out otherwise,
/// the item equals that of `make_mesh_item` bit for bit. Renderers send positions and normals alone.
/// A mesh with other faces, lines, tags, or colour, part or normal channels than the previous one's is made again with
/// the same options; comparing costs less than a tenth of updating.
/// @param previous any item; null: made with `options`
/// @param options only for null
/// @throws Error as make_mesh_item
/// O(n).
MeshItemPtr update_mesh_item(const MeshItemPtr& previous, const PolyMesh& mesh, const MeshItemOptions& options = {});

/// The same from positions alone, for results whose connectivity is known to stay (a plan of subdivision, a deformer):
/// nothing is compared. Vertices that were at one place are taken to have stayed together; normals are reckoned, also
/// where a channel gave them.
/// @param previous not null
/// @param positions of all vertices of the previous item's mesh
/// @throws Error (E_COUNT, usage) for another number of positions, (E_NOT_FINITE, malformed) naming each vertex with a
///         coordinate that is NaN or infinite
MeshItemPtr update_mesh_item(const MeshItemPtr& previous, std::span<const Vec3> positions);

/// The box of everything in the list; empty for none.
Bounds bounds_of(const std::vector<MeshItemPtr>& items);

/// Every vertex drawn, in model coordinates: what `frame` puts into the picture.
std::vector<glm::dvec3> points_of(const std::vector<MeshItemPtr>& items);

/// The i-th colour of the palette: muted, distinguishable with any colour vision, repeating after eight.
Color palette_color(std::size_t index);

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
