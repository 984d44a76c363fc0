// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/items/mesh_plan.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <numeric>
#include <string_view>
#include <tuple>

#include "croquis/geometry/polygon_cut.h"
#include "croquis/geometry/smooth_surface.h"
#include "render/items/item_colors.h"
#include "render/items/item_frame.h"

namespace croquis::render {
namespace {

constexpr double wanted_triangles = 30'000;
constexpr double sure_triangles = 36'000;  // with more than these a coarser grid is tried
constexpr int most_tries = 4;
/// Across each other, and aslant to the axes: the normals of a flat side agree about them.
constexpr std::array<glm::vec3, 3> octant_axes = {
    {{0.7712F, 0.5453F, 0.3287F}, {-0.6017F, 0.7871F, 0.1359F}, {-0.2082F, -0.3026F, 0.9301F}}};

constexpr double cells_per_area = 2.2;  // that a surface meets, by direction too, per square of a cell's side

double area_of(const MeshItem& item) {
  double twice = 0;
  for (std::size_t i = 0; i + 2 < item.triangles.size(); i += 3) {
    const glm::dvec3 a(item.vertices[item.triangles[i]].position);
    const glm::dvec3 b(item.vertices[item.triangles[i + 1]].position);
    const glm::dvec3 c(item.vertices[item.triangles[i + 2]].position);
    twice += glm::length(glm::cross(b - a, c - a));
  }
  return twice / 2;
}

/// The mean normal at each place, to distinguish the sides of thin parts.
std::vector<glm::vec3> normals_of_places(const MeshItem& item, std::span<const Index> places) {
  std::vector<glm::vec3> normals(item.vertices.size(), glm::vec3(0));
  for (std::size_t v = 0; v < places.size(); ++v) normals[places[v]] += item.vertices[v].normal;
  return normals;
}

std::uint64_t cell_key(const glm::vec3& position, const glm::vec3& normal, double cell) {
  std::uint64_t key = 0;
  for (int axis = 0; axis < 3; ++axis) {
    const auto step = static_cast<std::uint64_t>(std::max(0.0, std::floor((position[axis] + 1.001) / cell)));
    key = key << 20 | std::min<std::uint64_t>(step, (1U << 20) - 1);
  }
  for (const glm::vec3& side : octant_axes) key = key << 1 | (glm::dot(normal, side) < 0 ? 1U : 0U);
  return key;
}

struct Clusters {
  std::vector<Index> of;  ///< #V
  std::size_t count = 0;
};

/// Numbered in the order of their cells.
Clusters clusters_in(const MeshItem& item, std::span<const Index> places, std::span<const glm::vec3> normals,
                     double cell) {
  std::vector<std::pair<std::uint64_t, Index>> keys;
  for (Index v = 0; v < places.size(); ++v) {
    if (places[v] == v) keys.emplace_back(cell_key(item.vertices[v].position, normals[v], cell), v);
  }
  std::sort(keys.begin(), keys.end());
  Clusters clusters;
  clusters.of.resize(places.size());
  for (std::size_t i = 0; i < keys.size(); ++i) {
    if (i > 0 && keys[i].first != keys[i - 1].first) ++clusters.count;
    clusters.of[keys[i].second] = static_cast<Index>(clusters.count);
  }
  if (!keys.empty()) ++clusters.count;
  for (std::size_t v = 0; v < places.size(); ++v) clusters.of[v] = clusters.of[places[v]];
  return clusters;
}

std::size_t count_left(const MeshItem& item, const Clusters& clusters) {
  std::size_t left = 0;
  for (std::size_t i = 0; i + 2 < item.triangles.size(); i += 3) {
    const Index a = clusters.of[item.triangles[i]];
    const Index b = clusters.of[item.triangles[i + 1]];
    const Index c = clusters.of[item.triangles[i + 2]];
    left += a != b && b != c && c != a ? 1 : 0;
  }
  return left;
}

Clusters fitting_clusters(const MeshItem& item, std::span<const Index> places) {
  const std::vector<glm::vec3> normals = normals_of_places(item, places);
  // A grid of 2^20 cells along an axis is the finest; two cells are enough for anything.
  double cell = std::clamp(std::sqrt(2 * cells_per_area * area_of(item) / wanted_triangles), 2.5e-6, 1.0);
  Clusters clusters = clusters_in(item, places, normals, cell);
  for (int round = 1; round < most_tries; ++round) {
    const auto left = static_cast<double>(count_left(item, clusters));
    if (left <= sure_triangles) break;
    cell = std::min(1.0, cell * std::sqrt(1.15 * left / wanted_triangles));
    clusters = clusters_in(item, places, normals, cell);
  }
  return clusters;
}

/// How many of the item's vertices are at each place: more than one on creases.
std::vector<std::uint8_t> counts_of_places(std::span<const Index> places) {
  std::vector<std::uint8_t> counts(places.size(), 0);
  for (const Index place : places) counts[place] = static_cast<std::uint8_t>(std::min(counts[place] + 1, 255));
  return counts;
}

/// Of each cluster the place that stands for it.
std::vector<Index> chosen_places(const MeshItem& item, std::span<const Index> places, std::span<const Index> clusters,
                                 std::size_t cluster_count) {
  const std::vector<std::uint8_t> counts = counts_of_places(places);
  std::vector<glm::vec4> sums(cluster_count, glm::vec4(0));
  for (Index v = 0; v < places.size(); ++v) {
    if (places[v] == v) sums[clusters[v]] += glm::vec4(item.vertices[v].position, 1);
  }
  std::vector<Index> chosen(cluster_count, no_index);
  std::vector<float> distances(cluster_count);
  for (Index v = 0; v < places.size(); ++v) {
    if (places[v] != v) continue;
    const Index cluster = clusters[v];
    const float away = glm::distance(item.vertices[v].position, glm::vec3(sums[cluster]) / sums[cluster].w);
    const Index best = chosen[cluster];
    if (best != no_index && (counts[best] > counts[v] || (counts[best] == counts[v] && distances[cluster] <= away)))
      continue;
    chosen[cluster] = v;
    distances[cluster] = away;
  }
  return chosen;
}

/// Each triple or pair of clusters once, in the order in which they come.
template <std::size_t count>
std::vector<std::uint32_t> without_repeats(std::span<const std::uint32_t> indices, std::span<const Index> clusters) {
  struct Entry {
    std::array<Index, count> key;
    std::uint32_t at;
  };
  std::vector<Entry> entries;
  entries.reserve(indices.size() / count);
  for (std::uint32_t i = 0; i + count <= indices.size(); i += count) {
    Entry entry{{}, i};
    for (std::size_t k = 0; k < count; ++k) entry.key[k] = clusters[indices[i + k]];
    std::sort(entry.key.begin(), entry.key.end());
    if (std::adjacent_find(entry.key.begin(), entry.key.end()) == entry.key.end()) entries.push_back(entry);
  }
  std::sort(entries.begin(), entries.end(),
            [](const Entry& a, const Entry& b) { return std::tie(a.key, a.at) < std::tie(b.key, b.at); });
  const auto last =
      std::unique(entries.begin(), entries.end(), [](const Entry& a, const Entry& b) { return a.key == b.key; });
  entries.erase(last, entries.end());
  std::sort(entries.begin(), entries.end(), [](const Entry& a, const Entry& b) { return a.at < b.at; });
  std::vector<std::uint32_t> left;
  left.reserve(count * entries.size());
  for (const Entry& entry : entries) {
    left.insert(left.end(), indices.begin() + entry.at, indices.begin() + entry.at + count);
  }
  return left;
}

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

ReducedSurface::ReducedSurface(const MeshItem& item, std::span<const Index> places) {
  const Clusters clusters = fitting_clusters(item, places);
  choose_vertices(item, clusters.of, clusters.count, places);
  const auto mapped = [&](const SharedArray<std::uint32_t>& indices) {
    std::vector<std::uint32_t> result;
    result.reserve(indices.size());
    for (const std::uint32_t vertex : indices) result.push_back(vertex_of_[vertex]);
    return result;
  };
  triangles_ = without_repeats<3>(mapped(item.triangles), cluster_of_);
  edges_ = without_repeats<2>(mapped(item.edges), cluster_of_);
}

void ReducedSurface::choose_vertices(const MeshItem& item, std::span<const Index> clusters, std::size_t cluster_count,
                                     std::span<const Index> places) {
  const std::vector<Index> chosen = chosen_places(item, places, clusters, cluster_count);
  // One vertex for every patch in a cluster, at the cluster's place, with the look of the patch's vertex next to it.
  struct Entry {
    Index cluster;
    std::uint32_t patch;
    float away;
    std::uint32_t vertex;
  };
  std::vector<Entry> entries;
  entries.reserve(item.vertices.size());
  for (std::uint32_t v = 0; v < item.vertices.size(); ++v) {
    const glm::vec3& place = item.vertices[chosen[clusters[v]]].position;
    entries.push_back({clusters[v], item.paint[v].patch, glm::distance(item.vertices[v].position, place), v});
  }
  std::sort(entries.begin(), entries.end(), [](const Entry& a, const Entry& b) {
    return std::tie(a.cluster, a.patch, a.away, a.vertex) < std::tie(b.cluster, b.patch, b.away, b.vertex);
  });
  vertex_of_.resize(item.vertices.size());
  std::vector<SurfacePaint> paint;
  for (std::size_t i = 0; i < entries.size(); ++i) {
    const Entry& entry = entries[i];
    const bool goes_on = i > 0 && entries[i - 1].cluster == entry.cluster && entries[i - 1].patch == entry.patch;
    if (!goes_on) {
      sources_.push_back({static_cast<std::uint32_t>(chosen[entry.cluster]), entry.vertex});
      cluster_of_.push_back(entry.cluster);
      paint.push_back(item.paint[entry.vertex]);
    }
    vertex_of_[entry.vertex] = static_cast<std::uint32_t>(sources_.size() - 1);
  }
  paint_ = std::move(paint);
}

std::shared_ptr<const MeshItem> ReducedSurface::of(const MeshItem& item) const {
  auto reduced = std::make_shared<MeshItem>();
  reduced->origin = item.origin;
  reduced->scale = item.scale;
  reduced->bounds = item.bounds;
  reduced->vertices.reserve(sources_.size());
  for (const Source& source : sources_) {
    reduced->vertices.push_back({item.vertices[source.place].position, item.vertices[source.look].normal});
  }
  reduced->paint = paint_;
  reduced->triangles = triangles_;
  reduced->edges = edges_;
  reduced->line_vertices = item.line_vertices;
  reduced->segments = item.segments;
  reduced->patch_count = item.patch_count;
  reduced->edge_length = item.edge_length;
  return reduced;
}

std::vector<std::uint32_t> ReducedSurface::reduced(std::span<const std::uint32_t> triangles) const {
  std::vector<std::uint32_t> mapped;
  mapped.reserve(triangles.size());
  for (const std::uint32_t vertex : triangles) mapped.push_back(vertex_of_[vertex]);
  return without_repeats<3>(mapped, cluster_of_);
}

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
