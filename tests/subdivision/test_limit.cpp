// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <set>

#include <Eigen/Geometry>
#include <catch2/catch.hpp>

#include "croquis/subdivision/limit.h"
#include "subdivision/random_tags.h"
#include "subdivision/refined.h"
#include "support/meshes/cages.h"
#include "support/meshes/mesh_shapes.h"

using namespace croquis;
using namespace croquis::subdivision;
using namespace croquis::test;

namespace {

template <typename Result>
LimitSurface limit_of(const Result& result, int k, std::vector<std::uint8_t>* exact = nullptr) {
  Progress progress;
  const LimitPlan plan(result.plan, k, progress);
  LimitSurface surface;
  plan.evaluate(result.points, surface);
  if (exact != nullptr) *exact = plan.exact();
  return surface;
}

Vec3 unit_normal(const HalfEdges& mesh, const std::vector<Vec3>& points, Index face) {
  const auto corners = mesh.face(face);
  Vec3 sum = Vec3::Zero();
  for (std::size_t i = 1; i + 1 < corners.size(); ++i) {
    sum += (points[corners[i]] - points[corners[0]]).cross(points[corners[i + 1]] - points[corners[0]]);
  }
  return sum.normalized();
}

Vec3 centre(const HalfEdges& mesh, const std::vector<Vec3>& points, Index face) {
  Vec3 sum = Vec3::Zero();
  for (const Index v : mesh.face(face)) sum += points[v];
  return sum / static_cast<double>(mesh.face(face).size());
}

/// The face of level k that descends from a face of level `from` by staying that face.
Index descendant(const DooSabinPlan& plan, int from, Index face, int k) {
  for (int level = from + 1; level <= k; ++level) {
    for (Index f = 0; f < plan.level(level).topology.face_count(); ++f) {
      if (plan.face_origin(level, f) == FaceOrigin{FaceKind::Face, face}) {
        face = f;
        break;
      }
    }
  }
  return face;
}

double angle(const Vec3& a, const Vec3& b) { return std::atan2(a.cross(b).norm(), a.dot(b)); }

int sharp_edges_at(const Level& level, Index vertex) {
  const HalfEdges& mesh = level.topology;
  int count = 0;
  for (const SharpEdge& sharp : level.sharp) {
    const Index corner = mesh.edge_corner[sharp.edge];
    if (mesh.corner_vertex[corner] == vertex || mesh.corner_vertex[mesh.twin[corner]] == vertex) ++count;
  }
  return count;
}

/// With a vertex in the middle of every face: triangles, where a cut along diagonals would be lopsided.
PolyMesh with_centres(const PolyMesh& mesh) {
  PolyMesh result;
  result.positions = mesh.positions;
  result.tags = mesh.tags;
  for (std::size_t f = 0; f < mesh.face_count(); ++f) {
    const auto face = mesh.face(f);
    Vec3 sum = Vec3::Zero();
    for (const Index v : face) sum += mesh.positions[v];
    const auto middle = static_cast<Index>(result.positions.size());
    result.positions.push_back(sum / static_cast<double>(face.size()));
    for (std::size_t i = 0; i < face.size(); ++i) {
      result.add_face(std::array<Index, 3>{face[i], face[(i + 1) % face.size()], middle});
    }
  }
  return result;
}

/// A level's limit, with what is needed to compare it with another one.
struct SeenLimit {
  const HalfEdges* mesh;
  std::vector<Vec3> level_points;
  LimitSurface surface;
  std::vector<std::uint8_t> exact;
};

/// Alike after turning by a quarter about z and after x and y change places; with and without pins.
std::vector<NamedCage> symmetric_cages() {
  std::vector<NamedCage> cages;
  const auto add = [&](const std::string& name, PolyMesh mesh, std::vector<Index> pins) {
    for (Vec3& p : mesh.positions) p.z() += 0.1 * p.z() * p.x() * p.y() * p.x() * p.y();
    cages.push_back({name, mesh});
    mesh.tags.pins = std::move(pins);
    cages.push_back({name + ", pinned", mesh});
  };
  add("cube", cube_top_loop(), {4, 5, 6, 7});
  add("bolt", bolt_loop(), {8, 9, 10, 11});
  PolyMesh rays = cube_top_loop();  // with the upright edges sharp, too: three sharp edges at each corner of the top
  for (const Index v : {Index{0}, Index{1}, Index{2}, Index{3}})
    rays.tags.creases.push_back({{v, v + 4}, infinite_sharpness});
  add("cube with rays", rays, {4, 5, 6, 7});
  add("smooth cube", centred_cube(), {4, 5, 6, 7});
  const std::vector<Ring> rings = {{1, 2}, {2, 1}, {1.5, 0}, {2, -1}};
  std::vector<VertexPair> waist;
  for (Index i = 0; i < 4; ++i) waist.push_back({8 + i, 8 + (i + 1) % 4});
  add("vase", tagged(ring_stack(4, rings), waist), {8, 9, 10, 11});
  return cages;
}

/// At a corner of the mesh: where its vertex and its face lie, by which corners of a symmetric level are distinguished.
void check_symmetric(const SeenLimit& seen, const Eigen::Matrix3d& symmetry) {
  const HalfEdges& mesh = *seen.mesh;
  struct Place {
    Vec3 vertex, face, normal;
  };
  std::vector<Place> places;
  for (Index f = 0; f < mesh.face_count(); ++f) {
    for (Index c = mesh.face_offsets[f]; c < mesh.face_offsets[f + std::size_t{1}]; ++c) {
      places.push_back({seen.level_points[mesh.corner_vertex[c]], centre(mesh, seen.level_points, f),
                        seen.surface.corner_normals[c]});
    }
  }
  for (const Place& place : places) {
    const auto image = std::ranges::find_if(places, [&](const Place& other) {
      return (other.vertex - symmetry * place.vertex).norm() + (other.face - symmetry * place.face).norm() < 1e-9;
    });
    REQUIRE(image != places.end());
    INFO("vertex " << place.vertex.transpose() << ", normal " << place.normal.transpose() << ", at its image "
                   << image->normal.transpose());
    CHECK((image->normal - symmetry * place.normal).norm() < 1e-9);
  }
}

/// Every vertex of the coarse level is found again among the vertices of the fine one, with the same normals.
void check_same_normals(const SeenLimit& coarse, const SeenLimit& fine) {
  const auto normals_at = [](const SeenLimit& seen, const Vec3& point) {
    std::vector<Vec3> normals;
    for (Index c = 0; c < seen.mesh->corner_count(); ++c) {
      if ((seen.surface.points[seen.mesh->corner_vertex[c]] - point).norm() < 1e-9) {
        normals.push_back(seen.surface.corner_normals[c]);
      }
    }
    return normals;
  };
  const auto all_in = [](const std::vector<Vec3>& some, const std::vector<Vec3>& others) {
    return std::ranges::all_of(some, [&](const Vec3& normal) {
      return std::ranges::any_of(others, [&](const Vec3& other) { return (normal - other).norm() < 1e-9; });
    });
  };
  for (Index v = 0; v < coarse.surface.points.size(); ++v) {
    if (coarse.exact[v] == 0) continue;
    const std::vector<Vec3> before = normals_at(coarse, coarse.surface.points[v]);
    const std::vector<Vec3> after = normals_at(fine, coarse.surface.points[v]);
    INFO("vertex " << v << ", " << before[0].transpose() << ", later " << (after.empty() ? "none" : "other"));
    CHECK(all_in(before, after));
    CHECK(all_in(after, before));
  }
}

std::vector<PolyMesh> tagged_cages() { return {bolt(), bolt_loop(), bolt_open_chain(), cube_top_loop(), house()}; }

}  // namespace

TEST_CASE("Every exact limit point of a level is found again from the next level") {
  for (const PolyMesh& cage : tagged_cages()) {
    const Refined result = refined(cage, 4);
    std::vector<std::uint8_t> exact;
    const LimitSurface surface = limit_of(result, 1, &exact);
    const LimitSurface deeper = limit_of(result, 3);
    CHECK(std::all_of(exact.begin(), exact.end(), [](std::uint8_t flag) { return flag == 1; }));
    const double spacing = greatest_gap(surface.points, deeper.points);
    CHECK(spacing < 0.25 * extent(cage.positions));
    // The face that a vertex or the end of a chain becomes keeps its centre ever after.
    const HalfEdges& deep = result.plan.level(4).topology;
    for (Index face = 0; face < result.plan.level(2).topology.face_count(); ++face) {
      const FaceOrigin origin = result.plan.face_origin(2, face);
      if (origin.kind != FaceKind::Vertex) continue;
      if (sharp_edges_at(result.plan.level(1), origin.element) > 1) continue;  // not their face's centre
      const Vec3 again = centre(deep, result.at(4), descendant(result.plan, 2, face, 4));
      CHECK((again - surface.points[origin.element]).norm() < 1e-13);
    }
  }
}

TEST_CASE("Limit normals point outwards on closed surfaces, in all schemes") {
  for (const PolyMesh& cage : {centred_cube(), uv_sphere(8, 6), icosahedron()}) {
    const auto check = [&](const HalfEdges& mesh, const LimitSurface& surface) {
      for (Index c = 0; c < mesh.corner_count(); ++c) {
        const Vec3& point = surface.points[mesh.corner_vertex[c]];
        CHECK(surface.corner_normals[c].dot(point.normalized()) > 0.85);
        CHECK(surface.corner_normals[c].norm() == Approx(1));
      }
    };
    const Refined result = refined(cage, 3);
    check(result.plan.level(2).topology, limit_of(result, 2));
    for (const UniformScheme scheme : {UniformScheme::CatmullClark, UniformScheme::Loop}) {
      const UniformRefined uniform = uniformly_refined(cage, 2, {scheme, BoundaryCorners::Corner});
      check(uniform.plan.level(2).topology, limit_of(uniform, 2));
    }
  }
}

TEST_CASE("A vertex of a chain goes to (A + 6V + B)/8, with one normal per side") {
  const Refined result = refined(bolt_loop(), 3);
  const LimitSurface surface = limit_of(result, 2);
  const Level& level = result.plan.level(2);
  std::map<Index, std::vector<Index>> neighbours;
  for (const SharpEdge& sharp : level.sharp) {
    const Index corner = level.topology.edge_corner[sharp.edge];
    const Index a = level.topology.corner_vertex[corner], b = level.topology.corner_vertex[level.topology.twin[corner]];
    neighbours[a].push_back(b);
    neighbours[b].push_back(a);
  }
  const std::vector<Vec3>& points = result.at(2);
  for (const auto& [vertex, ends] : neighbours) {
    REQUIRE(ends.size() == 2);
    const Vec3 expected = (points[ends[0]] + 6 * points[vertex] + points[ends[1]]) / 8;
    CHECK((surface.points[vertex] - expected).norm() < 1e-15);
  }
  // The underside of the head is flat there, and the shank stands on it at right angles.
  for (Index c = 0; c < level.topology.corner_count(); ++c) {
    const Index vertex = level.topology.corner_vertex[c];
    if (!neighbours.contains(vertex)) continue;
    const bool below = (surface.corner_normals[c] + Vec3::UnitZ()).norm() < 1e-12;
    const Vec3 outwards = Vec3(surface.points[vertex].x(), surface.points[vertex].y(), 0).normalized();
    const bool beside =
        std::abs(surface.corner_normals[c].z()) < 1e-12 && surface.corner_normals[c].dot(outwards) > 0.9;
    CHECK((below || beside));
  }
}

TEST_CASE("Pins and corners stay at the limit, and a cube of sharp edges has its six normals") {
  const Refined result = refined(cube_all_sharp(), 2);
  const LimitSurface surface = limit_of(result, 1);
  CHECK(greatest_gap(surface.points, centred_cube().positions) < 1e-15);
  const UniformRefined uniform = uniformly_refined(cube_all_sharp(), 2);
  for (const LimitSurface& limits : {surface, limit_of(uniform, 2)}) {
    for (const Vec3& normal : limits.corner_normals) CHECK(normal.cwiseAbs().maxCoeff() == Approx(1).margin(1e-12));
  }
  const LimitSurface cube = limit_of(uniform, 2);
  for (const Vec3& point : cube.points) CHECK(point.cwiseAbs().maxCoeff() == Approx(1).margin(1e-14));
}

TEST_CASE("Limit points of both uniform schemes are where deep levels lead, to rounding where they say so") {
  std::size_t near_only = 0;
  for (const PolyMesh& cage : {bolt(), bolt_loop(), bolt_open_chain(), house(), mixed_disc(), cube_all_sharp()}) {
    for (const UniformScheme scheme : {UniformScheme::CatmullClark, UniformScheme::Loop}) {
      const UniformRefined result = uniformly_refined(cage, 5, {scheme, BoundaryCorners::Corner});
      std::vector<std::uint8_t> exact;
      const LimitSurface surface = limit_of(result, 1, &exact);
      const LimitSurface deep = limit_of(result, 5);
      for (Index v = 0; v < surface.points.size(); ++v) {
        const double gap = greatest_gap({&surface.points[v], 1}, deep.points);
        CHECK(gap < (exact[v] == 1 ? 1e-13 : 5e-3) * extent(cage.positions));
        if (exact[v] == 0) ++near_only;
      }
    }
  }
  CHECK(near_only == 5);  // two ends of a chain twice, and a vertex with two faces, which Loop's triangles part
}

TEST_CASE("One-sided normals of Catmull-Clark are those of the faces beside the crease, deep down") {
  PolyMesh cage = bolt_loop();
  for (Vec3& p : cage.positions) p = Vec3(p.x(), p.y() + 0.2 * p.x() * p.x(), p.z() + 0.1 * p.x() * p.y());
  const UniformRefined result = uniformly_refined(cage, 5);
  const HalfEdges& mesh = result.plan.level(5).topology;
  const LimitSurface surface = limit_of(result, 5);
  for (Index face = 0; face < mesh.face_count(); ++face) {
    const Vec3 normal = unit_normal(mesh, result.at(5), face);
    for (Index c = mesh.face_offsets[face]; c < mesh.face_offsets[face + std::size_t{1}]; ++c) {
      CHECK(angle(normal, surface.corner_normals[c]) < 0.12);
    }
  }
  std::set<Index> split;
  std::map<Index, Vec3> first_normal;
  for (Index c = 0; c < mesh.corner_count(); ++c) {
    const auto [place, is_new] = first_normal.try_emplace(mesh.corner_vertex[c], surface.corner_normals[c]);
    if (angle(place->second, surface.corner_normals[c]) > 1) split.insert(mesh.corner_vertex[c]);
  }
  CHECK(split.size() == result.plan.level(5).sharp.size());
}

TEST_CASE("Limit normals have the symmetry of the cage, and are the same from every level") {
  Eigen::Matrix3d turn, mirror;
  turn << 0, -1, 0, 1, 0, 0, 0, 0, 1;
  mirror << 0, 1, 0, 1, 0, 0, 0, 0, 1;
  for (const NamedCage& cage : symmetric_cages()) {
    // Vertices of Doo-Sabin become faces, so none is found again.
    const auto check = [&](const auto& result, const char* scheme, bool keeps_vertices) {
      std::vector<SeenLimit> levels;
      for (int k = 0; k <= 2; ++k) {
        SeenLimit seen{&result.plan.level(k).topology, result.at(k), {}, {}};
        seen.surface = limit_of(result, k, &seen.exact);
        levels.push_back(std::move(seen));
        INFO(cage.name << ", " << scheme << ", level " << k);
        if (k < 2) check_symmetric(levels.back(), turn);
        if (k < 2) check_symmetric(levels.back(), mirror);
        if (keeps_vertices) check_same_normals(levels.front(), levels.back());
      }
    };
    check(refined(cage.mesh, 3), "Doo-Sabin", false);
    check(uniformly_refined(cage.mesh, 2), "Catmull-Clark", true);
    // Loop's masks beside a crease are those of OpenSubdiv, which differ by the level at irregular vertices.
    const bool pinned = !cage.mesh.tags.pins.empty();
    check(uniformly_refined(with_centres(cage.mesh), 2, {UniformScheme::Loop, BoundaryCorners::Corner}), "Loop",
          pinned);
  }
}

TEST_CASE("At a pinned kink the normal of a single face between two sharp edges stands on both") {
  PolyMesh cage = cube_top_loop();
  cage.positions[7].z() += 0.5;
  cage.tags.pins = {4, 5, 6, 7};
  const std::map<Index, std::array<Index, 2>> neighbours = {{4, {5, 6}}, {5, {4, 7}}, {6, {4, 7}}, {7, {5, 6}}};
  const UniformRefined result = uniformly_refined(cage, 2);
  for (int k = 0; k <= 2; ++k) {
    const LimitSurface surface = limit_of(result, k);
    const HalfEdges& mesh = result.plan.level(k).topology;
    for (const auto& [pin, ends] : neighbours) {
      const Vec3 at = cage.positions[pin];
      const Vec3 upwards = (cage.positions[ends[0]] - at).cross(cage.positions[ends[1]] - at).normalized();
      std::vector<double> cosines;
      for (Index c = 0; c < mesh.corner_count(); ++c) {
        if (surface.points[mesh.corner_vertex[c]] == at)
          cosines.push_back(std::abs(upwards.dot(surface.corner_normals[c])));
      }
      REQUIRE(cosines.size() == 3);
      CHECK(std::ranges::max(cosines) == Approx(1).margin(1e-12));
    }
  }
}

TEST_CASE("The normal at a chain's end belongs to all its corners") {
  const Refined result = refined(bolt_open_chain(), 4);
  const UniformRefined uniform = uniformly_refined(bolt_open_chain(), 3);
  const auto check = [](const Level& level, const LimitSurface& surface) {
    std::map<Index, int> sharp_edges;
    for (const SharpEdge& sharp : level.sharp) {
      const Index corner = level.topology.edge_corner[sharp.edge];
      ++sharp_edges[level.topology.corner_vertex[corner]];
      ++sharp_edges[level.topology.corner_vertex[level.topology.twin[corner]]];
    }
    std::map<Index, Vec3> normal_of;
    for (Index c = 0; c < level.topology.corner_count(); ++c) {
      const Index vertex = level.topology.corner_vertex[c];
      if (!sharp_edges.contains(vertex) || sharp_edges[vertex] != 1) continue;
      const auto [place, is_new] = normal_of.try_emplace(vertex, surface.corner_normals[c]);
      CHECK((place->second - surface.corner_normals[c]).norm() == 0);
    }
    CHECK(normal_of.size() == 2);
  };
  check(result.plan.level(3), limit_of(result, 3));
  check(uniform.plan.level(3), limit_of(uniform, 3));
}

TEST_CASE("Limits are the same bits for any number of threads and move with the cage") {
  const PolyMesh cage = torus(24, 16);
  const Refined result = refined(cage, 3);
  Progress progress;
  const LimitPlan plan(result.plan, 2, progress);
  LimitSurface one, three, moved;
  plan.evaluate(result.points, one, 1);
  plan.evaluate(result.points, three, 3);
  CHECK(one.points == three.points);
  CHECK(one.corner_normals == three.corner_normals);
  const Eigen::AngleAxisd turn(0.7, Vec3(1, 2, 3).normalized());
  PositionBuffers turned = result.points;
  for (std::vector<Vec3>& level : turned.levels) {
    for (Vec3& p : level) p = turn * p;
  }
  plan.evaluate(turned, moved);
  double gap = 0;
  for (std::size_t i = 0; i < one.points.size(); ++i)
    gap = std::max(gap, (moved.points[i] - turn * one.points[i]).norm());
  CHECK(gap < 1e-14);
}

TEST_CASE("With any tags, limit points lie on the surface that deep levels approach") {
  for (std::uint64_t seed = 0; seed < 40; ++seed) {
    Random random(seed);
    const std::vector<NamedCage> cages = all_cages();
    NamedCage cage = cages[random.below(static_cast<std::uint32_t>(cages.size()))];
    if (cage.mesh.face_count() > 30) continue;  // a deep level of it takes too long
    add_random_tags(cage.mesh, random, seed % 2 == 0);
    INFO(cage.name << ", seed " << seed);
    const Refined result = refined(cage.mesh, 5);
    std::vector<std::uint8_t> exact;
    const LimitSurface surface = limit_of(result, 0, &exact);
    const HalfEdges& deep = result.plan.level(5).topology;
    std::vector<Vec3> places, normals;
    for (Index f = 0; f < deep.face_count(); ++f) {
      places.push_back(centre(deep, result.at(5), f));
      normals.push_back(unit_normal(deep, result.at(5), f));
      for (const Index v : deep.face(f)) {  // faces between corners stay large
        places.push_back(result.at(5)[v]);
        normals.push_back(normals.back());
      }
    }
    for (Index v = 0; v < surface.points.size(); ++v) {
      if (exact[v] == 0) continue;
      double nearest = 1e9, off = 0;
      for (std::size_t f = 0; f < places.size(); ++f) {
        const Vec3 offset = surface.points[v] - places[f];
        if (offset.norm() >= nearest) continue;
        nearest = offset.norm();
        off = std::abs(offset.dot(normals[f]));
      }
      CHECK(nearest < 0.15 * extent(cage.mesh.positions));
      CHECK(off < 0.01 * extent(cage.mesh.positions));
    }
    for (const Vec3& normal : surface.corner_normals) CHECK(std::abs(normal.norm() - 1) < 1e-12);
  }
}

TEST_CASE("With any tags, limits of the uniform schemes are finite and have normals") {
  for (std::uint64_t seed = 0; seed < 8; ++seed) {
    Random random(seed);
    for (NamedCage& cage : all_cages()) {
      if (cage.name.find("back") != std::string::npos) continue;  // flat: no normal at its rim
      add_random_tags(cage.mesh, random, false);
      INFO(cage.name << ", seed " << seed);
      const UniformScheme scheme = seed % 2 == 0 ? UniformScheme::CatmullClark : UniformScheme::Loop;
      const UniformRefined result = uniformly_refined(cage.mesh, 1, {scheme, BoundaryCorners::Corner});
      const LimitSurface surface = limit_of(result, 1);
      for (const Vec3& point : surface.points) REQUIRE(point.norm() < 2 * extent(cage.mesh.positions) + 20);
      std::size_t without = 0;  // triangles that fractional sharpness drew into a line
      for (const Vec3& normal : surface.corner_normals) {
        if (normal == Vec3::Zero()) {
          ++without;
        } else {
          REQUIRE(std::abs(normal.norm() - 1) < 1e-12);
        }
      }
      CHECK(without <= surface.corner_normals.size() / 100);
    }
  }
}
