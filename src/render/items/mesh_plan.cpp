// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/items/mesh_plan.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <numeric>
#include <string_view>
#include <utility>

#include "croquis/geometry/polygon_cut.h"
#include "croquis/geometry/smooth_surface.h"
#include "render/items/item_colors.h"
#include "render/items/to_glm.h"

namespace croquis::render {
namespace {

constexpr std::string_view normal_name = "normal";

bool shapes_the_look(const AttributeChannel& channel) {
  return channel.name == "color" || channel.name == "object" || channel.name == "group";
}

std::vector<AttributeChannel> channels_of_look(const PolyMesh& mesh) {
  std::vector<AttributeChannel> channels;
  std::copy_if(mesh.channels.begin(), mesh.channels.end(), std::back_inserter(channels), shapes_the_look);
  return channels;
}

/// Bit for bit: "none here" (NaN) is equal to itself.
bool same_data(const AttributeChannel& a, const AttributeChannel& b) {
  if (a.name != b.name || a.domain != b.domain || a.width != b.width || a.data.index() != b.data.index()) return false;
  return std::visit(
      [&](const auto& values) {
        const auto& others = std::get<std::decay_t<decltype(values)>>(b.data);
        const std::size_t bytes = values.size() * sizeof(values[0]);
        return values.size() == others.size() && (bytes == 0 || std::memcmp(values.data(), others.data(), bytes) == 0);
      },
      a.data);
}

bool same_look(std::span<const AttributeChannel> kept, const PolyMesh& mesh) {
  std::size_t seen = 0;
  for (const AttributeChannel& channel : mesh.channels) {
    if (!shapes_the_look(channel)) continue;
    if (seen == kept.size() || !same_data(kept[seen], channel)) return false;
    ++seen;
  }
  return seen == kept.size();
}

/// The channel that normals are read from, or null.
const AttributeChannel* normal_channel(const PolyMesh& mesh) {
  for (const Domain domain : {Domain::Corner, Domain::Vertex}) {
    const AttributeChannel* channel = mesh.channel(normal_name, domain);
    if (channel != nullptr && channel->width == 3) return channel;
  }
  return nullptr;
}

/// The unit normal that the channel has for an element, or 0.
glm::vec3 normal_at(const AttributeChannel& channel, std::size_t element) {
  return std::visit(
      [&](const auto& values) {
        if (3 * element + 3 > values.size()) return glm::vec3(0);
        const glm::dvec3 normal(values[3 * element], values[3 * element + 1], values[3 * element + 2]);
        const double length = glm::length(normal);
        return length > 0 && std::isfinite(length) ? glm::vec3(normal / length) : glm::vec3(0);
      },
      channel.data);
}

std::size_t element_of(const AttributeChannel& channel, Index corner, std::span<const Index> corners) {
  return channel.domain == Domain::Corner ? corner : corners[corner];
}

/// Of a thousand edges or fewer, spread evenly.
double mean_edge_length(const MeshItem& item) {
  const std::size_t count = item.edges.size() / 2;
  const std::size_t step = std::max<std::size_t>(1, count / 1000);
  double sum = 0;
  std::size_t seen = 0;
  for (std::size_t e = 0; e < count; e += step, ++seen) {
    sum += glm::distance(item.vertices[item.edges[2 * e]].position, item.vertices[item.edges[2 * e + 1]].position);
  }
  return seen == 0 ? 0 : sum / static_cast<double>(seen);
}

std::vector<std::array<Index, 2>> coincident_pairs(std::span<const Index> welded) {
  std::vector<std::array<Index, 2>> pairs;
  for (Index v = 0; v < welded.size(); ++v) {
    if (welded[v] != v) pairs.push_back({welded[v], v});
  }
  return pairs;
}

/// Makes as few vertices as possible: corners share one when group, paint and normal agree.
class VertexCollector {
 public:
  explicit VertexCollector(std::size_t group_count) : newest_(group_count, no_index) {}

  Index vertex(Index group, const SurfacePaint& paint, const glm::vec3& normal) {
    Index found = newest_[group];
    while (found != no_index && !(paints_[found] == paint && normals_[found] == normal)) found = older_[found];
    if (found != no_index) return found;
    found = static_cast<Index>(paints_.size());
    paints_.push_back(paint);
    normals_.push_back(normal);
    older_.push_back(std::exchange(newest_[group], found));
    return found;
  }
  std::size_t size() const { return paints_.size(); }
  std::vector<SurfacePaint> take_paints() { return std::move(paints_); }

 private:
  std::vector<SurfacePaint> paints_;
  std::vector<glm::vec3> normals_;
  std::vector<Index> newest_;  // vertex of each group
  std::vector<Index> older_;   // the one made before, per vertex
};

}  // namespace

MeshPlan::MeshPlan(const PolyMesh& mesh, std::span<const Vec3> positions, const MeshItemOptions& options)
    : options_(options),
      vertex_count_(mesh.vertex_count()),
      face_offsets_(mesh.face_offsets),
      corners_(mesh.corners),
      line_offsets_(mesh.line_offsets),
      line_vertices_(mesh.line_vertices),
      creases_(mesh.tags.creases),
      channels_(channels_of_look(mesh)),
      line_colors_(line_colors(mesh, options.line_color)) {
  const std::vector<Index> welded = joined_places(positions);
  coincident_ = coincident_pairs(welded);
  const std::vector<Index> parts = face_parts(mesh, welded);
  SmoothSurface surface = find_smooth_surface(
      mesh, positions, welded, parts, {options.crease_angle, tagged_edges(mesh.tags, welded, options.split_sharpness)});
  patch_count_ = surface.patch_count;
  corner_groups_ = std::move(surface.corner_groups);
  group_count_ = surface.group_count;
  if (options.shading == FaceShading::Flat) {
    std::iota(corner_groups_.begin(), corner_groups_.end(), Index{0});
    group_count_ = static_cast<Index>(corner_groups_.size());
  }
  collect_vertices(mesh, corner_colors(mesh, parts), surface.face_patches);
  std::vector<std::uint32_t> edges;
  edges.reserve(2 * surface.edges.size());
  for (const auto& [a, b] : surface.edges) {
    edges.push_back(corner_vertices_[a]);
    edges.push_back(corner_vertices_[b]);
  }
  edges_ = std::move(edges);
  face_triangles_.reserve(face_offsets_.size());
  face_triangles_.push_back(0);
  for (std::size_t f = 0; f < face_count(); ++f) {
    const Index corners = face_offsets_[f + 1] - face_offsets_[f];
    face_triangles_.push_back(face_triangles_.back() + (corners < 3 ? 0 : 3 * (corners - 2)));
  }
  triangles_ = cut_triangles(mesh.positions);
  index_lines(mesh);
}

void MeshPlan::collect_vertices(const PolyMesh& mesh, std::span<const Color> colors, std::span<const Index> patches) {
  const AttributeChannel* normals = normals_of(mesh);
  VertexCollector collector(group_count_);
  corner_vertices_.resize(corners_.size());
  for (std::size_t f = 0; f < face_count(); ++f) {
    for (Index c = face_offsets_[f]; c < face_offsets_[f + 1]; ++c) {
      const glm::vec3 normal =
          normals != nullptr ? normal_at(*normals, element_of(*normals, c, corners_)) : glm::vec3(0);
      corner_vertices_[c] = collector.vertex(corner_groups_[c], {colors[c], patches[f]}, normal);
      if (corner_vertices_[c] == vertex_corners_.size()) vertex_corners_.push_back(c);
    }
  }
  paint_ = collector.take_paints();
}

std::vector<std::uint32_t> MeshPlan::cut_triangles(std::span<const Vec3> positions) const {
  std::vector<std::uint32_t> triangles;
  triangles.reserve(face_triangles_.back());
  for (std::size_t f = 0; f < face_count(); ++f) {
    const std::span corners = std::span(corners_).subspan(face_offsets_[f], face_offsets_[f + 1] - face_offsets_[f]);
    visit_triangles(positions, corners, [&](const std::array<Index, 3>& triangle) {
      for (const Index corner : triangle) triangles.push_back(corner_vertices_[face_offsets_[f] + corner]);
    });
  }
  return triangles;
}

void MeshPlan::index_lines(const PolyMesh& mesh) {
  std::vector<std::uint32_t> segments;
  for (std::size_t l = 0; l < mesh.line_count(); ++l) {
    for (Index i = mesh.line_offsets[l]; i + 1 < mesh.line_offsets[l + 1]; ++i) {
      segments.insert(segments.end(), {i, i + 1});
    }
  }
  segments_ = std::move(segments);
}

bool MeshPlan::fits(const PolyMesh& mesh) const {
  if (mesh.face_offsets != face_offsets_ || mesh.corners != corners_ || mesh.line_offsets != line_offsets_ ||
      mesh.line_vertices != line_vertices_ || mesh.tags.creases != creases_ || mesh.vertex_count() != vertex_count_ ||
      !same_look(channels_, mesh)) {
    return false;
  }
  return std::all_of(coincident_.begin(), coincident_.end(),
                     [&](const auto& pair) { return mesh.positions[pair[0]] == mesh.positions[pair[1]]; });
}

Bounds MeshPlan::bounds_of_drawn(std::span<const Vec3> positions) const {
  Bounds bounds;
  const auto add = [&](Index vertex) {
    bounds.add({positions[vertex].x(), positions[vertex].y(), positions[vertex].z()});
  };
  for (const Index corner : vertex_corners_) add(corners_[corner]);
  for (const Index vertex : line_vertices_) add(vertex);
  return bounds;
}

const AttributeChannel* MeshPlan::normals_of(const PolyMesh& mesh) const {
  return options_.use_normal_channel ? normal_channel(mesh) : nullptr;
}

void MeshPlan::fill(std::span<const Vec3> given, std::span<const Vec3> positions, const AttributeChannel* channel,
                    MeshItem& item) const {
  const std::vector<Vec3> normals = group_normals(faces(), positions, corner_groups_, group_count_);
  item.vertices.resize(vertex_corners_.size());
  for (std::size_t v = 0; v < item.vertices.size(); ++v) {
    const Index corner = vertex_corners_[v];
    item.vertices[v] = {glm::vec3(to_glm(positions[corners_[corner]])),
                        glm::vec3(to_glm(normals[corner_groups_[corner]]))};
  }
  if (channel != nullptr) take_normals(*channel, item.vertices);
  item.line_vertices.resize(line_vertices_.size());
  for (std::size_t i = 0; i < line_vertices_.size(); ++i) {
    item.line_vertices[i] = {glm::vec3(to_glm(positions[line_vertices_[i]])), line_colors_[i]};
  }
  item.paint = paint_;
  const bool all_triangles = triangles_.size() == corners_.size();
  const SharedArray<std::uint32_t> triangles = all_triangles ? triangles_ : cut_triangles(given);
  item.triangles = triangles == triangles_ ? triangles_ : triangles;
  item.edges = edges_;
  item.segments = segments_;
  item.patch_count = patch_count_;
  item.edge_length = item.scale * mean_edge_length(item);
  if (reduced_) item.reduced = reduced_->of(item);
}

void MeshPlan::reduce(const MeshItem& item) {
  if (item.triangles.size() / 3 <= most_full_triangles) return;
  std::vector<Index> first_at(vertex_count_);
  std::iota(first_at.begin(), first_at.end(), Index{0});
  for (const auto& [first, vertex] : coincident_) first_at[vertex] = first;
  std::vector<Index> item_vertex(vertex_count_, no_index);
  std::vector<Index> places(vertex_corners_.size());
  for (Index v = 0; v < places.size(); ++v) {
    Index& place = item_vertex[first_at[corners_[vertex_corners_[v]]]];
    if (place == no_index) place = v;
    places[v] = place;
  }
  reduced_.emplace(item, places);
}

void MeshPlan::take_normals(const AttributeChannel& channel, std::span<SurfaceVertex> vertices) const {
  for (std::size_t v = 0; v < vertices.size(); ++v) {
    const glm::vec3 normal = normal_at(channel, element_of(channel, vertex_corners_[v], corners_));
    if (normal != glm::vec3(0)) vertices[v].normal = normal;
  }
}

}  // namespace croquis::render
