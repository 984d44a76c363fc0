// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/mesh_editing/mesh_rebuild.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <type_traits>
#include <utility>
#include <variant>

namespace croquis {
namespace {

/// Of categories (integers that name something) there is nothing in between.
template <typename T>
T between(T a, T b, double t, bool blends) {
  if (!blends) return t < 0.5 ? a : b;
  const double value = static_cast<double>(a) + t * (static_cast<double>(b) - static_cast<double>(a));
  if constexpr (std::is_floating_point_v<T>) {
    return static_cast<T>(value);
  } else {
    return static_cast<T>(std::llround(value));
  }
}

template <typename T>
std::vector<T> blended(const std::vector<T>& old, std::size_t width, const std::vector<Blend>& sources, bool blends) {
  std::vector<T> values(sources.size() * width);
  for (std::size_t i = 0; i < sources.size(); ++i) {
    const Blend& source = sources[i];
    for (std::size_t k = 0; k < width; ++k) {
      const T a = old[source.a * width + k];
      values[i * width + k] = source.b == no_index ? a : between(a, old[source.b * width + k], source.t, blends);
    }
  }
  return values;
}

std::vector<Blend> whole(const std::vector<Index>& sources) {
  std::vector<Blend> blends(sources.size());
  for (std::size_t i = 0; i < sources.size(); ++i) blends[i].a = sources[i];
  return blends;
}

AttributeChannel carried_channel(const AttributeChannel& old, const std::vector<Blend>& sources) {
  AttributeChannel channel{old.name, old.domain, old.width, {}, old.labels};
  const bool is_colour = old.name == "color";
  channel.data = std::visit(
      [&](const auto& values) -> AttributeChannel::Data {
        using T = typename std::decay_t<decltype(values)>::value_type;
        const bool blends = std::is_floating_point_v<T> || (is_colour && old.labels.empty());
        return blended(values, static_cast<std::size_t>(old.width), sources, blends);
      },
      old.data);
  return channel;
}

/// Polylines of which all vertices are still there. @return the old numbers of those kept
std::vector<Index> carry_lines(const PolyMesh& old, const std::vector<Index>& new_vertex, PolyMesh& mesh) {
  std::vector<Index> kept;
  for (Index line = 0; line < old.line_count(); ++line) {
    const auto vertices = old.line(line);
    const bool whole_line =
        std::all_of(vertices.begin(), vertices.end(), [&](Index v) { return new_vertex[v] != no_index; });
    if (!whole_line) continue;
    for (const Index v : vertices) mesh.line_vertices.push_back(new_vertex[v]);
    mesh.line_offsets.push_back(static_cast<Index>(mesh.line_vertices.size()));
    kept.push_back(line);
  }
  return kept;
}

void carry_channels(const PolyMesh& old, const MeshPlan& plan, const std::vector<Index>& lines, MeshEdit& edit) {
  const std::vector<Blend> faces = whole(plan.face_source);
  const std::vector<Blend> kept_lines = whole(lines);
  for (const AttributeChannel& channel : old.channels) {
    const auto width = static_cast<std::size_t>(std::max(channel.width, 0));
    if (width == 0 || channel.size() != width * old.element_count(channel.domain)) {
      edit.lost.push_back(make_warning(Category::Geometry, "W_ATTRIBUTE_DROPPED",
                                       "The attribute \"" + channel.name +
                                           "\" has another number of values than the mesh has elements, so the edit "
                                           "left it out."));
      continue;
    }
    if (channel.domain == Domain::Edge) {  // renumbered when all is there
      edit.mesh.channels.push_back(channel);
      continue;
    }
    const std::vector<Blend>* sources = &plan.vertices;
    if (channel.domain == Domain::Face) sources = &faces;
    if (channel.domain == Domain::Corner) sources = &plan.corner_source;
    if (channel.domain == Domain::Line) sources = &kept_lines;
    edit.mesh.channels.push_back(carried_channel(channel, *sources));
  }
}

template <typename T>
void forget(std::vector<T>& values, std::size_t width, std::size_t element) {
  if constexpr (std::is_floating_point_v<T>) {
    std::fill_n(values.begin() + static_cast<std::ptrdiff_t>(element * width), width,
                std::numeric_limits<T>::quiet_NaN());
  }
}

/// A tag that found no place in the new mesh.
void report_dropped(const std::vector<VertexPair>& edges, const std::vector<Index>& pins, MeshEdit& edit) {
  if (edges.empty() && pins.empty()) return;
  std::string what = edges.empty() ? "" : "the tags of " + named_edges(edges);
  if (!pins.empty()) {
    what += what.empty() ? "" : " and ";
    what += std::to_string(pins.size()) + (pins.size() == 1 ? " pin" : " pins");
  }
  std::vector<Subject> subjects;
  for (const VertexPair& edge : edges) subjects.push_back(edge_subject(edge[0], edge[1]));
  for (const Index pin : pins) subjects.push_back(numbered_subject(SubjectKind::Vertex, pin));
  constexpr std::size_t most_subjects = 100;
  if (subjects.size() > most_subjects) subjects.resize(most_subjects);
  edit.lost.push_back(make_warning(Category::Geometry, "W_TAGS_DROPPED",
                                   "The edit removed what they belonged to, so " + what + " went, too.",
                                   std::move(subjects)));
}

void carry_sets(const MeshTags& old, const TagMap& map, MeshTags& tags) {
  for (const CreaseSet& set : old.sets) {
    CreaseSet carried_set{set.name, set.sharpness, {}, {}};
    for (const VertexPair& edge : set.edges) {
      for (const VertexPair& now : map.edge(edge)) carried_set.edges.push_back(ordered_pair(now[0], now[1]));
    }
    for (const Index vertex : set.pins) {
      for (const Index now : map.pin(vertex)) carried_set.pins.push_back(now);
    }
    std::sort(carried_set.edges.begin(), carried_set.edges.end());
    carried_set.edges.erase(std::unique(carried_set.edges.begin(), carried_set.edges.end()), carried_set.edges.end());
    carried_set.pins = sorted_unique(std::move(carried_set.pins));
    if (!carried_set.edges.empty() || !carried_set.pins.empty()) tags.sets.push_back(std::move(carried_set));
  }
}

}  // namespace

MeshPlan plan_with_vertices_of(const PolyMesh& mesh) {
  MeshPlan plan;
  plan.vertices = whole(all_elements(mesh.vertex_count()));
  plan.face_offsets.reserve(mesh.face_offsets.size() + 16);
  plan.corners.reserve(mesh.corners.size() + 64);
  plan.corner_source.reserve(mesh.corners.size() + 64);
  plan.face_source.reserve(mesh.face_count() + 16);
  return plan;
}

void keep_face(MeshPlan& plan, const PolyMesh& mesh, Index face) {
  for (Index corner = mesh.face_offsets[face]; corner < mesh.face_offsets[face + 1]; ++corner)
    plan.add_corner(mesh.corners[corner], {corner, no_index, 0});
  plan.end_face(face);
}

std::vector<Index> drop_unused_vertices(MeshPlan& plan, const MeshTopology& before, std::span<const Index> loose) {
  std::vector<char> used(plan.vertices.size(), 0);
  for (const Index vertex : plan.corners) used[vertex] = 1;
  std::vector<Index> number(plan.vertices.size(), no_index);
  std::vector<Blend> kept;
  for (std::size_t v = 0; v < used.size(); ++v) {
    const bool was_loose = v < before.vertex_count() && before.vertex_corners(static_cast<Index>(v)).empty();
    const bool stays = was_loose && !std::binary_search(loose.begin(), loose.end(), static_cast<Index>(v));
    if (used[v] == 0 && !stays) continue;
    number[v] = static_cast<Index>(kept.size());
    kept.push_back(plan.vertices[v]);
  }
  plan.vertices = std::move(kept);
  for (Index& vertex : plan.corners) vertex = number[vertex];
  return number;
}

MeshEdit rebuilt(const PolyMesh& old, const MeshPlan& plan, const std::vector<Index>& new_vertex) {
  MeshEdit edit;
  edit.mesh.positions.resize(plan.vertices.size());
  edit.vertex_source.resize(plan.vertices.size(), no_index);
  for (std::size_t v = 0; v < plan.vertices.size(); ++v) {
    const auto& [a, b, t] = plan.vertices[v];
    const Vec3& from = old.positions[a];
    edit.mesh.positions[v] = b == no_index ? from : Vec3(from + t * (old.positions[b] - from));
    if (b == no_index) edit.vertex_source[v] = a;
  }
  edit.mesh.face_offsets = plan.face_offsets;
  edit.mesh.corners = plan.corners;
  edit.face_source = plan.face_source;
  const std::vector<Index> lines = carry_lines(old, new_vertex, edit.mesh);
  if (lines.size() < old.line_count()) {
    edit.lost.push_back(make_warning(Category::Geometry, "W_LINES_DROPPED",
                                     std::to_string(old.line_count() - lines.size()) +
                                         " of the mesh's lines used vertices that are gone, so they went, too."));
  }
  carry_channels(old, plan, lines, edit);
  renumber_edge_channels(old, edit.vertex_source, edit.mesh);
  return edit;
}

VertexPair ordered_pair(Index a, Index b) { return a < b ? VertexPair{a, b} : VertexPair{b, a}; }

void carry_tags(const MeshTags& old, const TagMap& map, MeshEdit& edit) {
  if (old.empty()) return;
  MeshTags& tags = edit.mesh.tags;
  std::map<VertexPair, std::size_t> place;
  std::vector<VertexPair> dropped;
  for (const Crease& crease : old.creases) {
    const std::vector<VertexPair> pairs = map.edge(crease.vertices);
    if (pairs.empty()) dropped.push_back(crease.vertices);
    for (const VertexPair& pair : pairs) {
      const auto [known, added] = place.try_emplace(ordered_pair(pair[0], pair[1]), tags.creases.size());
      if (added) {
        tags.creases.push_back({pair, crease.sharpness});
      } else {
        Crease& before = tags.creases[known->second];
        before.sharpness = std::max(before.sharpness, crease.sharpness);
      }
    }
  }
  std::vector<Index> dropped_pins;
  for (const Index pin : old.pins) {
    const std::vector<Index> vertices = map.pin(pin);
    if (vertices.empty()) dropped_pins.push_back(pin);
    tags.pins.insert(tags.pins.end(), vertices.begin(), vertices.end());
  }
  carry_sets(old, map, tags);
  report_dropped(dropped, dropped_pins, edit);
}

std::string named_edges(const std::vector<VertexPair>& edges) {
  constexpr std::size_t most_named = 3;
  std::string text = std::to_string(edges.size()) + (edges.size() == 1 ? " edge" : " edges");
  for (std::size_t i = 0; i < std::min(edges.size(), most_named); ++i)
    text += (i == 0 ? " (" : ", (") + std::to_string(edges[i][0]) + ", " + std::to_string(edges[i][1]) + ")";
  return edges.size() > most_named ? text + " …" : text;
}

void forget_normals(PolyMesh& mesh, const std::vector<char>& moved) {
  const bool any = std::any_of(mesh.channels.begin(), mesh.channels.end(),
                               [](const AttributeChannel& channel) { return channel.name == "normal"; });
  if (!any) return;
  std::vector<char> faces(mesh.face_count(), 0);
  std::vector<char> vertices = moved;
  for (std::size_t f = 0; f < faces.size(); ++f) {
    const auto corners = mesh.face(f);
    if (std::none_of(corners.begin(), corners.end(), [&](Index v) { return moved[v] != 0; })) continue;
    faces[f] = 1;
    for (const Index v : corners) vertices[v] = 1;
  }
  for (AttributeChannel& channel : mesh.channels) {
    const auto width = static_cast<std::size_t>(std::max(channel.width, 0));
    if (channel.name != "normal" || channel.size() != width * mesh.element_count(channel.domain)) continue;
    std::visit(
        [&](auto& values) {
          for (std::size_t v = 0; channel.domain == Domain::Vertex && v < vertices.size(); ++v)
            if (vertices[v] != 0) forget(values, width, v);
          for (std::size_t f = 0; f < faces.size(); ++f) {
            if (faces[f] == 0) continue;
            if (channel.domain == Domain::Face) forget(values, width, f);
            for (std::size_t c = mesh.face_offsets[f]; channel.domain == Domain::Corner && c < mesh.face_offsets[f + 1];
                 ++c)
              forget(values, width, c);
          }
        },
        channel.data);
  }
}

}  // namespace croquis
