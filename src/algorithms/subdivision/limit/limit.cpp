// SPDX-License-Identifier: GPL-3.0-or-later
#include "croquis/subdivision/limit.h"

#include <utility>

#include <Eigen/Geometry>

#include "algorithms/subdivision/levels/level_geometry.h"
#include "algorithms/subdivision/limit/limit_rows.h"
#include "croquis/geometry/polygon_area.h"

namespace croquis::subdivision {

struct LimitPlan::State {
  int k;
  HalfEdges topology;
  LimitRows rows;
};

namespace {

/// Tangents closer to one line than this (as the sine of their angle) span no plane.
constexpr double least_normal_sine = 1e-9;

std::vector<Vec3> normals_of(const LimitRows& rows, std::span<const Vec3> positions, int threads) {
  std::vector<Vec3> first(rows.first_tangents.size()), second(rows.second_tangents.size());
  apply(rows.first_tangents, positions, first, threads);
  apply(rows.second_tangents, positions, second, threads);
  for (std::size_t i = 0; i < first.size(); ++i) {
    const Vec3 normal = first[i].cross(second[i]);
    const bool flat = normal.norm() <= least_normal_sine * first[i].norm() * second[i].norm();
    first[i] = flat ? Vec3(Vec3::Zero()) : unit_or_zero(normal);
  }
  return first;
}

}  // namespace

LimitPlan::LimitPlan(const DooSabinPlan& plan, int k, Progress& progress)
    : state_(std::make_shared<const State>(State{k, plan.level(k).topology, doo_sabin_limit(plan, k, progress)})) {}

LimitPlan::LimitPlan(const UniformPlan& plan, int k, Progress& progress)
    : state_(std::make_shared<const State>(State{k, plan.level(k).topology, uniform_limit(plan, k, progress)})) {}

void LimitPlan::evaluate(const PositionBuffers& buffers, LimitSurface& surface, int threads) const {
  const HalfEdges& mesh = state_->topology;
  const std::vector<Vec3>& positions = buffers.levels.at(static_cast<std::size_t>(state_->k));
  const std::vector<Vec3>& weighed = buffers.levels.at(static_cast<std::size_t>(state_->rows.level));
  surface.points.resize(mesh.vertex_count());
  apply(state_->rows.points, weighed, surface.points, threads);
  const std::vector<Vec3> normals = normals_of(state_->rows, weighed, threads);
  surface.corner_normals.resize(mesh.corner_count());
  for (Index face = 0; face < mesh.face_count(); ++face) {
    for (Index corner = mesh.face_offsets[face]; corner < mesh.face_offsets[face + std::size_t{1}]; ++corner) {
      const Index normal = state_->rows.corner_normal[corner];
      const bool known = normal != no_index && normals[normal] != Vec3::Zero();
      surface.corner_normals[corner] = known ? normals[normal] : unit_or_zero(area_normal(positions, mesh.face(face)));
    }
  }
}

const std::vector<std::uint8_t>& LimitPlan::exact() const { return state_->rows.exact; }

}  // namespace croquis::subdivision
