// SPDX-License-Identifier: GPL-3.0-or-later
#include "support/scans/depth_image.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include <Eigen/Geometry>

namespace croquis::test {
namespace {

constexpr double nothing = -std::numeric_limits<double>::infinity();
constexpr double longest_edge = 4;  // × spacing

}  // namespace

DepthImage::DepthImage(const PolyMesh& mesh, const Vec3& towards, double spacing) : spacing_(spacing) {
  const Vec3 right = towards.unitOrthogonal();
  axes_ = {right, towards.normalized().cross(right), towards.normalized()};
  const double far = std::numeric_limits<double>::infinity();
  Vec3 low = Vec3::Constant(far), high = -low;
  for (const Vec3& p : mesh.positions) {
    const Vec3 q = in_view(p);
    low = low.cwiseMin(q);
    high = high.cwiseMax(q);
  }
  corner_ = Vec3(low.x() * spacing, low.y() * spacing, 0);
  columns_ = static_cast<Index>(high.x() - low.x()) + 2;
  rows_ = static_cast<Index>(high.y() - low.y()) + 2;
  depth_.assign(std::size_t{columns_} * rows_, nothing);
  for (std::size_t f = 0; f < mesh.face_count(); ++f) {
    const auto t = mesh.face(f);
    draw(in_view(mesh.positions[t[0]]), in_view(mesh.positions[t[1]]), in_view(mesh.positions[t[2]]));
  }
}

Vec3 DepthImage::in_view(const Vec3& point) const {
  return {(axes_[0].dot(point) - corner_.x()) / spacing_, (axes_[1].dot(point) - corner_.y()) / spacing_,
          axes_[2].dot(point)};
}

void DepthImage::draw(const Vec3& a, const Vec3& b, const Vec3& c) {
  const auto cross = [](const Vec3& p, const Vec3& q, double x, double y) {
    return (q.x() - p.x()) * (y - p.y()) - (q.y() - p.y()) * (x - p.x());
  };
  const double area = cross(a, b, c.x(), c.y());
  if (area == 0) return;
  const auto first = [](double low) { return static_cast<Index>(std::max(0.0, std::ceil(low))); };
  const auto last = [](double high, Index count) {
    return static_cast<Index>(std::clamp(std::floor(high) + 1, 0.0, static_cast<double>(count)));
  };
  for (Index row = first(std::min({a.y(), b.y(), c.y()})); row < last(std::max({a.y(), b.y(), c.y()}), rows_); ++row) {
    for (Index column = first(std::min({a.x(), b.x(), c.x()}));
         column < last(std::max({a.x(), b.x(), c.x()}), columns_); ++column) {
      const double u = cross(b, c, column, row) / area, v = cross(c, a, column, row) / area;
      if (u < 0 || v < 0 || u + v > 1) continue;
      double& depth = depth_[node(column, row)];
      depth = std::max(depth, u * a.z() + v * b.z() + (1 - u - v) * c.z());
    }
  }
}

bool DepthImage::shows(const Vec3& point, double slack) const {
  const Vec3 q = in_view(point);
  const auto column = static_cast<Index>(std::clamp(std::round(q.x()), 0.0, columns_ - 1.0));
  const auto row = static_cast<Index>(std::clamp(std::round(q.y()), 0.0, rows_ - 1.0));
  return depth_[node(column, row)] <= q.z() + slack;
}

PolyMesh DepthImage::surface() const {
  PolyMesh mesh;
  std::vector<Index> vertex(depth_.size(), no_index);
  for (Index row = 0; row < rows_; ++row) {
    for (Index column = 0; column < columns_; ++column) {
      const double depth = depth_[node(column, row)];
      if (depth == nothing) continue;
      vertex[node(column, row)] = static_cast<Index>(mesh.positions.size());
      mesh.positions.emplace_back((corner_.x() + column * spacing_) * axes_[0] +
                                  (corner_.y() + row * spacing_) * axes_[1] + depth * axes_[2]);
    }
  }
  const auto add = [&](std::size_t a, std::size_t b, std::size_t c) {
    const std::array<Index, 3> t = {vertex[a], vertex[b], vertex[c]};
    for (std::size_t i = 0; i < 3; ++i) {
      if (t[i] == no_index || t[(i + 1) % 3] == no_index) return;
      if ((mesh.positions[t[i]] - mesh.positions[t[(i + 1) % 3]]).norm() > longest_edge * spacing_) return;
    }
    mesh.add_triangle(t[0], t[1], t[2]);
  };
  for (Index row = 0; row + 1 < rows_; ++row) {
    for (Index column = 0; column + 1 < columns_; ++column) {
      add(node(column, row), node(column + 1, row), node(column + 1, row + 1));
      add(node(column, row), node(column + 1, row + 1), node(column, row + 1));
    }
  }
  return mesh;
}

}  // namespace croquis::test
