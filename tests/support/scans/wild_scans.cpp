// SPDX-License-Identifier: GPL-3.0-or-later
#include "support/scans/wild_scans.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <span>
#include <vector>

#include <Eigen/Geometry>

#include "croquis/geometry/mesh_topology.h"
#include "support/meshes/mesh_shapes.h"
#include "support/random.h"
#include "support/scans/scans.h"
#include "support/scans/virtual_scans.h"
#include "support/scans/waves.h"

namespace croquis::test {
namespace {

constexpr double full_turn = 2 * std::numbers::pi;

Vec3 wild_centre(const PolyMesh& mesh, std::size_t face) {
  const auto t = mesh.face(face);
  return (mesh.positions[t[0]] + mesh.positions[t[1]] + mesh.positions[t[2]]) / 3;
}

/// A grid over [-1,1]^2, moved by a function. Denser towards -x by the power.
PolyMesh warped_grid(std::size_t triangles, double power, const std::function<Vec3(double, double)>& place) {
  const auto side = static_cast<Index>(std::sqrt(static_cast<double>(triangles) / 2));
  PolyMesh mesh = sheet(side, side);
  for (Vec3& p : mesh.positions) {
    const double u = 2 * std::pow(p.x() / side, power) - 1, v = 2 * p.y() / side - 1;
    p = place(u, v);
  }
  return mesh;
}

PolyMesh without_where(const PolyMesh& mesh, const std::function<bool(std::size_t)>& is_missing) {
  std::vector<Index> missing;
  for (std::size_t f = 0; f < mesh.face_count(); ++f)
    if (is_missing(f)) missing.push_back(static_cast<Index>(f));
  return without_faces(mesh, missing);
}

/// Ragged: gone where waves are high, a share of about `level` (0: nothing, 1: half).
PolyMesh bitten(const PolyMesh& mesh, Random& random, double length, double level) {
  const Waves waves(random, length, 4);
  return without_where(mesh, [&](std::size_t f) { return waves.at(wild_centre(mesh, f)) > 1.6 * (1 - level); });
}

PolyMesh terrain(Random& random, std::size_t triangles) {
  const Waves hills(random, random.between(0.8, 2.5), 5);
  const double height = random.between(0.05, 0.3);
  const PolyMesh ground = warped_grid(triangles, random.between(1, 3.5),
                                      [&](double u, double v) { return Vec3(u, v, height * hills.at(Vec3(u, v, 0))); });
  const Waves border(random, 0.7, 4);
  const PolyMesh cut = without_where(ground, [&](std::size_t f) {
    const Vec3 p = wild_centre(ground, f);
    return std::hypot(p.x(), p.y()) > 0.85 + 0.15 * border.at(p);
  });
  return bitten(cut, random, random.between(0.3, 0.8), random.between(0, 0.5));
}

PolyMesh facade(Random& random, std::size_t triangles) {
  const double windows = std::floor(random.between(2, 6)), depth = random.between(0.05, 0.2);
  const PolyMesh wall = warped_grid(triangles, random.between(1, 2), [&](double u, double v) {
    const double x = std::sin(windows * std::numbers::pi * u), y = std::sin(windows * std::numbers::pi * v);
    const double ledge = std::abs(v) < 0.06 ? 1.5 * depth : 0;
    return Vec3(u, v, ledge + (x > 0.4 && y > 0.2 ? -depth : 0));
  });
  const PolyMesh seen = without_where(wall, [&](std::size_t f) {  // jumps of depth aren't seen from the front
    const auto t = wall.face(f);
    const auto [low, high] =
        std::minmax({wall.positions[t[0]].z(), wall.positions[t[1]].z(), wall.positions[t[2]].z()});
    return high - low > 0.5 * depth && f % 5 != 0;
  });
  return bitten(seen, random, random.between(0.4, 1), random.between(0, 0.6));
}

std::function<double(const Vec3&)> blob(Random& random) {
  const Waves bumps(random, random.between(1, 2), 4);
  const double rough = random.between(0.05, 0.18);
  const Sculpture inner = all_sculptures[random.below(6)];
  const bool is_sculpture = random.unit() < 0.5;
  return
      [=](const Vec3& p) { return is_sculpture ? field_value(inner, p) : 0.6 * (p.norm() - 1 + rough * bumps.at(p)); };
}

std::vector<Vec3> directions_above(Random& random, std::size_t count, double lowest) {
  std::vector<Vec3> directions;
  for (std::size_t i = 0; i < count; ++i) {
    const double angle = full_turn * (static_cast<double>(i) + random.unit()) / static_cast<double>(count);
    directions.push_back(Vec3(std::cos(angle), std::sin(angle), random.between(lowest, 1)).normalized());
  }
  return directions;
}

PolyMesh monument(Random& random, std::size_t triangles) {
  const auto figure = blob(random);
  const double level = random.between(-0.7, -0.2), wide = random.between(1.2, 2);
  const Waves hills(random, 1.5, 3);
  const auto ground = [&](const Vec3& p) {
    const double top = p.z() - level - 0.06 * hills.at(p), side = std::hypot(p.x(), p.y()) - wide;
    return std::max({0.8 * top, side, level - 0.35 - p.z()});
  };
  const PolyMesh whole = sculpt([&](const Vec3& p) { return std::min(figure(p), ground(p)); }, triangles);
  const PolyMesh seen = seen_from(whole, directions_above(random, 2 + random.below(4), 0.25)).mesh;
  return bitten(seen, random, random.between(0.6, 1.5), random.between(0, 0.35));
}

PolyMesh layers(Random& random, std::size_t triangles) {
  const PolyMesh whole = sculpt(blob(random), triangles);
  const std::size_t views = 3 + random.below(4);
  const double spacing = mean_edge_of(whole) * std::sqrt(0.12 * static_cast<double>(views));
  PolyMesh sheets;
  for (const Vec3& direction : directions_above(random, views, -0.6)) {
    const Vec3 shift(random.between(-1, 1), random.between(-1, 1), random.between(-1, 1));
    sheets = merged(sheets, translated(range_images(whole, std::vector{direction}, spacing), 0.7 * spacing * shift));
  }
  return sheets;
}

PolyMesh cloth(Random& random, std::size_t triangles) {
  const double turns = random.between(0.8, 2.2), gap = random.between(0.02, 0.15);
  const Waves folds(random, random.between(0.5, 1.2), 4);
  const double depth = random.between(0.02, 0.12);
  const PolyMesh rolled = warped_grid(triangles, random.between(1, 2), [&](double u, double v) {
    const double angle = turns * std::numbers::pi * u;
    const double radius = 0.6 + gap * angle / full_turn + depth * folds.at(Vec3(u, v, 0));
    return Vec3(radius * std::cos(angle), radius * std::sin(angle), v);
  });
  return bitten(rolled, random, random.between(0.4, 1), random.between(0, 0.5));
}

PolyMesh fragment(Random& random, std::size_t triangles) {
  const PolyMesh whole = sculpt(blob(random), triangles);
  return bitten(whole, random, random.between(0.8, 2.5), random.between(0.3, 0.8));
}

PolyMesh interior(Random& random, std::size_t triangles) {
  const auto furniture = blob(random);
  const double walls = random.between(0.8, 1.3);
  const auto room = [&](const Vec3& p) {
    return std::max({std::abs(p.x()), std::abs(p.y()), 1.3 * std::abs(p.z())}) - walls;
  };
  const auto solid = [&](const Vec3& p) {
    return std::max(room(p), -furniture(0.9 * Vec3(2.4 * (p - Vec3(0.2, 0, -0.4)))));
  };
  const PolyMesh whole = flipped(sculpt(solid, triangles));
  return bitten(whole, random, random.between(0.7, 1.5), random.between(0.2, 0.6));
}

// What is wrong besides.

PolyMesh with_spikes(PolyMesh mesh, Random& random, double share, double edge) {
  for (Vec3& p : mesh.positions) {
    const Vec3 way(random.between(-1, 1), random.between(-1, 1), random.between(-1, 1));
    const double length = std::pow(random.unit(), 4);
    if (random.unit() < share) p += 30 * edge * length * way;
  }
  return mesh;
}

PolyMesh with_specks(PolyMesh mesh, Random& random, std::size_t count, double edge) {
  const double wide = 0.6 * diagonal_of(mesh);
  for (std::size_t i = 0; i < count; ++i) {
    const Vec3 at(random.between(-wide, wide), random.between(-wide, wide), random.between(-wide, wide));
    const double size = edge * random.between(0.5, 4);
    const auto n = static_cast<Index>(1 + random.below(4));
    PolyMesh speck = transformed(sheet(n, n), Eigen::Affine3d(Eigen::Scaling(size)));
    speck = rotated(speck, random.between(0, full_turn), Vec3(random.unit(), random.unit(), 1).normalized());
    const Waves rough(random, 3 * size, 3);
    for (Vec3& p : speck.positions) p += Vec3(0, 0, 0.5 * size * rough.at(p));
    mesh = merged(mesh, translated(speck, at));
  }
  return mesh;
}

/// Triangles between far corners of the border, as meshing makes them that closes what isn't there.
PolyMesh with_needles(PolyMesh mesh, Random& random, std::size_t count) {
  const MeshTopology topology(mesh);
  const auto& loops = topology.boundary_loops();
  std::vector<std::array<Index, 3>> needles;
  for (std::size_t i = 0; i < count && loops.size() > 0; ++i) {
    const auto loop = loops[random.below(static_cast<Index>(loops.size()))];
    const auto n = static_cast<Index>(loop.size());
    if (n < 12) continue;
    const Index first = random.below(n), far = (first + n / 8 + random.below(n / 4)) % n;
    needles.push_back({loop[first], loop[far], loop[(first + 1) % n]});
  }
  for (const auto& [a, b, c] : needles)
    if (a != b && b != c && a != c) mesh.add_triangle(a, b, c);
  return mesh;
}

PolyMesh with_copies(const PolyMesh& mesh, Random& random, double edge, bool is_flipped) {
  const Vec3 centre = mesh.positions[mesh.corners[random.below(static_cast<Index>(mesh.corners.size()))]];
  const double radius = random.between(0.05, 0.2) * diagonal_of(mesh);
  const PolyMesh near =
      without_where(mesh, [&](std::size_t f) { return (wild_centre(mesh, f) - centre).norm() > radius; });
  const Vec3 away(random.between(-1, 1), random.between(-1, 1), random.between(-1, 1));
  const PolyMesh copy = without_loose_vertices(translated(near, 0.8 * edge * away));
  return merged(mesh, is_flipped ? flipped(copy) : copy);
}

/// Faces gone one by one: pinholes and bow-ties.
PolyMesh with_pinholes(const PolyMesh& mesh, Random& random, double share) {
  return without_where(mesh, [&](std::size_t) { return random.unit() < share; });
}

PolyMesh dirtied(PolyMesh mesh, Random& random) {
  const double edge = mean_edge_of(mesh);
  const auto is_so = [&](double share) { return random.unit() < share; };
  if (is_so(0.6)) mesh = with_noise(std::move(mesh), random.bits(), random.between(0.05, 0.4));
  if (is_so(0.4)) mesh = with_pinholes(mesh, random, random.between(0.002, 0.03));
  if (is_so(0.4)) mesh = with_needles(std::move(mesh), random, 1 + random.below(12));
  if (is_so(0.4)) mesh = with_copies(mesh, random, edge, false);
  if (is_so(0.3)) mesh = with_copies(mesh, random, edge, true);
  if (is_so(0.3)) mesh = with_spikes(std::move(mesh), random, random.between(0.0005, 0.005), edge);
  if (is_so(0.5)) mesh = with_specks(std::move(mesh), random, 1 + random.below(20), edge);
  return mesh;
}

PolyMesh clean_wild_scan(WildScan kind, Random& random, std::size_t triangles) {
  switch (kind) {
    case WildScan::Terrain: return terrain(random, triangles);
    case WildScan::Facade: return facade(random, triangles);
    case WildScan::Monument: return monument(random, triangles);
    case WildScan::Layers: return layers(random, triangles);
    case WildScan::Cloth: return cloth(random, triangles);
    case WildScan::Fragment: return fragment(random, triangles);
    case WildScan::Interior: return interior(random, triangles);
  }
  return {};
}

}  // namespace

const char* name_of(WildScan kind) {
  constexpr std::array names = {"terrain", "facade", "monument", "layers", "cloth", "fragment", "interior"};
  return names[static_cast<std::size_t>(kind)];
}

PolyMesh wild_scan(WildScan kind, std::uint64_t seed, std::size_t triangles) {
  Random random(seed * 1000 + static_cast<std::uint64_t>(kind));
  return without_loose_vertices(dirtied(without_loose_vertices(clean_wild_scan(kind, random, triangles)), random));
}

}  // namespace croquis::test
