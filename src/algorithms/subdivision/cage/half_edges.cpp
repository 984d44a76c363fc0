// SPDX-License-Identifier: GPL-3.0-or-later
#include "croquis/subdivision/half_edges.h"

#include <algorithm>

namespace croquis::subdivision {

CornerFaces::CornerFaces(const HalfEdges& mesh) : offsets_(mesh.face_offsets.data()) {
  face_.resize(mesh.corner_count());
  for (Index face = 0; face < mesh.face_count(); ++face) {
    std::fill(face_.begin() + mesh.face_offsets[face], face_.begin() + mesh.face_offsets[face + std::size_t{1}], face);
  }
}

}  // namespace croquis::subdivision
