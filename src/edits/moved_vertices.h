// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>

#include <Eigen/Geometry>

#include "croquis/base/parameter.h"
#include "croquis/mesh_editing/mesh_edit.h"

/// What edits share that keep every vertex and face.
namespace croquis {

/// The mesh as it is: everything comes from itself.
MeshEdit with_same_elements(PolyMesh mesh);

/// Moves the vertices of elements.
MeshEdit with_vertices_moved(const PolyMesh& mesh, const MeshTopology& topology, ComponentKind kind,
                             std::span<const Index> elements, const Eigen::Affine3d& map);

/// The parameter "about", else the mean of the elements' vertices.
Vec3 pivot_of(const PolyMesh& mesh, const MeshTopology& topology, ComponentKind kind, std::span<const Index> elements,
              const ParameterValues& parameters);

}  // namespace croquis
