// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <atomic>
#include <cmath>
#include <map>
#include <set>

#include <Eigen/Geometry>
#include <catch2/catch.hpp>

#include "attribute_surface/network_samples.h"
#include "attribute_surface/small_networks.h"
#include "croquis/attribute_surface/surface_tessellation.h"
#include "croquis/base/error.h"
#include "croquis/base/stage_cache.h"
#include "croquis/geometry/mesh_report.h"
#include "croquis/geometry/triangle_tree.h"
#include "croquis/io/attribute_network_file.h"
#include "croquis/io/file.h"
#include "support/attribute_surface/loops.h"
#include "support/attribute_surface/surfaces.h"
#include "support/random.h"

using namespace croquis;
using namespace croquis::test;

namespace {

SurfaceTessellation mesh_of(const AttributeNetwork& network, const AttributeSurface& surface,
                            const SurfaceTessellationOptions& options = {}) {
  Progress progress;
  return tessellate(network, surface, progress, options);
}

SurfaceTessellationOptions with_samples(std::size_t samples) {
  SurfaceTessellationOptions options;
  options.samples = samples;
  return options;
}

SurfaceTessellationOptions with_tolerance(double tolerance) {
  SurfaceTessellationOptions options;
  options.tolerance = tolerance;
  return options;
}

MeshReport figures_of(const PolyMesh& mesh) {
  Progress progress;
  return inspect(mesh, false, progress);
}

AttributeNetwork shipped_network(const std::string& name) {
  const std::string path = CROQUIS_SOURCE_DIR "/examples/data/surface/" + name + ".json";
  return read_attribute_network(read_file(path), name).network;
}

/// Sum of the signed areas of a part's triangles in its domain, each of which must be counter-clockwise.
double domain_area(const SurfaceTessellation& made, const SurfacePart& part, bool flipped) {
  std::map<Index, Vec2> place_of;
  for (std::size_t i = 0; i < part.vertices.size(); ++i) place_of[part.vertices[i]] = part.places[i];
  double sum = 0;
  for (std::size_t t = 0; t < part.triangle_count; ++t) {
    const auto corners = made.mesh.face(part.first_triangle + t);
    const Vec2 &a = place_of.at(corners[0]), &b = place_of.at(corners[1]), &c = place_of.at(corners[2]);
    const double area = 0.5 * cross(b - a, c - a) * (flipped ? -1 : 1);
    CHECK(area > 0);
    sum += area;
  }
  return sum;
}

double area_of(const DomainPolygon& domain) {
  double area = 0;
  for (std::size_t i = 0; i < domain.corners.size(); ++i)
    area += 0.5 * cross(domain.corners[i], domain.corners[(i + 1) % domain.corners.size()]);
  return area;
}

/// Every part covers its domain once, its vertices inside lie on the surface, and its corners have unit normals.
void check_parts(const AttributeNetwork& network, const AttributeSurface& surface, const SurfaceTessellation& made) {
  std::size_t next = 0;
  for (const SurfacePart& part : made.parts) {
    INFO(network.faces[part.face].id);
    const SurfaceFace& face = surface.faces[part.face];
    CHECK(part.first_triangle == next);
    next += part.triangle_count;
    REQUIRE(part.vertices.size() == part.places.size());
    CHECK(domain_area(made, part, face.flipped) == Approx(area_of(face.surface->domain())).epsilon(1e-9));
    double error = 0;
    for (std::size_t i = 0; i < part.vertices.size(); ++i)
      error = std::max(error, (made.mesh.positions[part.vertices[i]] - face.surface->at(part.places[i])).norm());
    CHECK(error < 1e-10);
  }
  CHECK(next == made.mesh.face_count());
  const AttributeChannel* normals = made.mesh.channel("normal", Domain::Corner);
  REQUIRE(normals != nullptr);
  const auto& values = std::get<std::vector<double>>(normals->data);
  REQUIRE(values.size() == 3 * made.mesh.corners.size());
  double off = 0;
  for (std::size_t c = 0; c < values.size(); c += 3)
    off = std::max(off, std::abs(Vec3(values[c], values[c + 1], values[c + 2]).norm() - 1));
  CHECK(off < 1e-12);
}

/// Radians, of a part's triangles in its domain.
double smallest_angle(const SurfaceTessellation& made, const SurfacePart& part) {
  std::map<Index, Vec2> place_of;
  for (std::size_t i = 0; i < part.vertices.size(); ++i) place_of[part.vertices[i]] = part.places[i];
  double smallest = 4;
  for (std::size_t t = 0; t < part.triangle_count; ++t) {
    const auto corners = made.mesh.face(part.first_triangle + t);
    for (std::size_t k = 0; k < 3; ++k) {
      const Vec2& at = place_of.at(corners[k]);
      const Vec2 a = place_of.at(corners[(k + 1) % 3]) - at, b = place_of.at(corners[(k + 2) % 3]) - at;
      smallest = std::min(smallest, std::abs(std::atan2(cross(a, b), a.dot(b))));
    }
  }
  return smallest;
}

/// The largest distance of many places of the surfaces from the mesh.
double chord_error(const AttributeSurface& surface, const SurfaceTessellation& made) {
  Random random(3);
  double error = 0;
  for (const SurfacePart& part : made.parts) {
    std::vector<std::array<Vec3, 3>> triangles;
    for (std::size_t t = 0; t < part.triangle_count; ++t) {
      const auto corners = made.mesh.face(part.first_triangle + t);
      triangles.push_back(
          {made.mesh.positions[corners[0]], made.mesh.positions[corners[1]], made.mesh.positions[corners[2]]});
    }
    const TriangleTree tree(std::move(triangles));
    const FaceSurface& face = *surface.faces[part.face].surface;
    for (int i = 0; i < 1500; ++i) {
      double a = random.unit(), b = random.unit();
      if (a + b > 1) a = 1 - a, b = 1 - b;
      const std::size_t k = random.below(static_cast<std::uint32_t>(face.domain().corners.size()));
      error = std::max(error, tree.nearest(face.at(place_in(face.domain(), {k, a, b})), 1e300).distance);
    }
  }
  return error;
}

/// How many triangles look away from the normal of their first corner: at the tips of leaves there are some.
std::size_t turned_over(const PolyMesh& mesh) {
  const auto& normals = std::get<std::vector<double>>(mesh.channel("normal", Domain::Corner)->data);
  std::size_t count = 0;
  for (std::size_t t = 0; t < mesh.face_count(); ++t) {
    const auto corners = mesh.face(t);
    const Vec3& a = mesh.positions[corners[0]];
    const Vec3 normal = (mesh.positions[corners[1]] - a).cross(mesh.positions[corners[2]] - a);
    count += normal.dot(Vec3(normals[9 * t], normals[9 * t + 1], normals[9 * t + 2])) < 0 ? 1U : 0U;
  }
  return count;
}

/// Keeps everything and counts what is made.
class CountingCache final : public StageCache {
 public:
  std::shared_ptr<const void> get(std::string_view stage, std::string_view content,
                                  const std::function<Stage()>& make) override {
    auto& result = kept_[{std::string(stage), std::string(content)}];
    if (result == nullptr) {
      result = make().result;
      ++made[std::string(stage)];
    }
    return result;
  }

  std::map<std::string, int> made;

 private:
  std::map<std::pair<std::string, std::string>, std::shared_ptr<const void>> kept_;
};

}  // namespace

TEST_CASE("fans of n rings have the promised counts and cover their domains") {
  for (const std::size_t sides : {3U, 4U, 5U, 6U, 9U, 12U}) {
    for (const std::size_t n : {1U, 2U, 3U, 8U, 16U}) {
      INFO(sides << " sides, " << n << " samples");
      const AttributeNetwork network = hill(sides, 0.3);
      const AttributeSurface surface = surface_of(network);
      const SurfaceTessellation made = mesh_of(network, surface, with_samples(n));
      CHECK(made.mesh.vertex_count() == 1 + sides * n * (n + 1) / 2);
      CHECK(made.mesh.face_count() == sides * n * n);
      CHECK(figures_of(made.mesh).boundary_edges == sides * n);
      check_parts(network, surface, made);
    }
  }
}

TEST_CASE("a face of two curves is covered once whatever the number of samples") {
  for (const std::size_t n : {1U, 2U, 3U, 7U, 16U}) {
    INFO(n << " samples");
    const std::size_t even = n + n % 2;
    const AttributeNetwork alone = small_leaf();
    const AttributeSurface surface = surface_of(alone);
    const SurfaceTessellation made = mesh_of(alone, surface, with_samples(n));
    CHECK(made.mesh.face_count() == even * even);
    CHECK(figures_of(made.mesh).boundary_edges == 2 * even);
    check_parts(alone, surface, made);

    const AttributeNetwork network = leaf_between_triangles();
    const AttributeSurface three = surface_of(network);
    const SurfaceTessellation joined = mesh_of(network, three, with_samples(n));
    const MeshReport figures = figures_of(joined.mesh);
    CHECK(figures.boundary_edges == 4 * n);
    CHECK(figures.nonmanifold_edges == 0);
    CHECK(figures.oriented);
    CHECK(figures.components == 1);
    check_parts(network, three, joined);
  }
}

TEST_CASE("the car is watertight: free edges only along free curves, no other vertex twice") {
  const AttributeNetwork network = shipped_network("car_intact");
  const AttributeSurface surface = surface_of(network);
  const SurfaceTessellation made = mesh_of(network, surface);
  const MeshReport figures = figures_of(made.mesh);
  CHECK(figures.boundary_edges == 224);  // 14 free curves of 16 parts
  CHECK(figures.nonmanifold_edges == 0);
  CHECK(figures.nonmanifold_vertices == 0);
  CHECK(figures.oriented);
  CHECK(figures.components == 1);
  std::size_t samples = 0;
  for (const SurfacePart& part : made.parts) samples += part.vertices.size();
  CHECK(samples == 12261);
  std::set<std::array<double, 3>> places;
  for (const Vec3& position : made.mesh.positions) places.insert({position.x(), position.y(), position.z()});
  CHECK(places.size() == made.mesh.vertex_count());
  check_parts(network, surface, made);
  for (std::size_t n = 0; n < network.nodes.size(); ++n)
    CHECK(std::ranges::count(made.mesh.positions, network.nodes[n].point) == 1);
}

TEST_CASE("both faces of a smooth curve have the same normals along it") {
  const AttributeNetwork network = shipped_network("car_intact");
  const AttributeSurface surface = surface_of(network);
  const SurfaceTessellation made = mesh_of(network, surface);
  const auto& normals = std::get<std::vector<double>>(made.mesh.channel("normal", Domain::Corner)->data);
  std::map<Index, std::map<Index, Vec3>> normal_of;  // by part and vertex
  for (std::size_t p = 0; p < made.parts.size(); ++p) {
    for (std::size_t c = 3 * made.parts[p].first_triangle;
         c < 3 * (made.parts[p].first_triangle + made.parts[p].triangle_count); ++c)
      normal_of[static_cast<Index>(p)][made.mesh.corners[c]] =
          Vec3(normals[3 * c], normals[3 * c + 1], normals[3 * c + 2]);
  }
  std::size_t compared = 0;
  for (std::size_t c = 0; c < network.curves.size(); ++c) {
    if (!surface.curves[c].smooth) continue;
    const auto& first = normal_of.at(surface.curves[c].faces[0]);
    for (const auto& [vertex, normal] : normal_of.at(surface.curves[c].faces[1])) {
      const auto other = first.find(vertex);
      const bool is_inner = other != first.end() && vertex >= surface.corners;
      if (!is_inner) continue;
      CHECK(angle_between(normal, other->second) < 1e-9);
      ++compared;
    }
  }
  CHECK(compared >= 17 * 15);
}

TEST_CASE("a face whose loop runs against its neighbour's is turned round with its normals") {
  AttributeNetwork network = leaf_between_triangles();
  const SurfaceTessellation plain = mesh_of(network, surface_of(network));
  auto& loop = network.faces[1].loop;
  std::ranges::reverse(loop);
  for (AttributeSide& side : loop) side.reversed = !side.reversed;
  const AttributeSurface surface = surface_of(network);
  CHECK(surface.faces[1].flipped);
  const SurfaceTessellation made = mesh_of(network, surface);
  CHECK(figures_of(made.mesh).oriented);
  check_parts(network, surface, made);
  CHECK(turned_over(made.mesh) == turned_over(plain.mesh));
  CHECK(turned_over(made.mesh) < made.mesh.face_count() / 20);
}

TEST_CASE("refined triangles keep to the tolerance, watertight, and with fewer of them where it is coarser") {
  for (const std::string name : {"tri_point", "pocket5", "car_crashed"}) {
    const AttributeNetwork network = shipped_network(name);
    const AttributeSurface surface = surface_of(network);
    std::size_t before = 0;
    for (const double tolerance : {0.02, 0.005, 0.001}) {
      INFO(name << ", tolerance " << tolerance);
      const SurfaceTessellation made = mesh_of(network, surface, with_tolerance(tolerance));
      CHECK(made.findings.empty());
      CHECK(chord_error(surface, made) <= 1.2 * tolerance);
      const MeshReport figures = figures_of(made.mesh);
      CHECK(figures.nonmanifold_edges == 0);
      CHECK(figures.oriented);
      CHECK(figures.components == 1);
      check_parts(network, surface, made);
      CHECK(made.mesh.face_count() > before);
      before = made.mesh.face_count();
    }
  }
}

TEST_CASE("what is flat needs no places inside, and a point is a vertex where that is asked for") {
  AttributeNetwork network = straight_loop({{0, 0, 0}, {2, 0, 0}, {2, 1, 0}, {0, 1, 0}});
  CHECK(mesh_of(network, surface_of(network), with_tolerance(1e-6)).mesh.face_count() == 4);
  network.points.push_back({"p", 0, {0.5, 0.3, 0.4}, {}, {}, PointProfile::Smooth, {}});
  const AttributeSurface surface = surface_of(network);
  SurfaceTessellationOptions options = with_tolerance(0.01);
  CHECK(std::ranges::count_if(mesh_of(network, surface, options).mesh.positions,
                              [](const Vec3& at) { return (at - Vec3(0.5, 0.3, 0.4)).norm() < 1e-12; }) == 1);
  CHECK(chord_error(surface, mesh_of(network, surface, options)) < 0.012);
  options.insert_points = false;
  CHECK(chord_error(surface, mesh_of(network, surface, options)) < 0.012);
}

TEST_CASE("points and inner curves have vertices of fans, and sides stay as they are") {
  std::vector<AttributeNetwork> networks = {rich_sheet(3, 2), shipped_network("car_crashed"),
                                            shipped_network("pocket5"), with_points(small_leaf(), 4, 0.2, 1)};
  for (const std::size_t sides : {3U, 5U, 8U, 12U}) networks.push_back(with_points(random_loop(sides, 7), 6, 0.1, 2));
  for (const AttributeNetwork& network : networks) {
    const AttributeSurface surface = surface_of(network);
    for (const std::size_t n : {1U, 2U, 5U, 16U, 31U}) {
      INFO(network.name << ", " << network.faces[0].loop.size() << " sides, " << n << " samples");
      SurfaceTessellationOptions options = with_samples(n);
      const SurfaceTessellation made = mesh_of(network, surface, options);
      options.insert_points = false;
      const SurfaceTessellation plain = mesh_of(network, surface, options);
      check_parts(network, surface, made);
      CHECK(figures_of(made.mesh).boundary_edges == figures_of(plain.mesh).boundary_edges);
      CHECK(figures_of(made.mesh).nonmanifold_edges == 0);
      CHECK(figures_of(made.mesh).oriented == figures_of(plain.mesh).oriented);
      std::size_t inside = 0;
      for (std::size_t p = 0; p < made.parts.size(); ++p) {
        const SurfacePart &part = made.parts[p], &even = plain.parts[p];
        const FaceSurface& face = *surface.faces[part.face].surface;
        const auto is_vertex = [&](const Vec3& place) {
          return std::ranges::any_of(
              part.vertices, [&](Index v) { return (made.mesh.positions[v] - place).norm() < 1e-9 * face.sigma(); });
        };
        CHECK(std::ranges::all_of(face.points(), is_vertex, &PlacedPoint::point));
        for (const PlacedCurve& curve : face.curves()) {
          CHECK(std::ranges::count_if(curve.points, is_vertex) >= std::min<std::ptrdiff_t>(static_cast<int>(n) / 3, 8));
        }
        inside += part.vertices.size() - even.vertices.size();
        if (n >= 5) CHECK(smallest_angle(made, part) > 0.3 * smallest_angle(plain, even));
      }
      CHECK(inside == made.mesh.vertex_count() - plain.mesh.vertex_count());
      if (network.faces[0].inner.empty() && n == 16) CHECK(inside == 0);
      const std::size_t along_curves = made.parts.front().vertices.front();  // those inside faces come last
      for (std::size_t v = 0; v < along_curves; ++v) CHECK(made.mesh.positions[v] == plain.mesh.positions[v]);
    }
  }
}

TEST_CASE("samples that are given for a curve are vertices as they are") {
  const AttributeNetwork network = leaf_between_triangles();
  const AttributeSurface surface = surface_of(network);
  SurfaceTessellationOptions options = with_samples(6);
  options.given.resize(network.curves.size());
  for (const double at : {0.0, 0.1, 0.35, 0.6, 0.95, 1.0}) {
    options.given[0].at.push_back(at);
    options.given[0].points.push_back(surface.curves[0].curve->at(at));
  }
  for (const bool refined : {false, true}) {
    if (refined) options.tolerance = 0.01;
    const SurfaceTessellation made = mesh_of(network, surface, options);
    for (const Vec3& point : options.given[0].points) CHECK(std::ranges::count(made.mesh.positions, point) == 1);
    const MeshReport figures = figures_of(made.mesh);
    CHECK(figures.nonmanifold_edges == 0);
    CHECK(figures.oriented);
    CHECK(figures.components == 1);
    CHECK(figures.boundary_loops == 1);
    CHECK(figures.euler_characteristic == 1);
  }
}

TEST_CASE("triangles are the same with a cache, and a moved point makes its face alone again") {
  AttributeNetwork network = shipped_network("car_crashed");
  CountingCache cache;
  SurfaceTessellationOptions options;
  options.cache = &cache;
  const SurfaceTessellation plain = mesh_of(network, surface_of(network));
  const SurfaceTessellation first = mesh_of(network, surface_of(network), options);
  CHECK(first.mesh.positions == plain.mesh.positions);
  CHECK(first.mesh.corners == plain.mesh.corners);
  CHECK(cache.made == std::map<std::string, int>{{"samples of a surface", 21}});
  network.points[0].point.z() += 0.05;
  const SurfaceTessellation moved = mesh_of(network, surface_of(network), options);
  CHECK(cache.made == std::map<std::string, int>{{"samples of a surface", 22}});
  for (std::size_t p = 0; p < moved.parts.size(); ++p) {
    const bool is_its_face = moved.parts[p].face == network.points[0].face;
    std::size_t changed = 0;
    for (const Index vertex : moved.parts[p].vertices)
      changed += moved.mesh.positions[vertex] != first.mesh.positions[vertex] ? 1U : 0U;
    CHECK((changed > 0) == is_its_face);
  }
}

TEST_CASE("a face that may not have enough places says what it keeps to") {
  const AttributeNetwork network = hill(5, 0.5);
  const AttributeSurface surface = surface_of(network);
  SurfaceTessellationOptions options = with_tolerance(1e-4);
  options.most_places = 40;
  const SurfaceTessellation made = mesh_of(network, surface, options);
  REQUIRE(made.findings.size() == 1);
  CHECK(made.findings[0].code == "W_TOLERANCE");
  CHECK(made.findings[0].subjects[0].id == "f");
  CHECK(made.parts[0].vertices.size() - figures_of(made.mesh).boundary_edges == 40);
  check_parts(network, surface, made);
}

TEST_CASE("nodes nearer than the tolerance are one vertex where a loop joins them") {
  AttributeNetwork network = leaf_between_triangles();
  network.tolerance = 0.01;
  network.nodes.push_back({"twin", network.nodes[0].point + Vec3(0, 0.004, 0)});
  network.curves[2].from = static_cast<Index>(network.nodes.size() - 1);  // of the face "left"
  const AttributeSurface surface = surface_of(network);
  const SurfaceTessellation made = mesh_of(network, surface);
  CHECK(made.parts.size() == 3);
  const MeshReport figures = figures_of(made.mesh);
  CHECK(figures.boundary_edges == 64);
  CHECK(figures.boundary_loops == 1);
  CHECK(figures.components == 1);
}

TEST_CASE("triangles of a cancelled computation aren't made") {
  const AttributeNetwork network = hill(5, 0.3);
  const AttributeSurface surface = surface_of(network);
  const std::atomic<bool> cancel = true;
  Progress progress({}, &cancel);
  CHECK_THROWS_AS(tessellate(network, surface, progress), Cancelled);
}
