// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "croquis/base/finding.h"
#include "croquis/geometry/poly_mesh.h"

namespace croquis::cli {

/// A mesh among others in one file.
struct NamedMesh {
  std::string name;
  std::shared_ptr<const PolyMesh> mesh;
};

struct MeshUnion {
  PolyMesh mesh;      ///< the parts one after the other; "object" on faces and lines distinguishes them; tags are kept
  Findings warnings;  ///< at most one W_CHANNELS: attributes that not all parts have, left out
};

/// One mesh of several, which stay as they are beside each other. A single one stays itself.
MeshUnion unite(const std::vector<NamedMesh>& parts);

}  // namespace croquis::cli
