// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>

#include <Eigen/Dense>
#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "cli/process.h"
#include "croquis/io/perspective_drawing_file.h"
#include "support/perspective/solid_drawing.h"

namespace croquis::test {
namespace {

using Json = nlohmann::json;

/// Sheets whose corner isn't (0, 0), and one that begins there.
std::vector<View> sheets() {
  View plain;
  plain.name = "plain";
  View moved;
  moved.name = "moved";
  moved.origin = {-137.5, 1042.25};
  View wide;
  wide.name = "wide";
  wide.origin = {300, -90};
  wide.image_size = {1600, 500};
  View tall;
  tall.name = "tall";
  tall.origin = {-2000, 77};
  tall.image_size = {600, 1100};
  View cropped = cropped_view();
  View tall_crop = cropped_view();
  tall_crop.name = "cropped and tall";
  tall_crop.image_size = {480, 620};
  tall_crop.principal_offset = {0.35, -0.25};
  return {plain, moved, wide, tall, cropped, tall_crop};
}

Eigen::MatrixXd matrix_of(const Json& rows) {
  const auto size = static_cast<Eigen::Index>(rows.size());
  Eigen::MatrixXd matrix(size, size);
  for (Eigen::Index i = 0; i < size; ++i) {
    for (Eigen::Index j = 0; j < size; ++j) matrix(i, j) = rows[std::size_t(i)][std::size_t(j)].get<double>();
  }
  return matrix;
}

/// p = P + f (X / Z, Y / Z) with (X, Y, Z) = R (point - eye), in the drawing's own coordinates.
Vec2 seen_by_formula(const Json& camera, const Vec3& point) {
  const Json &eye = camera.at("eye"), &principal = camera.at("principal_point");
  const Vec3 before = matrix_of(camera.at("rotation")) * (point - Vec3(eye[0], eye[1], eye[2]));
  return Vec2(principal[0], principal[1]) +
         camera.at("focal_length").get<double>() * Vec2(before.x(), before.y()) / before.z();
}

/// As fSpy has it: the camera looks along -z with y up. Its picture plane has its origin in the middle of the picture
/// and y up; x goes from -1 to 1 in a wide picture, y does in a tall one. The focal length in this unit is
/// 1 / tan(horizontalFieldOfView / 2), whichever side is longer.
/// @return parts of width and height, from the upper left corner
Vec2 seen_by_fspy(const Json& camera, const Vec3& point) {
  const Eigen::Vector4d before = matrix_of(camera.at("cameraTransform").at("rows")).inverse() * point.homogeneous();
  const double relative = 1 / std::tan(camera.at("horizontalFieldOfView").get<double>() / 2);
  const Json& principal = camera.at("principalPoint");
  const double x = principal.at("x").get<double>() - relative * before.x() / before.z();
  const double y = principal.at("y").get<double>() - relative * before.y() / before.z();
  const double aspect = camera.at("imageWidth").get<double>() / camera.at("imageHeight").get<double>();
  return aspect > 1 ? Vec2((1 + x) / 2, (1 - y * aspect) / 2) : Vec2((1 + x / aspect) / 2, (1 - y) / 2);
}

}  // namespace

TEST_CASE("the camera file shows every corner where it was drawn, on sheets that begin anywhere") {
  for (const View& view : sheets()) {
    for (const PerspectiveSolid& solid : {l_block(), bottle()}) {
      INFO(view.name << ", " << solid.name);
      const SolidDrawing truth = drawn(solid, view);
      const ScratchFolder folder;
      const std::string file = folder.write("drawing.svg", write_perspective_svg(truth.drawing));
      const ProcessResult result =
          run_cli({"perspective", file, "-o", folder / "solid.obj", "--camera", folder / "camera.json", "--json"});
      INFO(result.err);
      REQUIRE(result.code == 0);
      const Json camera = Json::parse(slurp(folder / "camera.json"));
      const Json report = Json::parse(result.out);
      REQUIRE(report.at("details").at("vertices").size() == solid.network.vertices.size());
      for (const Json& vertex : report.at("details").at("vertices")) {
        const Json& at = vertex.at("at");
        const Vec3 point(at[0], at[1], at[2]);
        const auto number = std::stoul(vertex.at("id").get<std::string>().substr(1));
        const Vec2 place = truth.camera.project(truth.network.vertices[number]);
        CHECK((seen_by_formula(camera, point) - place).norm() < 0.5);
        CHECK((seen_by_fspy(camera, point).cwiseProduct(view.image_size) + view.origin - place).norm() < 0.5);
      }
    }
  }
}

}  // namespace croquis::test
