// SPDX-License-Identifier: GPL-3.0-or-later
#include "croquis/io/mesh_file.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "croquis/base/error.h"
#include "io/float_positions.h"
#include "io/glb_writer.h"
#include "io/gltf/glb_reader.h"
#include "io/mesh_checks.h"
#include "io/obj/obj_reader.h"
#include "io/obj/obj_writer.h"
#include "io/off_reader.h"
#include "io/off_writer.h"
#include "io/ply/ply_reader.h"
#include "io/ply/ply_writer.h"
#include "io/read_context.h"
#include "io/stl_reader.h"
#include "io/stl_writer.h"
#include "io/text.h"

namespace croquis {
namespace {

// Vertices, corners and bytes of a file below this fit 32-bit indices.
constexpr std::size_t largest_file = std::size_t{1} << 32;

// Editors put it before UTF-8 text.
constexpr std::string_view byte_order_mark = "\xef\xbb\xbf";

/// What a format is called, and who reads it: the one list of formats.
struct FormatEntry {
  MeshFormat format;
  const char* name;
  std::string_view extension;
  PolyMesh (*read)(std::string_view bytes, ReadContext& context);
};

constexpr std::array formats = {
    FormatEntry{MeshFormat::Obj, "OBJ", "obj", &read_obj}, FormatEntry{MeshFormat::Ply, "PLY", "ply", &read_ply},
    FormatEntry{MeshFormat::Stl, "STL", "stl", &read_stl}, FormatEntry{MeshFormat::Off, "OFF", "off", &read_off},
    FormatEntry{MeshFormat::Glb, "GLB", "glb", &read_glb}};

const FormatEntry& entry_of(MeshFormat format) { return *std::ranges::find(formats, format, &FormatEntry::format); }

void check_size(const MeshSource& source, ReadContext& context) {
  if (source.bytes.find_first_not_of(" \t\r\n") == std::string_view::npos) {
    context.fail("E_EMPTY", "the file is empty", {});
  }
  if (source.bytes.size() < largest_file) return;
  throw Error(make_error(Category::Limit, "E_TOO_LARGE",
                         "'" + source.file_name + "': files of 4 GiB and more are not read; split the model.",
                         {{SubjectKind::File, source.file_name, source.file_name, std::nullopt, {}}}));
}

// What a text format's reader gets back under `precision`.
template <typename Float>
double rewritten(double value, int precision) {
  std::string text;
  append_number(text, static_cast<Float>(value), precision);
  Float back = 0;
  parse_number(text, back);
  return static_cast<double>(back);
}

bool stores_floats(MeshFormat format, const MeshWriteOptions& options) {
  return format == MeshFormat::Glb || (format == MeshFormat::Stl && !options.ascii);
}

}  // namespace

const char* to_string(MeshFormat format) { return entry_of(format).name; }

std::string extension_of(MeshFormat format) { return "." + std::string(entry_of(format).extension); }

std::vector<MeshFormat> mesh_formats() {
  std::vector<MeshFormat> all;
  for (const FormatEntry& entry : formats) all.push_back(entry.format);
  return all;
}

std::optional<MeshFormat> mesh_format_of(std::string_view path_or_extension) {
  const std::size_t separator = path_or_extension.find_last_of("./\\");
  const bool has_dot = separator != std::string_view::npos && path_or_extension[separator] == '.';
  if (separator != std::string_view::npos && !has_dot) return std::nullopt;
  const std::string extension = lower_case(path_or_extension.substr(has_dot ? separator + 1 : 0));
  const auto found = std::ranges::find(formats, extension, &FormatEntry::extension);
  return found == formats.end() ? std::nullopt : std::optional(found->format);
}

MeshReadResult read_mesh(const MeshSource& given, Progress& progress) {
  MeshSource source = given;
  if (source.bytes.starts_with(byte_order_mark)) source.bytes.remove_prefix(byte_order_mark.size());
  ReadContext context(source, progress);
  check_size(source, context);
  MeshReadResult result;
  result.mesh = entry_of(source.format).read(source.bytes, context);
  if (!context.has_errors()) check_mesh(result.mesh, source.require_faces, context);
  result.warnings = context.finish();
  progress.report(1);
  return result;
}

MeshReadResult read_mesh(std::string_view bytes, MeshFormat format, const std::string& file_name, Progress& progress) {
  return read_mesh({bytes, format, file_name}, progress);
}

MeshWriteResult write_mesh(const PolyMesh& mesh, MeshFormat format, const MeshWriteOptions& options,
                           Progress& progress) {
  switch (format) {
    case MeshFormat::Obj: return write_obj(mesh, options, progress);
    case MeshFormat::Ply: return write_ply(mesh, options, progress);
    case MeshFormat::Stl: return write_stl(mesh, options, progress);
    case MeshFormat::Off: return write_off(mesh, options, progress);
    case MeshFormat::Glb: return write_glb(mesh, options, progress);
  }
  return {};
}

bool keeps_positions(const PolyMesh& mesh, MeshFormat format, const MeshWriteOptions& options) {
  if (stores_floats(format, options)) return positions_are_floats(mesh);
  const bool as_text = format == MeshFormat::Obj || format == MeshFormat::Off || options.ascii;
  return !as_text || options.precision <= 0;
}

PolyMesh as_written(const PolyMesh& mesh, MeshFormat format, const MeshWriteOptions& options) {
  PolyMesh written = mesh;
  if (keeps_positions(mesh, format, options)) return written;
  if (stores_floats(format, options)) {
    written.positions = positions_as_floats(mesh, format);
    return written;
  }
  const bool as_floats = format == MeshFormat::Ply && positions_are_floats(mesh);
  for (Vec3& position : written.positions) {
    for (double& x : position) {
      x = as_floats ? rewritten<float>(x, options.precision) : rewritten<double>(x, options.precision);
    }
  }
  return written;
}

}  // namespace croquis
