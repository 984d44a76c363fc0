// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>

#include "io/channel_values.h"
#include "io/mesh_formats.h"
#include "io/mesh_writing.h"
#include "io/text.h"

namespace croquis {
namespace {

void append_values(std::string& text, const AttributeChannel& channel, std::size_t element, int precision) {
  const auto width = static_cast<std::size_t>(channel.width);
  for (std::size_t k = 0; k < width; ++k) append_number(text += ' ', value_of(channel, element * width + k), precision);
}

// A decimal point in a colour means a range from 0 to 1, not to 255.
void append_colour(std::string& text, const AttributeChannel& channel, std::size_t element, int precision) {
  const auto width = static_cast<std::size_t>(channel.width);
  for (std::size_t k = 0; k < width; ++k) {
    if (!std::isfinite(value_of(channel, element * width + k))) return;
  }
  for (std::size_t k = 0; k < width; ++k) {
    const std::size_t begin = text.size();
    append_number(text += ' ', value_of(channel, element * width + k), is_floating(channel) ? precision : 0);
    if (is_floating(channel) && text.find_first_of(".e", begin) == std::string::npos) text += ".0";
  }
}

}  // namespace

MeshWriteResult write_off(const PolyMesh& mesh, const MeshWriteOptions& options, Progress& progress) {
  // OFF can't express that one vertex has none.
  const auto finite_channel = [&](const char* name, int width, int or_width) {
    const AttributeChannel* channel = usable_channel(mesh, name, Domain::Vertex, width, or_width);
    return channel != nullptr && all_finite(*channel) ? channel : nullptr;
  };
  const AttributeChannel* normals = finite_channel("normal", 3, 3);
  const AttributeChannel* colours = finite_channel("color", 3, 4);
  const AttributeChannel* uvs = finite_channel("uv", 2, 2);
  const AttributeChannel* face_colours = usable_channel(mesh, "color", Domain::Face, 3, 4);
  WriteTick tick(progress);
  std::string text = std::string(uvs ? "ST" : "") + (colours ? "C" : "") + (normals ? "N" : "") + "OFF\n";
  text += std::to_string(mesh.vertex_count()) + " " + std::to_string(mesh.face_count()) + " 0\n";
  for (std::size_t v = 0; v < mesh.vertex_count(); ++v) {
    tick();
    for (int k = 0; k < 3; ++k) append_number(text += k > 0 ? " " : "", mesh.positions[v][k], options.precision);
    if (normals != nullptr) append_values(text, *normals, v, options.precision);
    if (colours != nullptr) append_colour(text, *colours, v, options.precision);
    if (uvs != nullptr) append_values(text, *uvs, v, options.precision);
    text += '\n';
  }
  for (std::size_t f = 0; f < mesh.face_count(); ++f) {
    tick();
    append_number(text, mesh.face(f).size());
    for (const Index vertex : mesh.face(f)) append_number(text += ' ', vertex);
    if (face_colours != nullptr) append_colour(text, *face_colours, f, options.precision);
    text += '\n';
  }
  FormatLoss loss("OFF");
  if (mesh.line_count() > 0) loss.note("polylines");
  loss.note_tags(mesh.tags);
  loss.note_others(mesh, {normals, colours, uvs, face_colours});
  return {std::move(text), loss.warnings()};
}

}  // namespace croquis
