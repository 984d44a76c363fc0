// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/off_writer.h"

#include <cmath>

#include "io/channel_values.h"
#include "io/format_loss.h"
#include "io/text.h"
#include "io/tick.h"

namespace croquis {
namespace {

class OffWriter {
 public:
  OffWriter(const PolyMesh& mesh, const MeshWriteOptions& options, Progress& progress)
      : mesh_(mesh), precision_(options.precision), tick_(progress) {}

  MeshWriteResult write() {
    normals_ = finite_channel("normal", 3, 3);
    colours_ = finite_channel("color", 3, 4);
    uvs_ = finite_channel("uv", 2, 2);
    face_colours_ = usable_channel(mesh_, "color", Domain::Face, 3, 4);
    text_ = std::string(uvs_ ? "ST" : "") + (colours_ ? "C" : "") + (normals_ ? "N" : "") + "OFF\n";
    text_ += std::to_string(mesh_.vertex_count()) + " " + std::to_string(mesh_.face_count()) + " 0\n";
    for (std::size_t v = 0; v < mesh_.vertex_count(); ++v) write_vertex(v);
    for (std::size_t f = 0; f < mesh_.face_count(); ++f) write_face(f);
    if (mesh_.line_count() > 0) loss_.note("polylines");
    loss_.note_tags(mesh_.tags);
    loss_.note_others(mesh_, {normals_, colours_, uvs_, face_colours_});
    return {std::move(text_), loss_.warnings()};
  }

 private:
  // OFF can't express that one vertex has none.
  const AttributeChannel* finite_channel(const char* name, int width, int or_width) const {
    const AttributeChannel* channel = usable_channel(mesh_, name, Domain::Vertex, width, or_width);
    return channel != nullptr && all_finite(*channel) ? channel : nullptr;
  }

  void write_values(const AttributeChannel& channel, std::size_t element);
  void write_colour(const AttributeChannel& channel, std::size_t element);
  void write_vertex(std::size_t vertex);
  void write_face(std::size_t face);

  const PolyMesh& mesh_;
  int precision_;
  WriteTick tick_;
  FormatLoss loss_{"OFF"};
  const AttributeChannel* normals_ = nullptr;
  const AttributeChannel* colours_ = nullptr;
  const AttributeChannel* uvs_ = nullptr;
  const AttributeChannel* face_colours_ = nullptr;
  std::string text_;
};

void OffWriter::write_values(const AttributeChannel& channel, std::size_t element) {
  const auto width = static_cast<std::size_t>(channel.width);
  for (std::size_t k = 0; k < width; ++k) {
    append_number(text_ += ' ', value_of(channel, element * width + k), precision_);
  }
}

// A decimal point in a colour means a range from 0 to 1, not to 255.
void OffWriter::write_colour(const AttributeChannel& channel, std::size_t element) {
  const auto width = static_cast<std::size_t>(channel.width);
  for (std::size_t k = 0; k < width; ++k) {
    if (!std::isfinite(value_of(channel, element * width + k))) return;
  }
  for (std::size_t k = 0; k < width; ++k) {
    const double value = value_of(channel, element * width + k);
    const std::size_t begin = text_.size();
    append_number(text_ += ' ', value, is_floating(channel) ? precision_ : 0);
    if (is_floating(channel) && text_.find_first_of(".e", begin) == std::string::npos) text_ += ".0";
  }
}

void OffWriter::write_vertex(std::size_t vertex) {
  tick_();
  for (int k = 0; k < 3; ++k) {
    if (k > 0) text_ += ' ';
    append_number(text_, mesh_.positions[vertex][k], precision_);
  }
  if (normals_ != nullptr) write_values(*normals_, vertex);
  if (colours_ != nullptr) write_colour(*colours_, vertex);
  if (uvs_ != nullptr) write_values(*uvs_, vertex);
  text_ += '\n';
}

void OffWriter::write_face(std::size_t face) {
  tick_();
  append_number(text_, mesh_.face(face).size());
  for (const Index vertex : mesh_.face(face)) append_number(text_ += ' ', vertex);
  if (face_colours_ != nullptr) write_colour(*face_colours_, face);
  text_ += '\n';
}

}  // namespace

MeshWriteResult write_off(const PolyMesh& mesh, const MeshWriteOptions& options, Progress& progress) {
  return OffWriter(mesh, options, progress).write();
}

}  // namespace croquis
