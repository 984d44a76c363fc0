// SPDX-License-Identifier: GPL-3.0-or-later
#include "croquis/io/mesh_file.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <span>

#include "croquis/base/error.h"
#include "io/mesh_formats.h"
#include "io/mesh_writing.h"
#include "io/read_context.h"
#include "io/text.h"

namespace croquis {
namespace {

// Vertices, corners and bytes of a file below this fit 32-bit indices.
constexpr std::size_t largest_file = std::size_t{1} << 32;

// Editors put it before UTF-8 text.
constexpr std::string_view byte_order_mark = "\xef\xbb\xbf";

/// What a format is called, who reads and writes it, and when its positions are 32-bit floats: the one list of formats.
struct FormatEntry {
  MeshFormat format;
  const char* name;
  std::string_view extension;
  PolyMesh (*read)(std::string_view bytes, ReadContext& context);
  MeshWriteResult (*write)(const PolyMesh& mesh, const MeshWriteOptions& options, Progress& progress);
  enum class Floats { Never, InBinary, Always } floats;
  bool is_binary;  ///< where the options don't ask for text
};

using Floats = FormatEntry::Floats;

constexpr std::array formats = {
    FormatEntry{MeshFormat::Obj, "OBJ", "obj", &read_obj, &write_obj, Floats::Never, false},
    FormatEntry{MeshFormat::Ply, "PLY", "ply", &read_ply, &write_ply, Floats::Never, true},
    FormatEntry{MeshFormat::Stl, "STL", "stl", &read_stl, &write_stl, Floats::InBinary, true},
    FormatEntry{MeshFormat::Off, "OFF", "off", &read_off, &write_off, Floats::Never, false},
    FormatEntry{MeshFormat::Glb, "GLB", "glb", &read_glb, &write_glb, Floats::Always, true}};

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

constexpr std::size_t named_faces = 100;

// Sorting keeps faces with very many corners from costing their square.
bool repeats_a_vertex(std::span<const Index> face, std::vector<Index>& scratch) {
  if (face.size() == 3) return face[0] == face[1] || face[1] == face[2] || face[2] == face[0];
  scratch.assign(face.begin(), face.end());
  std::sort(scratch.begin(), scratch.end());
  return std::adjacent_find(scratch.begin(), scratch.end()) != scratch.end();
}

void warn_of_degenerate_faces(const PolyMesh& mesh, ReadContext& context) {
  std::vector<Index> scratch;
  std::vector<Subject> subjects;
  std::size_t count = 0;
  for (std::size_t f = 0; f < mesh.face_count(); ++f) {
    if (!repeats_a_vertex(mesh.face(f), scratch)) continue;
    if (++count <= named_faces) subjects.push_back(face_subject(f).front());
  }
  if (count == 0) return;
  const std::string first = name_of(subjects.front());
  const std::string message = count == 1 ? "face " + first + " uses a vertex twice; it is kept as it is"
                                         : std::to_string(count) + " faces use a vertex twice, the first is face " +
                                               first + "; they are kept as they are";
  context.warn("W_DEGENERATE", message, {}, std::move(subjects));
}

bool all_points_equal(const PolyMesh& mesh) {
  return std::all_of(mesh.positions.begin(), mesh.positions.end(),
                     [&](const Vec3& p) { return p == mesh.positions.front(); });
}

/// What every format's result must hold beyond its syntax: faces unless they aren't asked for (E_NO_FACES), at least
/// vertices (E_EMPTY), points that differ (E_DEGENERATE). Faces that use a vertex twice are listed in one W_DEGENERATE
/// and kept: scans have them.
void check_mesh(const PolyMesh& mesh, bool require_faces, ReadContext& context) {
  if (require_faces && mesh.face_count() == 0) {
    context.fail("E_NO_FACES",
                 "the file has " + std::to_string(mesh.vertex_count()) + " vertices and " +
                     std::to_string(mesh.line_count()) + " polylines, but no faces",
                 {});
  }
  if (mesh.vertex_count() == 0) context.fail("E_EMPTY", "the file has no vertices", {});
  if (mesh.face_count() > 0 && all_points_equal(mesh)) {
    context.fail("E_DEGENERATE", "all points of the model are the same", {});
  }
  warn_of_degenerate_faces(mesh, context);
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
  const Floats floats = entry_of(format).floats;
  return floats == Floats::Always || (floats == Floats::InBinary && !options.ascii);
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
  return entry_of(format).write(mesh, options, progress);
}

bool keeps_positions(const PolyMesh& mesh, MeshFormat format, const MeshWriteOptions& options) {
  if (stores_floats(format, options)) return positions_are_floats(mesh);
  const bool as_text = !entry_of(format).is_binary || options.ascii;
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
