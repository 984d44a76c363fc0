// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <string>

#include <Eigen/Geometry>
#include <catch2/catch.hpp>

#include "croquis/base/error.h"
#include "croquis/io/camera_file.h"
#include "croquis/io/json.h"
#include "support/perspective/views.h"
#include "support/random.h"

using namespace croquis;
using namespace croquis::test;

namespace {

CameraFile some_camera(const View& view) { return {camera_for(l_block(), view), 3}; }

/// Without the members of our own: what fSpy itself would write.
std::string fspy_part(const std::string& json) {
  const Report report = read_json(json, "camera.json");
  Report part;
  for (const auto& [key, value] : report.as_object()) {
    const bool own = key == "mode" || key == "focal_length" || key == "principal_point" || key == "eye" ||
                     key == "rotation" || key == "image" || key == "origin";
    if (!own) part.set(key, value);
  }
  return write_json(part);
}

std::string little_word(std::uint32_t value) {
  std::string bytes;
  for (int i = 0; i < 4; ++i) bytes += static_cast<char>(value >> (8 * i));
  return bytes;
}

std::string project(const std::string& state, std::uint32_t version = 1) {
  const std::string picture = "\x89PNG";
  return "fspy" + little_word(version) + little_word(static_cast<std::uint32_t>(state.size())) +
         little_word(static_cast<std::uint32_t>(picture.size())) + state + picture;
}

std::string code_of(const std::string& bytes) {
  try {
    read_camera_file(bytes, "camera.json");
  } catch (const Error& error) {
    return error.findings().at(0).code;
  }
  return "";
}

double difference(const Camera& a, const Camera& b, const Vec2& shift) {
  double largest = 0;
  for (int i = 0; i < 8; ++i) {
    const Vec3 corner(i % 2 ? 2.5 : 0, i / 2 % 2 ? 2 : 0, i / 4 ? 3 : 0);
    largest = std::max(largest, (a.project(corner) - b.project(corner) - shift).norm());
  }
  return largest;
}

}  // namespace

TEST_CASE("cameras: our own file reads back exactly") {
  for (const View& view : all_views()) {
    const CameraFile file = some_camera(view);
    const CameraFile back = read_camera_file(write_camera_json(file), "camera.json");
    CHECK(back.camera.focal_length == file.camera.focal_length);
    CHECK(back.camera.principal_point == file.camera.principal_point);
    CHECK(back.camera.eye == file.camera.eye);
    CHECK((back.camera.rotation - file.camera.rotation).cwiseAbs().maxCoeff() < 1e-15);
    CHECK(back.camera.image_size == file.camera.image_size);
    CHECK(back.camera.image_origin == file.camera.image_origin);
    CHECK(back.mode == 3);
  }
}

TEST_CASE("cameras: what fSpy reads of it is the same camera") {
  View tall;
  tall.image_size = {600, 900};
  std::vector<View> views = all_views();
  views.push_back(tall);
  for (const View& view : views) {
    INFO(view.name);
    const CameraFile file = some_camera(view);
    const std::string json = fspy_part(write_camera_json(file));
    CHECK(difference(file.camera, read_camera_file(json, "camera.json").camera, view.origin) < 1e-9);
    const std::string state = "{\"calibrationSettingsBase\":{},\"cameraParameters\":" + json + "}";
    CHECK(difference(file.camera, read_camera_file(project(state), "camera.fspy").camera, view.origin) < 1e-9);
  }
}

TEST_CASE("cameras: the fSpy members are fSpy's projection") {
  for (const View& view : all_views()) {
    INFO(view.name);
    const CameraFile file = some_camera(view);
    const Report report = read_json(write_camera_json(file), "camera.json");
    const auto rows = [&](const char* name) {
      Eigen::Matrix4d matrix;
      for (int i = 0; i < 4; ++i) {
        for (int j = 0; j < 4; ++j) {
          matrix(i, j) = report.at(name).at("rows").as_array()[std::size_t(i)].as_array()[std::size_t(j)].as_number();
        }
      }
      return matrix;
    };
    const Eigen::Matrix4d see = rows("viewTransform");
    CHECK((see * rows("cameraTransform") - Eigen::Matrix4d::Identity()).cwiseAbs().maxCoeff() < 1e-9);
    const double scale = 1 / std::tan(report.at("horizontalFieldOfView").as_number() / 2);
    CHECK(std::abs(scale - report.at("relativeFocalLength").as_number()) < 1e-9);
    const Vec3 point(2, 1, 0.5);
    const Eigen::Vector4d seen = see * point.homogeneous();
    REQUIRE(seen.z() < 0);  // it looks along -z
    const double x = report.at("principalPoint").at("x").as_number() + scale * seen.x() / -seen.z();
    const double y = report.at("principalPoint").at("y").as_number() + scale * seen.y() / -seen.z();
    const double aspect = view.image_size.x() / view.image_size.y();
    const Vec2 relative(0.5 * (x + 1),
                        0.5 * (1 - y * aspect));  // as fSpy turns its places into parts of a wide picture
    CHECK((relative.cwiseProduct(view.image_size) + view.origin - file.camera.project(point)).norm() < 1e-9);
    // Far along an axis one sees its vanishing point.
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const Report& at = report.at("vanishingPoints").as_array()[axis];
      const bool positive = report.at("vanishingPointAxes").as_array()[axis].as_string().substr(1) == "Positive";
      if (at.is_null()) continue;
      const Vec3 far = (positive ? 1e9 : -1e9) * Vec3::Unit(static_cast<Eigen::Index>(axis));
      const Vec2 place(0.5 * (at.at("x").as_number() + 1), 0.5 * (1 - at.at("y").as_number() * aspect));
      const Vec2 seen_there = file.camera.project(far);
      CHECK((place.cwiseProduct(view.image_size) + view.origin - seen_there).norm() < 1e-3);
    }
  }
}

TEST_CASE("cameras: files that hold none are refused") {
  CHECK(code_of("") == "E_EMPTY");
  CHECK(code_of("{}") == "E_SYNTAX");
  CHECK(code_of("[1]") == "E_SYNTAX");
  const std::string json = write_camera_json(some_camera(View{}));
  std::string skew = json;
  skew.replace(skew.find("\"rotation\": [") + 13, 0, "[1,0,0],");
  CHECK(code_of(skew) == "E_SYNTAX");
  CHECK(code_of(R"({"focal_length":1,"principal_point":[0,0],"eye":[0,0,0],"image":[1,1],
                    "rotation":[[1,0,0],[0,1,0],[0,0,-1]]})") == "E_SYNTAX");
  const std::string state = "{\"cameraParameters\":" + fspy_part(json) + "}";
  CHECK(code_of(project(state)).empty());
  CHECK(code_of(project(state, 2)) == "E_VERSION");
  CHECK(code_of(project("{\"cameraParameters\":null}")) == "E_SYNTAX");
  CHECK(code_of(project(state).substr(0, 10)) == "E_TRUNCATED");
  CHECK(code_of(project(state).substr(0, 100)) == "E_TRUNCATED");
  CHECK(code_of("fspy" + little_word(1) + little_word(0xffffffff) + little_word(0) + state) == "E_TRUNCATED");
}
