// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>
#include <optional>
#include <set>
#include <string>

#include <catch2/catch.hpp>

#include "croquis/base/error.h"
#include "croquis/geometry/self_intersection.h"
#include "support/meshes/mesh_shapes.h"
#include "support/random.h"

using namespace croquis;
using namespace croquis::test;

namespace {

using Pairs = std::set<std::array<Index, 2>>;

SelfIntersections find_all(const PolyMesh& mesh) {
  Progress progress;
  return find_self_intersections(mesh, progress, {.max_pairs = 100000});
}

Pairs pairs_of(const PolyMesh& mesh) {
  const SelfIntersections found = find_all(mesh);
  Pairs pairs(found.pairs.begin(), found.pairs.end());
  CHECK(pairs.size() == found.count);
  return pairs;
}

/// Oracle: exact, for triangles with whole coordinates up to 1000, by clipping edges; no predicate in common with the
/// code under test. The corners of the set where two triangles meet all come from an edge of one clipped by the other;
/// so they meet beyond what they share when one of these points is not shared.
namespace oracle {

__extension__ using Whole = __int128;
using Vector = std::array<Whole, 3>;
using Triangle = std::array<Index, 3>;

Vector minus(const Vector& a, const Vector& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }
Whole dot(const Vector& a, const Vector& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
Vector cross(const Vector& a, const Vector& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

struct Fraction {
  Whole over, under;  // under > 0
  bool operator<(const Fraction& other) const { return over * other.under < other.over * under; }
};

/// Part [from, to] of a segment p + t d.
struct Part {
  Fraction from{0, 1}, to{1, 1};

  /// Keeps value + t slope >= 0. @return false when nothing is left
  bool clip(Whole value, Whole slope) {
    if (slope == 0) return value >= 0;
    const Fraction at = slope > 0 ? Fraction{-value, slope} : Fraction{value, -slope};
    if (slope > 0)
      from = std::max(from, at);
    else
      to = std::min(to, at);
    return !(to < from);
  }
};

class Soup {
 public:
  explicit Soup(const PolyMesh& mesh) : mesh_(mesh) {
    for (const Vec3& p : mesh.positions) {
      points_.push_back({static_cast<Whole>(p.x()), static_cast<Whole>(p.y()), static_cast<Whole>(p.z())});
    }
  }

  Pairs pairs() const {
    Pairs result;
    for (Index f = 0; f < mesh_.face_count(); ++f) {
      for (Index g = f + 1; g < mesh_.face_count(); ++g) {
        if (intersect(triangle(f), triangle(g))) result.insert({f, g});
      }
    }
    return result;
  }

 private:
  Triangle triangle(Index f) const { return {mesh_.face(f)[0], mesh_.face(f)[1], mesh_.face(f)[2]}; }

  Vector normal(const Triangle& t) const {
    return cross(minus(points_[t[1]], points_[t[0]]), minus(points_[t[2]], points_[t[0]]));
  }

  bool are_boxes_apart(const Triangle& u, const Triangle& v) const {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const auto less = [&](Index a, Index b) { return points_[a][axis] < points_[b][axis]; };
      const auto [low_u, high_u] = std::minmax_element(u.begin(), u.end(), less);
      const auto [low_v, high_v] = std::minmax_element(v.begin(), v.end(), less);
      if (less(*high_u, *low_v) || less(*high_v, *low_u)) return true;
    }
    return false;
  }

  bool intersect(const Triangle& u, const Triangle& v) const {
    if (are_boxes_apart(u, v)) return false;  // only to be done sooner
    if (normal(u) == Vector{} || normal(v) == Vector{}) return false;
    std::vector<Index> shared;
    for (const Index vertex : u) {
      if (std::count(v.begin(), v.end(), vertex) > 0) shared.push_back(vertex);
    }
    return shared.size() == 3 || edges_meet(u, v, shared) || edges_meet(v, u, shared);
  }

  /// Whether an edge of `u` reaches a point of `v` that is not shared.
  bool edges_meet(const Triangle& u, const Triangle& v, const std::vector<Index>& shared) const {
    for (std::size_t i = 0; i < 3; ++i) {
      const Vector& p = points_[u[i]];
      const Vector d = minus(points_[u[(i + 1) % 3]], p);
      const std::optional<Part> part = clip(p, d, v);
      if (part && !(is_shared(p, d, part->from, shared) && is_shared(p, d, part->to, shared))) return true;
    }
    return false;
  }

  std::optional<Part> clip(const Vector& p, const Vector& d, const Triangle& v) const {
    Part part;
    const Vector n = normal(v);
    const Whole height = dot(n, minus(p, points_[v[0]]));
    if (!part.clip(height, dot(n, d)) || !part.clip(-height, -dot(n, d))) return std::nullopt;
    for (std::size_t k = 0; k < 3; ++k) {
      const Vector inwards = cross(n, minus(points_[v[(k + 1) % 3]], points_[v[k]]));
      if (!part.clip(dot(inwards, minus(p, points_[v[k]])), dot(inwards, d))) return std::nullopt;
    }
    return part;
  }

  /// Whether p + t d is the shared vertex, or on the line of the shared edge.
  bool is_shared(const Vector& p, const Vector& d, const Fraction& t, const std::vector<Index>& shared) const {
    if (shared.empty()) return false;
    const Vector& s = points_[shared[0]];
    Vector offset{};  // from the shared vertex, times t.under
    for (std::size_t k = 0; k < 3; ++k) offset[k] = (p[k] - s[k]) * t.under + d[k] * t.over;
    if (shared.size() == 1) return offset == Vector{};
    return cross(offset, minus(points_[shared[1]], s)) == Vector{};
  }

  const PolyMesh& mesh_;
  std::vector<Vector> points_;
};

}  // namespace oracle

/// Triangles over a small pool of lattice points: many share vertices, touch, overlap in a plane, or are degenerate.
PolyMesh lattice_soup(std::uint64_t seed, Index points, Index triangles, std::uint32_t size) {
  Random random(seed);
  PolyMesh mesh;
  for (Index i = 0; i < points; ++i) {
    const double x = random.below(size);
    const double y = random.below(size);
    mesh.positions.emplace_back(x, y, random.below(size));
  }
  while (mesh.face_count() < triangles) {
    const Index a = random.below(points);
    const Index b = random.below(points);
    const Index c = random.below(points);
    if (a != b && b != c && c != a) mesh.add_triangle(a, b, c);
  }
  return mesh;
}

PolyMesh two_triangles(std::vector<Vec3> positions, std::array<Index, 3> a, std::array<Index, 3> b) {
  PolyMesh mesh;
  mesh.positions = std::move(positions);
  mesh.add_face(a);
  mesh.add_face(b);
  return mesh;
}

std::size_t count(const PolyMesh& mesh) { return find_all(mesh).count; }

}  // namespace

TEST_CASE("an exact search of all pairs finds the same in soups full of special positions") {
  std::size_t found = 0;
  std::size_t pairs = 0;
  for (std::uint64_t seed = 0; seed < 400; ++seed) {
    const std::uint32_t size = 2 + static_cast<std::uint32_t>(seed % 5);
    const PolyMesh mesh = lattice_soup(seed, 12, 14, size);
    const Pairs expected = oracle::Soup(mesh).pairs();
    INFO("seed " << seed);
    CHECK(pairs_of(mesh) == expected);
    found += expected.size();
    pairs += 14 * 13 / 2;
  }
  CHECK(found > pairs / 10);  // the family has plenty of both answers
  CHECK(found < pairs * 9 / 10);
}

TEST_CASE("an exact search of all pairs finds the same in soups in general position") {
  for (std::uint64_t seed = 0; seed < 40; ++seed) {
    const PolyMesh mesh = lattice_soup(seed + 1000, seed % 2 == 0 ? 90 : 20, 40, 1000);
    CHECK(pairs_of(mesh) == oracle::Soup(mesh).pairs());
  }
}

TEST_CASE("an exact search of all pairs finds the same in larger meshes, with shared vertices and edges") {
  const auto rounded = [](PolyMesh mesh) {
    for (Vec3& p : mesh.positions) p = (p * 300).array().round();
    return mesh;
  };
  const PolyMesh ring = triangulated(torus(22, 14));
  const PolyMesh crossing = rounded(merged(ring, translated(rotated(ring, 0.7, {1, 2, 3}), {0.5, 0.1, 0.2})));
  REQUIRE(crossing.face_count() > 1200);
  for (const PolyMesh& mesh : {crossing, shuffled(crossing, 3), lattice_soup(77, 300, 300, 1000)}) {
    const Pairs expected = oracle::Soup(mesh).pairs();
    CHECK(expected.size() > 50);
    CHECK(pairs_of(mesh) == expected);
    Progress progress;
    std::vector<Index> all(mesh.face_count());
    std::iota(all.begin(), all.end(), Index{0});
    CHECK(find_intersections_of(mesh, all, progress).count == expected.size());
  }
}

TEST_CASE("answers do not change with the scale, down to the smallest and up to the largest that is read") {
  const PolyMesh mesh = lattice_soup(5, 30, 40, 100);
  const Pairs expected = pairs_of(mesh);
  for (const int exponent : {-1000, -600, -300, -60, 60, 90}) {
    INFO("2^" << exponent);
    CHECK(pairs_of(scaled(mesh, std::ldexp(1.0, exponent))) == expected);
  }
}

TEST_CASE("surfaces that keep apart have no self-intersection, in any position") {
  const std::vector<PolyMesh> shapes = {tetrahedron(),
                                        cube(),
                                        uv_sphere(12, 9),
                                        torus(20, 12),
                                        double_torus(),
                                        grid(8, 8),
                                        tetrahedra_sharing_edge(),
                                        tetrahedra_sharing_vertex(),
                                        moebius(24),
                                        merged(uv_sphere(12, 9), scaled(uv_sphere(12, 9), 0.5)),
                                        merged(uv_sphere(12, 9), translated(uv_sphere(12, 9), {2.5, 0, 0}))};
  for (std::size_t i = 0; i < shapes.size(); ++i) {
    INFO("shape " << i);
    CHECK(count(shapes[i]) == 0);
    CHECK(count(triangulated(shapes[i])) == 0);
    CHECK(count(shuffled(triangulated(shapes[i]), 4)) == 0);
    CHECK(count(translated(rotated(triangulated(shapes[i]), 1.1, {1, 2, 3}), {300, -20, 7})) == 0);
  }
}

TEST_CASE("polygons count as their fans, each pair of faces once") {
  const PolyMesh mesh = merged(double_torus(), translated(rotated(double_torus(), 0.4, {1, 1, 2}), {0.3, 0.4, 0.35}));
  const PolyMesh fans = triangulated(mesh);
  Pairs expected;
  for (const auto& [first, second] : pairs_of(fans)) expected.insert({first / 2, second / 2});  // all faces are quads
  CHECK(expected.size() > 10);
  CHECK(pairs_of(mesh) == expected);
}

TEST_CASE("duplicate faces intersect, whichever way they are turned, and those nearly folded onto each other don't") {
  const std::vector<Vec3> positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  CHECK(count(two_triangles(positions, {0, 1, 2}, {0, 1, 2})) == 1);
  CHECK(count(two_triangles(positions, {0, 1, 2}, {2, 1, 0})) == 1);
  CHECK(count(two_triangles({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0.3, 1, 1e-300}}, {0, 1, 2}, {1, 0, 3})) == 0);
  PolyMesh quads = grid(1, 1);
  quads.add_face(std::vector<Index>(quads.face(0).begin(), quads.face(0).end()));
  CHECK(pairs_of(quads) == Pairs{{0, 1}});
}

TEST_CASE("faces without an area take no part") {
  PolyMesh mesh = triangulated(cube());
  mesh.positions.emplace_back(0.5, 0.5, -3);
  mesh.positions.emplace_back(0.5, 0.5, 0.5);
  mesh.positions.emplace_back(0.5, 0.5, 3);
  mesh.add_triangle(8, 9, 10);
  mesh.add_triangle(8, 8, 10);
  mesh.add_face(std::array<Index, 2>{8, 10});
  CHECK(count(mesh) == 0);
}

TEST_CASE("a polygon that crosses itself is a pair with itself, one with a dent isn't, wherever it begins") {
  PolyMesh mesh;
  mesh.positions = {{0, 0, 0}, {2, 0, 0}, {0.5, 0.5, 0}, {0, 2, 0}, {0, 0, 0}, {1, 1, 0}, {1, 0, 0}, {0, 1, 0}};
  for (Index first = 0; first < 4; ++first) {
    const auto face = [&](Index a, Index b, Index c, Index d) {
      mesh.face_offsets = {0};
      mesh.corners.clear();
      std::array<Index, 4> corners = {a, b, c, d};
      std::ranges::rotate(corners, corners.begin() + first);
      mesh.add_face(corners);
      return pairs_of(mesh);
    };
    CHECK(face(0, 1, 2, 3).empty());
    CHECK(face(4, 5, 6, 7) == Pairs{{0, 0}});
  }
}

TEST_CASE("the list is the first pairs in order and the count stays complete") {
  const PolyMesh mesh = random_soup(9, 200);
  const SelfIntersections all = find_all(mesh);
  REQUIRE(all.count > 100);
  REQUIRE(std::is_sorted(all.pairs.begin(), all.pairs.end()));
  for (const std::size_t limit : {std::size_t{0}, std::size_t{1}, std::size_t{17}}) {
    Progress progress;
    const SelfIntersections some = find_self_intersections(mesh, progress, {.max_pairs = limit});
    CHECK(some.count == all.count);
    CHECK(some.pairs == std::vector(all.pairs.begin(), all.pairs.begin() + static_cast<std::ptrdiff_t>(limit)));
  }
}

TEST_CASE("a search for some faces finds the pairs of all that involve them") {
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    const PolyMesh mesh =
        seed % 2 == 0 ? random_soup(seed, 150) : merged(uv_sphere(12, 9), translated(torus(9, 7), Vec3(0.3, 0.1, 0.2)));
    Random random(seed);
    std::set<Index> chosen;
    for (int i = 0; i < 12; ++i) chosen.insert(random.below(static_cast<Index>(mesh.face_count())));
    Pairs expected = pairs_of(mesh);
    std::erase_if(expected, [&](const auto& pair) { return !chosen.contains(pair[0]) && !chosen.contains(pair[1]); });
    Progress progress;
    const std::vector<Index> faces(chosen.begin(), chosen.end());
    const SelfIntersections found = find_intersections_of(mesh, faces, progress, {.max_pairs = 100000});
    CHECK(Pairs(found.pairs.begin(), found.pairs.end()) == expected);
    CHECK(found.count == expected.size());
  }
  Progress progress;
  CHECK(find_intersections_of(random_soup(1, 50), {}, progress).count == 0);
}

TEST_CASE("a search for some faces finds what reaches them from afar, at any scale and in a plane") {
  PolyMesh mesh = triangulated(uv_sphere(12, 9));
  const auto first = static_cast<Index>(mesh.face_count());
  for (const double reach : {0.3, 3.0, 1e3, 1e6}) {  // needles through the sphere's side and each other
    const auto base = static_cast<Index>(mesh.vertex_count());
    mesh.positions.insert(mesh.positions.end(), {{0.1, 0.2, 0.01}, {reach + 1, 0.3, 0.02}, {reach + 1, 0.32, 0.5}});
    mesh.add_triangle(base, base + 1, base + 2);
  }
  for (const double scale : {1.0, 1e-310, 1e-150, 1e20}) {
    const PolyMesh scaled_mesh = scaled(mesh, scale);
    const Pairs all = pairs_of(scaled_mesh);
    for (Index f = 0; f < mesh.face_count(); f += f < first ? 7 : 1) {
      Pairs expected = all;
      std::erase_if(expected, [&](const auto& pair) { return pair[0] != f && pair[1] != f; });
      Progress progress;
      const SelfIntersections found = find_intersections_of(scaled_mesh, std::array{f}, progress);
      CHECK(Pairs(found.pairs.begin(), found.pairs.end()) == expected);
      CHECK((f < first || !expected.empty()));
    }
  }
}

TEST_CASE("a search can be cancelled before and during its work, and its progress rises to the end") {
  const PolyMesh mesh = triangulated(torus(150, 150));
  std::atomic<bool> cancel{false};
  std::vector<double> fractions;
  Progress watched([&](double fraction, const std::string&) { fractions.push_back(fraction); });
  find_self_intersections(mesh, watched);
  CHECK(fractions.size() > 2);
  CHECK(std::ranges::is_sorted(fractions));
  CHECK(fractions.back() == 1);
  std::size_t reports = 0;
  Progress stopped([&](double, const std::string&) { cancel = ++reports == 2; }, &cancel);
  CHECK_THROWS_AS(find_self_intersections(mesh, stopped), Cancelled);
  CHECK(reports == 2);
  CHECK_THROWS_AS(find_self_intersections(tetrahedron(), stopped), Cancelled);
}

TEST_CASE("positions that are not finite and indices out of range are refused") {
  PolyMesh mesh = tetrahedron();
  mesh.positions[1].x() = std::numeric_limits<double>::infinity();
  Progress progress;
  CHECK_THROWS_AS(find_self_intersections(mesh, progress), Error);
  mesh = tetrahedron();
  mesh.corners[2] = 4;
  CHECK_THROWS_AS(find_self_intersections(mesh, progress), Error);
}
