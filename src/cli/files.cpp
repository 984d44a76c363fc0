// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/files.h"

#include <array>
#include <cstdio>
#include <filesystem>
#include <utility>

#include "cli/finite_part.h"
#include "croquis/base/error.h"
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
  FinitePart part = finite_part(read_source(invocation, source, result, progress));
  append(result.warnings, part.warnings);
  return std::move(part.mesh);
}

Report read_report(const std::string& path) {
  return read_json(path == "-" ? read_standard_input() : read_file(path), shown_name(path));
}

Drawing read_input_drawing(const Invocation& invocation, CommandResult& result, Progress& progress) {
  const std::string& format = invocation.input_format;
  if (!format.empty() && format != "svg" && format != "png") {
    throw Error(make_error(Category::Usage, "E_FORMAT",
                           "There is no drawing format '" + format + "': use svg, or png for a picture of one.",
                           {{SubjectKind::Parameter, "input-format", {}, {}, {}}}));
  }
  const std::string bytes = read_input(invocation);
  const std::string name = shown_name(invocation.input);
  if (format.empty() ? is_picture(bytes) : format == "png") return read_picture_drawing(bytes, name, progress);
  DrawingReadResult read = read_svg_drawing(bytes, name, progress);
  append(result.warnings, read.warnings);
  return std::move(read.drawing);
}

PerspectiveDrawing read_input_perspective(const Invocation& invocation, CommandResult& result, Progress& progress) {
  const std::string& format = invocation.input_format;
  if (!format.empty() && format != "svg" && format != "json") {
    throw Error(make_error(Category::Usage, "E_FORMAT",
                           "There is no format '" + format + "' of perspective drawings: use svg or json.",
                           {{SubjectKind::Parameter, "input-format", {}, {}, {}}}));
  }
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
  if (!invocation.input_format.empty() && invocation.input_format != "json") {
    throw Error(make_error(Category::Usage, "E_FORMAT",
                           "There is no format '" + invocation.input_format + "' of attribute networks: use json.",
                           {{SubjectKind::Parameter, "input-format", {}, {}, {}}}));
  }
  AttributeNetworkReadResult read = read_attribute_network(read_input(invocation), shown_name(invocation.input));
  append(result.warnings, read.warnings);
  return std::move(read.network);
}

MeshFormat output_mesh_format(const std::string& path, const std::string& named) {
  return mesh_format(path, named, "--output-format");
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
