// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <limits>
#include <map>
#include <set>
#include <string>
#include <vector>

#include <catch2/catch.hpp>

#include "algorithms/perspective/drawing/end_linkage.h"
#include "croquis/perspective/drawing_vertices.h"
#include "support/perspective/solid_drawing.h"
#include "support/perspective/solids.h"
#include "support/perspective/views.h"
#include "support/random.h"

using namespace croquis;
using namespace croquis::test;

namespace {

/// A vertex by the ends of its strokes.
using Ends = std::set<std::pair<std::string, bool>>;

Ends ends_of(const PerspectiveDrawing& drawing, const DrawingVertex& vertex) {
  Ends ends;
  for (const StrokeEnd& end : vertex.ends) ends.emplace(drawing.strokes[end.stroke].id, end.at_end);
  return ends;
}

std::set<Ends> partition(const PerspectiveDrawing& drawing, const DrawingVertices& found) {
  std::set<Ends> result;
  for (const DrawingVertex& vertex : found.vertices) result.insert(ends_of(drawing, vertex));
  return result;
}

/// The same from the names that the test drawing gives.
std::set<Ends> true_partition(const PerspectiveDrawing& drawing) {
  std::map<std::string, Ends> vertices;
  for (const PerspectiveStroke& stroke : drawing.strokes) {
    if (stroke.from.empty()) continue;
    vertices[stroke.from].emplace(stroke.id, false);
    vertices[stroke.to].emplace(stroke.id, true);
  }
  std::set<Ends> result;
  for (const auto& [name, ends] : vertices) result.insert(ends);
  return result;
}

PerspectiveDrawing without_names(PerspectiveDrawing drawing) {
  for (PerspectiveStroke& stroke : drawing.strokes) stroke.from = stroke.to = "";
  return drawing;
}

PerspectiveStroke line(const std::string& id, const Vec2& a, const Vec2& b, StrokeGroup group = StrokeGroup::NormalY) {
  PerspectiveStroke stroke;
  stroke.id = id;
  stroke.group = group;
  stroke.pieces = {{a, a + (b - a) / 3, b - (b - a) / 3, b}};
  stroke.straight = true;
  return stroke;
}

PerspectiveStroke arc(const std::string& id, const Vec2& a, const Vec2& b, double height) {
  PerspectiveStroke stroke = line(id, a, b);
  stroke.straight = false;
  stroke.pieces[0][1].y() -= height;
  stroke.pieces[0][2].y() -= height;
  return stroke;
}

PerspectiveDrawing sheet(std::vector<PerspectiveStroke> strokes) {
  PerspectiveDrawing drawing;
  drawing.image_size = {1000, 750};
  drawing.strokes = std::move(strokes);
  return drawing;
}

std::vector<std::string> codes_of(const Findings& findings) {
  std::vector<std::string> codes;
  for (const Finding& finding : findings) codes.push_back(finding.code);
  return codes;
}

using Codes = std::vector<std::string>;

using Cluster = std::vector<std::size_t>;

bool may_join(const std::vector<LinkagePoint>& points, const Cluster& a, const Cluster& b) {
  for (const std::size_t i : a) {
    for (const std::size_t j : b) {
      const bool grouped = points[i].group != no_index && points[j].group != no_index;
      if (grouped && points[i].group != points[j].group) return false;
      if (points[i].owner == points[j].owner && !grouped) return false;
    }
  }
  return true;
}

double mean_distance(const std::vector<LinkagePoint>& points, const Cluster& a, const Cluster& b) {
  double sum = 0;
  for (const std::size_t i : a) {
    for (const std::size_t j : b) sum += (points[i].place - points[j].place).norm();
  }
  return sum / static_cast<double>(a.size() * b.size());
}

/// By the definition: all pairs of clusters, again after each join.
std::set<Cluster> clusters_by_definition(const std::vector<LinkagePoint>& points, double limit) {
  std::vector<Cluster> clusters;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const auto same = std::find_if(clusters.begin(), clusters.end(), [&](const Cluster& cluster) {
      return points[i].group != no_index && points[cluster[0]].group == points[i].group;
    });
    if (same != clusters.end()) {
      same->push_back(i);
    } else {
      clusters.push_back({i});
    }
  }
  while (true) {
    double best = limit;
    std::pair<std::size_t, std::size_t> pair{0, 0};
    for (std::size_t i = 0; i < clusters.size(); ++i) {
      for (std::size_t j = i + 1; j < clusters.size(); ++j) {
        if (!may_join(points, clusters[i], clusters[j])) continue;
        const double distance = mean_distance(points, clusters[i], clusters[j]);
        if (distance < best) {
          best = distance;
          pair = {i, j};
        }
      }
    }
    if (pair.second == 0) break;
    auto& into = clusters[pair.first];
    into.insert(into.end(), clusters[pair.second].begin(), clusters[pair.second].end());
    clusters.erase(clusters.begin() + static_cast<std::ptrdiff_t>(pair.second));
  }
  std::set<Cluster> result;
  for (Cluster& cluster : clusters) {
    std::sort(cluster.begin(), cluster.end());
    result.insert(cluster);
  }
  return result;
}

std::set<Cluster> clusters_of(const std::vector<Index>& numbers) {
  std::vector<Cluster> clusters(numbers.size());
  for (std::size_t i = 0; i < numbers.size(); ++i) clusters[numbers[i]].push_back(i);
  std::set<Cluster> result(clusters.begin(), clusters.end());
  result.erase(Cluster{});
  return result;
}

}  // namespace

TEST_CASE("drawing vertices: jittered ends without names meet where the solid's vertices are") {
  for (const PerspectiveSolid& solid : all_solids()) {
    for (const View& view : all_views()) {
      if (view.name == "cropped") continue;  // a smaller sheet with a smaller limit
      SolidDrawingOptions options;
      options.end_jitter = 0.4;
      options.noise = 0.4;
      const PerspectiveDrawing drawing = drawn(solid, view, options).drawing;
      INFO(solid.name << ", " << view.name);
      const PerspectiveDrawing nameless = without_names(drawing);
      const DrawingVertices found = find_drawing_vertices(nameless);
      CHECK(found.vertices.size() == solid.network.vertices.size());
      CHECK(partition(nameless, found) == true_partition(drawing));
      CHECK(found.warnings.empty());
    }
  }
}

TEST_CASE("drawing vertices: names win over places") {
  SolidDrawingOptions options;
  options.noise = 30;
  options.end_jitter = 20;
  const PerspectiveSolid solid = camera_ring();
  const PerspectiveDrawing drawing = drawn(solid, View{}, options).drawing;
  const DrawingVertices found = find_drawing_vertices(drawing);
  CHECK(partition(drawing, found) == true_partition(drawing));
  for (const DrawingVertex& vertex : found.vertices) {
    Vec2 sum = Vec2::Zero();
    for (const StrokeEnd& end : vertex.ends) {
      const PerspectiveStroke& stroke = drawing.strokes[end.stroke];
      sum += end.at_end ? stroke.end() : stroke.start();
      CHECK((end.at_end ? stroke.to : stroke.from) == vertex.name);
    }
    CHECK((vertex.position - sum / static_cast<double>(vertex.ends.size())).norm() < 1e-9);
  }
  PerspectiveDrawing close = sheet(
      {line("a", {100, 100}, {200, 100}), line("b", {200, 100}, {200, 200}), line("c", {200.5, 100}, {300, 100})});
  close.strokes[0].to = "p";
  close.strokes[1].from = "q";
  CHECK(find_drawing_vertices(close).vertices.size() == 5);
  close.strokes[1].from = "";
  CHECK(find_drawing_vertices(close).vertices.size() == 4);
}

TEST_CASE("drawing vertices: order, direction and ids of strokes change nothing") {
  Random random(11);
  for (const PerspectiveSolid& solid : all_solids()) {
    SolidDrawingOptions options;
    options.noise = 1;
    options.end_jitter = 0.6;
    options.vertex_ids = false;
    const PerspectiveDrawing drawing = drawn(solid, View{}, options).drawing;
    const DrawingVertices found = find_drawing_vertices(drawing);
    PerspectiveDrawing other = drawing;
    for (std::size_t i = other.strokes.size(); i > 1; --i) {
      std::swap(other.strokes[i - 1], other.strokes[random.below(static_cast<std::uint32_t>(i))]);
    }
    for (PerspectiveStroke& stroke : other.strokes) {
      stroke.id = "n" + std::to_string(random.bits());
      if (random.below(2) == 0) continue;
      std::reverse(stroke.pieces.begin(), stroke.pieces.end());
      for (PictureCubic& piece : stroke.pieces) std::reverse(piece.begin(), piece.end());
    }
    const DrawingVertices again = find_drawing_vertices(other);
    REQUIRE(again.vertices.size() == found.vertices.size());
    for (std::size_t i = 0; i < found.vertices.size(); ++i) {
      CHECK(again.vertices[i].position == found.vertices[i].position);
      CHECK(again.vertices[i].ends.size() == found.vertices[i].ends.size());
    }
  }
}

TEST_CASE("drawing vertices: the ends of one stroke stay apart") {
  const PerspectiveDrawing drawing =
      sheet({line("short", {100, 100}, {102, 100}), line("left", {100, 100}, {20, 20}),
             line("right", {102, 100}, {200, 20}), arc("loop", {500, 500}, {500, 501}, 200)});
  const DrawingVertices found = find_drawing_vertices(drawing);
  CHECK(found.vertices.size() == 6);
  for (const auto& [start, end] : found.of_stroke) CHECK(start != end);
  CHECK(found.of_stroke[0][0] == found.of_stroke[1][0]);
  CHECK(found.of_stroke[0][1] == found.of_stroke[2][0]);
}

TEST_CASE("drawing vertices: only edges and links have vertices") {
  PerspectiveDrawing drawing =
      sheet({line("edge", {100, 100}, {200, 100}), line("construction", {100, 100}, {300, 100}),
             line("link", {200, 101}, {300, 200})});
  drawing.strokes[1].role = drawing.strokes[2].role = StrokeRole::Construction;
  drawing.strokes[2].link = true;
  const DrawingVertices found = find_drawing_vertices(drawing);
  CHECK(found.vertices.size() == 3);
  CHECK(found.of_stroke[1] == std::array<Index, 2>{no_index, no_index});
  CHECK(found.is_used(1));
  CHECK(found.of_stroke[0][1] == found.of_stroke[2][0]);
}

TEST_CASE("drawing vertices: strokes that can't be used are named and left out") {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  PerspectiveDrawing drawing =
      sheet({line("e3", {100, 100}, {200, 100}), line("e2", {100, nan}, {200, 100}),
             line("e1", {100, 100}, {100.1, 100}), line("e0", {100, 100}, {100, 300}, StrokeGroup::Unknown)});
  drawing.file = "drawing.svg";
  drawing.strokes[1].line = 7;
  const DrawingVertices found = find_drawing_vertices(drawing);
  CHECK(codes_of(found.warnings) == Codes{"UNKNOWN_GROUP", "ZERO_LENGTH", "NOT_FINITE"});
  CHECK(found.uses ==
        std::vector{StrokeUse::Used, StrokeUse::NotFinite, StrokeUse::ZeroLength, StrokeUse::UnknownGroup});
  REQUIRE(found.warnings.size() == 3);
  CHECK(found.warnings[2].subjects.at(0).id == "e2");
  CHECK(found.warnings[2].subjects.at(0).line == 7);
  CHECK(found.warnings[2].message.find("e2") != std::string::npos);
  CHECK(found.vertices.size() == 2);
}

TEST_CASE("drawing vertices: of two strokes along the same curve one is left out") {
  const Vec2 a(100, 300), b(400, 320);
  SECTION("the one that says less") {
    const auto found = find_drawing_vertices(sheet(
        {line("plane", a, b), line("axis", b + Vec2(1, 1), a, StrokeGroup::ParallelX), line("on", b, {600, 600})}));
    CHECK(found.uses[0] == StrokeUse::Duplicate);
    CHECK(found.is_used(1));
    REQUIRE(codes_of(found.warnings) == Codes{"DUPLICATE_STROKE"});
    CHECK(found.warnings[0].subjects.at(0).id == "plane");
    CHECK(found.warnings[0].subjects.at(1).id == "axis");
    CHECK(found.vertices.size() == 3);
  }
  SECTION("curves, whichever way they run") {
    const auto found = find_drawing_vertices(sheet({arc("one", a, b, 100), arc("two", b + Vec2(0.5, 0.5), a, 100.4)}));
    CHECK(std::count(found.uses.begin(), found.uses.end(), StrokeUse::Duplicate) == 1);
  }
  SECTION("not those that bulge differently") {
    const auto found =
        find_drawing_vertices(sheet({arc("one", a, b, 100), arc("two", b, a, 105), line("three", a, b)}));
    CHECK(found.warnings.empty());
    CHECK(found.vertices.size() == 2);
  }
  SECTION("of equal ones the lower id stays, in any order") {
    for (const bool first : {false, true}) {
      const auto found =
          find_drawing_vertices(sheet({arc(first ? "p" : "q", a, b, 50), arc(first ? "q" : "p", a, b, 50)}));
      CHECK(found.is_used(first ? 0 : 1));
      CHECK_FALSE(found.is_used(first ? 1 : 0));
    }
  }
}

TEST_CASE("ends are linked as average linkage is defined") {
  Random random(5);
  for (int round = 0; round < 300; ++round) {
    const double size = random.between(2, 30);
    std::vector<LinkagePoint> points;
    for (Index owner = 0; owner < 12; ++owner) {
      for (int end = 0; end < 2; ++end) {
        LinkagePoint point{Vec2(random.between(0, size), random.between(0, size)), owner, no_index};
        if (random.below(6) == 0) point.group = random.below(4);
        points.push_back(point);
      }
    }
    CHECK(clusters_of(link_nearest(points, 4)) == clusters_by_definition(points, 4));
  }
}

TEST_CASE("thousands of ends on one spot are linked within bounds") {
  std::vector<LinkagePoint> points(9000);
  for (Index i = 0; i < points.size(); ++i) points[i].owner = i;
  CHECK(clusters_of(link_nearest(points, 1)).size() == 36);
  points[0].place = Vec2(1e300, -1e300);
  points[1].place = Vec2(1e300, -1e300);
  CHECK(clusters_of(link_nearest(points, 1)).size() == 37);
}
