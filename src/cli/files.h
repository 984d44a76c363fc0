// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "cli/command.h"
#include "croquis/geometry/attribute_network.h"
#include "croquis/geometry/drawing.h"
#include "croquis/geometry/perspective_drawing.h"
#include "croquis/geometry/poly_mesh.h"
#include "croquis/io/mesh_file.h"

/// Between the names on the command line and the readers and writers of croquis/io.
namespace croquis::cli {

/// The input's bytes: of the file, or of standard input when it is "-".
/// @throws Error (E_FILE_OPEN)
std::string read_input(const Invocation& invocation);

/// Reads the input as a mesh; the reader's warnings go to the result.
/// @param require_faces false also accepts files of lines and points
/// @throws Error (E_FORMAT when neither name nor --input-format names a mesh format; the reader's codes)
PolyMesh read_input_mesh(const Invocation& invocation, bool require_faces, CommandResult& result, Progress& progress);

/// Reads the input as a mesh with faces of which vertices that are not finite are dropped, with what uses them; a
/// warning gives their number.
/// @throws Error like read_input_mesh
PolyMesh read_finite_mesh(const Invocation& invocation, CommandResult& result, Progress& progress);

/// Reads a further input of the command, a JSON file, as a report. "-" is standard input.
/// @throws Error
Report read_report(const std::string& path);

/// Reads the input as a silhouette sketch.
/// @throws Error
Drawing read_input_drawing(const Invocation& invocation, CommandResult& result, Progress& progress);

/// Reads the input as a perspective drawing: JSON where it begins with a brace, else SVG.
/// @throws Error
PerspectiveDrawing read_input_perspective(const Invocation& invocation, CommandResult& result, Progress& progress);

/// Reads the input as an attribute network.
/// @throws Error
AttributeNetwork read_input_network(const Invocation& invocation, CommandResult& result);

/// The mesh format of an output path; `named` (--output-format) goes before the name.
/// @throws Error (E_FORMAT, Category::Usage)
MeshFormat output_mesh_format(const std::string& path, const std::string& named);

/// @throws Error (E_FORMAT, Category::Usage) where the output isn't a picture by its name or --output-format
void require_png_output(const Invocation& invocation);

/// Puts the mesh's bytes among the result's files, warnings of the format included.
void stage_mesh(const std::string& path, const PolyMesh& mesh, const MeshWriteOptions& options, MeshFormat format,
                CommandResult& result, Progress& progress);

/// Puts a file's bytes among the result's files.
/// @throws Error (E_USAGE) when two outputs have one name
void stage_file(const std::string& path, std::string bytes, CommandResult& result);

}  // namespace croquis::cli
