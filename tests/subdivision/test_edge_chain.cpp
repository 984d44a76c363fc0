// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <set>

#include <catch2/catch.hpp>

#include "croquis/subdivision/chain_curve.h"
#include "croquis/subdivision/edge_chain.h"
#include "subdivision/random_tags.h"
#include "subdivision/refined.h"
#include "support/meshes/cages.h"
#include "support/meshes/mesh_shapes.h"

using namespace croquis;
using namespace croquis::subdivision;
using namespace croquis::test;

namespace {

/// A lattice of sharp edges, infinite unless said otherwise, on a torus of quads: vertex (i, j) is i * sides + j.
PolyMesh torus_with(std::span<const VertexPair> edges) { return tagged(torus(12, 8), edges); }

std::vector<Vec3> chain_points(const EdgeChain& chain, const std::vector<Vec3>& points) {
  std::vector<Vec3> result;
  for (const Index v : chain.vertices) result.push_back(points[v]);
  return result;
}

ChainShape first_shape(const Refined& result, int k) {
  const Level& level = result.plan.level(k);
  return chain_shapes(level, edge_chains(level), result.at(k))[0];
}

/// Chaikin's step on a closed polygon.
std::vector<Vec3> chaikin(const std::vector<Vec3>& polygon) {
  std::vector<Vec3> result;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Vec3& a = polygon[i];
    const Vec3& b = polygon[(i + 1) % polygon.size()];
    result.push_back(0.75 * a + 0.25 * b);
    result.push_back(0.25 * a + 0.75 * b);
  }
  return result;
}

double begin_of(const ChainCurve& curve) { return curve.knots[static_cast<std::size_t>(curve.degree)]; }
double end_of(const ChainCurve& curve) { return curve.knots[curve.control_points.size()]; }

std::vector<Vec3> dense(const ChainCurve& curve, int count) {
  std::vector<Vec3> points;
  for (int i = 0; i <= count; ++i) {
    points.push_back(point_at(curve, begin_of(curve) + (end_of(curve) - begin_of(curve)) * i / count));
  }
  return points;
}

PolyMesh skewed(PolyMesh mesh) {
  for (Vec3& p : mesh.positions) p = Vec3(p.x(), p.y() + 0.2 * p.x() * p.x(), p.z() + 0.3 * p.x() * p.y());
  return mesh;
}

}  // namespace

TEST_CASE("A loop is one closed chain from its lowest vertex, in order") {
  const Refined result = refined(bolt_loop(), 3);
  for (int k = 0; k <= 3; ++k) {
    const std::vector<EdgeChain> chains = edge_chains(result.plan.level(k));
    REQUIRE(chains.size() == 1);
    const EdgeChain& chain = chains[0];
    CHECK(chain.closed);
    CHECK(chain.edges.size() == (std::size_t{4} << k));
    CHECK(chain.vertices.size() == chain.edges.size());
    CHECK(chain.vertices[0] == *std::min_element(chain.vertices.begin(), chain.vertices.end()));
    CHECK(chain.vertices[1] < chain.vertices.back());
    const HalfEdges& mesh = result.plan.level(k).topology;
    for (std::size_t i = 0; i < chain.edges.size(); ++i) {
      const Index corner = mesh.edge_corner[chain.edges[i]];
      const std::set<Index> ends = {mesh.corner_vertex[corner], mesh.corner_vertex[mesh.twin[corner]]};
      CHECK(ends == std::set<Index>{chain.vertices[i], chain.vertices[(i + 1) % chain.vertices.size()]});
    }
  }
}

TEST_CASE("Chains end at darts, pins, crossings and the boundary") {
  const Refined open = refined(bolt_open_chain(), 0);
  const std::vector<EdgeChain> single = edge_chains(open.plan.level(0));
  REQUIRE(single.size() == 1);
  CHECK(single[0].vertices == std::vector<Index>{8, 9, 10, 11});
  CHECK(single[0].ends == std::array{ChainEnd::Dart, ChainEnd::Dart});

  PolyMesh pinned = bolt_loop();
  pinned.tags.pins = {9};
  const std::vector<EdgeChain> loop = edge_chains(refined(pinned, 0).plan.level(0));
  REQUIRE(loop.size() == 1);
  CHECK(!loop[0].closed);
  CHECK(loop[0].vertices == std::vector<Index>{9, 8, 11, 10, 9});

  const std::vector<VertexPair> cross = {{9, 17}, {17, 25}, {16, 17}, {17, 18}};
  const std::vector<EdgeChain> four = edge_chains(refined(torus_with(cross), 0).plan.level(0));
  REQUIRE(four.size() == 4);
  for (const EdgeChain& chain : four) CHECK(chain.edges.size() == 1);

  const std::vector<VertexPair> across = {{1, 6}, {6, 11}, {11, 16}};  // a grid of 4 by 3 quads, from rim to rim
  const std::vector<EdgeChain> rim = edge_chains(refined(tagged(grid(4, 3), across), 0).plan.level(0));
  REQUIRE(rim.size() == 1);
  CHECK(rim[0].ends == std::array{ChainEnd::Corner, ChainEnd::Corner});
}

TEST_CASE("Chains can be listed by sharpness") {
  PolyMesh cage = bolt();
  cage.tags.creases = {{{8, 9}, 0.5}, {{9, 10}, 2}, {{10, 11}, infinite_sharpness}};
  const Level level = refined(cage, 0).plan.level(0);
  const std::vector<EdgeChain> sharp = edge_chains(level);
  REQUIRE(sharp.size() == 1);
  CHECK(sharp[0].edges.size() == 2);
  CHECK(sharp[0].least_sharpness == 2);
  CHECK(sharp[0].greatest_sharpness == infinite_sharpness);
  CHECK(edge_chains(level, 0.1)[0].edges.size() == 3);
  CHECK(edge_chains(level, infinite_sharpness)[0].edges.size() == 1);
}

TEST_CASE("The bolt's loop bends by a right angle everywhere and lies in its plane") {
  for (const Preset preset : {Preset::Refined, Preset::Paper}) {
    const Refined result = refined(bolt_loop(), 4, Rules::of(preset));
    for (int k = 0; k <= 4; ++k) {
      const std::vector<EdgeChain> chains = edge_chains(result.plan.level(k));
      const ChainShape shape = chain_shapes(result.plan.level(k), chains, result.at(k))[0];
      CHECK(degrees(shape.least_bend) == Approx(90).margin(1e-9));
      CHECK(degrees(shape.greatest_bend) == Approx(90).margin(1e-9));
      CHECK(shape.planar());
      CHECK(shape.deviation < 1e-15);
      CHECK(std::abs(shape.plane_normal.z()) == Approx(1).margin(1e-12));
    }
  }
}

TEST_CASE("Planar chains stay planar and others say by how much they are not") {
  const Refined flat = refined(skewed(cube_top_loop()), 0);
  const ChainShape saddle = first_shape(flat, 0);
  CHECK(!saddle.planar());
  CHECK(saddle.deviation > 0.2);

  PolyMesh tilted = cube_top_loop();
  for (Vec3& p : tilted.positions) p = Vec3(p.x() + 0.3 * p.z(), p.y(), p.z() + 0.7 * p.x() - 0.2 * p.y());
  const Refined result = refined(tilted, 4);
  for (int k = 0; k <= 4; ++k) {
    const ChainShape shape = first_shape(result, k);
    CHECK(shape.deviation < 1e-14);
  }
}

TEST_CASE("A chain along a line has no plane and no deviation") {
  const std::vector<VertexPair> line = {{6, 7}, {7, 8}};
  const Refined result = refined(tagged(grid(4, 3), line), 0);
  const ChainShape shape = first_shape(result, 0);
  CHECK(shape.plane_normal == Vec3::Zero());
  CHECK(shape.planar());
  CHECK(shape.length == 2);
}

TEST_CASE("Closed chains are Chaikin's polygon of the cage's, and tend to its quadratic B-spline") {
  const PolyMesh cage = skewed(bolt_loop());
  const Refined result = refined(cage, 6);
  std::vector<Vec3> polygon = chain_points(edge_chains(result.plan.level(0))[0], result.at(0));
  const std::vector<ChainCurve> curves = limit_curves(result.plan, result.points, {});
  REQUIRE(curves.size() == 1);
  CHECK(curves[0].exact);
  CHECK(curves[0].control_points.size() == 6);
  const std::vector<Vec3> points = dense(curves[0], 4000);
  for (int k = 1; k <= 6; ++k) {
    polygon = chaikin(polygon);
    const std::vector<Vec3> chain = chain_points(edge_chains(result.plan.level(k))[0], result.at(k));
    REQUIRE(chain.size() == polygon.size());
    CHECK(greatest_gap(chain, polygon) < 1e-14);
  }
  CHECK(greatest_gap(polygon, points) < 1e-3);
  const std::vector<EdgeChain> deep = edge_chains(result.plan.level(6));
  const ChainCurve again = doo_sabin_curve(deep[0], result.at(6), {});
  CHECK(greatest_gap(dense(again, 64), dense(curves[0], 1 << 14)) < 1e-3);
}

TEST_CASE("Chains between corners are clamped, exactly, in the refined preset") {
  PolyMesh cage = skewed(bolt_loop());
  cage.tags.pins = {8};
  const Refined result = refined(cage, 7);
  const ChainCurve curve = limit_curves(result.plan, result.points, {})[0];
  CHECK(curve.exact);
  CHECK((point_at(curve, begin_of(curve)) - cage.positions[8]).norm() < 1e-15);
  CHECK((point_at(curve, end_of(curve)) - cage.positions[8]).norm() < 1e-15);
  const std::vector<Vec3> chain = chain_points(edge_chains(result.plan.level(7))[0], result.at(7));
  CHECK(greatest_gap(chain, dense(curve, 20000)) < 3e-4);
  const EdgeChain deep = edge_chains(result.plan.level(7))[0];
  for (std::size_t i = 1; i + 2 < deep.vertices.size(); i += 16) {
    const Vec3 middle = (chain[i] + chain[i + 1]) / 2;
    CHECK(greatest_gap({&middle, 1}, dense(curve, 20000)) < 3e-4);
  }
}

TEST_CASE("Ends that retract begin in the middle of the first edge") {
  Rules rules;
  rules.chain_ends = ChainEnds::Retract;
  const PolyMesh cage = bolt_open_chain();
  const Refined result = refined(cage, 6, rules);
  const ChainCurve curve = limit_curves(result.plan, result.points, rules)[0];
  CHECK(curve.exact);
  const Vec3 middle = (cage.positions[8] + cage.positions[9]) / 2;
  CHECK((point_at(curve, begin_of(curve)) - middle).norm() < 1e-15);
  const std::vector<Vec3> chain = chain_points(edge_chains(result.plan.level(6))[0], result.at(6));
  CHECK(greatest_gap(chain, dense(curve, 4096)) < 0.05);
  CHECK(greatest_gap(dense(curve, 200), chain) < 0.05);
}

TEST_CASE("A single edge shrinks to its middle, stays between pins, or keeps what it has") {
  PolyMesh cage = tagged(bolt(), std::vector<VertexPair>{{8, 9}});
  Rules rules;
  rules.chain_ends = ChainEnds::Retract;
  const Refined result = refined(cage, 4, rules);
  const ChainCurve shrunk = doo_sabin_curve(edge_chains(result.plan.level(0))[0], result.at(0), rules);
  CHECK(sampled(shrunk, 1e-3).size() == 2);
  CHECK((point_at(shrunk, 0.3) - (cage.positions[8] + cage.positions[9]) / 2).norm() < 1e-15);
  cage.tags.pins = {8, 9};
  const Refined pinned = refined(cage, 0, rules);
  const ChainCurve kept = doo_sabin_curve(edge_chains(pinned.plan.level(0))[0], pinned.at(0), rules);
  CHECK(kept.exact);
  CHECK(greatest_gap(std::vector<Vec3>{cage.positions[8], cage.positions[9]}, sampled(kept, 1e-3)) == 0);
}

TEST_CASE("Under Catmull-Clark chains tend to cubic B-splines, closed, between corners and at ends") {
  PolyMesh pinned = skewed(bolt_loop());
  pinned.tags.pins = {8};
  for (const PolyMesh& cage : {skewed(bolt_loop()), pinned}) {
    for (const UniformScheme scheme : {UniformScheme::CatmullClark, UniformScheme::Loop}) {
      const UniformRefined result = uniformly_refined(cage, 6, {scheme, BoundaryCorners::Corner});
      const std::vector<ChainCurve> curves = limit_curves(result.plan, result.points);
      REQUIRE(curves.size() == 1);
      CHECK(curves[0].exact);
      const std::vector<EdgeChain> deep = edge_chains(result.plan.level(6));
      const std::vector<Vec3> chain = chain_points(deep[0], result.at(6));
      CHECK(greatest_gap(chain, dense(curves[0], 10000)) < 5e-4);
      // Vertices go to (A + 4V + B)/6: at parameters in 64ths.
      const std::vector<Vec3> points = dense(curves[0], 256);
      for (std::size_t i = 8; i + 8 < chain.size(); i += 16) {
        const Vec3 limit = (chain[i - 1] + 4 * chain[i] + chain[i + 1]) / 6;
        CHECK(greatest_gap({&limit, 1}, points) < 1e-13);
      }
    }
  }
  const UniformRefined open = uniformly_refined(bolt_open_chain(), 5);
  const ChainCurve curve = limit_curves(open.plan, open.points)[0];
  CHECK(!curve.exact);
  CHECK(greatest_gap(chain_points(edge_chains(open.plan.level(5))[0], open.at(5)), dense(curve, 2000)) < 0.01);
}

TEST_CASE("Sampled chords stay within the tolerance and samples lie on the curve") {
  const Refined result = refined(skewed(bolt_loop()), 1);
  const ChainCurve quadratic = limit_curves(result.plan, result.points, {})[0];
  const UniformRefined uniform = uniformly_refined(skewed(bolt_loop()), 1);
  const ChainCurve cubic = limit_curves(uniform.plan, uniform.points)[0];
  for (const ChainCurve& curve : {quadratic, cubic}) {
    const std::vector<Vec3> fine = dense(curve, 1 << 14);
    std::size_t last_count = 0;
    for (const double tolerance : {0.1, 0.01, 0.001, 0.0001}) {
      const std::vector<Vec3> points = sampled(curve, tolerance);
      CHECK(points.front() == points.back());
      CHECK(points.size() > last_count);
      last_count = points.size();
      CHECK(greatest_gap(points, fine) < 4e-4);
      double gap = 0;
      for (std::size_t i = 0; i < fine.size(); i += 16) {
        double nearest = 10;
        for (std::size_t j = 1; j < points.size(); ++j) {
          const Vec3 along = points[j] - points[j - 1];
          const double share = std::clamp((fine[i] - points[j - 1]).dot(along) / along.squaredNorm(), 0.0, 1.0);
          nearest = std::min(nearest, (fine[i] - points[j - 1] - share * along).norm());
        }
        gap = std::max(gap, nearest);
      }
      CHECK(gap < tolerance);
      CHECK(gap > tolerance / 40);
    }
  }
}

TEST_CASE("With any tags, chains hold every sharp edge once and pass through crease vertices only") {
  for (std::uint64_t seed = 0; seed < 30; ++seed) {
    Random random(seed);
    for (NamedCage& cage : all_cages()) {
      add_random_tags(cage.mesh, random, false);
      INFO(cage.name << ", seed " << seed);
      const Refined result = refined(cage.mesh, 1);
      for (int k = 0; k <= 1; ++k) {
        const Level& level = result.plan.level(k);
        std::vector<int> at_vertex(level.topology.vertex_count(), 0), seen(level.topology.edge_count(), 0);
        std::size_t sharp_edges = 0, chain_edges = 0;
        for (const SharpEdge& sharp : level.sharp) {
          if (sharp.sharpness < 1) continue;
          ++sharp_edges;
          const Index corner = level.topology.edge_corner[sharp.edge];
          ++at_vertex[level.topology.corner_vertex[corner]];
          ++at_vertex[level.topology.corner_vertex[level.topology.twin[corner]]];
        }
        const std::vector<EdgeChain> chains = edge_chains(level);
        for (const EdgeChain& chain : chains) {
          chain_edges += chain.edges.size();
          for (const Index edge : chain.edges) REQUIRE(++seen[edge] == 1);
          REQUIRE(chain.vertices.size() == chain.edges.size() + (chain.closed ? 0 : 1));
          const std::size_t inner_end = chain.closed ? chain.vertices.size() : chain.vertices.size() - 1;
          for (std::size_t i = chain.closed ? 0 : 1; i < inner_end; ++i) REQUIRE(at_vertex[chain.vertices[i]] == 2);
          if (!chain.closed && chain.ends[0] == ChainEnd::Dart) REQUIRE(at_vertex[chain.vertices[0]] == 1);
        }
        REQUIRE(chain_edges == sharp_edges);
        for (const ChainShape& shape : chain_shapes(level, chains, result.at(k))) {
          REQUIRE(shape.length > 0);
          REQUIRE(shape.least_bend <= shape.greatest_bend);
        }
      }
      for (const ChainCurve& curve : limit_curves(result.plan, result.points, {})) {
        for (const Vec3& p : sampled(curve, 0.01)) REQUIRE(p.norm() < 2 * extent(cage.mesh.positions) + 20);
      }
    }
  }
}
