// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/files.h"

#include <algorithm>
#include <array>
#include <cstdio>
#include <filesystem>
#include <utility>
#include <vector>

#include "croquis/base/error.h"
#include "croquis/base/limits.h"
#include "croquis/geometry/mesh_part.h"
#include "croquis/io/attribute_network_file.h"
#include "croquis/io/file.h"
#include "croquis/io/json.h"
#include "croquis/io/perspective_drawing_file.h"
#include "croquis/io/picture_trace.h"
#include "croquis/io/svg_drawing.h"

namespace croquis::cli {
namespace {

std::string shown_name(const std::string& path) { return path == "-" ? "standard input" : path; }

void append(Findings& all, const Findings& more) { all.insert(all.end(), more.begin(), more.end()); }

std::string read_standard_input() {
  std::string bytes;
  std::array<char, 65536> buffer;
  while (const std::size_t count = std::fread(buffer.data(), 1, buffer.size(), stdin)) {
    bytes.append(buffer.data(), count);
  }
  if (std::ferror(stdin) != 0) {
    throw Error(make_error(Category::Malformed, "E_FILE_OPEN", "Standard input can't be read.",
                           {{SubjectKind::File, "-", {}, {}, {}}}));
  }
  return bytes;
}

MeshFormat mesh_format(const std::string& path, const std::string& named, const char* option) {
  const auto format = mesh_format_of(named.empty() ? path : named);
  if (format) return *format;
  const std::string what =
      named.empty() ? "The format of '" + path + "' isn't known" : "There is no format '" + named + "'";
  throw Error(make_error(Category::Usage, "E_FORMAT",
                         what + ": use obj, ply, stl, off or glb as its extension or with " + option + ".",
                         {{SubjectKind::File, path, {}, {}, {}}}));
}

/// @param before, after of the sentence, around the format that isn't known
void require_format(const std::string& format, const std::vector<std::string>& known, const std::string& before,
                    const std::string& after) {
  if (format.empty() || std::ranges::find(known, format) != known.end()) return;
  throw Error(make_error(Category::Usage, "E_FORMAT", "There is no " + before + " '" + format + "'" + after,
                         {{SubjectKind::Parameter, "input-format", {}, {}, {}}}));
}

/// The input as a mesh; of the source all is filled in but how it is to be read.
PolyMesh read_source(const Invocation& invocation, MeshSource source, CommandResult& result, Progress& progress) {
  source.format = mesh_format(invocation.input, invocation.input_format, "--input-format");
  const std::string bytes = read_input(invocation);
  source.bytes = bytes;
  source.file_name = shown_name(invocation.input);
  MeshReadResult read = read_mesh(source, progress);
  append(result.warnings, read.warnings);
  return std::move(read.mesh);
}

Finding dropped_finding(const PolyMesh& before, const PolyMesh& after) {
  const std::size_t vertices = before.vertex_count() - after.vertex_count();
  const std::size_t faces = before.face_count() - after.face_count();
  return make_warning(Category::Malformed, "W_BAD_DROPPED",
                      "Dropped " + std::to_string(vertices) + (vertices == 1 ? " vertex" : " vertices") +
                          " with coordinates that aren't finite or are larger than 1e30, and " + std::to_string(faces) +
                          (faces == 1 ? " face that uses it" : " faces that use them") +
                          "; those behind them have lower numbers now.");
}

/// A mesh without the vertices that are not finite, and without the faces, polylines and tags that use them. What
/// remains keeps its order and its attributes. Linear time.
/// @param warnings gets at most one W_BAD_DROPPED: how much is gone
PolyMesh finite_part(PolyMesh mesh, Findings& warnings) {
  std::vector<bool> is_finite(mesh.vertex_count());
  bool all_finite = true;
  for (std::size_t v = 0; v < mesh.vertex_count(); ++v) {
    is_finite[v] = are_usable_numbers(mesh.positions[v]);
    all_finite = all_finite && is_finite[v];
  }
  if (all_finite) return mesh;
  MeshPart part = part_of(mesh, is_finite, std::vector<bool>(mesh.face_count(), true));
  warnings.push_back(dropped_finding(mesh, part.mesh));
  return std::move(part.mesh);
}

}  // namespace

std::string read_input(const Invocation& invocation) {
  return invocation.input == "-" ? read_standard_input() : read_file(invocation.input);
}

PolyMesh read_input_mesh(const Invocation& invocation, bool require_faces, CommandResult& result, Progress& progress) {
  MeshSource source;
  source.require_faces = require_faces;
  return read_source(invocation, source, result, progress);
}

PolyMesh read_finite_mesh(const Invocation& invocation, CommandResult& result, Progress& progress) {
  MeshSource source;
  source.keep_not_finite = true;
  return finite_part(read_source(invocation, source, result, progress), result.warnings);
}

Report read_report(const std::string& path) {
  return read_json(path == "-" ? read_standard_input() : read_file(path), shown_name(path));
}

Drawing read_input_drawing(const Invocation& invocation, CommandResult& result, Progress& progress) {
  const std::string& format = invocation.input_format;
  require_format(format, {"svg", "png"}, "drawing format", ": use svg, or png for a picture of one.");
  const std::string bytes = read_input(invocation);
  const std::string name = shown_name(invocation.input);
  if (format.empty() ? is_picture(bytes) : format == "png") return read_picture_drawing(bytes, name, progress);
  DrawingReadResult read = read_svg_drawing(bytes, name, progress);
  append(result.warnings, read.warnings);
  return std::move(read.drawing);
}

PerspectiveDrawing read_input_perspective(const Invocation& invocation, CommandResult& result, Progress& progress) {
  const std::string& format = invocation.input_format;
  require_format(format, {"svg", "json"}, "format", " of perspective drawings: use svg or json.");
  const std::string bytes = read_input(invocation);
  const std::size_t first = bytes.find_first_not_of(" \t\r\n");
  const bool is_json = format.empty() ? first != std::string::npos && bytes[first] == '{' : format == "json";
  const std::string name = shown_name(invocation.input);
  PerspectiveReadResult read =
      is_json ? read_perspective_json(bytes, name) : read_perspective_svg(bytes, name, progress);
  append(result.warnings, read.warnings);
  return std::move(read.drawing);
}

AttributeNetwork read_input_network(const Invocation& invocation, CommandResult& result) {
  require_format(invocation.input_format, {"json"}, "format", " of attribute networks: use json.");
  AttributeNetworkReadResult read = read_attribute_network(read_input(invocation), shown_name(invocation.input));
  append(result.warnings, read.warnings);
  return std::move(read.network);
}

MeshFormat output_mesh_format(const std::string& path, const std::string& named) {
  return mesh_format(path, named, "--output-format");
}

void require_png_output(const Invocation& invocation) {
  const std::string& named = invocation.output_format;
  if (named == "png" || (named.empty() && (invocation.output == "-" || invocation.output.ends_with(".png")))) return;
  throw Error(make_error(Category::Usage, "E_FORMAT", "Pictures are written as PNG: give the output a name in .png.",
                         {{SubjectKind::File, invocation.output, {}, {}, {}}}));
}

void stage_mesh(const std::string& path, const PolyMesh& mesh, const MeshWriteOptions& options, MeshFormat format,
                CommandResult& result, Progress& progress) {
  MeshWriteOptions named = options;
  if (named.name.empty() && path != "-") named.name = std::filesystem::path(path).stem().string();
  MeshWriteResult written = write_mesh(mesh, format, named, progress);
  append(result.warnings, written.warnings);
  stage_file(path, std::move(written.bytes), result);
}

void stage_file(const std::string& path, std::string bytes, CommandResult& result) {
  if (!result.files.emplace(path, std::move(bytes)).second) {
    throw Error(make_error(Category::Usage, "E_USAGE", "Two outputs are called '" + path + "'; give each its own name.",
                           {{SubjectKind::File, path, {}, {}, {}}}));
  }
}

}  // namespace croquis::cli
