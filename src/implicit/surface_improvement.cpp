// SPDX-License-Identifier: GPL-3.0-or-later
#include "croquis/implicit/surface_improvement.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "croquis/base/error.h"
#include "croquis/base/parallel.h"
#include "implicit/point_checks.h"

namespace croquis::implicit {
namespace {

constexpr std::size_t points_per_part = 256;  // points that move together

void require_triangles(const PolyMesh& mesh) {
  for (std::size_t f = 0; f < mesh.face_count(); ++f) {
    if (mesh.face(f).size() == 3) continue;
    throw Error(make_error(Category::Geometry, "E_NOT_TRIANGLES",
                           "Face " + std::to_string(f) + " has " + std::to_string(mesh.face(f).size()) +
                               " corners, where triangles are needed: triangulate the mesh.",
                           {numbered_subject(SubjectKind::Face, f)}));
  }
}

void require_marks(std::span<const std::uint8_t> fixed, std::size_t count) {
  if (fixed.empty() || fixed.size() == count) return;
  throw Error(make_error(Category::Internal, "E_COUNT",
                         "There are " + std::to_string(count) + " points but " + std::to_string(fixed.size()) +
                             " marks of fixed ones: give one for every point, or none."));
}

/// What a projection needs to remember of one point.
struct Moving {
  std::size_t index;
  Vec3 start;
};

/// Brings a few points onto the surface, those that still move at once.
class Projection {
 public:
  Projection(std::span<Vec3> points, const Field& field, const ProjectionOptions& options)
      : points_(points), field_(field), options_(options) {}

  void run(std::vector<Moving> moving) {
    const std::vector<Moving> all = moving;
    for (int i = 0; i < options_.iterations && !moving.empty(); ++i) step(moving);
    report.moved = all.size();
    report.not_converged += moving.size();
    for (const Moving& point : all)
      report.largest_move = std::max(report.largest_move, (points_[point.index] - point.start).norm());
  }

  ProjectionReport report;

 private:
  void step(std::vector<Moving>& moving);
  Vec3 move_of(double value, const Vec3& gradient) const;

  std::span<Vec3> points_;
  const Field& field_;
  const ProjectionOptions& options_;
};

/// - F g / max(|g|^2, least^2), no longer than the step allowed.
Vec3 Projection::move_of(double value, const Vec3& gradient) const {
  const double least = options_.least_gradient * options_.least_gradient;
  const Vec3 move = -value / std::max(gradient.squaredNorm(), least) * gradient;
  const double length = move.norm();
  const double longest = options_.longest_step * options_.cell;
  return length > longest ? Vec3(longest / length * move) : move;
}

void Projection::step(std::vector<Moving>& moving) {
  std::array<Vec3, points_per_part> places, gradients;
  std::array<double, points_per_part> values;
  for (std::size_t i = 0; i < moving.size(); ++i) places[i] = points_[moving[i].index];
  field_({places.data(), moving.size()}, {values.data(), moving.size()}, {gradients.data(), moving.size()});
  std::vector<Moving> still;
  for (std::size_t i = 0; i < moving.size(); ++i) {
    const Vec3 move = move_of(values[i], gradients[i]);
    if (!move.allFinite()) {  // no value here: the point stays where it is
      ++report.not_converged;
      continue;
    }
    points_[moving[i].index] += move;
    if (move.norm() >= options_.accuracy * options_.cell) still.push_back(moving[i]);
  }
  moving = std::move(still);
}

}  // namespace

ProjectionReport project(std::span<Vec3> points, std::span<const std::uint8_t> fixed, const Field& field,
                         const ProjectionOptions& options) {
  require_parameter(std::isfinite(options.cell) && options.cell > 0, "cell", "the scale of steps must be positive");
  require_marks(fixed, points.size());
  std::vector<ProjectionReport> parts((points.size() + points_per_part - 1) / points_per_part);
  Progress silent;
  for_each_part(points.size(), points_per_part, options.threads, silent, [&](std::size_t begin, std::size_t end) {
    std::vector<Moving> moving;
    for (std::size_t i = begin; i < end; ++i)
      if (fixed.empty() || fixed[i] == 0) moving.push_back({i, points[i]});
    Projection projection(points, field, options);
    projection.run(std::move(moving));
    parts[begin / points_per_part] = projection.report;
  });
  ProjectionReport whole;
  for (const ProjectionReport& part : parts) {
    whole.moved += part.moved;
    whole.not_converged += part.not_converged;
    whole.largest_move = std::max(whole.largest_move, part.largest_move);
  }
  return whole;
}

PolyMesh split_in_four(const PolyMesh& mesh) {
  require_triangles(mesh);
  struct Side {
    Index low, high;
    std::size_t corner;
  };
  std::vector<Side> sides;
  for (std::size_t c = 0; c < mesh.corners.size(); ++c) {
    const Index a = mesh.corners[c];
    const Index b = mesh.corners[c % 3 == 2 ? c - 2 : c + 1];
    sides.push_back({std::min(a, b), std::max(a, b), c});
  }
  std::sort(sides.begin(), sides.end(), [](const Side& a, const Side& b) {
    return std::array{a.low, a.high} != std::array{b.low, b.high}
               ? std::array{a.low, a.high} < std::array{b.low, b.high}
               : a.corner < b.corner;
  });
  PolyMesh fine;
  fine.positions = mesh.positions;
  std::vector<Index> middle(mesh.corners.size());
  for (std::size_t i = 0; i < sides.size(); ++i) {
    const bool again = i > 0 && sides[i].low == sides[i - 1].low && sides[i].high == sides[i - 1].high;
    if (!again) fine.positions.push_back(0.5 * (mesh.positions[sides[i].low] + mesh.positions[sides[i].high]));
    middle[sides[i].corner] = static_cast<Index>(fine.positions.size() - 1);
  }
  for (std::size_t c = 0; c < mesh.corners.size(); c += 3) {
    const std::array m = {middle[c], middle[c + 1], middle[c + 2]};
    fine.add_triangle(mesh.corners[c], m[0], m[2]);
    fine.add_triangle(m[0], mesh.corners[c + 1], m[1]);
    fine.add_triangle(m[2], m[1], mesh.corners[c + 2]);
    fine.add_triangle(m[0], m[1], m[2]);
  }
  return fine;
}

}  // namespace croquis::implicit
