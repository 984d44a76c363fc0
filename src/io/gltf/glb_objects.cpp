// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <map>
#include <numeric>

#include "croquis/geometry/polygon_cut.h"
#include "croquis/geometry/smooth_surface.h"
#include "croquis/geometry/surface_normals.h"
#include "io/channel_values.h"
#include "io/gltf/glb_writing.h"

namespace croquis {
namespace {

using Numbers = std::array<float, glb_numbers>;

/// Unit normals of all corners: smooth where faces meet at less than the usual angle and no sharp tag lies between.
std::vector<Vec3> computed_normals(const PolyMesh& mesh, const std::vector<Vec3>& positions) {
  const std::vector<Index> welded = joined_places(positions);
  const std::vector<Index> one_part(mesh.face_count(), 0);
  const SmoothSurface surface = find_smooth_surface(
      mesh, positions, welded, one_part, {usual_crease_angle, tagged_edges(mesh.tags, welded, usual_split_sharpness)});
  const std::vector<Vec3> groups =
      group_normals({mesh.face_offsets, mesh.corners}, positions, surface.corner_groups, surface.group_count);
  std::vector<Vec3> normals;
  normals.reserve(mesh.corners.size());
  for (const Index group : surface.corner_groups) normals.push_back(groups[group]);
  return normals;
}

class ObjectMaker {
 public:
  ObjectMaker(const PolyMesh& mesh, const std::vector<Vec3>& positions, const Progress& progress)
      : mesh_(mesh),
        progress_(progress),
        cut_(mesh_triangles(positions, mesh)),
        newest_(mesh.vertex_count(), no_index) {
    normals_ = find("normal", {Domain::Corner, Domain::Vertex}, 3, 3);
    colours_ = find("color", {Domain::Vertex, Domain::Corner, Domain::Face}, 3, 4);
    places_ = find("uv", {Domain::Vertex, Domain::Corner}, 2, 2);
    result_.normals_computed = normals_ == nullptr && mesh.face_count() > 0;
    if (result_.normals_computed) computed_ = computed_normals(mesh, positions);
    result_.has_normals = normals_ != nullptr || result_.normals_computed;
    result_.colour_width = colours_ == nullptr ? 0 : colours_->width;
    result_.has_uv = places_ != nullptr;
  }

  GlbObjects run() {
    const auto faces = elements_by(names_of("object", Domain::Face), mesh_.face_count());
    const auto lines = elements_by(names_of("object", Domain::Line), mesh_.line_count());
    std::vector<std::string> names = faces.names;
    for (const std::string& name : lines.names) {
      if (std::ranges::find(names, name) == names.end()) names.push_back(name);
    }
    if (names.empty() && mesh_.vertex_count() > 0) names.emplace_back();
    triangles_of_face_.assign(mesh_.face_count() + 1, 0);
    for (const Index face : cut_.faces) ++triangles_of_face_[face + 1];
    std::partial_sum(triangles_of_face_.begin(), triangles_of_face_.end(), triangles_of_face_.begin());
    materials_ = names_of("material", Domain::Face);
    if (materials_ == nullptr) materials_ = names_of("group", Domain::Face);
    result_.has_groups = materials_ != nullptr && materials_->name == "group";
    for (const std::string& name : names) make_object(name, faces.of(name), lines.of(name), names.size() == 1);
    result_.keeps_order = result_.keeps_order && next_ == mesh_.vertex_count();
    return std::move(result_);
  }

 private:
  /// Elements by the names of a channel, all under no name without one.
  struct Elements {
    std::vector<std::string> names;
    std::map<std::string, std::vector<Index>> by_name;
    std::vector<Index> of(const std::string& name) const {
      const auto found = by_name.find(name);
      return found == by_name.end() ? std::vector<Index>() : found->second;
    }
  };

  static Elements elements_by(const AttributeChannel* channel, std::size_t count) {
    Elements result;
    for (Index e = 0; e < count; ++e) {
      const std::string name = channel == nullptr ? std::string() : label_of(*channel, e);
      std::vector<Index>& list = result.by_name[name];
      if (list.empty()) result.names.push_back(name);
      list.push_back(e);
    }
    return result;
  }

  const AttributeChannel* written(const AttributeChannel* channel) {
    if (channel != nullptr) result_.written.push_back(channel);
    return channel;
  }

  const AttributeChannel* names_of(const char* name, Domain domain) {
    return written(usable_channel(mesh_, name, domain, 1, 1));
  }

  const AttributeChannel* find(const char* name, std::initializer_list<Domain> domains, int width, int or_width) {
    for (const Domain domain : domains) {
      const AttributeChannel* channel = usable_channel(mesh_, name, domain, width, or_width);
      if (channel != nullptr && all_finite(*channel)) return written(channel);
    }
    return nullptr;
  }

  /// @param corner no_index for a vertex of lines or of nothing
  Numbers numbers_of(Index vertex, Index corner, Index face) const {
    Numbers numbers{0, 0, 1, 1, 1, 1, 1, 0, 0};
    const auto take = [&](const AttributeChannel* channel, std::size_t first) {
      if (channel == nullptr || (channel->domain != Domain::Vertex && corner == no_index)) return;
      const Index element = channel->domain == Domain::Vertex ? vertex
                            : channel->domain == Domain::Face ? face
                                                              : corner;
      const auto width = static_cast<std::size_t>(channel->width);
      for (std::size_t i = 0; i < width; ++i) {
        const double value =
            first == glb_colour ? colour_of(*channel, element * width + i) : value_of(*channel, element * width + i);
        numbers[first + i] = static_cast<float>(first == glb_uv && i == 1 ? 1 - value : value);  // glTF's v points down
      }
    };
    take(normals_, glb_normal);
    take(colours_, glb_colour);
    take(places_, glb_uv);
    if (result_.normals_computed && corner != no_index && !computed_[corner].isZero()) {
      for (int i = 0; i < 3; ++i)
        numbers[glb_normal + static_cast<std::size_t>(i)] = static_cast<float>(computed_[corner][i]);
    }
    return numbers;
  }

  std::uint32_t vertex_of(GlbObject& object, Index vertex, Index corner, Index face) {
    const bool any = corner == no_index && newest_[vertex] != no_index;
    const Numbers numbers = numbers_of(vertex, corner, face);
    Index found = newest_[vertex];
    while (!any && found != no_index && object.vertices[found].numbers != numbers) found = older_[found];
    if (found != no_index) return found;
    object.vertices.push_back({vertex, numbers});
    older_.push_back(newest_[vertex]);
    return newest_[vertex] = static_cast<Index>(object.vertices.size() - 1);
  }

  void make_object(const std::string& name, const std::vector<Index>& faces, const std::vector<Index>& lines,
                   bool is_only) {
    GlbObject object{name, {}, {}, {}};
    older_.clear();
    std::map<std::string, std::size_t> part_of;
    for (const Index face : faces) {
      progress_.check();
      const std::string material = materials_ == nullptr ? std::string() : label_of(*materials_, face);
      const auto [part, is_new] = part_of.try_emplace(material, object.parts.size());
      if (is_new) object.parts.push_back({material, {}});
      for (Index t = triangles_of_face_[face]; t < triangles_of_face_[face + 1]; ++t) {
        for (const Index corner : cut_.corners[t]) {
          const std::uint32_t vertex = vertex_of(object, mesh_.corners[corner], corner, face);
          object.parts[part->second].triangles.push_back(vertex);
        }
      }
    }
    for (const Index line : lines) {
      const auto vertices = mesh_.line(line);
      for (std::size_t i = 0; i + 1 < vertices.size(); ++i) {
        object.segments.push_back(vertex_of(object, vertices[i], no_index, no_index));
        object.segments.push_back(vertex_of(object, vertices[i + 1], no_index, no_index));
      }
    }
    for (Index v = 0; is_only && v < mesh_.vertex_count(); ++v) vertex_of(object, v, no_index, no_index);
    for (const GlbVertex& vertex : object.vertices) newest_[vertex.vertex] = no_index;
    put_in_order(object);
    result_.objects.push_back(std::move(object));
  }

  /// By the mesh's vertices, so that a reader that joins those at one place finds these in their own order.
  void put_in_order(GlbObject& object) {
    std::vector<std::uint32_t> order(object.vertices.size()), number(order.size());
    std::iota(order.begin(), order.end(), 0U);
    std::ranges::stable_sort(order, {}, [&](std::uint32_t i) { return object.vertices[i].vertex; });
    std::vector<GlbVertex> sorted;
    sorted.reserve(order.size());
    for (const std::uint32_t i : order) {
      number[i] = static_cast<std::uint32_t>(sorted.size());
      sorted.push_back(object.vertices[i]);
      if (sorted.back().vertex == next_)
        ++next_;
      else if (sorted.back().vertex > next_)
        result_.keeps_order = false;
    }
    object.vertices = std::move(sorted);
    for (GlbPart& part : object.parts) {
      for (std::uint32_t& vertex : part.triangles) vertex = number[vertex];
    }
    for (std::uint32_t& vertex : object.segments) vertex = number[vertex];
  }

  const PolyMesh& mesh_;
  const Progress& progress_;
  MeshTriangles cut_;
  std::vector<Index> triangles_of_face_;  ///< #F+1, into cut_
  const AttributeChannel *normals_ = nullptr, *colours_ = nullptr, *places_ = nullptr, *materials_ = nullptr;
  std::vector<Vec3> computed_;         ///< per corner
  std::vector<Index> newest_, older_;  ///< vertices of the object: the newest of each of the mesh, the one before each
  Index next_ = 0;                     ///< vertex of the mesh that a reader hasn't met
  GlbObjects result_;
};

}  // namespace

GlbObjects glb_objects(const PolyMesh& mesh, const std::vector<Vec3>& positions, const Progress& progress) {
  return ObjectMaker(mesh, positions, progress).run();
}

}  // namespace croquis
