// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <span>

#include "document/content_size.h"
#include "document/values/value_row.h"

namespace croquis {
namespace {

// ---- Bytes

constexpr std::uint32_t first_mesh_layout = 1;
constexpr std::uint32_t tagged_mesh_layout = 2;  // of meshes with tags, which the first one has no place for

// The fewest bytes that an element takes: counts are checked with it.
constexpr std::size_t least_channel_bytes = 3 * sizeof(std::uint64_t) + sizeof(std::int32_t) + 2;
constexpr std::size_t edge_bytes = 2 * sizeof(Index);
constexpr std::size_t crease_bytes = edge_bytes + sizeof(double);
constexpr std::size_t least_set_bytes = 3 * sizeof(std::uint64_t) + sizeof(double);

/// Calls `use` with an empty vector of the type with that number in AttributeChannel::Data.
template <std::size_t I = 0, typename Use>
void with_type(std::size_t type, const Use& use) {
  if constexpr (I < std::variant_size_v<AttributeChannel::Data>) {
    if (type == I) {
      use(std::variant_alternative_t<I, AttributeChannel::Data>{});
    } else {
      with_type<I + 1>(type, use);
    }
  } else {
    throw BadBytes("a channel's type is not known");
  }
}

void write_positions(const std::vector<Vec3>& positions, ByteWriter& writer) {
  writer.count(positions.size());
  for (const Vec3& position : positions) {
    for (int axis = 0; axis < 3; ++axis) writer.number(position[axis]);
  }
}

std::vector<Vec3> read_positions(ByteReader& reader) {
  std::vector<Vec3> positions(reader.count(3 * sizeof(double)));
  for (Vec3& position : positions) {
    for (int axis = 0; axis < 3; ++axis) position[axis] = reader.number<double>();
  }
  return positions;
}

void write_channel(const AttributeChannel& channel, ByteWriter& writer) {
  writer.text(channel.name);
  writer.number(static_cast<std::uint8_t>(channel.domain));
  writer.number(static_cast<std::int32_t>(channel.width));
  writer.number(static_cast<std::uint8_t>(channel.data.index()));
  std::visit([&](const auto& values) { writer.numbers(values); }, channel.data);
  writer.count(channel.labels.size());
  for (const std::string& label : channel.labels) writer.text(label);
}

AttributeChannel read_channel(ByteReader& reader) {
  AttributeChannel channel;
  channel.name = reader.text();
  const auto domain = reader.number<std::uint8_t>();
  if (domain > static_cast<std::uint8_t>(Domain::Edge)) throw BadBytes("a channel's domain is not known");
  channel.domain = static_cast<Domain>(domain);
  channel.width = reader.number<std::int32_t>();
  with_type(reader.number<std::uint8_t>(),
            [&]<typename T>(const std::vector<T>&) { channel.data = reader.numbers<T>(); });
  channel.labels.resize(reader.count(sizeof(std::uint64_t)));
  for (std::string& label : channel.labels) label = reader.text();
  return channel;
}

void write_edge(const std::array<Index, 2>& edge, ByteWriter& writer) {
  for (const Index vertex : edge) writer.number(vertex);
}

std::array<Index, 2> read_edge(ByteReader& reader) {
  const auto a = reader.number<Index>();
  return {a, reader.number<Index>()};
}

void write_set(const CreaseSet& set, ByteWriter& writer) {
  writer.text(set.name);
  writer.number(set.sharpness);
  writer.count(set.edges.size());
  for (const auto& edge : set.edges) write_edge(edge, writer);
  writer.numbers(set.pins);
}

CreaseSet read_set(ByteReader& reader) {
  CreaseSet set;
  set.name = reader.text();
  set.sharpness = reader.number<double>();
  set.edges.resize(reader.count(edge_bytes));
  for (auto& edge : set.edges) edge = read_edge(reader);
  set.pins = reader.numbers<Index>();
  return set;
}

void require_lists(const std::vector<Index>& offsets, const std::vector<Index>& vertices, std::size_t vertex_count) {
  const bool cut = !offsets.empty() && offsets.front() == 0 && offsets.back() == vertices.size() &&
                   std::is_sorted(offsets.begin(), offsets.end());
  if (!cut) throw BadBytes("its faces or lines are not whole");
  const auto in_range = [&](Index vertex) { return vertex < vertex_count; };
  if (!std::all_of(vertices.begin(), vertices.end(), in_range)) throw BadBytes("a vertex index is out of range");
}

void require_channel(const AttributeChannel& channel, std::size_t elements) {
  const bool fits = channel.width > 0 && channel.size() % static_cast<std::size_t>(channel.width) == 0 &&
                    channel.size() / static_cast<std::size_t>(channel.width) == elements;
  if (!fits) throw BadBytes("a channel has not one value per element");
}

void write_elements(const PolyMesh& mesh, ByteWriter& writer) {
  write_positions(mesh.positions, writer);
  for (const auto* indices : {&mesh.face_offsets, &mesh.corners, &mesh.line_offsets, &mesh.line_vertices}) {
    writer.numbers(*indices);
  }
  writer.count(mesh.channels.size());
  for (const AttributeChannel& channel : mesh.channels) write_channel(channel, writer);
}

PolyMesh read_elements(ByteReader& reader) {
  PolyMesh mesh;
  mesh.positions = read_positions(reader);
  for (auto* indices : {&mesh.face_offsets, &mesh.corners, &mesh.line_offsets, &mesh.line_vertices}) {
    *indices = reader.numbers<Index>();
  }
  require_lists(mesh.face_offsets, mesh.corners, mesh.vertex_count());
  require_lists(mesh.line_offsets, mesh.line_vertices, mesh.vertex_count());
  for (std::size_t left = reader.count(least_channel_bytes); left > 0; --left) {
    mesh.channels.push_back(read_channel(reader));
    require_channel(mesh.channels.back(), mesh.element_count(mesh.channels.back().domain));
  }
  return mesh;
}

void write_tags(const MeshTags& tags, ByteWriter& writer) {
  writer.count(tags.creases.size());
  for (const Crease& crease : tags.creases) {
    write_edge(crease.vertices, writer);
    writer.number(crease.sharpness);
  }
  writer.numbers(tags.pins);
  writer.count(tags.sets.size());
  for (const CreaseSet& set : tags.sets) write_set(set, writer);
}

MeshTags read_tags(ByteReader& reader) {
  MeshTags tags;
  tags.creases.resize(reader.count(crease_bytes));
  for (Crease& crease : tags.creases) {
    crease.vertices = read_edge(reader);
    crease.sharpness = reader.number<double>();
  }
  tags.pins = reader.numbers<Index>();
  for (std::size_t left = reader.count(least_set_bytes); left > 0; --left) tags.sets.push_back(read_set(reader));
  return tags;
}

// ---- Hash

void hash_channel(const AttributeChannel& channel, ContentHasher& hasher) {
  hasher.add(channel.name);
  hasher.add(static_cast<int>(channel.domain));
  hasher.add(channel.width);
  hasher.add(channel.data.index());
  std::visit([&](const auto& values) { hasher.add(std::as_bytes(std::span(values))); }, channel.data);
  hasher.add(channel.labels.size());
  for (const std::string& label : channel.labels) hasher.add(label);
}

void hash_edge(const std::array<Index, 2>& edge, ContentHasher& hasher) {
  hasher.add(edge[0]);
  hasher.add(edge[1]);
}

void hash_set(const CreaseSet& set, ContentHasher& hasher) {
  hasher.add(set.name);
  hasher.add(set.sharpness);
  hasher.add(set.edges.size());
  for (const auto& edge : set.edges) hash_edge(edge, hasher);
  hasher.add(std::span<const Index>(set.pins));
}

void hash_tags(const MeshTags& tags, ContentHasher& hasher) {
  hasher.add(tags.creases.size());
  for (const Crease& crease : tags.creases) {
    hash_edge(crease.vertices, hasher);
    hasher.add(crease.sharpness);
  }
  hasher.add(std::span<const Index>(tags.pins));
  hasher.add(tags.sets.size());
  for (const CreaseSet& set : tags.sets) hash_set(set, hasher);
}

std::size_t tag_size(const MeshTags& tags) {
  std::size_t bytes = size_of(tags.creases) + size_of(tags.pins) + size_of(tags.sets);
  for (const CreaseSet& set : tags.sets) bytes += set.name.capacity() + size_of(set.edges) + size_of(set.pins);
  return bytes;
}

/// Polygons, polylines, attributes and tags.
struct MeshValue {
  using Content = PolyMesh;
  static constexpr const char* name = "mesh";
  static constexpr std::uint64_t tag = 0;

  static void add_content(const PolyMesh& mesh, ContentHasher& hasher) {
    static_assert(sizeof(Vec3) == 3 * sizeof(double));
    hasher.add(std::as_bytes(std::span(mesh.positions)));
    hasher.add(std::span<const Index>(mesh.face_offsets));
    hasher.add(std::span<const Index>(mesh.corners));
    hasher.add(std::span<const Index>(mesh.line_offsets));
    hasher.add(std::span<const Index>(mesh.line_vertices));
    hasher.add(mesh.channels.size());
    for (const AttributeChannel& channel : mesh.channels) hash_channel(channel, hasher);
    if (!mesh.tags.empty()) hash_tags(mesh.tags, hasher);  // last, so that nothing can be mistaken for them
  }

  static std::size_t byte_size(const PolyMesh& mesh) {
    std::size_t bytes = sizeof(PolyMesh) + size_of(mesh.positions) + size_of(mesh.face_offsets) +
                        size_of(mesh.corners) + size_of(mesh.line_offsets) + size_of(mesh.line_vertices) +
                        size_of(mesh.channels) + tag_size(mesh.tags);
    for (const AttributeChannel& channel : mesh.channels) {
      bytes += channel.name.capacity();
      bytes += std::visit([](const auto& values) { return size_of(values); }, channel.data);
      for (const std::string& label : channel.labels) bytes += size_of(label);
    }
    return bytes;
  }

  static void store(const PolyMesh& mesh, ByteWriter& writer) {
    writer.number(mesh.tags.empty() ? first_mesh_layout : tagged_mesh_layout);
    write_elements(mesh, writer);
    if (!mesh.tags.empty()) write_tags(mesh.tags, writer);
  }

  static PolyMesh load(ByteReader& reader) {
    const std::uint32_t layout = read_layout(reader, tagged_mesh_layout);
    PolyMesh mesh = read_elements(reader);
    if (layout == tagged_mesh_layout) mesh.tags = read_tags(reader);
    return mesh;
  }
};

}  // namespace

constinit const ValueTraits ValueTraits::Mesh = value_row<MeshValue>();

}  // namespace croquis
