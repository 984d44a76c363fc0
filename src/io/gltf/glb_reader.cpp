// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <limits>
#include <map>
#include <optional>
#include <set>
#include <utility>
#include <vector>

#include <Eigen/Dense>

#include "croquis/base/error.h"
#include "croquis/base/limits.h"
#include "io/channel_values.h"
#include "io/gltf/glb_reading.h"
#include "io/gltf/glb_writing.h"
#include "io/mesh_formats.h"
#include "io/position_joiner.h"

namespace croquis {
namespace {

/// Vertices and corners that a model may have: so many per byte of its file (a strip of one-byte indices has three
/// corners a byte, the rest is for meshes that several nodes share), and so many besides.
constexpr std::size_t elements_per_byte = 4;
constexpr std::size_t elements_besides = 1000000;

/// Extensions that change only how surfaces look, or what this reader does anyway.
constexpr std::array harmless_extensions = {"KHR_materials_", "KHR_texture_", "KHR_lights_", "KHR_mesh_quantization"};

constexpr std::size_t no_accessor = static_cast<std::size_t>(-1);

enum PrimitiveMode : std::size_t { Points, Lines, LineLoop, LineStrip, Triangles, TriangleStrip, TriangleFan };

/// A primitive of a mesh, where a node puts it.
struct Placed {
  const Report& primitive;
  std::string name;
  const GlbInstance& instance;
};

class GlbReader {
 public:
  GlbReader(std::string_view bytes, ReadContext& context)
      : context_(context),
        container_(open_glb(bytes, context)),
        document_(container_.json, context),
        accessors_(document_, container_.binary),
        room_(elements_per_byte * bytes.size() + elements_besides) {}

  PolyMesh read() {
    check_extensions();
    const std::vector<GlbInstance> instances = glb_instances(document_);
    several_ = instances.size() > 1;
    for (const GlbInstance& instance : instances) {
      read_instance(instance);
      ++instances_done_;
      position_ = context_.file_size() * instances_done_ / instances.size();
    }
    finish();
    return std::move(mesh_);
  }

 private:
  using VertexKey = std::array<std::size_t, 4>;  ///< accessors of position, normal, uv and colour

  void check_extensions() const {
    const Report* required = document_.root().find("extensionsRequired");
    const auto* list = required == nullptr ? nullptr : std::get_if<Report::Array>(&required->value());
    if (list == nullptr) return;
    for (const Report& entry : *list) {
      const auto* name = std::get_if<std::string>(&entry.value());
      if (name == nullptr) continue;
      const bool harmless = std::any_of(harmless_extensions.begin(), harmless_extensions.end(),
                                        [&](const char* start) { return name->starts_with(start); });
      if (!harmless) {
        document_.fail("E_FORMAT",
                       "the model needs the extension '" + *name + "', which isn't read: export it without");
      }
    }
  }

  void read_instance(const GlbInstance& instance) {
    const std::string node = gltf_element("node", instance.node);
    const Report& mesh = document_.element("meshes", instance.mesh, node);
    name_object(instance, mesh);
    first_of_.clear();
    const Report* extras = mesh.find("extras");
    const auto is_told = [&](const char* member) {
      const Report* told = extras == nullptr ? nullptr : extras->find(member);
      return told != nullptr && std::holds_alternative<bool>(told->value()) && std::get<bool>(told->value());
    };
    has_own_normals_ = !is_told(GlbExtras::computed_normals);
    has_groups_ = is_told(GlbExtras::groups);
    const Report* primitives = mesh.find("primitives");
    const auto* list = primitives == nullptr ? nullptr : std::get_if<Report::Array>(&primitives->value());
    if (list == nullptr) document_.fail("E_SYNTAX", gltf_element("mesh", instance.mesh) + " has no list of primitives");
    for (std::size_t p = 0; p < list->size(); ++p) {
      const std::string name = gltf_element("primitive", p) + " of " + gltf_element("mesh", instance.mesh);
      if (!std::holds_alternative<Report::Object>((*list)[p].value()))
        document_.fail("E_SYNTAX", name + " is no object");
      take_room(1);
      read_primitive({(*list)[p], name, instance});
    }
  }

  void name_object(const GlbInstance& instance, const Report& mesh) {
    const Report& node = document_.element("nodes", instance.node, "the model");
    std::string label = GltfDocument::text(node, "name");
    if (label.empty()) label = GltfDocument::text(mesh, "name");
    if (label.empty() && several_) label = "Object " + std::to_string(instances_done_ + 1);
    label.empty() ? objects_.clear() : objects_.set(label);
    if (node.find("skin") != nullptr) passed_over_.insert("skins");
  }

  void name_material(const Report& primitive, const std::string& name) {
    materials_.clear();
    groups_.clear();
    const std::optional<std::size_t> index = document_.index(primitive, "material", name);
    if (!index || document_.count("materials") <= *index) return;
    std::string label = GltfDocument::text(document_.element("materials", *index, name), "name");
    if (label.empty() && document_.count("materials") > 1) label = "Material " + std::to_string(*index + 1);
    if (!label.empty()) (has_groups_ ? groups_ : materials_).set(label);
  }

  void read_primitive(const Placed& placed) {
    name_material(placed.primitive, placed.name);
    if (placed.primitive.find("targets") != nullptr) passed_over_.insert("morph targets");
    const std::size_t mode = document_.index_or(placed.primitive, "mode", Triangles, placed.name);
    if (mode > TriangleFan) document_.fail("E_SYNTAX", "'mode' of " + placed.name + " is none of glTF's");
    std::size_t vertex_count = 0;
    const std::size_t first = vertices_of(placed, vertex_count);
    const std::vector<std::size_t> corners = corners_of(placed, vertex_count);
    if (mode >= Triangles) {
      add_faces(placed, mode, corners, first, vertex_count);
    } else if (mode != Points) {
      add_lines(placed, mode, corners, first, vertex_count);
    }
  }

  /// The first of the primitive's vertices, read unless another primitive of the node has the same.
  std::size_t vertices_of(const Placed& placed, std::size_t& count) {
    const Report* attributes = placed.primitive.find("attributes");
    const auto* members = attributes == nullptr ? nullptr : std::get_if<Report::Object>(&attributes->value());
    if (members == nullptr) document_.fail("E_SYNTAX", placed.name + " has no attributes");
    constexpr std::array<const char*, 4> known = {"POSITION", "NORMAL", "TEXCOORD_0", "COLOR_0"};
    VertexKey key{};
    for (std::size_t i = 0; i < known.size(); ++i)
      key[i] = document_.index_or(*attributes, known[i], no_accessor, placed.name);
    for (const auto& [name, value] : *members) {
      if (std::find(known.begin(), known.end(), std::string_view(name)) == known.end())
        passed_over_.insert("further attributes");
    }
    if (key[0] == no_accessor) document_.fail("E_SYNTAX", placed.name + " has no positions");
    if (!has_own_normals_) key[1] = no_accessor;
    count = accessors_.count(key[0], placed.name);
    const auto [entry, is_new] = first_of_.try_emplace(key, vertices_.joined.size());
    if (!is_new) return entry->second;
    take_room(count);
    const std::size_t first = entry->second;
    if (first + count > std::numeric_limits<std::uint32_t>::max()) take_room(room_ + 1);
    add_positions(read_attribute(placed, key[0], 3, 3, count), placed.instance.transform);
    if (key[1] != no_accessor) {
      add_normals(first, read_attribute(placed, key[1], 3, 3, count), placed.instance.transform);
    }
    if (key[2] != no_accessor) {
      GltfNumbers places = read_attribute(placed, key[2], 2, 2, count);
      for (std::size_t i = 1; i < places.values.size(); i += 2)
        places.values[i] = 1 - places.values[i];  // v points down
      places_.add(first, places);
    }
    if (key[3] != no_accessor) colours_.add(first, read_attribute(placed, key[3], 3, 4, count));
    return first;
  }

  void add_positions(const GltfNumbers& numbers, const Eigen::Matrix4d& transform) {
    const bool moved = transform != Eigen::Matrix4d::Identity();
    for (std::size_t i = 0; i < numbers.count(); ++i) {
      context_.tick(position_);
      Vec3 point(numbers.values[3 * i], numbers.values[3 * i + 1], numbers.values[3 * i + 2]);
      if (moved) point = (transform * point.homogeneous()).head<3>();
      if (!are_usable_numbers(point)) context_.not_finite(mesh_.vertex_count(), {});
      vertices_.joined.push_back(joiner_.add(point, mesh_.positions));
    }
  }

  void add_normals(std::size_t first, GltfNumbers numbers, const Eigen::Matrix4d& transform) {
    const Eigen::Matrix3d linear = transform.topLeftCorner<3, 3>();
    const bool turns = linear != Eigen::Matrix3d::Identity() && linear.determinant() != 0;
    const Eigen::Matrix3d of_normals =
        turns ? Eigen::Matrix3d(linear.inverse().transpose()) : Eigen::Matrix3d::Identity();
    for (std::size_t i = 0; turns && i < numbers.count(); ++i) {
      Eigen::Map<Vec3> normal(numbers.values.data() + 3 * i);
      normal = (of_normals * normal).eval();
      if (normal.norm() > 0) normal.normalize();
    }
    normals_.add(first, numbers);
  }

  GltfNumbers read_attribute(const Placed& placed, std::size_t accessor, std::size_t least, std::size_t most,
                             std::size_t count) const {
    GltfNumbers numbers = accessors_.read(accessor, least, most, placed.name);
    if (numbers.count() != count) {
      document_.fail("E_COUNT", gltf_element("accessor", accessor) + " has " + std::to_string(numbers.count()) +
                                    " elements, but " + placed.name + " has " + std::to_string(count) + " positions");
    }
    return numbers;
  }

  std::vector<std::size_t> corners_of(const Placed& placed, std::size_t vertex_count) {
    const std::size_t accessor = document_.index_or(placed.primitive, "indices", no_accessor, placed.name);
    const std::size_t count = accessor == no_accessor ? vertex_count : accessors_.count(accessor, placed.name);
    const std::size_t mode = document_.index_or(placed.primitive, "mode", Triangles, placed.name);
    take_room(mode == TriangleStrip || mode == TriangleFan ? 3 * count : count);
    if (accessor != no_accessor) return accessors_.read_indices(accessor, placed.name);
    std::vector<std::size_t> corners(count);
    for (std::size_t i = 0; i < count; ++i) corners[i] = i;
    return corners;
  }

  void add_faces(const Placed& placed, std::size_t mode, const std::vector<std::size_t>& corners, std::size_t first,
                 std::size_t vertex_count) {
    const bool turned = placed.instance.transform.topLeftCorner<3, 3>().determinant() < 0;
    if (mode == Triangles && corners.size() % 3 != 0) {
      context_.error(
          "E_COUNT",
          placed.name + " has " + std::to_string(corners.size()) + " corners, which make no whole number of triangles",
          {});
      return;
    }
    const std::size_t step = mode == Triangles ? 3 : 1;
    for (std::size_t i = 0; i + 2 < corners.size(); i += step) {
      context_.tick(position_);
      const bool odd = mode == TriangleStrip && i % 2 == 1;
      const std::size_t a = corners[mode == TriangleFan ? 0 : i];
      const std::size_t b = corners[odd ? i + 2 : i + 1];
      const std::size_t c = corners[odd ? i + 1 : i + 2];
      // Strips are joined by triangles without area.
      if (mode == TriangleStrip && (a == b || b == c || c == a)) continue;
      add_triangle({a, b, c}, first, vertex_count, turned);
    }
  }

  void add_triangle(const std::array<std::size_t, 3>& corners, std::size_t first, std::size_t vertex_count,
                    bool turned) {
    for (const std::size_t corner : corners) {
      if (corner < vertex_count) continue;
      context_.bad_index(mesh_.face_count(), static_cast<std::int64_t>(corner), vertex_count, {});
      return;
    }
    std::array<std::size_t, 3> own = corners;
    if (turned) std::swap(own[1], own[2]);
    objects_.face_added(mesh_.face_count());
    materials_.face_added(mesh_.face_count());
    groups_.face_added(mesh_.face_count());
    std::array<Index, 3> face{};
    for (std::size_t i = 0; i < 3; ++i) {
      vertices_.corners.push_back(static_cast<std::uint32_t>(first + own[i]));
      face[i] = vertices_.joined[first + own[i]];
    }
    mesh_.add_face(face);
  }

  void add_lines(const Placed& placed, std::size_t mode, const std::vector<std::size_t>& corners, std::size_t first,
                 std::size_t vertex_count) {
    std::vector<Index> line;
    for (const std::size_t corner : corners) {
      if (corner >= vertex_count) {
        context_.error("E_INDEX",
                       placed.name + " uses vertex " + std::to_string(corner) + " of " + std::to_string(vertex_count),
                       {});
        return;
      }
      line.push_back(vertices_.joined[first + corner]);
      if (mode != Lines || line.size() < 2) continue;
      mesh_.add_line(line);
      line.clear();
    }
    if (mode == Lines || line.size() < 2) return;
    if (mode == LineLoop) line.push_back(line.front());
    mesh_.add_line(line);
  }

  void take_room(std::size_t elements) {
    if (elements <= room_) {
      room_ -= elements;
      return;
    }
    const std::string& file = context_.file_name();
    throw Error(make_error(Category::Limit, "E_TOO_LARGE",
                           "'" + file + "': its nodes repeat its meshes more often than is read; export fewer copies.",
                           {{SubjectKind::File, file, file, std::nullopt, {}}}));
  }

  void finish() {
    add_glb_channel("normal", normals_, vertices_, mesh_);
    add_glb_channel("color", colours_, vertices_, mesh_);
    add_glb_channel("uv", places_, vertices_, mesh_);
    objects_.finish(mesh_);
    materials_.finish(mesh_);
    groups_.finish(mesh_);
    note_passed_over();
  }

  /// What a mesh can't hold, in one sentence.
  void note_passed_over() {
    for (const auto& [list, words] : {std::pair{"textures", "textures"},
                                      {"images", "textures"},
                                      {"skins", "skins"},
                                      {"animations", "animations"},
                                      {"cameras", "cameras"}}) {
      if (document_.count(list) > 0) passed_over_.insert(words);
    }
    if (passed_over_.empty()) return;
    std::string words;
    std::size_t left = passed_over_.size();
    for (const std::string& name : passed_over_) {
      words += name;
      --left;
      if (left > 0) words += left == 1 ? " and " : ", ";
    }
    context_.warn("W_IGNORED", words + " were passed over: a mesh holds none", {});
  }

  ReadContext& context_;
  GlbContainer container_;
  GltfDocument document_;
  GltfAccessors accessors_;
  std::size_t room_;
  bool several_ = false;
  std::size_t instances_done_ = 0;
  std::size_t position_ = 0;  ///< of the file, for progress
  PolyMesh mesh_;
  PositionJoiner joiner_;
  GlbVertices vertices_;
  GlbAttribute normals_, places_, colours_;
  std::map<VertexKey, std::size_t> first_of_;         ///< of this node: primitives may share their vertices
  bool has_own_normals_ = true, has_groups_ = false;  ///< of this node, see GlbExtras
  CategoryState objects_{"object"}, materials_{"material"}, groups_{"group"};
  std::set<std::string> passed_over_;
};

}  // namespace

PolyMesh read_glb(std::string_view bytes, ReadContext& context) { return GlbReader(bytes, context).read(); }

}  // namespace croquis
