// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "croquis/geometry/affine3.h"

namespace croquis {

/// A mesh that is to become a part of a larger one.
struct NamedMesh {
  std::string name;
  std::shared_ptr<const PolyMesh> mesh;  ///< never null
  Affine3 map;                           ///< that puts it in its place; invertible
};

/// All meshes as one that shares nothing between them: their elements one after the other, with the names of the meshes
/// as the channel "object" of the faces, and of the lines where there are any. What was "object" in a mesh becomes
/// "group" where it has no such channel. Channels that some meshes lack are kept where there is a value for "none here"
/// (NaN, or -1 in channels with labels); others that lack or differ in type are left out. A single mesh is only mapped.
/// O(n).
PolyMesh joined(const std::vector<NamedMesh>& meshes);

}  // namespace croquis
