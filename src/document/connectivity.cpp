// SPDX-License-Identifier: GPL-3.0-or-later
#include "croquis/document/connectivity.h"

#include <cstdio>
#include <span>

#include "croquis/document/content_hash.h"

namespace croquis {

std::string connectivity_name(const PolyMesh& mesh) {
  ContentHasher hasher;
  hasher.add(mesh.vertex_count());
  hasher.add(std::span<const Index>(mesh.face_offsets));
  hasher.add(std::span<const Index>(mesh.corners));
  char text[17];
  std::snprintf(text, sizeof text, "%016llx", static_cast<unsigned long long>(hasher.digest().high));
  return text;
}

}  // namespace croquis
