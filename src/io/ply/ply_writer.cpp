// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <set>

#include "io/channel_values.h"
#include "io/mesh_formats.h"
#include "io/mesh_writing.h"
#include "io/ply/ply_tables.h"

namespace croquis {
namespace {

constexpr std::size_t longest_byte_list = 255;

const char* type_name(const AttributeChannel& channel) {
  static constexpr std::array names = {"char", "uchar", "short", "ushort", "int", "uint", "float", "double"};
  return names[channel.data.index()];
}

// The property names of a channel's parts.
std::vector<std::string> part_names(const AttributeChannel& channel) {
  for (const PlyPartNames& row : ply_part_names) {
    if (row.channel != channel.name || row.width != channel.width) continue;
    return {row.parts.begin(), row.parts.begin() + row.width};
  }
  std::string name = channel.name.empty() ? "attribute" : channel.name;
  std::replace_if(
      name.begin(), name.end(), [](char c) { return static_cast<unsigned char>(c) <= 0x20; }, '_');
  if (channel.width == 1) return {name};
  std::vector<std::string> names;
  for (int k = 0; k < channel.width; ++k) names.push_back(name + "_" + std::to_string(k));
  return names;
}

// A channel on corners is one list for each face.
std::string list_name(const AttributeChannel& channel) {
  if (channel.name == "uv" && channel.width == 2) return "texcoord";
  AttributeChannel single = {channel.name, Domain::Corner, 1, {}, {}};
  return part_names(single).front();
}

class PlyWriter {
 public:
  PlyWriter(const PolyMesh& mesh, const MeshWriteOptions& options, Progress& progress)
      : mesh_(mesh), options_(options), tick_(progress), sink_(options.ascii, options.precision) {}

  MeshWriteResult write() {
    prepare();
    write_header();
    if (!options_.ascii) sink_.text().reserve(sink_.text().size() + byte_count());
    write_vertices();
    write_faces();
    write_edges();
    loss_.note_tags(mesh_.tags);
    loss_.note_others(mesh_, written_);
    return {std::move(sink_.text()), loss_.warnings()};
  }

 private:
  using Channels = std::vector<const AttributeChannel*>;

  void prepare() {
    std::set<std::string> of_vertices = {"x", "y", "z"}, of_faces = {"vertex_indices", "vertex_index"};
    std::set<std::string> of_edges = {"vertex1", "vertex2"};
    vertex_channels_ = choose(Domain::Vertex, of_vertices);
    corner_channels_ = choose(Domain::Corner, of_faces);
    face_channels_ = choose(Domain::Face, of_faces);
    line_channels_ = choose(Domain::Line, of_edges);
    floats_ = positions_are_floats(mesh_);
    std::size_t longest = 0;
    int widest = 1;
    for (std::size_t f = 0; f < mesh_.face_count(); ++f) longest = std::max(longest, mesh_.face(f).size());
    for (const AttributeChannel* channel : corner_channels_) widest = std::max(widest, channel->width);
    short_lists_ = longest * static_cast<std::size_t>(widest) <= longest_byte_list;
    for (std::size_t l = 0; l < mesh_.line_count(); ++l) {
      if (mesh_.line(l).size() <= 2) continue;
      loss_.note("polylines (they are cut into edges)");
      break;
    }
  }

  // Channels that fit and whose property names are free; the names of labels have no place in PLY.
  Channels choose(Domain domain, std::set<std::string>& taken) {
    Channels channels;
    for (const AttributeChannel& channel : mesh_.channels) {
      if (channel.domain != domain || !fits(channel, mesh_)) continue;
      std::vector<std::string> names = part_names(channel);
      if (domain == Domain::Corner) names = {list_name(channel)};
      const bool free =
          std::none_of(names.begin(), names.end(), [&](const auto& name) { return taken.contains(name); });
      if (!free) continue;
      taken.insert(names.begin(), names.end());
      channels.push_back(&channel);
      written_.push_back(&channel);
      if (!channel.labels.empty()) loss_.note("the names of " + in_quotes(channel.name) + " (their numbers are kept)");
    }
    return channels;
  }

  void write_header() {
    std::string& text = sink_.text();
    text = options_.ascii ? "ply\nformat ascii 1.0\n" : "ply\nformat binary_little_endian 1.0\n";
    text += "element vertex " + std::to_string(mesh_.vertex_count()) + "\n";
    for (const char* axis : {"x", "y", "z"}) {
      text.append("property ").append(floats_ ? "float " : "double ").append(axis).append("\n");
    }
    write_properties(vertex_channels_);
    text += "element face " + std::to_string(mesh_.face_count()) + "\n";
    text += std::string("property list ") + length_type() + " int vertex_indices\n";
    write_properties(face_channels_);
    write_corner_lists();
    if (mesh_.line_count() > 0) {
      const std::size_t edges = mesh_.line_vertices.size() - mesh_.line_count();
      text += "element edge " + std::to_string(edges) + "\nproperty int vertex1\nproperty int vertex2\n";
      write_properties(line_channels_);
    }
    text += "end_header\n";
  }

  void write_properties(const Channels& channels) {
    for (const AttributeChannel* channel : channels) {
      for (const std::string& name : part_names(*channel)) {
        sink_.text().append("property ").append(type_name(*channel)).append(" ").append(name).append("\n");
      }
    }
  }

  void write_corner_lists() {
    for (const AttributeChannel* channel : corner_channels_) {
      sink_.text() += std::string("property list ") + length_type() + " " + type_name(*channel) + " ";
      sink_.text() += list_name(*channel) + "\n";
    }
  }

  void write_vertices() {
    for (std::size_t v = 0; v < mesh_.vertex_count(); ++v) {
      tick_();
      for (int k = 0; k < 3; ++k) {
        const double coordinate = mesh_.positions[v][k];
        floats_ ? sink_.put(static_cast<float>(coordinate)) : sink_.put(coordinate);
      }
      put_values(vertex_channels_, v);
      sink_.end_row();
    }
  }

  void write_faces() {
    for (std::size_t f = 0; f < mesh_.face_count(); ++f) {
      tick_();
      put_length(mesh_.face(f).size());
      for (const Index vertex : mesh_.face(f)) sink_.put(static_cast<std::int32_t>(vertex));
      put_values(face_channels_, f);
      for (const AttributeChannel* channel : corner_channels_) put_corner_list(*channel, f);
      sink_.end_row();
    }
  }

  void write_edges() {
    for (std::size_t l = 0; l < mesh_.line_count(); ++l) {
      const auto line = mesh_.line(l);
      for (std::size_t i = 0; i + 1 < line.size(); ++i) {
        tick_();
        sink_.put(static_cast<std::int32_t>(line[i]));
        sink_.put(static_cast<std::int32_t>(line[i + 1]));
        put_values(line_channels_, l);
        sink_.end_row();
      }
    }
  }

  /// Of a binary file's vertices and faces.
  std::size_t byte_count() const {
    const std::size_t length = short_lists_ ? 1 : sizeof(std::uint32_t);
    std::size_t bytes = mesh_.vertex_count() * 3 * (floats_ ? sizeof(float) : sizeof(double)) +
                        mesh_.face_count() * length * (1 + corner_channels_.size()) +
                        mesh_.corners.size() * sizeof(std::int32_t);
    for (const AttributeChannel* channel : written_)
      bytes += channel->size() * std::visit([](const auto& values) { return sizeof values[0]; }, channel->data);
    return bytes;
  }

  void put_values(const Channels& channels, std::size_t element) {
    for (const AttributeChannel* channel : channels) {
      const auto width = static_cast<std::size_t>(channel->width);
      std::visit(
          [&](const auto& values) {
            for (std::size_t k = 0; k < width; ++k) sink_.put(values[element * width + k]);
          },
          channel->data);
    }
  }

  void put_corner_list(const AttributeChannel& channel, std::size_t face) {
    const auto width = static_cast<std::size_t>(channel.width);
    const std::size_t begin = mesh_.face_offsets[face] * width;
    const std::size_t end = mesh_.face_offsets[face + 1] * width;
    put_length(end - begin);
    std::visit(
        [&](const auto& values) {
          for (std::size_t i = begin; i < end; ++i) sink_.put(values[i]);
        },
        channel.data);
  }

  void put_length(std::size_t length) {
    short_lists_ ? sink_.put(static_cast<std::uint8_t>(length)) : sink_.put(static_cast<std::uint32_t>(length));
  }
  const char* length_type() const { return short_lists_ ? "uchar" : "uint"; }

  const PolyMesh& mesh_;
  const MeshWriteOptions& options_;
  WriteTick tick_;
  ValueSink sink_;
  FormatLoss loss_{"PLY"};
  Channels written_, vertex_channels_, face_channels_, corner_channels_, line_channels_;
  bool floats_ = false;
  bool short_lists_ = true;
};

}  // namespace

MeshWriteResult write_ply(const PolyMesh& mesh, const MeshWriteOptions& options, Progress& progress) {
  return PlyWriter(mesh, options, progress).write();
}

}  // namespace croquis
