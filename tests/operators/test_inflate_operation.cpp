// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include <catch2/catch.hpp>

#include "croquis/base/error.h"
#include "croquis/io/json.h"
#include "croquis/operators/inflate_result.h"
#include "operators/operations.h"
#include "support/check_operation.h"
#include "support/sketches/sketch_errors.h"
#include "support/sketches/sketch_gallery.h"

namespace croquis {
namespace {

Values inputs_of(const Drawing& drawing) { return {{"drawing", std::make_shared<const Drawing>(drawing)}}; }

TEST_CASE("inflating is a function of drawing and parameters") {
  test::check_operation(*inflate_operation(), inputs_of(test::snake_sketch().drawing), {{"resolution", 10.0}});
  test::check_operation(*inflate_operation(), inputs_of(test::circle_sketch().drawing),
                        {{"resolution", 10.0}, {"preset", std::string("tablet")}});
}

TEST_CASE("inflating with attached objects is a function of its arguments too") {
  const Values inputs = inputs_of(test::dog_sketch().drawing);
  Progress progress;
  Context context{progress};
  const OperationResult plain = run(*inflate_operation(), inputs, {}, context);
  const Report& details = plain.outputs.at("details").get<Report>();
  std::string pairs;
  for (const Report& pair : details.at("attach_suggestions").as_array()) {
    pairs += pair.at("a").as_string() + "," + pair.at("b").as_string() + "=0.5;";
  }
  test::check_operation(*inflate_operation(), inputs, {{"attach", pairs}});
}

TEST_CASE("inflating with grooves is a function of its arguments too") {
  Drawing drawing = test::circle_sketch().drawing;
  Vec2 middle = Vec2::Zero();
  for (const StrokeSample& sample : drawing.strokes.front().samples) middle += sample.position;
  middle /= static_cast<double>(drawing.strokes.front().samples.size());
  const double reach = 0.3 * (drawing.strokes.front().samples.front().position - middle).norm();
  drawing.strokes.push_back(test::stroke_of("mouth", {middle - Vec2(reach, 0), middle, middle + Vec2(reach, reach)}));
  drawing.strokes.back().data["kind"] = "detail";
  test::check_operation(*inflate_operation(), inputs_of(drawing),
                        {{"resolution", 10.0}, {"details", std::string("groove")}, {"detail-width", 20.0}});
}

TEST_CASE("texts that are no pairs of objects are refused, all of them") {
  const auto refused = [](const std::string& text) {
    Progress progress;
    Context context{progress};
    try {
      run(*inflate_operation(), inputs_of(test::dog_sketch().drawing), {{"attach", text}}, context);
    } catch (const Error& error) {
      return error.findings().size();
    }
    return std::size_t{0};
  };
  CHECK(refused("") == 0);
  CHECK(refused(" ; ") == 0);
  for (const char* wrong : {"a", "a,", ",b", "a,b,c", "a,b=", "a,b=x", "a,b=1x"}) CHECK(refused(wrong) == 1);
  CHECK(refused("a;b;c,d=e") == 3);
}

TEST_CASE("labels name the object of every arc") {
  Progress progress;
  Context context{progress};
  const OperationResult result = run(*inflate_operation(), inputs_of(test::dog_sketch().drawing), {}, context);
  const Drawing& labels = result.outputs.at("labels").get<Drawing>();
  const PolyMesh& mesh = result.outputs.at("mesh").get<PolyMesh>();
  const std::vector<std::string>& names = mesh.channel("object", Domain::Face)->labels;
  REQUIRE(!labels.strokes.empty());
  for (const Stroke& arc : labels.strokes) {
    CHECK(std::count(names.begin(), names.end(), arc.data.at("object")) == 1);
  }
}

TEST_CASE("a drawing on another plane becomes the same solid, rigidly moved") {
  const auto inflated = [](const Drawing& drawing) {
    Progress progress;
    Context context{progress};
    return run(*inflate_operation(), inputs_of(drawing), {{"resolution", 10.0}}, context);
  };
  Drawing drawing = test::snake_sketch().drawing;
  const OperationResult plain = inflated(drawing);
  const std::vector<DrawingPlane> planes = {{Vec3(0, 0, 5), Vec3::UnitX(), Vec3::UnitY()},
                                            {Vec3::Zero(), Vec3::UnitX(), Vec3::UnitZ()},
                                            {Vec3(1, -2, 3), Vec3::UnitY(), Vec3::UnitX()},
                                            {Vec3(7, 0, 0), Vec3(0, 0.6, 0.8), Vec3(-1, 0, 0)}};
  for (const DrawingPlane& plane : planes) {
    drawing.plane = plane;
    const OperationResult placed = inflated(drawing);
    for (const char* port : {"mesh", "skeleton"}) {
      const PolyMesh& there = placed.outputs.at(port).get<PolyMesh>();
      const PolyMesh& here = plain.outputs.at(port).get<PolyMesh>();
      REQUIRE(there.corners == here.corners);
      REQUIRE(there.line_vertices == here.line_vertices);
      const Vec3 normal = plane.u.cross(plane.v);
      double error = 0;
      for (std::size_t v = 0; v < here.vertex_count(); ++v) {
        const Vec3& p = here.positions[v];
        const Vec3 expected = plane.origin + p.x() * plane.u + p.y() * plane.v + p.z() * normal;
        error = std::max(error, (there.positions[v] - expected).norm());
      }
      CHECK(error < 1e-9);
    }
    CHECK(placed.outputs.at("labels").get<Drawing>().plane == plane);
    CHECK(write_json(placed.outputs.at("details").get<Report>()) ==
          write_json(plain.outputs.at("details").get<Report>()));
  }
}

TEST_CASE("inflating refuses a drawing with the same findings every time") {
  test::check_operation(*inflate_operation(), inputs_of(test::error_sketch("E_CROSS").drawing),
                        {{"preset", std::string("clean")}});
}

TEST_CASE("programs read labels and parts of a solid as its drawing and mesh show them") {
  Progress progress;
  Context context{progress};
  const OperationResult result = run(*inflate_operation(), inputs_of(test::dog_sketch().drawing), {}, context);
  const InflateResult& found = *result.details.get<InflateResult>();
  const Drawing& labels = result.outputs.at("labels").get<Drawing>();
  REQUIRE(found.arcs.size() == labels.strokes.size());
  for (std::size_t i = 0; i < found.arcs.size(); ++i) {
    CHECK(std::to_string(found.arcs[i].depth) == labels.strokes[i].data.at("depth"));
    CHECK(found.arcs[i].visible == (found.arcs[i].depth == 0));
  }
  const PolyMesh& mesh = result.outputs.at("mesh").get<PolyMesh>();
  const std::vector<std::string>& names = mesh.channel("object", Domain::Face)->labels;
  for (const InflatedObject& object : found.objects) CHECK(std::ranges::count(names, object.name) == 1);
  REQUIRE(!found.suggested.empty());
  // y grows upwards for programs, downwards in the report.
  const Report& first = result.outputs.at("details").get<Report>().at("attach_suggestions").as_array()[0];
  CHECK(first.at("at").as_array()[1].as_number() == -found.suggested[0].at.y());
}

}  // namespace
}  // namespace croquis
