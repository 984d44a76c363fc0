// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>
#include <optional>
#include <set>
#include <string_view>
#include <utility>
#include <vector>

#include <Eigen/Dense>

#include "croquis/base/error.h"
#include "croquis/base/limits.h"
#include "io/channel_values.h"
#include "io/gltf/glb_reading.h"
#include "io/gltf/glb_writing.h"
#include "io/json/report_reader.h"
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
constexpr std::size_t most_components = 4;
constexpr double no_value = std::numeric_limits<double>::quiet_NaN();

enum PrimitiveMode : std::size_t { Points, Lines, LineLoop, LineStrip, Triangles, TriangleStrip, TriangleFan };

/// One attribute of the vertices as a GLB file repeats them.
struct VertexAttribute {
  std::vector<double> values = {};  ///< four per vertex, NaN where there is none
  std::size_t width = 0;
  bool all_bytes = true;

  double value(std::size_t vertex, std::size_t component) const {
    const std::size_t place = most_components * vertex + component;
    return place < values.size() ? values[place] : no_value;
  }
};

/// What has been read so far.
struct GlbModel {
  ReadContext& context;
  const GltfDocument& document;
  const GltfAccessors& accessors;
  std::size_t elements_left;  ///< of elements_per_byte
  std::size_t position = 0;   ///< of the file, for progress
  PolyMesh mesh = {};
  PositionJoiner joiner = {};
  std::vector<Index> joined = {};           ///< per vertex of the file, the vertex of the mesh
  std::vector<std::uint32_t> corners = {};  ///< per corner of the mesh, the vertex of the file
  VertexAttribute normals = {}, places = {}, colours = {};
  CategoryState objects{"object"}, materials{"material"}, groups{"group"};
  std::set<std::string> passed_over = {};
};

/// A primitive of a mesh, where a node puts it.
struct Placed {
  const Report& primitive;
  std::string name;
  const Eigen::Matrix4d& transform;
  bool has_own_normals, has_groups;  ///< see GlbExtras
};

/// Accessors of position, normal, uv and colour: with the same, primitives of a node share their vertices.
using VertexKey = std::array<std::size_t, 4>;
using FirstVertices = std::map<VertexKey, std::size_t>;

void require_known_extensions(const GltfDocument& document) {
  const auto* list = report_as<Report::Array>(member_of(document.root(), "extensionsRequired"));
  for (std::size_t i = 0; list != nullptr && i < list->size(); ++i) {
    const auto* name = report_as<std::string>(&(*list)[i]);
    const auto is_harmless = [&](const char* start) { return name->starts_with(start); };
    if (name == nullptr || std::ranges::any_of(harmless_extensions, is_harmless)) continue;
    document.fail("E_FORMAT", "the model needs the extension '" + *name + "', which isn't read: export it without");
  }
}

void count_elements(GlbModel& model, std::size_t elements) {
  if (elements <= model.elements_left) {
    model.elements_left -= elements;
    return;
  }
  const std::string& file = model.context.file_name();
  throw Error(make_error(Category::Limit, "E_TOO_LARGE",
                         "'" + file + "': its nodes repeat its meshes more often than is read; export fewer copies.",
                         {{SubjectKind::File, file, file, std::nullopt, {}}}));
}

// ---- Vertices

GltfNumbers read_attribute(const GlbModel& model, const Placed& placed, std::size_t accessor, std::size_t least,
                           std::size_t most, std::size_t count) {
  GltfNumbers numbers = model.accessors.read(accessor, least, most, placed.name);
  if (numbers.count() != count) {
    model.document.fail("E_COUNT", gltf_element("accessor", accessor) + " has " + std::to_string(numbers.count()) +
                                       " elements, but " + placed.name + " has " + std::to_string(count) +
                                       " positions");
  }
  return numbers;
}

/// Values of vertices `first`, `first` + 1, …
void add_values(VertexAttribute& attribute, std::size_t first, const GltfNumbers& numbers) {
  const std::size_t end = most_components * (first + numbers.count());
  if (attribute.values.size() < end) attribute.values.resize(end, no_value);
  attribute.width = std::max(attribute.width, numbers.components);
  attribute.all_bytes = attribute.all_bytes && numbers.parts_of_255;
  for (std::size_t i = 0; i < numbers.count(); ++i) {
    // A colour among others that have a fourth component is opaque.
    for (std::size_t c = 0; c < most_components; ++c)
      attribute.values[most_components * (first + i) + c] =
          c < numbers.components ? numbers.values[i * numbers.components + c] : 1;
  }
}

void add_positions(GlbModel& model, const GltfNumbers& numbers, const Eigen::Matrix4d& transform) {
  const bool moved = transform != Eigen::Matrix4d::Identity();
  for (std::size_t i = 0; i < numbers.count(); ++i) {
    model.context.tick(model.position);
    Vec3 point(numbers.values[3 * i], numbers.values[3 * i + 1], numbers.values[3 * i + 2]);
    if (moved) point = (transform * point.homogeneous()).head<3>();
    if (!are_usable_numbers(point)) model.context.not_finite(model.mesh.vertex_count(), {});
    model.joined.push_back(model.joiner.add(point, model.mesh.positions));
  }
}

void turn_normals(GltfNumbers& numbers, const Eigen::Matrix4d& transform) {
  const Eigen::Matrix3d linear = transform.topLeftCorner<3, 3>();
  if (linear == Eigen::Matrix3d::Identity() || linear.determinant() == 0) return;
  const Eigen::Matrix3d of_normals = linear.inverse().transpose();
  for (std::size_t i = 0; i < numbers.count(); ++i) {
    Eigen::Map<Vec3> normal(numbers.values.data() + 3 * i);
    normal = (of_normals * normal).eval();
    if (normal.norm() > 0) normal.normalize();
  }
}

/// The first of the primitive's vertices, read unless another primitive of the node has the same.
std::size_t read_vertices(GlbModel& model, const Placed& placed, FirstVertices& known, std::size_t& count) {
  const GltfDocument& document = model.document;
  const Report* attributes = member_of(placed.primitive, "attributes");
  const auto* members = report_as<Report::Object>(attributes);
  if (members == nullptr) document.fail("E_SYNTAX", placed.name + " has no attributes");
  constexpr std::array<const char*, 4> names = {"POSITION", "NORMAL", "TEXCOORD_0", "COLOR_0"};
  VertexKey key{};
  for (std::size_t i = 0; i < names.size(); ++i)
    key[i] = document.index_or(*attributes, names[i], no_accessor, placed.name);
  for (const auto& [name, value] : *members) {
    if (std::ranges::find(names, std::string_view(name)) == names.end()) model.passed_over.insert("further attributes");
  }
  const auto [position, normal, place, colour] = key;
  if (position == no_accessor) document.fail("E_SYNTAX", placed.name + " has no positions");
  if (!placed.has_own_normals) key[1] = no_accessor;
  count = model.accessors.count(position, placed.name);
  const auto [entry, is_new] = known.try_emplace(key, model.joined.size());
  const std::size_t first = entry->second;
  if (!is_new) return first;
  count_elements(model, count);
  if (first + count > std::numeric_limits<std::uint32_t>::max()) count_elements(model, model.elements_left + 1);
  add_positions(model, read_attribute(model, placed, position, 3, 3, count), placed.transform);
  if (key[1] != no_accessor) {
    GltfNumbers normals = read_attribute(model, placed, normal, 3, 3, count);
    turn_normals(normals, placed.transform);
    add_values(model.normals, first, normals);
  }
  if (place != no_accessor) {
    GltfNumbers places = read_attribute(model, placed, place, 2, 2, count);
    for (std::size_t i = 1; i < places.values.size(); i += 2) places.values[i] = 1 - places.values[i];  // v points down
    add_values(model.places, first, places);
  }
  if (colour != no_accessor)
    add_values(model.colours, first, read_attribute(model, placed, colour, 3, most_components, count));
  return first;
}

// ---- Faces and lines

/// @param corners vertices of the primitive, whose first one is `first` of the file
void add_faces(GlbModel& model, const Placed& placed, std::size_t mode, const std::vector<std::size_t>& corners,
               std::size_t first, std::size_t vertex_count) {
  const bool turned = placed.transform.topLeftCorner<3, 3>().determinant() < 0;
  if (mode == Triangles && corners.size() % 3 != 0) {
    return model.context.error(
        "E_COUNT",
        placed.name + " has " + std::to_string(corners.size()) + " corners, which make no whole number of triangles",
        {});
  }
  for (std::size_t i = 0; i + 2 < corners.size(); i += mode == Triangles ? 3 : 1) {
    model.context.tick(model.position);
    const bool odd = mode == TriangleStrip && i % 2 == 1;
    std::array<std::size_t, 3> triangle = {corners[mode == TriangleFan ? 0 : i], corners[odd ? i + 2 : i + 1],
                                           corners[odd ? i + 1 : i + 2]};
    const auto [a, b, c] = triangle;
    // Strips are joined by triangles without area.
    if (mode == TriangleStrip && (a == b || b == c || c == a)) continue;
    const auto beyond = std::ranges::find_if(triangle, [&](std::size_t corner) { return corner >= vertex_count; });
    const std::size_t face = model.mesh.face_count();
    if (beyond != triangle.end()) {
      model.context.bad_index(face, static_cast<std::int64_t>(*beyond), vertex_count, {});
      continue;
    }
    if (turned) std::swap(triangle[1], triangle[2]);
    for (CategoryState* category : {&model.objects, &model.materials, &model.groups}) category->face_added(face);
    std::array<Index, 3> vertices{};
    for (std::size_t k = 0; k < 3; ++k) {
      model.corners.push_back(static_cast<std::uint32_t>(first + triangle[k]));
      vertices[k] = model.joined[first + triangle[k]];
    }
    model.mesh.add_face(vertices);
  }
}

void add_lines(GlbModel& model, const Placed& placed, std::size_t mode, const std::vector<std::size_t>& corners,
               std::size_t first, std::size_t vertex_count) {
  std::vector<Index> line;
  for (const std::size_t corner : corners) {
    if (corner >= vertex_count) {
      return model.context.error(
          "E_INDEX", placed.name + " uses vertex " + std::to_string(corner) + " of " + std::to_string(vertex_count),
          {});
    }
    line.push_back(model.joined[first + corner]);
    if (mode != Lines || line.size() < 2) continue;
    model.mesh.add_line(line);
    line.clear();
  }
  if (mode == Lines || line.size() < 2) return;
  if (mode == LineLoop) line.push_back(line.front());
  model.mesh.add_line(line);
}

void name_material(GlbModel& model, const Placed& placed) {
  const GltfDocument& document = model.document;
  model.materials.clear();
  model.groups.clear();
  const std::optional<std::size_t> index = document.index(placed.primitive, "material", placed.name);
  const std::size_t count = document.count("materials");
  if (!index || count <= *index) return;
  std::string label = GltfDocument::text(document.element("materials", *index, placed.name), "name");
  if (label.empty() && count > 1) label = "Material " + std::to_string(*index + 1);
  if (!label.empty()) (placed.has_groups ? model.groups : model.materials).set(label);
}

void read_primitive(GlbModel& model, const Placed& placed, FirstVertices& known) {
  const GltfDocument& document = model.document;
  name_material(model, placed);
  if (member_of(placed.primitive, "targets") != nullptr) model.passed_over.insert("morph targets");
  const std::size_t mode = document.index_or(placed.primitive, "mode", Triangles, placed.name);
  if (mode > TriangleFan) document.fail("E_SYNTAX", "'mode' of " + placed.name + " is none of glTF's");
  std::size_t vertex_count = 0;
  const std::size_t first = read_vertices(model, placed, known, vertex_count);
  const std::size_t accessor = document.index_or(placed.primitive, "indices", no_accessor, placed.name);
  const std::size_t count = accessor == no_accessor ? vertex_count : model.accessors.count(accessor, placed.name);
  count_elements(model, mode == TriangleStrip || mode == TriangleFan ? 3 * count : count);
  std::vector<std::size_t> corners(accessor == no_accessor ? count : 0);
  std::iota(corners.begin(), corners.end(), std::size_t{0});
  if (accessor != no_accessor) corners = model.accessors.read_indices(accessor, placed.name);
  if (mode >= Triangles) {
    add_faces(model, placed, mode, corners, first, vertex_count);
  } else if (mode != Points) {
    add_lines(model, placed, mode, corners, first, vertex_count);
  }
}

/// @param number of the instance, from 1; 0 where there is only one
void read_instance(GlbModel& model, const GlbInstance& instance, std::size_t number) {
  const GltfDocument& document = model.document;
  const Report& mesh = document.element("meshes", instance.mesh, gltf_element("node", instance.node));
  const Report& node = document.element("nodes", instance.node, "the model");
  std::string label = GltfDocument::text(node, "name");
  if (label.empty()) label = GltfDocument::text(mesh, "name");
  if (label.empty() && number > 0) label = "Object " + std::to_string(number);
  label.empty() ? model.objects.clear() : model.objects.set(label);
  if (member_of(node, "skin") != nullptr) model.passed_over.insert("skins");
  const Report* extras = member_of(mesh, "extras");
  const auto has_extra = [&](const char* name) {
    const bool* flag = extras == nullptr ? nullptr : report_as<bool>(member_of(*extras, name));
    return flag != nullptr && *flag;
  };
  const auto* list = report_as<Report::Array>(member_of(mesh, "primitives"));
  if (list == nullptr) document.fail("E_SYNTAX", gltf_element("mesh", instance.mesh) + " has no list of primitives");
  FirstVertices known;
  for (std::size_t p = 0; p < list->size(); ++p) {
    const std::string name = gltf_element("primitive", p) + " of " + gltf_element("mesh", instance.mesh);
    if (report_as<Report::Object>(&(*list)[p]) == nullptr) document.fail("E_SYNTAX", name + " is no object");
    count_elements(model, 1);
    read_primitive(
        model,
        {(*list)[p], name, instance.transform, !has_extra(GlbExtras::computed_normals), has_extra(GlbExtras::groups)},
        known);
  }
}

// ---- Channels

/// Per vertex of the mesh the value of the first that was joined; nothing when another one differs.
std::vector<double> common_values(const VertexAttribute& attribute, const GlbModel& model) {
  const std::size_t width = attribute.width, count = model.mesh.vertex_count();
  std::vector<double> common(count * width, no_value);
  std::vector<std::uint8_t> known(count, 0);
  for (std::size_t r = 0; r < model.joined.size(); ++r) {
    const Index v = model.joined[r];
    for (std::size_t c = 0; c < width; ++c) {
      double& kept = common[v * width + c];
      const double value = attribute.value(r, c);
      const bool same = kept == value || (std::isnan(kept) && std::isnan(value));
      if (known[v] != 0 && !same) return {};
      kept = value;
    }
    known[v] = 1;
  }
  return common;
}

/// On vertices where all that were joined agree, else on corners.
void add_channel(const char* name, const VertexAttribute& attribute, GlbModel& model) {
  if (attribute.width == 0) return;
  std::vector<double> values = common_values(attribute, model);
  const Domain domain = values.empty() ? Domain::Corner : Domain::Vertex;
  if (values.empty()) {
    values.reserve(model.corners.size() * attribute.width);
    for (const std::uint32_t r : model.corners) {
      for (std::size_t c = 0; c < attribute.width; ++c) values.push_back(attribute.value(r, c));
    }
  }
  const auto width = static_cast<int>(attribute.width);
  model.mesh.channels.push_back(
      std::string_view(name) == "color"
          ? colour_channel(domain, width, std::move(values), attribute.all_bytes)
          : make_channel(name, domain, width, std::vector<float>(values.begin(), values.end())));
}

/// What a mesh can't hold, in one sentence.
void warn_of_the_rest(GlbModel& model) {
  for (const auto& [list, words] : {std::pair{"textures", "textures"},
                                    {"images", "textures"},
                                    {"skins", "skins"},
                                    {"animations", "animations"},
                                    {"cameras", "cameras"}}) {
    if (model.document.count(list) > 0) model.passed_over.insert(words);
  }
  if (model.passed_over.empty()) return;
  std::string words;
  std::size_t left = model.passed_over.size();
  for (const std::string& name : model.passed_over) {
    --left;
    words += name + (left == 0 ? "" : left == 1 ? " and " : ", ");
  }
  model.context.warn("W_IGNORED", words + " were passed over: a mesh holds none", {});
}

}  // namespace

PolyMesh read_glb(std::string_view bytes, ReadContext& context) {
  const GlbContainer container = open_glb(bytes, context);
  const GltfDocument document(container.json, context);
  const GltfAccessors accessors(document, container.binary);
  GlbModel model{context, document, accessors, elements_per_byte * bytes.size() + elements_besides};
  require_known_extensions(document);
  const std::vector<GlbInstance> instances = glb_instances(document);
  for (std::size_t i = 0; i < instances.size(); ++i) {
    read_instance(model, instances[i], instances.size() > 1 ? i + 1 : 0);
    model.position = context.file_size() * (i + 1) / instances.size();
  }
  add_channel("normal", model.normals, model);
  add_channel("color", model.colours, model);
  add_channel("uv", model.places, model);
  for (CategoryState* category : {&model.objects, &model.materials, &model.groups}) category->finish(model.mesh);
  warn_of_the_rest(model);
  return std::move(model.mesh);
}

}  // namespace croquis
