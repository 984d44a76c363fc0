// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/subdivision/levels/level_positions.h"

#include <algorithm>
#include <vector>

#include "croquis/base/parallel.h"

namespace croquis::subdivision {
namespace {

/// Faces, and rows of weights, from which a further thread is worth starting.
constexpr std::size_t least_faces = 4096;
constexpr std::size_t least_rows = 8192;

/// Points of faces whose corners all have their own lie behind one another; the others go through the new numbers.
class FacePoints {
 public:
  FacePoints(const HalfEdges& old, const Refinement& made, const FaceMask& mask, const Vec3* from, Vec3* to)
      : old_(old), made_(made), mask_(mask), from_(from), to_(to) {}

  void compute(std::size_t begin, std::size_t end) const {
    const auto& gaps = made_.rules.gap_faces;
    auto gap = std::lower_bound(gaps.begin(), gaps.end(), begin);
    for (std::size_t face = begin; face < end;) {
      const std::size_t run_end = gap != gaps.end() && *gap < end ? *gap : end;
      compute_run(face, run_end);
      if (run_end == end) return;
      compute_gap_face(*gap++);
      face = run_end + 1;
    }
  }

 private:
  void compute_run(std::size_t begin, std::size_t end) const {
    if (begin == end) return;
    Vec3* result = to_ + made_.level.topology.corner_vertex[old_.face_offsets[begin]];
    for (std::size_t face = begin; face < end; ++face) {
      const auto corners = old_.face(face);
      mask_.apply(from_, corners, result);
      result += corners.size();
    }
  }

  void compute_gap_face(std::size_t face) const {
    const auto corners = old_.face(face);
    std::vector<Vec3> result(corners.size());
    mask_.apply(from_, corners, result.data());
    const Index* points = made_.level.topology.corner_vertex.data() + old_.face_offsets[face];
    for (std::size_t i = 0; i < corners.size(); ++i) {
      if (points[i] < made_.origins.own_corners.kept_count()) to_[points[i]] = result[i];
    }
  }

  const HalfEdges& old_;
  const Refinement& made_;
  const FaceMask& mask_;
  const Vec3* from_;
  Vec3* to_;
};

Vec3 weighted_sum(const WeightRows& rows, std::size_t row, const Vec3* points) {
  Vec3 sum = Vec3::Zero();
  for (Index i = rows.offsets[row]; i < rows.offsets[row + 1]; ++i) sum += rows.weights[i] * points[rows.columns[i]];
  return sum;
}

}  // namespace

void compute_positions(const HalfEdges& old, const Refinement& made, const FaceMask& mask, const Vec3* old_points,
                       Vec3* points, int threads) {
  const FacePoints faces(old, made, mask, old_points, points);
  for_each_part(old.face_count(), even_grain(old.face_count(), threads, least_faces), threads,
                [&](std::size_t begin, std::size_t end) { faces.compute(begin, end); });

  const PointRules& rules = made.rules;
  const auto& number_of_corner = made.level.topology.corner_vertex;
  for_each_part(rules.adjusted.size(), even_grain(rules.adjusted.size(), threads, least_rows), threads,
                [&](std::size_t begin, std::size_t end) {
                  for (std::size_t row = begin; row < end; ++row) {
                    Vec3& point = points[number_of_corner[rules.adjusted_corner[row]]];
                    point = rules.plain_share[row] * point + weighted_sum(rules.adjusted, row, old_points);
                  }
                });
  Vec3* listed = points + made.origins.own_corners.kept_count();
  for_each_part(rules.listed.size(), even_grain(rules.listed.size(), threads, least_rows), threads,
                [&](std::size_t begin, std::size_t end) {
                  for (std::size_t row = begin; row < end; ++row)
                    listed[row] = weighted_sum(rules.listed, row, old_points);
                });
}

}  // namespace croquis::subdivision
