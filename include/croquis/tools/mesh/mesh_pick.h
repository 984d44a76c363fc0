// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "croquis/geometry/mesh_topology.h"
#include "croquis/session/selection.h"
#include "croquis/tools/pointer/mesh_event.h"
#include "croquis/tools/pointer/view_frame.h"

namespace croquis {

/// What a ray or a pixel met.
struct PickedElement {
  Index element = no_index;   ///< a vertex, an edge (MeshTopology) or a face
  Vec3 place = Vec3::Zero();  ///< on it
  double distance = 0;        ///< of a face: along the ray; else pixels from the pointer
  double parameter = 0;       ///< of an edge: 0..1 from edge_vertices[0] to [1]
};

struct MeshPickOptions {
  double pixels = 8;     ///< how far a vertex or edge may be from the pointer
  bool through = false;  ///< also what the surface hides
};

/// Finds the elements of one mesh in views of it.
///
/// Hidden means that a face which doesn't have the vertex or edge lies nearer to the eye by more than half a pixel:
/// so elements on the silhouette, and twins at one place, count as visible. Polygons with more than four corners are
/// tested as they are seen, concave or not, in the depth of their plane; quads as two triangles.
/// Built in O(n) on first use (a million faces in about a tenth of a second), refitted in O(n) after positions changed.
/// Queries look at what lies near; the box, at all that is in it, on all cores. Deterministic for any number of them.
/// Calls from one thread at a time.
class MeshPicker {
 public:
  /// @param mesh positions finite. @param topology of that mesh; null: made by the first query about vertices or edges
  explicit MeshPicker(std::shared_ptr<const PolyMesh> mesh, std::shared_ptr<const MeshTopology> topology = nullptr);
  ~MeshPicker();
  MeshPicker(MeshPicker&&) noexcept;
  MeshPicker& operator=(MeshPicker&&) noexcept;

  /// The same connectivity with other positions. O(1): the work is done by the next query.
  void move_to(std::shared_ptr<const PolyMesh> mesh);

  /// Does that work now.
  void prepare();

  const PolyMesh& mesh() const;
  const MeshTopology& topology() const;

  /// The face that the ray meets first, from either side.
  std::optional<PickedElement> face_under(const Ray& ray);

  /// The vertex, edge or face at a pixel: of vertices and edges the nearest within reach.
  std::optional<PickedElement> at(const ViewFrame& frame, const Vec2& pixel, ComponentKind kind,
                                  const MeshPickOptions& options = {});

  /// The elements of which some part is in the box, sorted. @param box pixels of the view
  /// Without `through`, those of which some part in the box is seen, decided on a grid of at most a million cells over
  /// what the box shows of the mesh.
  std::vector<Index> in_box(const ViewFrame& frame, const PickBox& box, ComponentKind kind, bool through = false);

  /// Whether the place on these faces (sorted) is not hidden by others.
  bool visible(const ViewFrame& frame, const Vec3& place, const std::vector<Index>& own_faces);

 private:
  struct State;
  std::unique_ptr<State> state_;
};

/// As MeshPicker::face_under, for one ray: looks at every face, which takes less than to prepare a picker.
std::optional<PickedElement> face_under(const PolyMesh& mesh, const Ray& ray);

}  // namespace croquis
