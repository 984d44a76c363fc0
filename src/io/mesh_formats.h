// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string_view>

#include "croquis/geometry/poly_mesh.h"
#include "croquis/io/mesh_file.h"
#include "io/read_context.h"

/// The readers and writers of all formats of meshes; read_mesh and write_mesh choose among them.
namespace croquis {

/// Wavefront OBJ (Advanced Visualizer manual, appendix B1): vertices, faces and polylines, and the tags for
/// subdivision that OpenSubdiv's shapes add (`t crease`, `t corner`); free-form geometry, points and display attributes
/// are passed over with a warning.
PolyMesh read_obj(std::string_view bytes, ReadContext& context);

/// Wavefront OBJ: vertices in order with their colours, faces with uv and normals, groups, objects, materials and
/// smoothing groups, then polylines, then creases and pins.
MeshWriteResult write_obj(const PolyMesh& mesh, const MeshWriteOptions& options, Progress& progress);

/// PLY in its three encodings, with every property kept; triangle strips are expanded.
PolyMesh read_ply(std::string_view bytes, ReadContext& context);

/// PLY with every channel as properties of its own type; polylines as edge elements.
MeshWriteResult write_ply(const PolyMesh& mesh, const MeshWriteOptions& options, Progress& progress);

/// STL, text or binary, distinguished by the size in the binary header before the word "solid". Equal corners
/// are joined; the facets' own normals are redundant and not kept.
PolyMesh read_stl(std::string_view bytes, ReadContext& context);

/// STL: triangles with the normals of their corners, binary with 32-bit floats or text.
MeshWriteResult write_stl(const PolyMesh& mesh, const MeshWriteOptions& options, Progress& progress);

/// OFF as Geomview defines it ([ST][C][N]OFF, three dimensions, text): vertices with normals, colours and texture
/// coordinates in that order, faces with colours.
PolyMesh read_off(std::string_view bytes, ReadContext& context);

/// OFF with whatever of vertex normals, colours, texture coordinates and face colours the mesh has.
MeshWriteResult write_off(const PolyMesh& mesh, const MeshWriteOptions& options, Progress& progress);

/// Reads the meshes of all nodes of a GLB file, where their nodes put them. Equal positions are joined, since files
/// repeat a vertex wherever its normal or its place in a texture changes.
/// @throws Error Malformed as read_mesh; Limit: E_TOO_LARGE when nodes repeat meshes too often
PolyMesh read_glb(std::string_view bytes, ReadContext& context);

/// Binary glTF 2.0: a node with a mesh for each object, of triangles by material (else by group) and of polylines as
/// lines, with normals, colours and texture coordinates (see glb_objects); the camera of the options as a node.
MeshWriteResult write_glb(const PolyMesh& mesh, const MeshWriteOptions& options, Progress& progress);

}  // namespace croquis
