// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/glb_writer.h"

#include <algorithm>
#include <sstream>

#include <tiny_gltf.h>

#include "croquis/base/error.h"
#include "io/channel_values.h"
#include "io/face_triangles.h"
#include "io/float_positions.h"
#include "io/format_loss.h"
#include "io/gltf/glb_camera.h"
#include "io/value_sink.h"

namespace croquis {
namespace {

class GlbWriter {
 public:
  GlbWriter(const PolyMesh& mesh, const MeshWriteOptions& options, Progress& progress)
      : mesh_(mesh),
        camera_(options.camera),
        z_up_(options.z_up),
        progress_(progress),
        positions_(positions_as_floats(mesh, MeshFormat::Glb)),
        cut_(face_triangles(mesh)) {}

  MeshWriteResult write() {
    add_attributes();
    progress_.check();
    add_triangles();
    add_lines();
    progress_.check();
    finish_model();
    note_losses();
    return {serialized(), loss_.warnings()};
  }

 private:
  template <typename T>
  int add_accessor(const std::vector<T>& values, std::size_t per_element, int type, int component_type, int target);
  void add_positions();
  void add_attributes();
  void add_triangles();
  void add_lines();
  void add_primitive(const std::vector<std::uint32_t>& indices, int mode);
  void finish_model();
  void turn_upright(tinygltf::Scene& scene);
  void note_losses();
  std::string serialized() const;

  const PolyMesh& mesh_;
  const std::optional<Camera>& camera_;
  bool z_up_;
  Progress& progress_;
  std::vector<Vec3> positions_;
  FaceTriangles cut_;
  FormatLoss loss_{"GLB"};
  std::vector<const AttributeChannel*> written_;
  tinygltf::Model model_;
  tinygltf::Mesh target_;
  std::map<std::string, int> attributes_;
  std::string data_;
};

// Every accessor has a view of its own; all component sizes here keep the data aligned to four bytes.
template <typename T>
int GlbWriter::add_accessor(const std::vector<T>& values, std::size_t per_element, int type, int component_type,
                            int target) {
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
  accessor.type = type;
  accessor.count = values.size() / per_element;
  model_.accessors.push_back(accessor);
  return static_cast<int>(model_.accessors.size()) - 1;
}

void GlbWriter::add_positions() {
  std::vector<float> values;
  Vec3 low = positions_.front(), high = positions_.front();
  for (const Vec3& p : positions_) {
    low = low.cwiseMin(p);
    high = high.cwiseMax(p);
    for (const double x : p) values.push_back(static_cast<float>(x));
  }
  const int accessor =
      add_accessor(values, 3, TINYGLTF_TYPE_VEC3, TINYGLTF_COMPONENT_TYPE_FLOAT, TINYGLTF_TARGET_ARRAY_BUFFER);
  tinygltf::Accessor& entry = model_.accessors[static_cast<std::size_t>(accessor)];
  entry.minValues.assign(low.begin(), low.end());
  entry.maxValues.assign(high.begin(), high.end());
  attributes_["POSITION"] = accessor;
}

void GlbWriter::add_attributes() {
  if (positions_.empty()) return;
  add_positions();
  const auto add = [&](const char* name, const char* gltf_name, int width, int or_width) {
    const AttributeChannel* channel = usable_channel(mesh_, name, Domain::Vertex, width, or_width);
    if (channel == nullptr || !all_finite(*channel)) return;
    const bool is_colour = std::string_view(name) == "color";
    const bool is_uv = std::string_view(name) == "uv";
    std::vector<float> values;
    for (std::size_t i = 0; i < channel->size(); ++i) {
      const double value = is_colour ? colour_of(*channel, i) : value_of(*channel, i);
      values.push_back(static_cast<float>(is_uv && i % 2 == 1 ? 1 - value : value));  // glTF's v points down
    }
    const int type = channel->width == 2   ? TINYGLTF_TYPE_VEC2
                     : channel->width == 3 ? TINYGLTF_TYPE_VEC3
                                           : TINYGLTF_TYPE_VEC4;
    attributes_[gltf_name] = add_accessor(values, static_cast<std::size_t>(channel->width), type,
                                          TINYGLTF_COMPONENT_TYPE_FLOAT, TINYGLTF_TARGET_ARRAY_BUFFER);
    written_.push_back(channel);
  };
  add("normal", "NORMAL", 3, 3);
  add("color", "COLOR_0", 3, 4);
  add("uv", "TEXCOORD_0", 2, 2);
}

void GlbWriter::add_primitive(const std::vector<std::uint32_t>& indices, int mode) {
  if (indices.empty()) return;
  tinygltf::Primitive primitive;
  primitive.attributes = attributes_;
  primitive.indices = add_accessor(indices, 1, TINYGLTF_TYPE_SCALAR, TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT,
                                   TINYGLTF_TARGET_ELEMENT_ARRAY_BUFFER);
  primitive.material = 0;
  primitive.mode = mode;
  target_.primitives.push_back(primitive);
}

void GlbWriter::add_triangles() {
  std::vector<std::uint32_t> indices;
  indices.reserve(3 * cut_.triangles.size());
  for (const auto& triangle : cut_.triangles) indices.insert(indices.end(), triangle.begin(), triangle.end());
  add_primitive(indices, TINYGLTF_MODE_TRIANGLES);
}

void GlbWriter::add_lines() {
  std::vector<std::uint32_t> indices;
  for (std::size_t l = 0; l < mesh_.line_count(); ++l) {
    const auto line = mesh_.line(l);
    for (std::size_t i = 0; i + 1 < line.size(); ++i) indices.insert(indices.end(), {line[i], line[i + 1]});
  }
  add_primitive(indices, TINYGLTF_MODE_LINE);
}

void GlbWriter::finish_model() {
  model_.asset.version = "2.0";
  model_.asset.generator = "Croquis";
  tinygltf::Material material;
  material.doubleSided = true;  // open surfaces are seen from both sides
  material.pbrMetallicRoughness.metallicFactor = 0;
  material.pbrMetallicRoughness.roughnessFactor = 0.8;
  model_.materials.push_back(material);
  tinygltf::Scene scene;
  if (!target_.primitives.empty()) {
    model_.meshes.push_back(target_);
    tinygltf::Node node;
    node.mesh = 0;
    model_.nodes.push_back(node);
    scene.nodes.push_back(0);
  } else if (!camera_) {
    scene.name = "empty";  // the library would write a scene without any member as null
  }
  if (camera_) scene.nodes.push_back(add_camera_node(*camera_, positions_, model_));
  if (z_up_ && !scene.nodes.empty()) turn_upright(scene);
  model_.scenes.push_back(scene);
  model_.defaultScene = 0;
  if (data_.empty()) return;
  tinygltf::Buffer buffer;
  buffer.data.assign(data_.begin(), data_.end());
  model_.buffers.push_back(buffer);
}

/// Puts all nodes under one that turns z, which points up in the mesh, to y.
void GlbWriter::turn_upright(tinygltf::Scene& scene) {
  tinygltf::Node upright;
  upright.name = "Z up";
  upright.matrix = {1, 0, 0, 0, 0, 0, -1, 0, 0, 1, 0, 0, 0, 0, 0, 1};
  upright.children = scene.nodes;
  scene.nodes = {static_cast<int>(model_.nodes.size())};
  model_.nodes.push_back(std::move(upright));
}

void GlbWriter::note_losses() {
  if (cut_.cut_polygons) loss_.note("polygons are cut into triangles");
  if (positions_ != mesh_.positions) loss_.note("coordinates are rounded to 32-bit floats");
  loss_.note_tags(mesh_.tags);
  loss_.note_others(mesh_, written_);
}

std::string GlbWriter::serialized() const {
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

}  // namespace

MeshWriteResult write_glb(const PolyMesh& mesh, const MeshWriteOptions& options, Progress& progress) {
  return GlbWriter(mesh, options, progress).write();
}

}  // namespace croquis
