// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include <Eigen/Geometry>
#include <catch2/catch.hpp>

#include "croquis/base/error.h"
#include "croquis/mesh_editing/mesh_edit.h"
#include "croquis/mesh_editing/tag_edit.h"
#include "support/meshes/mesh_shapes.h"
#include "support/random.h"

namespace croquis {
namespace {

/// Edges of exactly one of the faces.
Elements rim_of(const MeshTopology& topology, const Elements& faces) {
  Elements rim;
  for (Index edge = 0; edge < topology.edge_count(); ++edge) {
    const auto corners = topology.edge_corners(edge);
    const auto inside = std::count_if(corners.begin(), corners.end(), [&](Index corner) {
      return std::binary_search(faces.begin(), faces.end(), topology.face(corner));
    });
    if (inside == 1) rim.push_back(edge);
  }
  return rim;
}

long euler(const PolyMesh& mesh) {
  const MeshTopology topology(mesh);
  return static_cast<long>(mesh.vertex_count()) - static_cast<long>(topology.edge_count()) +
         static_cast<long>(mesh.face_count());
}

/// Usable, every vertex manifold, every edge run both ways by its two faces.
void check_sound(const PolyMesh& mesh) {
  CHECK(validate(mesh).empty());
  const MeshTopology topology(mesh);
  for (Index v = 0; v < mesh.vertex_count(); ++v) CHECK(topology.is_manifold(v));
  for (Index edge = 0; edge < topology.edge_count(); ++edge) {
    const auto corners = topology.edge_corners(edge);
    CHECK(corners.size() <= 2);
    if (corners.size() == 2) CHECK(topology.vertex(corners[0]) != topology.vertex(corners[1]));
  }
}

double volume(const PolyMesh& mesh) {
  double sum = 0;
  for (std::size_t f = 0; f < mesh.face_count(); ++f) {
    const auto corners = mesh.face(f);
    for (std::size_t i = 1; i + 1 < corners.size(); ++i)
      sum += mesh.positions[corners[0]].dot(mesh.positions[corners[i]].cross(mesh.positions[corners[i + 1]])) / 6;
  }
  return sum;
}

std::vector<PolyMesh> closed_families() {
  return {test::cube(), test::uv_sphere(8, 5), test::torus(7, 5), test::double_torus(), test::tetrahedron()};
}

std::vector<PolyMesh> families() {
  std::vector<PolyMesh> all = closed_families();
  all.push_back(test::grid(4, 3));
  return all;
}

/// Tags on some edges and vertices, and two sets.
MeshTags random_tags(const MeshTopology& topology, test::Random& random) {
  MeshTags tags;
  Elements members, pins;
  for (Index edge = 0; edge < topology.edge_count(); ++edge) {
    const double chance = random.unit();
    if (chance < 0.3) tags = with_sharpness(tags, topology, Elements{edge}, 1 + std::floor(8 * random.unit()));
    if (chance < 0.1) members.push_back(edge);
  }
  for (Index v = 0; v < topology.vertex_count(); ++v)
    if (random.unit() < 0.2) pins.push_back(v);
  tags = with_pins(tags, pins, true);
  return members.empty() ? tags : with_set(tags, topology, "some", members, {}, 3);
}

double tagged_length(const PolyMesh& mesh, double sharpness) {
  double sum = 0;
  for (const Crease& crease : mesh.tags.creases) {
    if (crease.sharpness == sharpness)
      sum += (mesh.positions[crease.vertices[0]] - mesh.positions[crease.vertices[1]]).norm();
  }
  return sum;
}

/// Each edge's value is its length: what is carried over to another edge shows.
void add_lengths(PolyMesh& mesh) {
  const MeshTopology topology(mesh);
  std::vector<double> lengths;
  for (Index e = 0; e < topology.edge_count(); ++e) {
    const auto [a, b] = topology.edge_vertices(e);
    lengths.push_back((mesh.positions[a] - mesh.positions[b]).norm());
  }
  mesh.channels.push_back({"length", Domain::Edge, 1, lengths, {}});
}

/// How many edges have no value; all others must have their lengths.
std::size_t edges_without_value(const PolyMesh& mesh) {
  CHECK(validate(mesh).empty());
  const MeshTopology topology(mesh);
  const auto& lengths = std::get<std::vector<double>>(mesh.channel("length", Domain::Edge)->data);
  REQUIRE(lengths.size() == topology.edge_count());
  std::size_t without = 0;
  for (Index e = 0; e < topology.edge_count(); ++e) {
    if (std::isnan(lengths[e])) {
      ++without;
      continue;
    }
    const auto [a, b] = topology.edge_vertices(e);
    CHECK(lengths[e] == Approx((mesh.positions[a] - mesh.positions[b]).norm()));
  }
  return without;
}

TEST_CASE("edges whose ends survive an edit keep their values, new ones have none") {
  PolyMesh mesh = test::grid(4, 3);
  for (Vec3& position : mesh.positions) position.x() += 0.1 * position.x() * position.x() + 0.03 * position.y();
  add_lengths(mesh);
  const MeshTopology topology(mesh);
  CHECK(edges_without_value(delete_faces(mesh, topology, std::vector<Index>{0, 5}).mesh) == 0);
  // A cut through 3 quads halves 4 edges and adds 3.
  const Index across = find_edge(topology, 0, 1);
  CHECK(edges_without_value(loop_cut(mesh, topology, across).mesh) == 4 * 2 + 3);
  // The four edges at the sides of the lifted face.
  CHECK(edges_without_value(extrude_faces(mesh, topology, std::vector<Index>{5}, Vec3(0, 0, 1)).mesh) == 4);
  const Index inner = find_edge(topology, 6, 7);
  CHECK(edges_without_value(dissolve_edges(mesh, topology, std::vector<Index>{inner}).mesh) == 0);
}

TEST_CASE("moving vertices changes them and nothing else") {
  PolyMesh mesh = test::cube();
  mesh.tags.pins = {3};
  const Eigen::Affine3d map(Eigen::Translation3d(1, 2, 3));
  const PolyMesh moved = transformed(mesh, Elements{0, 5, 77}, map);
  for (Index v = 0; v < 8; ++v) {
    const Vec3 by = v == 0 || v == 5 ? Vec3(1, 2, 3) : Vec3(Vec3::Zero());
    CHECK(moved.positions[v] == mesh.positions[v] + by);
  }
  CHECK(moved.corners == mesh.corners);
  CHECK(moved.tags == mesh.tags);
}

TEST_CASE("normals from a file are forgotten where the surface changes") {
  PolyMesh mesh = test::grid(3, 1);
  AttributeChannel normal{"normal", Domain::Vertex, 3, std::vector<float>(3 * mesh.vertex_count(), 0.5F), {}};
  mesh.channels.push_back(normal);
  const PolyMesh moved = transformed(mesh, Elements{0}, Eigen::Affine3d(Eigen::Translation3d(0, 0, 1)));
  const auto& values = std::get<std::vector<float>>(moved.channel("normal", Domain::Vertex)->data);
  const auto neighbours = mesh.face(0);
  for (Index v = 0; v < mesh.vertex_count(); ++v) {
    const bool near = std::find(neighbours.begin(), neighbours.end(), v) != neighbours.end();
    CHECK(std::isnan(values[3 * v]) == near);
  }
}

TEST_CASE("a loop cut keeps the Euler number, the volume and all the tags' length") {
  test::Random random(11);
  for (PolyMesh mesh : families()) {
    const MeshTopology topology(mesh);
    mesh.tags = random_tags(topology, random);
    for (Index edge = 0; edge < topology.edge_count(); edge += 3) {
      const Elements ring = edge_ring(topology, edge);
      if (ring.size() < 2) {
        CHECK_THROWS_AS(loop_cut(mesh, topology, edge), Error);
        continue;
      }
      const double at = random.between(0.1, 0.9);
      const MeshEdit edit = loop_cut(mesh, topology, edge, at);
      check_sound(edit.mesh);
      CHECK(edit.lost.empty());
      CHECK(euler(edit.mesh) == euler(mesh));
      CHECK(edit.mesh.vertex_count() == mesh.vertex_count() + ring.size());
      CHECK(edit.mesh.face_count() == mesh.face_count() + edit.new_edges.size());
      CHECK(volume(edit.mesh) == Approx(volume(mesh)).margin(1e-12));
      for (int level = 1; level <= 9; ++level)
        CHECK(tagged_length(edit.mesh, level) == Approx(tagged_length(mesh, level)).margin(1e-12));
      CHECK(edit.mesh.tags.pins == mesh.tags.pins);
      const MeshTopology after(edit.mesh);
      CHECK(tagged_edges(edit.mesh.tags, after).size() == edit.mesh.tags.creases.size());
      const std::size_t halves = carried(edit, topology, after, ComponentKind::Edge, ring).size();
      CHECK(halves == 2 * ring.size());
      CHECK(edges_of(after, edit.new_edges).size() == edit.new_edges.size());
      if (const CreaseSet* set = find_set(mesh.tags, "some")) {
        const Elements members = carried(edit, topology, after, ComponentKind::Edge, set_edges(*set, topology));
        CHECK(set_edges(*find_set(edit.mesh.tags, "some"), after) == members);
      }
    }
  }
}

TEST_CASE("a cut lies where it was asked for, on one side all around, and the preview shows it") {
  const PolyMesh mesh = test::torus(9, 6);
  const MeshTopology topology(mesh);
  for (const double at : {0.25, 0.5, 0.8}) {
    const MeshEdit edit = loop_cut(mesh, topology, 4, at);
    const LoopCutPreview preview = loop_cut_preview(mesh, topology, 4, at);
    CHECK(preview.closed);
    REQUIRE(preview.points.size() + mesh.vertex_count() == edit.mesh.vertex_count());
    for (std::size_t i = 0; i < preview.points.size(); ++i)
      CHECK(edit.mesh.positions[mesh.vertex_count() + i] == preview.points[i]);
    const auto [a, b] = topology.edge_vertices(4);
    const Vec3 expected = mesh.positions[a] + at * (mesh.positions[b] - mesh.positions[a]);
    CHECK(std::any_of(preview.points.begin(), preview.points.end(),
                      [&](const Vec3& p) { return (p - expected).norm() < 1e-12; }));
    // Around a torus every cut edge's part is the same: no point lies on the other side.
    const auto height = [&](const Vec3& p) { return std::hypot(std::hypot(p.x(), p.y()) - 1, p.z()); };
    for (const Vec3& p : preview.points) CHECK(height(p) == Approx(height(expected)).margin(0.02));
  }
}

TEST_CASE("attributes are blended by a cut, categories taken from the nearer end") {
  PolyMesh mesh = test::grid(1, 1);
  std::vector<double> heat;
  std::vector<std::int32_t> group;
  for (const Vec3& p : mesh.positions) {
    heat.push_back(10 * p.x() + p.y());
    group.push_back(p.x() < 0.5 ? 4 : 9);
  }
  mesh.channels.push_back({"heat", Domain::Vertex, 1, heat, {}});
  mesh.channels.push_back({"group", Domain::Vertex, 1, group, {}});
  mesh.channels.push_back({"material", Domain::Face, 1, std::vector<std::int32_t>{7}, {"wood"}});
  mesh.channels.push_back({"broken", Domain::Corner, 1, std::vector<float>{1}, {}});
  const MeshTopology topology(mesh);
  for (Index edge = 0; edge < 4; ++edge) {
    const MeshEdit edit = loop_cut(mesh, topology, edge, 0.3);
    const auto& now = std::get<std::vector<double>>(edit.mesh.channel("heat", Domain::Vertex)->data);
    const auto& groups = std::get<std::vector<std::int32_t>>(edit.mesh.channel("group", Domain::Vertex)->data);
    for (Index v = 0; v < edit.mesh.vertex_count(); ++v) {
      const Vec3& p = edit.mesh.positions[v];
      CHECK(now[v] == Approx(10 * p.x() + p.y()));
      CHECK(groups[v] == (p.x() < 0.5 ? 4 : 9));
    }
    CHECK(std::get<std::vector<std::int32_t>>(edit.mesh.channel("material", Domain::Face)->data) ==
          std::vector<std::int32_t>{7, 7});
    CHECK(edit.mesh.channel("broken", Domain::Corner) == nullptr);
    REQUIRE(edit.lost.size() == 1);
    CHECK(edit.lost.front().code == "W_ATTRIBUTE_DROPPED");
  }
}

TEST_CASE("an extruded patch stays sound, adds the volume it sweeps and takes its tags along") {
  test::Random random(12);
  for (PolyMesh mesh : closed_families()) {
    const MeshTopology topology(mesh);
    mesh.tags = random_tags(topology, random);
    for (int round = 0; round < 6; ++round) {
      Elements faces = {random.below(static_cast<Index>(mesh.face_count()))};
      for (int grow = 0; grow < round % 3; ++grow) faces = grown(topology, ComponentKind::Face, faces);
      if (faces.size() == mesh.face_count()) continue;
      const Vec3 by = 0.1 * Vec3(random.between(-1, 1), random.between(-1, 1), random.between(-1, 1));
      const MeshEdit edit = extrude_faces(mesh, topology, faces, by);
      const Elements rim = rim_of(topology, faces);
      CHECK(validate(edit.mesh).empty());
      CHECK(euler(edit.mesh) == euler(mesh));
      CHECK(edit.mesh.face_count() == mesh.face_count() + rim.size());
      CHECK(edit.moved_faces == faces);
      CHECK(edit.new_faces.size() == rim.size());
      check_sound(edit.mesh);
      // Sweeping a patch with the area vector A by d adds A · d.
      Vec3 area = Vec3::Zero();
      for (const Index f : faces) {
        const auto corners = mesh.face(f);
        for (std::size_t i = 1; i + 1 < corners.size(); ++i)
          area += (mesh.positions[corners[i]] - mesh.positions[corners[0]])
                      .cross(mesh.positions[corners[i + 1]] - mesh.positions[corners[0]]) /
                  2;
      }
      CHECK(volume(edit.mesh) == Approx(volume(mesh) + area.dot(by)).margin(1e-9));
      // All tags are still edges; those of the patch and its rim lie on the lifted faces, the walls have none.
      const MeshTopology after(edit.mesh);
      const Elements tagged = tagged_edges(edit.mesh.tags, after);
      CHECK(tagged.size() == mesh.tags.creases.size());
      CHECK(edit.lost.empty());
      const Elements lifted_edges = converted(after, ComponentKind::Face, ComponentKind::Edge, edit.moved_faces);
      for (const Index edge : converted(after, ComponentKind::Face, ComponentKind::Edge, edit.new_faces)) {
        if (std::binary_search(tagged.begin(), tagged.end(), edge))
          CHECK(std::binary_search(lifted_edges.begin(), lifted_edges.end(), edge));
      }
    }
  }
}

TEST_CASE("two faces that touch in a vertex part there when they are lifted") {
  const PolyMesh mesh = test::grid(2, 2);
  const MeshTopology topology(mesh);
  Elements diagonal;
  for (Index f = 0; f < 4; ++f) {
    Vec3 middle = Vec3::Zero();
    for (const Index v : mesh.face(f)) middle += mesh.positions[v] / 4;
    if ((middle.x() < 1) == (middle.y() < 1)) diagonal.push_back(f);
  }
  REQUIRE(diagonal.size() == 2);
  const MeshEdit edit = extrude_faces(mesh, topology, diagonal, {0, 0, 1});
  CHECK(edit.mesh.vertex_count() == mesh.vertex_count() + 8);
  CHECK(edit.mesh.face_count() == 4 + 8);
  CHECK(validate(edit.mesh).empty());
  const MeshEdit whole = extrude_faces(mesh, topology, Elements{0, 1, 2, 3}, {0, 0, 1});
  CHECK(whole.mesh.vertex_count() == 9 + 8);  // the middle one goes up, the rim is copied
  check_sound(whole.mesh);
  CHECK_THROWS_AS(extrude_faces(mesh, topology, Elements{}, {0, 0, 1}), Error);
  const PolyMesh cube = test::cube();
  const MeshEdit closed = extrude_faces(cube, MeshTopology(cube), all_elements(6), {1, 0, 0});
  CHECK(closed.mesh.corners == cube.corners);
  CHECK(closed.mesh.positions[0] == cube.positions[0] + Vec3(1, 0, 0));
}

TEST_CASE("deleting faces takes along what only they had, and says which tags went") {
  PolyMesh mesh = test::cube();
  const MeshTopology topology(mesh);
  mesh.tags = with_sharpness({}, topology, all_elements(12), 2);
  mesh.tags.pins = {0};
  const Elements around = converted(topology, ComponentKind::Vertex, ComponentKind::Face, Elements{0});
  const MeshEdit edit = delete_faces(mesh, topology, around);
  CHECK(edit.mesh.face_count() == 3);
  CHECK(edit.mesh.vertex_count() == 7);
  CHECK(edit.mesh.tags.creases.size() == 9);
  CHECK(edit.mesh.tags.pins.empty());
  REQUIRE(edit.lost.size() == 1);
  CHECK(edit.lost.front().code == "W_TAGS_DROPPED");
  CHECK(edit.lost.front().subjects.size() == 4);
  check_sound(edit.mesh);
  const MeshTopology after(edit.mesh);
  CHECK(tagged_edges(edit.mesh.tags, after).size() == 9);
  CHECK(carried(edit, topology, after, ComponentKind::Face, all_elements(6)).size() == 3);
  CHECK(carried(edit, topology, after, ComponentKind::Vertex, Elements{0}).empty());
}

TEST_CASE("what is left after deleting faces is what it was") {
  test::Random random(13);
  for (PolyMesh mesh : families()) {
    const MeshTopology topology(mesh);
    mesh.tags = random_tags(topology, random);
    Elements gone;
    for (Index f = 0; f < mesh.face_count(); ++f)
      if (random.unit() < 0.3) gone.push_back(f);
    const MeshEdit edit = delete_faces(mesh, topology, gone);
    CHECK(validate(edit.mesh).empty());
    for (Index f = 0; f < edit.mesh.face_count(); ++f) {
      const auto now = edit.mesh.face(f);
      const auto before = mesh.face(edit.face_source[f]);
      REQUIRE(now.size() == before.size());
      for (std::size_t i = 0; i < now.size(); ++i) CHECK(edit.mesh.positions[now[i]] == mesh.positions[before[i]]);
    }
    const std::vector<double> was = edge_sharpness(mesh.tags, topology);
    const MeshTopology after(edit.mesh);
    const std::vector<double> is = edge_sharpness(edit.mesh.tags, after);
    for (Index edge = 0; edge < after.edge_count(); ++edge) {
      const auto [a, b] = after.edge_vertices(edge);
      CHECK(is[edge] == was[find_edge(topology, edit.vertex_source[a], edit.vertex_source[b])]);
    }
  }
}

TEST_CASE("dissolving the loop that a cut made gives the mesh back") {
  for (const PolyMesh& mesh : {test::torus(7, 5), test::grid(4, 3), test::double_torus()}) {
    const MeshTopology topology(mesh);
    for (Index edge = 0; edge < topology.edge_count(); edge += 5) {
      const MeshEdit cut = loop_cut(mesh, topology, edge, 0.4);
      const MeshTopology after(cut.mesh);
      const MeshEdit back = dissolve_edges(cut.mesh, after, edges_of(after, cut.new_edges));
      CHECK(back.lost.empty());
      check_sound(back.mesh);
      CHECK(back.mesh.face_count() == mesh.face_count());
      CHECK(euler(back.mesh) == euler(mesh));
      // On a rim the cut's ends stay as corners.
      const bool closed = boundary_edges(topology).empty();
      CHECK(back.mesh.vertex_count() == mesh.vertex_count() + (closed ? 0U : 2U));
      CHECK(volume(back.mesh) == Approx(volume(mesh)).margin(1e-12));
    }
  }
}

TEST_CASE("an inset leaves each edge by its width, whatever the corners' angles are") {
  Eigen::Affine3d leaning = Eigen::Affine3d::Identity();
  leaning.linear() << 1, 0.7, 0.2, 0, 1, 0.4, 0, 0, 1;
  for (const PolyMesh& mesh : {test::cube(), test::tetrahedron(), test::transformed(test::cube(), leaning)}) {
    const MeshTopology topology(mesh);
    for (Index face = 0; face < mesh.face_count(); ++face) {
      const Elements one{face};
      constexpr double width = 0.05;
      const MeshEdit edit = inset_faces(mesh, topology, one, width);
      check_sound(edit.mesh);
      CHECK(volume(edit.mesh) == Approx(volume(mesh)));
      REQUIRE(edit.moved_faces.size() == 1);
      const auto outer = mesh.face(face), inner = edit.mesh.face(edit.moved_faces.front());
      REQUIRE(inner.size() == outer.size());
      for (std::size_t i = 0; i < outer.size(); ++i) {
        const Vec3& start = mesh.positions[outer[i]];
        const Vec3 along = (mesh.positions[outer[(i + 1) % outer.size()]] - start).normalized();
        for (const std::size_t end : {i, (i + 1) % outer.size()}) {
          const Vec3 off = edit.mesh.positions[inner[end]] - start;
          CHECK((off - off.dot(along) * along).norm() == Approx(width));
        }
      }
    }
  }
}

TEST_CASE("dissolving an inner vertex leaves one polygon around it; on a rim the corner is cut off") {
  const PolyMesh mesh = test::grid(2, 2);
  const MeshTopology topology(mesh);
  const auto vertex_at = [&](double x, double y) {
    for (Index v = 0; v < mesh.vertex_count(); ++v)
      if (mesh.positions[v].x() == x && mesh.positions[v].y() == y) return v;
    return no_index;
  };
  const MeshEdit inner = dissolve_vertices(mesh, topology, Elements{vertex_at(1, 1)});
  CHECK(inner.mesh.face_count() == 1);
  CHECK(inner.mesh.vertex_count() == 8);
  CHECK(inner.mesh.face(0).size() == 8);
  const MeshEdit corner = dissolve_vertices(mesh, topology, Elements{vertex_at(0, 0)});
  CHECK(corner.mesh.face_count() == 4);
  CHECK(corner.mesh.vertex_count() == 8);
  CHECK(corner.mesh.corners.size() == mesh.corners.size() - 1);
  const MeshEdit rim = dissolve_vertices(mesh, topology, Elements{vertex_at(1, 0)});
  CHECK(rim.mesh.face_count() == 3);
  CHECK(rim.mesh.vertex_count() == 8);
  for (const MeshEdit* edit : {&inner, &corner, &rim}) check_sound(edit->mesh);
  PolyMesh loose;
  loose.positions = {{0, 0, 0}, {1, 0, 0}};
  CHECK(dissolve_vertices(loose, MeshTopology(loose), Elements{1}).mesh.vertex_count() == 1);
}

TEST_CASE("what can't be one polygon stays, and is reported") {
  const PolyMesh cube = test::cube();
  const MeshTopology topology(cube);
  const MeshEdit all = dissolve_edges(cube, topology, all_elements(12));
  CHECK(all.mesh.corners == cube.corners);
  REQUIRE(all.lost.size() == 1);
  CHECK(all.lost.front().code == "W_NOT_DISSOLVED");
  // A ring of faces would have two rims.
  const PolyMesh torus = test::torus(8, 6);
  const MeshTopology of_torus(torus);
  const MeshEdit ring = dissolve_edges(torus, of_torus, edge_ring(of_torus, 0));
  CHECK(ring.mesh.face_count() == torus.face_count());
  CHECK(ring.lost.size() == 1);
}

TEST_CASE("random dissolving never makes an unsound mesh") {
  test::Random random(14);
  for (int round = 0; round < 40; ++round) {
    for (PolyMesh mesh : families()) {
      const MeshTopology topology(mesh);
      mesh.tags = random_tags(topology, random);
      Elements edges, vertices;
      for (Index e = 0; e < topology.edge_count(); ++e)
        if (random.unit() < 0.1) edges.push_back(e);
      for (Index v = 0; v < topology.vertex_count(); ++v)
        if (random.unit() < 0.05) vertices.push_back(v);
      for (const MeshEdit& edit :
           {dissolve_edges(mesh, topology, edges), dissolve_vertices(mesh, topology, vertices)}) {
        CHECK(validate(edit.mesh).empty());
        const MeshTopology after(edit.mesh);
        CHECK(tagged_edges(edit.mesh.tags, after).size() == edit.mesh.tags.creases.size());
        for (Index e = 0; e < after.edge_count(); ++e) CHECK(after.edge_corners(e).size() <= 2);
      }
      const MeshEdit faces = dissolve_edges(mesh, topology, edges);
      if (boundary_edges(topology).empty()) CHECK(euler(faces.mesh) == euler(mesh));
    }
  }
}

TEST_CASE("polylines stay with their vertices or are reported") {
  PolyMesh mesh = test::grid(2, 1);
  mesh.add_line(std::vector<Index>{mesh.face(0)[0], mesh.face(0)[1]});
  mesh.add_line(std::vector<Index>{mesh.face(1)[0], mesh.face(1)[1], mesh.face(1)[2]});
  const MeshTopology topology(mesh);
  const MeshEdit cut = loop_cut(mesh, topology, 0);
  CHECK(cut.mesh.line_count() == 2);
  const MeshEdit less = delete_faces(mesh, topology, Elements{1});
  CHECK(less.mesh.line_count() == 1);
  REQUIRE(less.lost.size() == 1);
  CHECK(less.lost.front().code == "W_LINES_DROPPED");
}

/// Meshes as files bring them: edges of four faces, vertices of two fans, turned faces, one-sided strips, soups.
std::vector<PolyMesh> unsound_families() {
  PolyMesh winged = test::grid(2, 2);  // a third face on an inner edge
  winged.positions.push_back({1, 0.5, 1});
  const MeshTopology topology(winged);
  for (Index edge = 0; edge < topology.edge_count(); ++edge) {
    if (topology.edge_corners(edge).size() != 2) continue;
    winged.add_triangle(topology.edge_vertices(edge)[0], topology.edge_vertices(edge)[1], 9);
    break;
  }
  return {winged,
          test::moebius(5),
          test::moebius(6),
          test::tetrahedra_sharing_edge(),
          test::tetrahedra_sharing_vertex(),
          test::flipped_face(test::torus(6, 4), 5),
          test::random_soup(2, 40),
          test::merged(test::cube(), test::cube()),
          test::without_faces(test::torus(6, 4), std::vector<Index>{0, 7, 8})};
}

TEST_CASE("edits of unsound meshes give usable meshes, whatever they are asked to do") {
  test::Random random(15);
  for (PolyMesh mesh : unsound_families()) {
    const MeshTopology topology(mesh);
    mesh.tags = random_tags(topology, random);
    const auto some = [&](std::size_t count, double chance) {
      Elements elements;
      for (Index i = 0; i < count; ++i)
        if (random.unit() < chance) elements.push_back(i);
      return elements;
    };
    for (int round = 0; round < 25; ++round) {
      std::vector<MeshEdit> edits = {delete_faces(mesh, topology, some(mesh.face_count(), 0.2)),
                                     dissolve_edges(mesh, topology, some(topology.edge_count(), 0.15)),
                                     dissolve_vertices(mesh, topology, some(mesh.vertex_count(), 0.1))};
      const Elements faces = some(mesh.face_count(), 0.3);
      if (!faces.empty()) edits.push_back(extrude_faces(mesh, topology, faces, {0.1, 0.2, 0.3}));
      const Index edge = random.below(static_cast<Index>(topology.edge_count()));
      if (edge_ring(topology, edge).size() > 1) edits.push_back(loop_cut(mesh, topology, edge, random.unit()));
      for (const MeshEdit& edit : edits) {
        CHECK(validate(edit.mesh).empty());
        const MeshTopology after(edit.mesh);
        CHECK(tagged_edges(edit.mesh.tags, after).size() == edit.mesh.tags.creases.size());
        CHECK(edit.vertex_source.size() == edit.mesh.vertex_count());
        CHECK(edit.face_source.size() == edit.mesh.face_count());
        for (const ComponentKind kind : {ComponentKind::Vertex, ComponentKind::Edge, ComponentKind::Face})
          for (const Index element : carried(edit, topology, after, kind, all_elements(element_count(topology, kind))))
            CHECK(element < element_count(after, kind));
      }
    }
  }
}

}  // namespace
}  // namespace croquis
