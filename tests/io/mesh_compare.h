// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "croquis/base/error.h"
#include "croquis/geometry/poly_mesh.h"
#include "croquis/io/mesh_file.h"
#include "fuzz/readers.h"

namespace croquis::test {

/// What differs between two meshes down to the bits of positions and channels, in their tags too; empty when nothing
/// does.
std::string difference(const PolyMesh& a, const PolyMesh& b);

MeshReadResult read(const std::string& bytes, MeshFormat format);
MeshWriteResult write(const PolyMesh& mesh, MeshFormat format, MeshWriteOptions options = {});

/// The findings that reading throws; fails the test when it throws none.
Findings refusal(const std::string& bytes, MeshFormat format);

/// Channels of every kind that a scan or a game asset may bring.
PolyMesh with_attributes(PolyMesh mesh);

}  // namespace croquis::test
