// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>

#include "croquis/geometry/poly_mesh.h"
#include "croquis/io/mesh_file.h"

/// What must hold for any bytes that a mesh reader is given: shared by the fuzzers and the tests.
namespace croquis::test {

/// Faces and lines are the same.
bool same_connectivity(const PolyMesh& a, const PolyMesh& b);

/// The same tags in the same order; NaN equals itself.
bool same_tags(const MeshTags& a, const MeshTags& b);

/// Indices and offsets are in range, positions finite, faces have 3 corners or more and channels their lengths.
bool usable(const PolyMesh& mesh);

/// Reading either throws an Error with findings that name the file, or gives a usable mesh that the same format writes
/// and reads back with the same connectivity.
/// @return what did not hold; empty when all did
std::string broken_property(std::string_view bytes, MeshFormat format);

}  // namespace croquis::test
