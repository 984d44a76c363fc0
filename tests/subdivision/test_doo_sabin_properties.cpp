// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cstddef>
#include <vector>

#include <Eigen/Geometry>
#include <catch2/catch.hpp>

#include "croquis/geometry/mesh_topology.h"
#include "croquis/subdivision/level_mesh.h"
#include "subdivision/random_tags.h"
#include "subdivision/subdivided.h"
#include "support/meshes/cages.h"
#include "support/meshes/mesh_shapes.h"
#include "support/random.h"
#include "support/sample_count.h"

namespace croquis::test {
namespace {

using subdivision::HalfEdges;
using subdivision::Rules;

constexpr int levels = 3;
constexpr double tolerance = 1e-10;  // relative to the size of the cages, a few units

struct Configuration {
  std::string name;
  PolyMesh mesh;
  Rules rules;
  bool all_infinite;
};

Configuration configuration(std::uint64_t seed) {
  static const std::vector<NamedCage> cages = all_cages();
  Random random(seed);
  const NamedCage& cage = cages[seed % cages.size()];
  Configuration result{cage.name + ", seed " + std::to_string(seed), cage.mesh, random_rules(random),
                       random.below(2) == 0};
  for (Vec3& point : result.mesh.positions) {
    point += 0.2 * Vec3(random.unit() - 0.5, random.unit() - 0.5, random.unit() - 0.5);
  }
  add_random_tags(result.mesh, random, result.all_infinite);
  return result;
}

std::ptrdiff_t euler_number(const HalfEdges& mesh) {
  const auto [v, e, f] = counts(mesh);
  return static_cast<std::ptrdiff_t>(v + f) - static_cast<std::ptrdiff_t>(e);
}

std::size_t boundary_loop_count(const subdivision::Level& level) {
  return MeshTopology(to_mesh(level, std::vector<Vec3>(level.topology.vertex_count(), Vec3::Zero())))
      .boundary_loops()
      .size();
}

std::size_t largest_face(const HalfEdges& mesh) { return faces_by_size(mesh).rbegin()->first; }

std::size_t largest_valence(const HalfEdges& mesh) {
  std::vector<std::size_t> valence(mesh.vertex_count(), 0);
  for (const Index v : mesh.corner_vertex) ++valence[v];
  return *std::max_element(valence.begin(), valence.end());
}

void check_weights(const Subdivided& result, int k) {
  const auto weights = result.plan.weights(k);
  const Eigen::VectorXd sums = weights * Eigen::VectorXd::Ones(weights.cols());
  CHECK((sums.array() - 1).abs().maxCoeff() < 1e-14);
  double lowest = 0;
  for (Eigen::Index i = 0; i < weights.nonZeros(); ++i) lowest = std::min(lowest, weights.valuePtr()[i]);
  CHECK(lowest >= 0);
  double worst = 0;
  for (int row = 0; row < weights.rows(); ++row) {
    Vec3 point = Vec3::Zero();
    for (decltype(weights)::InnerIterator entry(weights, row); entry; ++entry) {
      point += entry.value() * result.points(k - 1)[static_cast<std::size_t>(entry.col())];
    }
    worst = std::max(worst, (point - result.points(k)[static_cast<std::size_t>(row)]).norm());
  }
  CHECK(worst < tolerance);
}

TEST_CASE("any tags on any cage give sound levels with convex weights") {
  const int configurations = sample_count(300, 5000);
  for (int i = 0; i < configurations; ++i) {
    const Configuration config = configuration(static_cast<std::uint64_t>(i));
    INFO(config.name);
    const Subdivided result = subdivide(config.mesh, levels, config.rules);
    const HalfEdges& cage = result.topology(0);
    std::size_t bound = std::max({largest_face(cage), largest_valence(cage) + 1, std::size_t{6}});
    for (int k = 0; k <= levels; ++k) {
      INFO("level " << k);
      REQUIRE(fault(result.topology(k)) == "");
      CHECK(euler_number(result.topology(k)) == euler_number(cage));
      CHECK(boundary_loop_count(result.plan.level(k)) == boundary_loop_count(result.plan.level(0)));
      CHECK(largest_face(result.topology(k)) <= bound);
      // Where finite sharpness fades at a corner of the surface, the fan it grew becomes one face.
      if (!config.all_infinite) bound = std::max(bound, largest_valence(result.topology(k)) + 1);
      if (k > 0) check_weights(result, k);
      if (k > 1 && config.all_infinite) CHECK_FALSE(result.plan.banded(k));
    }
  }
}

TEST_CASE("levels don't depend on the order of the faces") {
  const int configurations = sample_count(60, 1000);
  for (int i = 0; i < configurations; ++i) {
    const Configuration config = configuration(static_cast<std::uint64_t>(10000 + i));
    INFO(config.name);
    Random random(static_cast<std::uint64_t>(i));
    const Subdivided result = subdivide(config.mesh, levels, config.rules);
    const Subdivided shuffled = subdivide(with_faces_shuffled(config.mesh, random), levels, config.rules);
    for (int k = 1; k <= levels; ++k) {
      CHECK(counts(result.topology(k)) == counts(shuffled.topology(k)));
      CHECK(faces_by_size(result.topology(k)) == faces_by_size(shuffled.topology(k)));
      CHECK(same_points(result.points(k), shuffled.points(k), tolerance));
    }
  }
}

TEST_CASE("levels move with the cage") {
  const int configurations = sample_count(60, 1000);
  const Eigen::Affine3d motion =
      Eigen::Translation3d(0.7, -1.3, 2.1) * Eigen::AngleAxisd(1.1, Vec3(1, 2, -1).normalized());
  for (int i = 0; i < configurations; ++i) {
    const Configuration config = configuration(static_cast<std::uint64_t>(20000 + i));
    INFO(config.name);
    Subdivided result = subdivide(config.mesh, levels, config.rules);
    std::vector<Vec3> moved;
    for (const Vec3& point : result.cage.positions) moved.push_back(motion * point);
    subdivision::PositionBuffers buffers;
    result.plan.positions(moved, buffers);
    for (std::size_t k = 0; k < buffers.levels.size(); ++k) {
      double worst = 0;
      for (std::size_t v = 0; v < buffers.levels[k].size(); ++v) {
        worst = std::max(worst, (buffers.levels[k][v] - motion * result.buffers.levels[k][v]).norm());
      }
      CHECK(worst < tolerance);
    }
  }
}

TEST_CASE("a chain is what Chaikin makes of its polyline") {
  PolyMesh mesh = torus(7, 6);
  std::vector<VertexPair> edges;
  Random random(4);
  for (Vec3& point : mesh.positions) point += 0.1 * Vec3(random.unit(), random.unit(), random.unit());
  std::vector<Vec3> polyline;
  for (Index i = 0; i < 7; ++i) {
    edges.push_back({i * 6, (i + 1) % 7 * 6});
    polyline.push_back(mesh.positions[i * 6]);
  }
  const Subdivided result = subdivide(tagged(mesh, edges), 4);
  for (int k = 1; k <= 4; ++k) {
    std::vector<Vec3> finer;
    for (std::size_t i = 0; i < polyline.size(); ++i) {
      const Vec3 &a = polyline[i], &b = polyline[(i + 1) % polyline.size()];
      finer.push_back(0.75 * a + 0.25 * b);
      finer.push_back(0.25 * a + 0.75 * b);
    }
    polyline = finer;
    std::vector<Vec3> chain;
    for (const Index v : tagged_vertices(result.plan.level(k))) chain.push_back(result.points(k)[v]);
    CHECK(same_points(chain, polyline, tolerance));
  }
}

}  // namespace
}  // namespace croquis::test
