// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "croquis/geometry/poly_mesh.h"
#include "io/gltf/gltf_accessor.h"

namespace croquis {

/// One attribute of the vertices as a GLB file repeats them, NaN where there is none.
class GlbAttribute {
 public:
  /// Values of vertices `first`, `first` + 1, …; at most four components.
  void add(std::size_t first, const GltfNumbers& numbers);

  bool empty() const { return width_ == 0; }
  bool all_bytes() const { return all_bytes_; }
  std::size_t width() const { return width_; }

  /// @param repeated how many vertices the file has. Component by component
  std::vector<double> values(std::size_t repeated) const;

 private:
  std::vector<double> values_;  ///< four per vertex
  std::size_t width_ = 0;
  bool all_bytes_ = true;
};

/// Which vertices of the file became which of the mesh.
struct GlbVertices {
  std::vector<Index> joined;           ///< per vertex of the file
  std::vector<std::uint32_t> corners;  ///< per corner of the mesh, the vertex of the file
};

/// Appends a channel: on vertices where all that were joined agree, else on corners.
void add_glb_channel(const char* name, const GlbAttribute& attribute, const GlbVertices& vertices, PolyMesh& mesh);

}  // namespace croquis
