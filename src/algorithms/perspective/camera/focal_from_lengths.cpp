// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/perspective/camera/focal_from_lengths.h"

#include <algorithm>
#include <cmath>

#include <Eigen/Geometry>
#include <Eigen/LU>

namespace croquis {

std::optional<double> focal_from_lengths(const PerspectiveDrawing& drawing, const DrawingVertices& vertices,
                                         const VertexCoordinates& coordinates) {
  constexpr double least_rank = 1e-9;
  Eigen::Matrix2d matrix = Eigen::Matrix2d::Zero();
  Vec2 right = Vec2::Zero();
  for (const KnownLength& known : drawing.known_lengths) {
    for (std::size_t s = 0; s < drawing.strokes.size(); ++s) {
      const auto [a, b] = vertices.of_stroke[s];
      if (drawing.strokes[s].id != known.stroke || a == no_index || b == no_index) continue;
      if (!drawing.strokes[s].straight || coordinates.component[a] != coordinates.component[b]) continue;
      const Vec3 span = coordinates.camera.rotation * (coordinates.positions[b] - coordinates.positions[a]);
      // Relative lengths count alike.
      const Vec2 row = Vec2(span.head<2>().squaredNorm(), span.z() * span.z()) / (known.length * known.length);
      matrix += row * row.transpose();
      right += row;
    }
  }
  const double determinant = matrix.determinant();
  if (!(determinant > least_rank * matrix(0, 0) * matrix(1, 1))) return std::nullopt;
  const Vec2 squares = matrix.inverse() * right;  // of the scales across and along the view
  if (!(squares.minCoeff() > 0)) return std::nullopt;
  return coordinates.camera.focal_length * std::sqrt(squares.y() / squares.x());
}

}  // namespace croquis
