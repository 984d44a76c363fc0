// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "croquis/base/progress.h"
#include "croquis/geometry/camera.h"
#include "croquis/geometry/poly_mesh.h"

/// Meshes as bytes of a file, and back.
///
/// The readers take strangers' files: damaged input is refused with every finding at once, each naming file and line
/// (text) or byte (binary), and never by a crash or a hang. Time and memory are linear in the size of the file; counts
/// that a header claims are compared with that size before anything is allocated.
namespace croquis {

enum class MeshFormat { Obj, Ply, Stl, Off, Glb };

/// "OBJ", "PLY", …
const char* to_string(MeshFormat format);

/// ".obj", ".ply", …
std::string extension_of(MeshFormat format);

/// All formats; each is read and written. What dialogs offer comes from here.
std::vector<MeshFormat> mesh_formats();

/// The format meant by a path or a bare extension ("a/b.OBJ", ".obj" and "obj" are the same), or nothing.
std::optional<MeshFormat> mesh_format_of(std::string_view path_or_extension);

/// A file to read.
struct MeshSource {
  std::string_view bytes;
  MeshFormat format = MeshFormat::Obj;
  std::string file_name;         ///< for findings only
  bool require_faces = true;     ///< refuse files without faces; else polylines and bare points are meshes too
  bool keep_not_finite = false;  ///< keep such positions, with warnings W_NOT_FINITE: the caller drops their faces
};

struct MeshReadResult {
  PolyMesh mesh;      ///< indices in range, at least 3 corners a face; faces may use a vertex twice
  Findings warnings;  ///< W_DEGENERATE, W_IGNORED, W_TRAILING, W_NOT_FINITE, W_TAG_SHARPNESS
};

/// Reads a mesh. What the formats' attributes become:
/// - OBJ: "group", "object" and "material" on faces and lines are indices into the channel's labels, -1 for none;
///   "smoothing_group" on faces; "color" on vertices; "uv" and "normal" on vertices where every corner uses its
///   vertex' own, else on corners with NaN where a corner has none. `t crease` and `t corner` are the mesh's tags
///   (creases, and pins for corners of any sharpness, with W_TAG_SHARPNESS below 10), `t settled` is "settled_corner"
///   on vertices; tags need not fit the mesh.
/// - PLY: nx ny nz are "normal", red green blue (alpha) "color", s t or u v "uv", a face's texcoord list "uv" on
///   corners; name_0 name_1 … become one channel; all others keep name and type. Edge elements are polylines.
/// - STL: equal corners are joined; "attribute" on faces where it isn't 0; the solids' names are "object".
/// - OFF: vertex "normal", "color", "uv" and face "color".
/// - GLB: the meshes of all nodes, where these put them; triangles, strips, fans and lines. Equal positions are joined;
///   "normal", "color" and "uv" are on vertices where all that were joined agree, else on corners. Nodes' names are
///   "object", materials' "material". Textures, skins, animations and morph targets are named (W_IGNORED).
/// @throws Error Malformed: E_EMPTY, E_FORMAT, E_TRUNCATED, E_SYNTAX, E_COUNT, E_INDEX, E_NOT_FINITE, E_NO_FACES,
/// E_DEGENERATE
///         (all points equal), E_FACE_DEGENERATE (fewer than 3 corners); Limit: E_TOO_LARGE (4 GiB and more, or a GLB
///         whose nodes repeat its meshes beyond measure)
/// @throws Cancelled
MeshReadResult read_mesh(const MeshSource& source, Progress& progress);

/// Short form with the default answers.
MeshReadResult read_mesh(std::string_view bytes, MeshFormat format, const std::string& file_name, Progress& progress);

struct MeshWriteOptions {
  int precision = 0;   ///< significant digits (1..17) of text formats; 0 = the shortest that read back exactly
  bool ascii = false;  ///< PLY and STL as text; else binary, little endian
  std::optional<Camera> camera = {};  ///< that sees the mesh: a camera node in GLB, nothing in the other formats
  std::string name = {};              ///< in GLB, of what has no "object" name
  bool z_up = false;                  ///< the mesh's z axis points up, not y: GLB, whose y axis does, turns it upright
};

struct MeshWriteResult {
  std::string bytes;
  Findings warnings;  ///< at most one W_FORMAT_LOSS: what the format can't hold
};

/// Writes a mesh whose indices are in range. Tags go into OBJ, but for their sets, and into no other format. PLY
/// positions are doubles unless floats hold all of them exactly; polygons are triangulated for STL and GLB.
/// @throws Error Geometry: E_OUT_OF_RANGE (too large for 32-bit numbers in STL or GLB), E_NO_FACES (none, for STL)
/// @throws Cancelled
MeshWriteResult write_mesh(const PolyMesh& mesh, MeshFormat format, const MeshWriteOptions& options,
                           Progress& progress);

/// Whether a mesh's positions will read back as they are: then there is no need for as_written.
bool keeps_positions(const PolyMesh& mesh, MeshFormat format, const MeshWriteOptions& options);

/// The same mesh with its positions exactly as they will read back: for judging the file instead of the model.
/// @throws Error like write_mesh
PolyMesh as_written(const PolyMesh& mesh, MeshFormat format, const MeshWriteOptions& options);

}  // namespace croquis
