// SPDX-License-Identifier: GPL-3.0-or-later
#include <Eigen/LU>

#include "croquis/geometry/camera.h"
#include "document/values/member_bytes.h"

namespace croquis {
namespace {

constexpr std::uint32_t camera_layout = 1;
constexpr std::uint32_t placed_camera_layout = 2;  // with the corner of its picture
constexpr double largest_camera_skew = 1e-9;       // of stored rotations, which are written as they are

void require_camera(const Camera& camera) {
  if (!(camera.focal_length > 0 && is_usable_number(camera.focal_length)))
    throw BadBytes("its focal length is not positive");
  const Eigen::Matrix3d off = camera.rotation * camera.rotation.transpose() - Eigen::Matrix3d::Identity();
  if (off.cwiseAbs().maxCoeff() > largest_camera_skew || camera.rotation.determinant() < 0) {
    throw BadBytes("its axes are not at right angles");
  }
  if (camera.image_size.minCoeff() < 0) throw BadBytes("its picture's size is negative");
}

bool is_placed(const Camera& camera) { return camera.image_origin != Vec2::Zero(); }

/// A pinhole camera. Files hold its rotation row by row, and the corner of its picture where it isn't the origin.
struct CameraValue {
  using Content = Camera;
  static constexpr const char* name = "camera";
  static constexpr std::uint64_t tag = 3;

  static void add_content(const Camera& camera, ContentHasher& hasher) {
    hash_member(std::tie(camera.focal_length, camera.principal_point, camera.eye, camera.rotation, camera.image_size),
                hasher);
    if (is_placed(camera)) hash_member(camera.image_origin, hasher);
  }

  static std::size_t byte_size(const Camera&) { return sizeof(Camera); }

  static void store(const Camera& camera, ByteWriter& writer) {
    writer.number(is_placed(camera) ? placed_camera_layout : camera_layout);
    const Eigen::Matrix3d rows = camera.rotation.transpose();
    store_member(std::tie(camera.focal_length, camera.principal_point, camera.eye, rows, camera.image_size), writer);
    if (is_placed(camera)) store_member(camera.image_origin, writer);
  }

  static Camera load(ByteReader& reader) {
    const std::uint32_t layout = read_layout(reader, placed_camera_layout);
    Camera camera;
    camera.focal_length = reader.number<double>();
    camera.principal_point = load_member<Vec2>(reader);
    camera.eye = load_member<Vec3>(reader);
    camera.rotation = load_member<Eigen::Matrix3d>(reader).transpose().eval();
    camera.image_size = load_member<Vec2>(reader);
    if (layout == placed_camera_layout) camera.image_origin = load_member<Vec2>(reader);
    require_camera(camera);
    return camera;
  }
};

}  // namespace

constinit const ValueTraits ValueTraits::Camera = value_row<CameraValue>();

}  // namespace croquis
