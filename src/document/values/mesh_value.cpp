// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include "croquis/geometry/poly_mesh.h"
#include "document/values/member_bytes.h"

namespace croquis {

inline auto members(const AttributeChannel& channel) {
  return std::tie(channel.name, channel.domain, channel.width, channel.data, channel.labels);
}
static_assert(lists_every_member<AttributeChannel>);

inline auto members(const Crease& crease) { return std::tie(crease.vertices, crease.sharpness); }
static_assert(lists_every_member<Crease>);

inline auto members(const CreaseSet& set) { return std::tie(set.name, set.sharpness, set.edges, set.pins); }
static_assert(lists_every_member<CreaseSet>);

inline auto members(const MeshTags& tags) { return std::tie(tags.creases, tags.pins, tags.sets); }
static_assert(lists_every_member<MeshTags>);

constexpr Domain last_of(Domain) { return Domain::Edge; }

namespace {

constexpr std::uint32_t first_mesh_layout = 1;
constexpr std::uint32_t tagged_mesh_layout = 2;  // of meshes with tags, which the first one has no place for

auto elements_of(const PolyMesh& mesh) {
  return std::tie(mesh.face_offsets, mesh.corners, mesh.line_offsets, mesh.line_vertices, mesh.channels);
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

/// Polygons, polylines, attributes and, where there are any, tags.
struct MeshValue {
  using Content = PolyMesh;
  static constexpr const char* name = "mesh";
  static constexpr std::uint64_t tag = 0;

  static void add_content(const PolyMesh& mesh, ContentHasher& hasher) {
    static_assert(sizeof(Vec3) == 3 * sizeof(double));
    hasher.add(std::as_bytes(std::span(mesh.positions)));
    hash_member(elements_of(mesh), hasher);
    if (!mesh.tags.empty()) hash_member(mesh.tags, hasher);  // last, so that nothing can be mistaken for them
  }

  static std::size_t byte_size(const PolyMesh& mesh) {
    return sizeof(PolyMesh) + size_of(mesh.positions) + held_bytes(elements_of(mesh)) + held_bytes(mesh.tags);
  }

  static void store(const PolyMesh& mesh, ByteWriter& writer) {
    writer.number(mesh.tags.empty() ? first_mesh_layout : tagged_mesh_layout);
    store_member(mesh.positions, writer);
    store_member(elements_of(mesh), writer);
    if (!mesh.tags.empty()) store_member(mesh.tags, writer);
  }

  static PolyMesh load(ByteReader& reader) {
    const std::uint32_t layout = read_layout(reader, tagged_mesh_layout);
    PolyMesh mesh;
    mesh.positions = load_member<std::vector<Vec3>, true>(reader);  // what isn't finite is a finding of the mesh
    for (auto* indices : {&mesh.face_offsets, &mesh.corners, &mesh.line_offsets, &mesh.line_vertices})
      *indices = reader.numbers<Index>();
    require_lists(mesh.face_offsets, mesh.corners, mesh.vertex_count());
    require_lists(mesh.line_offsets, mesh.line_vertices, mesh.vertex_count());
    mesh.channels = load_member<std::vector<AttributeChannel>>(reader);
    for (const AttributeChannel& channel : mesh.channels) require_channel(channel, mesh.element_count(channel.domain));
    if (layout == tagged_mesh_layout) mesh.tags = load_member<MeshTags>(reader);
    return mesh;
  }
};

}  // namespace

constinit const ValueTraits ValueTraits::Mesh = value_row<MeshValue>();

}  // namespace croquis
