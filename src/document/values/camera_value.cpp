// SPDX-License-Identifier: GPL-3.0-or-later

#include <Eigen/LU>

#include "croquis/base/limits.h"
#include "croquis/geometry/camera.h"
#include "document/values/value_row.h"
#include "document/values/vector_bytes.h"

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

/// A pinhole camera.
struct CameraValue {
  using Content = Camera;
  static constexpr const char* name = "camera";
  static constexpr std::uint64_t tag = 3;

  static void add_content(const Camera& camera, ContentHasher& hasher) {
    hasher.add(camera.focal_length);
    hash_numbers(camera.principal_point, hasher);
    hash_numbers(camera.eye, hasher);
    hash_numbers(camera.rotation, hasher);
    hash_numbers(camera.image_size, hasher);
    if (is_placed(camera)) hash_numbers(camera.image_origin, hasher);
  }

  static std::size_t byte_size(const Camera&) { return sizeof(Camera); }

  static void store(const Camera& camera, ByteWriter& writer) {
    writer.number(is_placed(camera) ? placed_camera_layout : camera_layout);
    writer.number(camera.focal_length);
    write_numbers(camera.principal_point, writer);
    write_numbers(camera.eye, writer);
    write_numbers(camera.rotation.transpose(), writer);
    write_numbers(camera.image_size, writer);
    if (is_placed(camera)) write_numbers(camera.image_origin, writer);
  }

  static Camera load(ByteReader& reader) {
    const std::uint32_t layout = read_layout(reader, placed_camera_layout);
    Camera camera;
    camera.focal_length = reader.number<double>();
    camera.principal_point = read_usable<Vec2>(reader);
    camera.eye = read_usable<Vec3>(reader);
    camera.rotation = read_usable<Eigen::Matrix3d>(reader).transpose().eval();
    camera.image_size = read_usable<Vec2>(reader);
    if (layout == placed_camera_layout) camera.image_origin = read_usable<Vec2>(reader);
    require_camera(camera);
    return camera;
  }
};

}  // namespace

constinit const ValueTraits ValueTraits::Camera = value_row<CameraValue>();

}  // namespace croquis
