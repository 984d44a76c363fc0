// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include <tiny_gltf.h>

#include "io/gltf/glb_writing.h"

namespace croquis {
namespace {

constexpr double near_share = 0.1;       // of the least depth of what is seen
constexpr double far_share = 10;         // of the greatest
constexpr double least_near_far = 1e-4;  // of the far plane, so that depth buffers tell surfaces apart

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

}  // namespace

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

}  // namespace croquis
