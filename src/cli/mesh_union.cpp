// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/mesh_union.h"

#include <algorithm>
#include <array>
#include <limits>
#include <set>
#include <utility>

#include "croquis/base/error.h"

namespace croquis::cli {
namespace {

constexpr const char* object_channel = "object";

/// Channels can be joined when every part has one of that name, width and type without labels of its own.
bool everywhere(const std::vector<NamedMesh>& parts, const AttributeChannel& channel) {
  return std::all_of(parts.begin(), parts.end(), [&](const NamedMesh& part) {
    const AttributeChannel* other = part.mesh->channel(channel.name, channel.domain);
    return other != nullptr && other->width == channel.width && other->data.index() == channel.data.index() &&
           other->labels.empty();
  });
}

void append_values(AttributeChannel& all, const AttributeChannel& more) {
  const auto append = [&](auto& values) {
    const auto& others = std::get<std::decay_t<decltype(values)>>(more.data);
    values.insert(values.end(), others.begin(), others.end());
  };
  std::visit(append, all.data);
}

void append_lists(std::vector<Index>& offsets, std::vector<Index>& vertices, const std::vector<Index>& more_offsets,
                  const std::vector<Index>& more_vertices, Index first_vertex) {
  const Index first = offsets.back();
  for (std::size_t i = 1; i < more_offsets.size(); ++i) offsets.push_back(first + more_offsets[i]);
  for (const Index vertex : more_vertices) vertices.push_back(first_vertex + vertex);
}

/// Tags of vertices that the part doesn't have would mean those of the next one, so they go.
class TagAppender {
 public:
  TagAppender(const NamedMesh& part, Index first_vertex) : part_(part), first_(first_vertex) {}

  void append_to(MeshTags& all) const {
    const MeshTags& tags = part_.mesh->tags;
    for (const Crease& crease : tags.creases) {
      if (is_there(crease.vertices)) all.creases.push_back({shifted(crease.vertices), crease.sharpness});
    }
    append_pins(tags.pins, all.pins);
    for (const CreaseSet& set : tags.sets) {
      CreaseSet copy{part_.name + ": " + set.name, set.sharpness, {}, {}};
      for (const auto& edge : set.edges) {
        if (is_there(edge)) copy.edges.push_back(shifted(edge));
      }
      append_pins(set.pins, copy.pins);
      all.sets.push_back(std::move(copy));
    }
  }

 private:
  bool is_there(Index vertex) const { return vertex < part_.mesh->vertex_count(); }
  bool is_there(const std::array<Index, 2>& edge) const { return is_there(edge[0]) && is_there(edge[1]); }
  std::array<Index, 2> shifted(const std::array<Index, 2>& edge) const { return {first_ + edge[0], first_ + edge[1]}; }

  void append_pins(const std::vector<Index>& pins, std::vector<Index>& all) const {
    for (const Index pin : pins) {
      if (is_there(pin)) all.push_back(first_ + pin);
    }
  }

  const NamedMesh& part_;
  Index first_;
};

void append_part(PolyMesh& all, const NamedMesh& named) {
  const PolyMesh& part = *named.mesh;
  const auto first_vertex = static_cast<Index>(all.positions.size());
  TagAppender(named, first_vertex).append_to(all.tags);
  all.positions.insert(all.positions.end(), part.positions.begin(), part.positions.end());
  append_lists(all.face_offsets, all.corners, part.face_offsets, part.corners, first_vertex);
  append_lists(all.line_offsets, all.line_vertices, part.line_offsets, part.line_vertices, first_vertex);
  for (AttributeChannel& channel : all.channels) append_values(channel, *part.channel(channel.name, channel.domain));
}

AttributeChannel objects(const std::vector<NamedMesh>& parts, Domain domain) {
  AttributeChannel channel{object_channel, domain, 1, std::vector<std::int32_t>(), {}};
  auto& values = std::get<std::vector<std::int32_t>>(channel.data);
  for (const NamedMesh& part : parts) {
    values.insert(values.end(), part.mesh->element_count(domain), static_cast<std::int32_t>(channel.labels.size()));
    channel.labels.push_back(part.name);
  }
  return channel;
}

/// Empty channels to be filled, and the names of those that can't be.
std::set<std::string> prepare_channels(const std::vector<NamedMesh>& parts, PolyMesh& all) {
  std::set<std::string> dropped;
  for (const NamedMesh& part : parts) {
    for (const AttributeChannel& channel : part.mesh->channels) {
      if (channel.name == object_channel) continue;
      if (!everywhere(parts, channel)) {
        dropped.insert(channel.name);
      } else if (all.channel(channel.name, channel.domain) == nullptr) {
        AttributeChannel empty = channel;
        std::visit([](auto& values) { values.clear(); }, empty.data);
        all.channels.push_back(std::move(empty));
      }
    }
  }
  return dropped;
}

void require_room(const std::vector<NamedMesh>& parts) {
  std::size_t vertices = 0, corners = 0, line_vertices = 0;
  for (const NamedMesh& part : parts) {
    vertices += part.mesh->vertex_count();
    corners += part.mesh->corners.size();
    line_vertices += part.mesh->line_vertices.size();
  }
  if (std::max({vertices, corners, line_vertices}) < std::numeric_limits<Index>::max()) return;
  throw Error(make_error(Category::Limit, "E_LIMIT",
                         "The project's meshes have too many vertices for one file; hide some of them."));
}

}  // namespace

MeshUnion unite(const std::vector<NamedMesh>& parts) {
  if (parts.size() == 1) return {*parts.front().mesh, {}};
  require_room(parts);
  MeshUnion result;
  const std::set<std::string> dropped = prepare_channels(parts, result.mesh);
  for (const NamedMesh& part : parts) append_part(result.mesh, part);
  for (const Domain domain : {Domain::Face, Domain::Line}) result.mesh.channels.push_back(objects(parts, domain));
  if (dropped.empty()) return result;
  std::string names;
  for (const std::string& name : dropped) names += (names.empty() ? "'" : ", '") + name + "'";
  result.warnings.push_back(make_warning(Category::Geometry, "W_CHANNELS",
                                         "Attributes that not all meshes of the project have alike were left out: " +
                                             names + "; show one mesh at a time to keep them."));
  return result;
}

}  // namespace croquis::cli
