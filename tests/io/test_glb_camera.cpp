// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <cstring>

#include <Eigen/Dense>
#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "croquis/io/mesh_file.h"
#include "support/meshes/mesh_shapes.h"
#include "support/perspective/solids.h"
#include "support/perspective/views.h"

using namespace croquis;
using namespace croquis::test;

namespace {

using Json = nlohmann::json;

/// The JSON chunk of a GLB (glTF 2.0, section 4.4).
Json json_of(const std::string& glb) {
  std::uint32_t length = 0;
  std::memcpy(&length, glb.data() + 12, sizeof length);
  return Json::parse(glb.substr(20, length));
}

Json glb_with_camera(const PolyMesh& mesh, const Camera& camera, std::string* bytes = nullptr) {
  Progress progress;
  MeshWriteOptions options;
  options.camera = camera;
  const MeshWriteResult written = write_mesh(mesh, MeshFormat::Glb, options, progress);
  if (bytes != nullptr) *bytes = written.bytes;
  return json_of(written.bytes);
}

PolyMesh corners_of(const PerspectiveSolid& solid) {
  PolyMesh mesh = tetrahedron();
  mesh.positions.insert(mesh.positions.end(), solid.network.vertices.begin(), solid.network.vertices.end());
  return mesh;
}

/// glTF 2.0, section 3.10.3: the finite perspective projection.
Eigen::Matrix4d projection_of(const Json& perspective) {
  const double a = perspective.at("aspectRatio"), y = perspective.at("yfov");
  const double n = perspective.at("znear"), f = perspective.at("zfar");
  Eigen::Matrix4d matrix = Eigen::Matrix4d::Zero();
  matrix(0, 0) = 1 / (a * std::tan(y / 2));
  matrix(1, 1) = 1 / std::tan(y / 2);
  matrix(2, 2) = (f + n) / (n - f);
  matrix(2, 3) = 2 * f * n / (n - f);
  matrix(3, 2) = -1;
  return matrix;
}

}  // namespace

TEST_CASE("the camera node of a GLB sees the model where it was drawn") {
  for (const View& view : all_views()) {
    for (const PerspectiveSolid& solid : {box(), bottle(), camera_body()}) {
      INFO(view.name << ", " << solid.name);
      Camera camera = camera_for(solid, view);
      camera.image_origin = view.origin;
      const Json gltf = glb_with_camera(corners_of(solid), camera);
      const Json node = gltf.at("nodes").at(gltf.at("scenes").at(0).at("nodes").back().get<std::size_t>());
      const Json& made = gltf.at("cameras").at(node.at("camera").get<std::size_t>());
      CHECK(made.at("type") == "perspective");
      const auto numbers = node.at("matrix").get<std::vector<double>>();
      const Eigen::Matrix4d placed = Eigen::Map<const Eigen::Matrix4d>(numbers.data());
      CHECK((placed.topLeftCorner<3, 3>() * placed.topLeftCorner<3, 3>().transpose()).isIdentity(1e-12));
      CHECK(placed.topLeftCorner<3, 3>().determinant() > 0);
      const Eigen::Matrix4d seen = projection_of(made.at("perspective")) * placed.inverse();
      const auto frame = made.at("extras").at("frame").get<std::vector<double>>();
      for (const Vec3& corner : solid.network.vertices) {
        const Eigen::Vector4d clip = seen * corner.homogeneous();
        const Vec3 device = clip.head<3>() / clip.w();
        CHECK(std::abs(device.z()) < 1);  // between the near and the far plane
        const Vec2 place(frame[0] + frame[2] * (device.x() + 1) / 2, frame[1] + frame[3] * (1 - device.y()) / 2);
        CHECK((place - camera.project(corner)).norm() < 1e-6);
      }
      // The sheet is in the picture, and touches it: it is the smallest one.
      const Vec2 low = view.origin - Vec2(frame[0], frame[1]);
      const Vec2 high = Vec2(frame[0] + frame[2], frame[1] + frame[3]) - view.origin - view.image_size;
      CHECK(low.minCoeff() > -1e-6);
      CHECK(high.minCoeff() > -1e-6);
      CHECK(low.cwiseMin(high).maxCoeff() < 1e-6);
      const Json& extras = made.at("extras");
      CHECK(extras.at("image")[0].get<double>() == view.image_size.x());
      CHECK(extras.at("principal_point")[1].get<double>() == camera.principal_point.y());
      CHECK(extras.at("focal_length").get<double>() == camera.focal_length);
    }
  }
}

TEST_CASE("a GLB with a camera is read as the mesh that it holds") {
  std::string bytes;
  const PerspectiveSolid solid = box();
  const Camera camera = camera_for(solid, off_centre_view());
  glb_with_camera(tetrahedron(), camera, &bytes);
  Progress progress;
  const MeshReadResult read = read_mesh(bytes, MeshFormat::Glb, "seen.glb", progress);
  CHECK(read.mesh.face_count() == 4);
  CHECK(read.mesh.positions == tetrahedron().positions);
  const MeshWriteResult plain = write_mesh(tetrahedron(), MeshFormat::Glb, {}, progress);
  CHECK_FALSE(json_of(plain.bytes).contains("cameras"));
}
