// SPDX-License-Identifier: GPL-3.0-or-later
#include "support/scans/sculptures.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <stdexcept>
#include <vector>

#include <Eigen/Dense>

#include "croquis/base/progress.h"
#include "croquis/implicit/marching_cubes.h"
#include "croquis/implicit/surface_improvement.h"
#include "support/difference_field.h"
#include "support/scans/surface_smoothing.h"
#include "support/scans/virtual_scans.h"

namespace croquis::test {
namespace {

constexpr double reach = 3;             // everything lies within this of the origin
constexpr double trial_cell = 0.05;     // of the mesh whose triangles tell how many a cell gives
constexpr double gradient_step = 1e-5;  // units

using Solid = std::function<double(const Vec3&)>;

/// Where the way from a place outside to one inside enters the solid.
Vec3 entry(Vec3 outside, Vec3 inside, const Solid& solid) {
  for (int i = 0; i < 30; ++i) {
    const Vec3 middle = (outside + inside) / 2;
    (solid(middle) < 0 ? inside : outside) = middle;
  }
  return inside;
}

/// A place on the surface: where a line through the solid enters it.
Vec3 place_on(const Solid& solid) {
  constexpr double step = 0.01;
  for (const double z : {0.0, -0.3, 0.3, -0.6, 0.6}) {
    for (const double y : {0.0, -0.25, 0.25, -0.5, 0.5}) {
      for (double x = -reach; x < reach; x += step) {
        if (solid({x, y, z}) < 0) return entry({x - step, y, z}, {x, y, z}, solid);
      }
    }
  }
  throw std::logic_error("no line meets the solid");
}

Solid solid_of(Sculpture sculpture) {
  return [sculpture](const Vec3& p) { return field_value(sculpture, p); };
}

PolyMesh cubes(const Vec3& seed, const implicit::Field& field, double cell) {
  implicit::PolygonizerOptions options;
  options.cell = cell;
  options.origin = Vec3(-0.0137, 0.0071, 0.0113);  // no plane of a machined piece lies in the lattice
  options.bounds = {Vec3::Constant(-reach), Vec3::Constant(reach)};
  Progress progress;
  return implicit::polygonize(field, std::span(&seed, 1), options, progress).mesh;
}

/// Where the planes of the triangles around a vertex meet, as far as they fix it: one plane moves it to that plane, two
/// to their line, three to their corner.
class PlaneMeeting {
 public:
  void add(const Vec3& place, const Vec3& normal) {
    squares_ += normal * normal.transpose();
    offsets_ += normal * normal.dot(place);
    middle_ += place;
    ++count_;
  }

  Vec3 solve(double furthest) const {
    constexpr double least_share = 0.03;  // of the greatest eigenvalue: about 20 degrees between planes
    const Vec3 middle = middle_ / count_;
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(squares_);
    const Vec3 error = offsets_ - squares_ * middle;
    Vec3 move = Vec3::Zero();
    for (int i = 0; i < 3; ++i) {
      const double value = solver.eigenvalues()[i];
      if (value < least_share * solver.eigenvalues()[2]) continue;
      const Vec3 axis = solver.eigenvectors().col(i);
      move += axis * (axis.dot(error) / value);
    }
    return move.norm() > furthest ? middle : Vec3(middle + move);
  }

 private:
  Eigen::Matrix3d squares_ = Eigen::Matrix3d::Zero();
  Vec3 offsets_ = Vec3::Zero(), middle_ = Vec3::Zero();
  double count_ = 0;
};

class FacesOfVertices {
 public:
  explicit FacesOfVertices(const PolyMesh& mesh) : ends_(mesh.vertex_count() + 1, 0), faces_(mesh.corners.size()) {
    for (const Index v : mesh.corners) ++ends_[v];
    for (std::size_t v = 1; v < ends_.size(); ++v) ends_[v] += ends_[v - 1];
    for (auto f = static_cast<Index>(mesh.face_count()); f-- > 0;) {
      for (const Index v : mesh.face(f)) faces_[--ends_[v]] = f;
    }
  }

  std::span<const Index> of(Index v) const { return {faces_.data() + ends_[v], faces_.data() + ends_[v + 1]}; }

 private:
  std::vector<std::size_t> ends_;  // once all are placed, the beginnings
  std::vector<Index> faces_;
};

/// Whether a triangle looks about where the surface does, and isn't too thin to tell.
bool lies_right(const PolyMesh& mesh, Index face, const Vec3& surface_normal) {
  constexpr double least_cosine = 0.5;
  constexpr double least_height = 0.1;  // × longest edge
  const auto t = mesh.face(face);
  const Vec3 ab = mesh.positions[t[1]] - mesh.positions[t[0]], ac = mesh.positions[t[2]] - mesh.positions[t[0]];
  const Vec3 normal = ab.cross(ac);
  const double longest = std::max({ab.squaredNorm(), ac.squaredNorm(), (ac - ab).squaredNorm()});
  return normal.norm() > least_height * longest &&
         normal.dot(surface_normal) > least_cosine * normal.norm() * surface_normal.norm();
}

/// Ohtake, Belyaev 2002: middles of triangles go onto the surface, and vertices to where the planes there meet.
void sharpen(PolyMesh& mesh, const implicit::Field& field, double cell) {
  std::vector<Vec3> middles, normals(mesh.face_count());
  for (std::size_t f = 0; f < mesh.face_count(); ++f) {
    const auto t = mesh.face(f);
    middles.emplace_back((mesh.positions[t[0]] + mesh.positions[t[1]] + mesh.positions[t[2]]) / 3);
  }
  implicit::ProjectionOptions options;
  options.cell = cell;
  implicit::project(middles, {}, field, options);
  std::vector<double> values(middles.size());
  field(middles, values, normals);
  std::vector<PlaneMeeting> meetings(mesh.vertex_count());
  for (std::size_t f = 0; f < mesh.face_count(); ++f) {
    for (const Index v : mesh.face(f)) meetings[v].add(middles[f], normals[f].normalized());
  }
  const FacesOfVertices around(mesh);
  for (Index v = 0; v < mesh.vertex_count(); ++v) {
    const Vec3 from = mesh.positions[v], move = meetings[v].solve(1.5 * cell) - from;
    for (const double share : {1.0, 0.5, 0.25, 0.0}) {
      mesh.positions[v] = from + share * move;
      const auto faces = around.of(v);
      if (std::all_of(faces.begin(), faces.end(), [&](Index f) { return lies_right(mesh, f, normals[f]); })) break;
    }
  }
}

}  // namespace

const char* name_of(Sculpture sculpture) {
  constexpr std::array names = {"beast", "head",   "hand",  "mug",     "knot",
                                "coral", "armour", "shell", "bracket", "housing"};
  return names[static_cast<std::size_t>(sculpture)];
}

bool is_machined(Sculpture sculpture) { return sculpture == Sculpture::Bracket || sculpture == Sculpture::Housing; }

PolyMesh sculpt(Sculpture sculpture, std::size_t triangles) {
  return sculpt(solid_of(sculpture), triangles, is_machined(sculpture));
}

PolyMesh sculpt(const Solid& solid, std::size_t triangles, bool is_sharp) {
  const implicit::Field field = field_of(solid, gradient_step);
  const Vec3 seed = place_on(solid);
  const auto trial = static_cast<double>(cubes(seed, field, trial_cell).face_count());
  implicit::ProjectionOptions projection;
  projection.cell = trial_cell * std::sqrt(trial / static_cast<double>(triangles));
  projection.accuracy = 1e-4;
  PolyMesh mesh = cubes(seed, field, projection.cell);
  smooth_on_surface(mesh, field, 2, projection);
  if (!is_sharp) return mesh;
  const double cell = mean_edge_of(mesh);
  for (int round = 0; round < 3; ++round) sharpen(mesh, field, cell);
  return mesh;
}

void bring_onto(const Solid& solid, std::vector<Vec3>& points, double cell) {
  implicit::ProjectionOptions options;
  options.cell = cell;
  options.accuracy = 1e-4;
  implicit::project(points, {}, field_of(solid, gradient_step), options);
}

}  // namespace croquis::test
