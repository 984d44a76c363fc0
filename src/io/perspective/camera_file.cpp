// SPDX-License-Identifier: GPL-3.0-or-later
#include "croquis/io/camera_file.h"

#include <algorithm>
#include <cmath>

#include <Eigen/Geometry>
#include <Eigen/SVD>

#include "croquis/base/error.h"
#include "croquis/io/json.h"
#include "io/json/report_reader.h"
#include "io/little_endian.h"
#include "io/text.h"

namespace croquis {
namespace {

constexpr std::string_view fspy_magic = "fspy";
constexpr std::size_t fspy_head = 16;  // magic, version, size of the JSON, size of the picture
constexpr double largest_skew = 1e-3;  // of a rotation from an orthonormal one, times its scale
constexpr const char* axis_letters = "xyz";

/// fSpy's camera looks along -z with y up.
Eigen::Matrix3d fspy_axes() { return Eigen::Vector3d(1, -1, -1).asDiagonal(); }

/// Half of the longer side, px: fSpy's unit in the picture.
double fspy_unit(const Vec2& image) { return image.maxCoeff() / 2; }

// ---- Writing

Report row_report(const Eigen::Matrix<double, 1, Eigen::Dynamic>& row) {
  Report list = Report::array();
  for (Eigen::Index i = 0; i < row.size(); ++i) list.push(row[i]);
  return list;
}

template <typename Matrix>
Report rows_report(const Matrix& matrix) {
  Report rows = Report::array();
  for (Eigen::Index i = 0; i < matrix.rows(); ++i) rows.push(row_report(matrix.row(i)));
  return rows;
}

Report transform_report(const Eigen::Affine3d& transform) {
  Report report;
  return std::move(report.set("rows", rows_report(transform.matrix())));
}

Report place_report(const Vec2& place) {
  Report report;
  return std::move(report.set("x", place.x()).set("y", place.y()));
}

/// A place of the picture as fSpy counts it.
Vec2 fspy_place(const CameraFile& file, const Vec2& place) {
  const Vec2 off = (place - file.camera.image_origin - file.camera.image_size / 2) / fspy_unit(file.camera.image_size);
  return {off.x(), -off.y()};
}

void set_vanishing_points(const CameraFile& file, Report& report) {
  Report points = Report::array(), axes = Report::array();
  for (int axis = 0; axis < 3; ++axis) {
    const Vec3 point = file.camera.vanishing_point(axis);
    const bool finite = std::abs(point.z()) > 1e-12;
    points.push(finite ? place_report(fspy_place(file, point.head<2>() / point.z())) : Report());
    axes.push(std::string(1, axis_letters[axis]) + (point.z() < 0 ? "Negative" : "Positive"));
  }
  report.set("vanishingPoints", std::move(points)).set("vanishingPointAxes", std::move(axes));
}

void set_fspy_members(const CameraFile& file, Report& report) {
  const Camera& camera = file.camera;
  const double relative = camera.focal_length / fspy_unit(camera.image_size);
  const double aspect = camera.image_size.x() / camera.image_size.y();
  Eigen::Affine3d view = Eigen::Affine3d::Identity();
  view.linear() = fspy_axes() * camera.rotation;
  view.translation() = -view.linear() * camera.eye;
  report.set("principalPoint", place_report(fspy_place(file, camera.principal_point)));
  report.set("viewTransform", transform_report(view)).set("cameraTransform", transform_report(view.inverse()));
  report.set("horizontalFieldOfView", 2 * std::atan(1 / relative));
  report.set("verticalFieldOfView", 2 * std::atan(1 / (aspect * relative)));
  set_vanishing_points(file, report);
  report.set("relativeFocalLength", relative);
  report.set("imageWidth", camera.image_size.x()).set("imageHeight", camera.image_size.y());
}

// ---- Reading

class CameraReader {
 public:
  explicit CameraReader(const std::string& file) : file_(file) {}

  CameraFile read(std::string_view bytes) {
    if (bytes.substr(0, fspy_magic.size()) == fspy_magic) return read_project(bytes);
    const Report report = read_json(bytes, file_);
    if (member_of(report, "rotation") != nullptr) return read_own(report);
    if (member_of(report, "cameraParameters") != nullptr) return read_fspy(*member_of(report, "cameraParameters"));
    return read_fspy(report);
  }

 private:
  [[noreturn]] void refuse(const char* code, const std::string& what) const {
    throw Error(make_error(Category::Malformed, code, in_quotes(file_) + ": " + what + ".",
                           {{SubjectKind::File, file_, file_, {}, {}}}));
  }

  double positive(const Report& report, const char* key) const {
    const auto number = number_of(member_of(report, key));
    if (!number || *number <= 0) refuse("E_SYNTAX", std::string(key) + " is not a number above 0");
    return *number;
  }

  template <std::size_t N>
  Eigen::Matrix<double, N, 1> vector(const Report* report, const char* name) const {
    const auto numbers = numbers_of<N>(report);
    if (!numbers) refuse("E_SYNTAX", std::string(name) + " is not a list of " + std::to_string(N) + " numbers");
    return Eigen::Map<const Eigen::Matrix<double, N, 1>>(numbers->data());
  }

  template <std::size_t N>
  Eigen::Matrix<double, N, N> matrix(const Report* report, const char* name) const {
    const auto* rows = report_as<Report::Array>(report);
    if (rows == nullptr || rows->size() != N) {
      refuse("E_SYNTAX", std::string(name) + " is not a list of " + std::to_string(N) + " rows");
    }
    Eigen::Matrix<double, N, N> result;
    for (std::size_t i = 0; i < N; ++i) {
      result.row(static_cast<Eigen::Index>(i)) = vector<N>(&(*rows)[i], name).transpose();
    }
    return result;
  }

  /// The nearest rotation; what isn't nearly one up to a scale is refused.
  Eigen::Matrix3d rotation(const Eigen::Matrix3d& given, const char* name) const {
    const Eigen::JacobiSVD<Eigen::Matrix3d> svd(given, Eigen::ComputeFullU | Eigen::ComputeFullV);
    const auto& sizes = svd.singularValues();
    const bool good = sizes[0] > 0 && sizes[0] - sizes[2] < largest_skew * sizes[0] && given.determinant() > 0;
    if (!good) refuse("E_SYNTAX", std::string(name) + " is not a rotation");
    if ((given * given.transpose() - Eigen::Matrix3d::Identity()).cwiseAbs().maxCoeff() < 1e-14) return given;
    return svd.matrixU() * svd.matrixV().transpose();
  }

  CameraFile read_own(const Report& report) const {
    CameraFile file;
    file.camera.focal_length = positive(report, "focal_length");
    file.camera.principal_point = vector<2>(member_of(report, "principal_point"), "principal_point");
    file.camera.eye = vector<3>(member_of(report, "eye"), "eye");
    file.camera.rotation = rotation(matrix<3>(member_of(report, "rotation"), "rotation"), "rotation");
    file.camera.image_size = vector<2>(member_of(report, "image"), "image");
    if (file.camera.image_size.minCoeff() <= 0) refuse("E_SYNTAX", "image is not two numbers above 0");
    if (member_of(report, "origin") != nullptr)
      file.camera.image_origin = vector<2>(member_of(report, "origin"), "origin");
    const auto mode = number_of(member_of(report, "mode"));
    if (mode && *mode >= 1 && *mode <= 3) file.mode = static_cast<int>(*mode);
    return file;
  }

  CameraFile read_fspy(const Report& report) const {
    const Report* view = member_of(report, "viewTransform");
    const Report* principal = member_of(report, "principalPoint");
    if (view == nullptr || principal == nullptr)
      refuse("E_SYNTAX", "it holds no camera: rotation or viewTransform is missing");
    CameraFile file;
    Camera& camera = file.camera;
    camera.image_size = {positive(report, "imageWidth"), positive(report, "imageHeight")};
    const double unit = fspy_unit(camera.image_size);
    camera.focal_length = unit * relative_focal_length(report);
    const auto x = number_of(member_of(*principal, "x")), y = number_of(member_of(*principal, "y"));
    if (!x || !y) refuse("E_SYNTAX", "principalPoint is not an object with x and y");
    camera.principal_point = camera.image_size / 2 + unit * Vec2(*x, -*y);
    const Eigen::Matrix4d rows = matrix<4>(member_of(*view, "rows"), "viewTransform");
    const Eigen::Matrix3d turn = rotation(rows.topLeftCorner<3, 3>(), "viewTransform");
    camera.rotation = fspy_axes() * turn;
    camera.eye = -turn.transpose() * rows.topRightCorner<3, 1>();
    return file;
  }

  double relative_focal_length(const Report& report) const {
    if (member_of(report, "relativeFocalLength") != nullptr) return positive(report, "relativeFocalLength");
    const double angle = positive(report, "horizontalFieldOfView");
    if (angle >= 3.14) refuse("E_SYNTAX", "horizontalFieldOfView is not an angle below pi");
    return 1 / std::tan(angle / 2);
  }

  CameraFile read_project(std::string_view bytes) const {
    if (bytes.size() < fspy_head) refuse("E_TRUNCATED", "the fSpy project ends within its head of 16 bytes");
    const auto version = load_little_endian<std::uint32_t>(bytes.data() + 4);
    const auto size = load_little_endian<std::uint32_t>(bytes.data() + 8);
    if (version != 1) {
      refuse("E_VERSION",
             "the fSpy project is of version " + std::to_string(version) + ", only 1 can be read: export it as JSON");
    }
    if (bytes.size() - fspy_head < size) {
      refuse("E_TRUNCATED", "the fSpy project ends before its " + std::to_string(size) + " bytes of JSON do");
    }
    const Report report = read_json(bytes.substr(fspy_head, size), file_);
    const Report* camera = member_of(report, "cameraParameters");
    if (camera == nullptr || camera->is_null()) refuse("E_SYNTAX", "the fSpy project has no camera: fSpy found none");
    return read_fspy(*camera);
  }

  std::string file_;
};

}  // namespace

std::string write_camera_json(const CameraFile& file) {
  const Camera& camera = file.camera;
  Report report;
  if (file.mode != 0) report.set("mode", file.mode);
  report.set("focal_length", camera.focal_length).set("principal_point", Report::list(camera.principal_point));
  report.set("eye", Report::list(camera.eye)).set("rotation", rows_report(camera.rotation));
  report.set("image", Report::list(camera.image_size));
  if (camera.image_origin != Vec2::Zero()) report.set("origin", Report::list(camera.image_origin));
  set_fspy_members(file, report);
  return write_json(report);
}

CameraFile read_camera_file(std::string_view bytes, const std::string& file_name) {
  return CameraReader(file_name).read(bytes);
}

}  // namespace croquis
