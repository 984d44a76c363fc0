// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <sstream>
#include <utility>

#include <tiny_gltf.h>

#include "croquis/base/error.h"
#include "io/gltf/glb_writing.h"
#include "io/mesh_formats.h"
#include "io/mesh_writing.h"

namespace croquis {
namespace {

constexpr double near_share = 0.1;       // of the least depth of what is seen
constexpr double far_share = 10;         // of the greatest
constexpr double least_near_far = 1e-4;  // of the far plane, so that depth buffers distinguish surfaces

tinygltf::Value numbers_of(std::initializer_list<double> numbers) {
  tinygltf::Value::Array values;
  for (const double number : numbers) values.emplace_back(number);
  return tinygltf::Value(std::move(values));
}

/// Half of the width and height of the smallest picture around the principal point that holds the sheet, px.
Vec2 half_frame(const Camera& camera) {
  const Vec2 low = camera.principal_point - camera.image_origin;
  const Vec2 high = camera.image_origin + camera.image_size - camera.principal_point;
  const Vec2 half = low.cwiseAbs().cwiseMax(high.cwiseAbs());
  return half.cwiseMax(1e-6 * camera.focal_length);  // a sheet without size
}

/// Near and far plane.
std::pair<double, double> depth_range(const Camera& camera, const std::vector<Vec3>& positions) {
  double nearest = std::numeric_limits<double>::infinity(), farthest = 0;
  for (const Vec3& position : positions) {
    const double depth = camera.depth(position);
    if (depth <= 0) continue;
    nearest = std::min(nearest, depth);
    farthest = std::max(farthest, depth);
  }
  if (farthest == 0) return {0.01, 1000};
  const double far = far_share * farthest;
  return {std::max(near_share * nearest, least_near_far * far), far};
}

/// Adds a perspective camera and its node, which looks along -z with y up (glTF 2.0, sections 3.10 and 5.12).
///
/// A glTF camera has its principal point in the middle of what it sees. It gets the smallest such picture that holds
/// the sheet: `extras` of the camera has `image` [width, height], `origin` [x, y] and `principal_point` [u, v] of the
/// sheet (px, y down) and `focal_length` (px), and `frame` [x, y, width, height], the part of the sheet's plane that
/// the camera sees (px).
/// @param positions that are to lie between the near and the far plane
/// @return the node
int add_camera_node(const Camera& camera, const std::vector<Vec3>& positions, tinygltf::Model& model) {
  const Vec2 half = half_frame(camera);
  const auto [near, far] = depth_range(camera, positions);
  tinygltf::Camera made;
  made.type = "perspective";
  made.name = "Perspective drawing";
  made.perspective.yfov = 2 * std::atan(half.y() / camera.focal_length);
  made.perspective.aspectRatio = half.x() / half.y();
  made.perspective.znear = near;
  made.perspective.zfar = far;
  const Vec2 corner = camera.principal_point - half;
  tinygltf::Value::Object extras;
  extras["image"] = numbers_of({camera.image_size.x(), camera.image_size.y()});
  extras["origin"] = numbers_of({camera.image_origin.x(), camera.image_origin.y()});
  extras["principal_point"] = numbers_of({camera.principal_point.x(), camera.principal_point.y()});
  extras["focal_length"] = tinygltf::Value(camera.focal_length);
  extras["frame"] = numbers_of({corner.x(), corner.y(), 2 * half.x(), 2 * half.y()});
  made.extras = tinygltf::Value(std::move(extras));

  tinygltf::Node node;
  node.name = made.name;
  node.camera = static_cast<int>(model.cameras.size());
  const Vec3 right = camera.rotation.row(0), up = -camera.rotation.row(1), back = -camera.rotation.row(2);
  for (const Vec3& column : {right, up, back, camera.eye}) {
    node.matrix.insert(node.matrix.end(), column.begin(), column.end());
    node.matrix.push_back(node.matrix.size() < 15 ? 0 : 1);
  }
  model.cameras.push_back(std::move(made));
  model.nodes.push_back(std::move(node));
  return static_cast<int>(model.nodes.size()) - 1;
}

class GlbWriter {
 public:
  GlbWriter(const PolyMesh& mesh, const MeshWriteOptions& options, Progress& progress)
      : mesh_(mesh),
        options_(options),
        progress_(progress),
        positions_(positions_as_floats(mesh, MeshFormat::Glb)),
        content_(glb_objects(mesh, positions_, progress)) {}

  MeshWriteResult write() {
    model_.asset.version = "2.0";
    model_.asset.generator = "Croquis";
    for (const GlbObject& object : content_.objects) {
      progress_.check();
      add_object(object);
    }
    finish_model();
    note_losses();
    return {serialized(), loss_.warnings()};
  }

 private:
  // Every accessor has a view of its own; all component sizes here keep the data aligned to four bytes.
  template <typename T>
  int add_accessor(const std::vector<T>& values, std::size_t per_element, int component_type, int target) {
    ValueSink sink(false, 0);
    for (const T value : values) sink.put(value);
    tinygltf::BufferView view;
    view.buffer = 0;
    view.byteOffset = data_.size();
    view.byteLength = sink.text().size();
    view.target = target;
    data_ += sink.text();
    model_.bufferViews.push_back(view);
    tinygltf::Accessor accessor;
    accessor.bufferView = static_cast<int>(model_.bufferViews.size()) - 1;
    accessor.componentType = component_type;
    // The library's numbers of vectors are those of their components.
    accessor.type = per_element == 1 ? TINYGLTF_TYPE_SCALAR : static_cast<int>(per_element);
    accessor.count = values.size() / per_element;
    model_.accessors.push_back(accessor);
    return static_cast<int>(model_.accessors.size()) - 1;
  }

  std::map<std::string, int> add_attributes(const GlbObject& object) {
    std::map<std::string, int> attributes;
    const auto add = [&](const char* name, std::size_t width, const auto& value) {
      std::vector<float> values;
      values.reserve(width * object.vertices.size());
      for (const GlbVertex& vertex : object.vertices) {
        for (std::size_t i = 0; i < width; ++i) values.push_back(value(vertex, i));
      }
      attributes[name] = add_accessor(values, width, TINYGLTF_COMPONENT_TYPE_FLOAT, TINYGLTF_TARGET_ARRAY_BUFFER);
    };
    const auto add_numbers = [&](const char* name, std::size_t width, std::size_t first) {
      add(name, width, [first](const GlbVertex& vertex, std::size_t i) { return vertex.numbers[first + i]; });
    };
    add("POSITION", 3, [&](const GlbVertex& vertex, std::size_t i) {
      return static_cast<float>(positions_[vertex.vertex][static_cast<Eigen::Index>(i)]);
    });
    Vec3 low = positions_[object.vertices.front().vertex], high = low;
    for (const GlbVertex& vertex : object.vertices) {
      low = low.cwiseMin(positions_[vertex.vertex]);
      high = high.cwiseMax(positions_[vertex.vertex]);
    }
    tinygltf::Accessor& bounded = model_.accessors.back();
    bounded.minValues.assign(low.begin(), low.end());
    bounded.maxValues.assign(high.begin(), high.end());
    if (content_.has_normals) add_numbers("NORMAL", 3, glb_normal);
    if (content_.colour_width > 0) add_numbers("COLOR_0", static_cast<std::size_t>(content_.colour_width), glb_colour);
    if (content_.has_uv) add_numbers("TEXCOORD_0", 2, glb_uv);
    return attributes;
  }

  /// The material of that name, which is made when it is first asked for.
  int material(const std::string& name) {
    const auto [known, is_new] = materials_.try_emplace(name, static_cast<int>(model_.materials.size()));
    if (!is_new) return known->second;
    tinygltf::Material material;
    material.name = name;
    material.doubleSided = true;  // open surfaces are seen from both sides
    material.pbrMetallicRoughness.metallicFactor = 0;
    material.pbrMetallicRoughness.roughnessFactor = 0.8;
    model_.materials.push_back(material);
    return known->second;
  }

  void add_object(const GlbObject& object) {
    tinygltf::Mesh mesh;
    const std::map<std::string, int> attributes = add_attributes(object);
    const auto add_primitive = [&](const std::vector<std::uint32_t>& indices, int mode, const std::string& name) {
      if (indices.empty()) return;
      tinygltf::Primitive primitive;
      primitive.attributes = attributes;
      // Lines without normals are drawn in their own colour, not as if light fell on them.
      if (mode == TINYGLTF_MODE_LINE && content_.normals_computed) primitive.attributes.erase("NORMAL");
      primitive.indices =
          add_accessor(indices, 1, TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT, TINYGLTF_TARGET_ELEMENT_ARRAY_BUFFER);
      primitive.material = material(name);
      primitive.mode = mode;
      mesh.primitives.push_back(primitive);
    };
    for (const GlbPart& part : object.parts) add_primitive(part.triangles, TINYGLTF_MODE_TRIANGLES, part.name);
    add_primitive(object.segments, TINYGLTF_MODE_LINE, object.parts.empty() ? "" : object.parts.front().name);
    if (mesh.primitives.empty()) return;
    tinygltf::Node node;
    node.name = mesh.name = object.name.empty() ? options_.name : object.name;
    node.mesh = static_cast<int>(model_.meshes.size());
    tinygltf::Value::Object extras;
    if (content_.normals_computed) extras[GlbExtras::computed_normals] = tinygltf::Value(true);
    if (content_.has_groups) extras[GlbExtras::groups] = tinygltf::Value(true);
    if (!extras.empty()) mesh.extras = tinygltf::Value(extras);
    model_.meshes.push_back(mesh);
    scene_.nodes.push_back(static_cast<int>(model_.nodes.size()));
    model_.nodes.push_back(node);
  }

  void finish_model() {
    if (options_.camera) scene_.nodes.push_back(add_camera_node(*options_.camera, positions_, model_));
    if (scene_.nodes.empty()) scene_.name = "empty";  // the library would write a scene without any member as null
    if (options_.z_up && !scene_.nodes.empty()) turn_upright(scene_);
    model_.scenes.push_back(scene_);
    model_.defaultScene = 0;
    if (data_.empty()) return;
    tinygltf::Buffer buffer;
    buffer.data.assign(data_.begin(), data_.end());
    model_.buffers.push_back(buffer);
  }

  /// Puts all nodes under one that turns z, which points up in the mesh, to y.
  void turn_upright(tinygltf::Scene& scene) {
    tinygltf::Node upright;
    upright.name = "Z up";
    upright.matrix = {1, 0, 0, 0, 0, 0, -1, 0, 0, 1, 0, 0, 0, 0, 0, 1};
    upright.children = scene.nodes;
    scene.nodes = {static_cast<int>(model_.nodes.size())};
    model_.nodes.push_back(std::move(upright));
  }

  void note_losses() {
    loss_.note_polygons(mesh_);
    if (!content_.keeps_order) loss_.note("the order of vertices");
    loss_.note_tags(mesh_.tags);
    loss_.note_others(mesh_, content_.written);
  }

  std::string serialized() const {
    std::ostringstream stream;
    tinygltf::TinyGLTF writer;
    bool good = false;
    std::string reason = "the library gave no reason";
    try {
      good = writer.WriteGltfSceneToStream(&model_, stream, false, true);
    } catch (const std::exception& exception) {
      reason = exception.what();
    }
    if (!good) {
      throw Error(make_error(Category::Internal, "E_GLB", "The mesh can't be encoded as GLB: " + reason + "."));
    }
    return std::move(stream).str();
  }

  const PolyMesh& mesh_;
  const MeshWriteOptions& options_;
  Progress& progress_;
  std::vector<Vec3> positions_;
  GlbObjects content_;
  FormatLoss loss_{"GLB"};
  tinygltf::Model model_;
  tinygltf::Scene scene_;
  std::map<std::string, int> materials_;
  std::string data_;
};

}  // namespace

MeshWriteResult write_glb(const PolyMesh& mesh, const MeshWriteOptions& options, Progress& progress) {
  return GlbWriter(mesh, options, progress).write();
}

}  // namespace croquis
