// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <set>

#include <catch2/catch.hpp>

#include "croquis/perspective/vertex_coordinates.h"
#include "perspective/network_truth.h"
#include "support/perspective/solids.h"
#include "support/perspective/views.h"
#include "support/random.h"

using namespace croquis;
using namespace croquis::test;

namespace {

View usual_view() { return three_point_views()[1]; }

SolidDrawing noisy(const PerspectiveSolid& solid, double noise, std::uint64_t seed, const View& view = usual_view()) {
  SolidDrawingOptions options;
  options.noise = noise;
  options.seed = seed;
  options.vertex_ids = false;
  return drawn(solid, view, options);
}

/// With vertex ids, so that even wild noise leaves the topology alone.
SolidDrawing coarse(const PerspectiveSolid& solid, double noise, std::uint64_t seed) {
  SolidDrawingOptions options;
  options.noise = noise;
  options.seed = seed;
  return drawn(solid, usual_view(), options);
}

PerspectiveStroke& stroke_of(PerspectiveDrawing& drawing, const std::string& id) {
  return *std::ranges::find(drawing.strokes, id, &PerspectiveStroke::id);
}

std::vector<Vec3> propagated(const PerspectiveDrawing& drawing, const ReconstructedNetwork& network) {
  return propagate(drawing, network.vertices, network.camera, network.coordinates.groups, 0, 1);
}

bool all_finite(const std::vector<Vec3>& positions) {
  return std::ranges::all_of(positions, [](const Vec3& position) { return position.allFinite(); });
}

double error_of(const SolidDrawing& truth, const ReconstructedNetwork& network) {
  return greatest_error(truth, truth.drawing, network.vertices, network.coordinates.positions);
}

/// Another group of the same kind.
StrokeGroup wrong_group(StrokeGroup group, Random& random) {
  const int first = is_parallel(group) ? 0 : 3;
  return static_cast<StrokeGroup>(first + (axis_of(group) + 1 + static_cast<int>(random.below(2))) % 3);
}

}  // namespace

TEST_CASE("Vertices of drawings without noise are exact") {
  for (const View& view : all_views()) {
    for (const PerspectiveSolid& solid : all_solids()) {
      SolidDrawing truth = noisy(solid, 0, 2, view);
      if (view.name == frontal_view().name) truth.drawing.field_of_view = view.field_of_view;
      const ReconstructedNetwork network = reconstructed(truth.drawing);
      INFO(view.name << ", " << solid.name);
      CHECK(network.warnings.empty());
      CHECK(network.vertices.vertices.size() == solid.network.vertices.size());
      CHECK(error_of(truth, network) < 1e-9);
      CHECK(count_planes(network.coordinates.positions) == count_true_planes(truth));
      CHECK(network.coordinates.rms < 1e-7);
    }
  }
}

TEST_CASE("Four decimals in the file cost nothing that can be seen") {
  for (const PerspectiveSolid& solid : {box(), l_block(), camera_body(), bottle(), soap()}) {
    SolidDrawing truth = noisy(solid, 0, 2);
    for (PerspectiveStroke& stroke : truth.drawing.strokes) {
      for (PictureCubic& piece : stroke.pieces) {
        for (Vec2& point : piece) point = (point * 1e4).array().round().matrix() / 1e4;
      }
    }
    CHECK(error_of(truth, reconstructed(truth.drawing)) < 1e-5);
  }
}

TEST_CASE("Coordinates that strokes make equal are equal bit by bit, whatever the noise") {
  for (const PerspectiveSolid& solid : all_solids()) {
    const SolidDrawing truth = coarse(solid, 5, 3);
    const ReconstructedNetwork network = reconstructed(truth.drawing);
    INFO(solid.name);
    for (std::size_t s = 0; s < truth.drawing.strokes.size(); ++s) {
      const auto [a, b] = network.vertices.of_stroke[s];
      const StrokeGroup group = network.coordinates.groups[s];
      if (a == no_index || group == StrokeGroup::Unknown) continue;
      for (int k = 0; k < 3; ++k) {
        if ((k == axis_of(group)) == is_parallel(group)) continue;
        CHECK(network.coordinates.positions[a][k] == network.coordinates.positions[b][k]);
      }
    }
    for (std::size_t v = 0; v < network.coordinates.positions.size(); ++v) {
      for (std::size_t k = 0; k < 3; ++k) {
        CHECK(network.coordinates.positions[v][static_cast<Eigen::Index>(k)] ==
              network.coordinates.class_values[network.coordinates.classes[v][k]]);
      }
    }
  }
}

TEST_CASE("Noise of the hand is averaged out") {
  const std::vector<std::pair<double, double>> limits{{2, 0.0040}, {5, 0.010}, {10, 0.022}};
  for (const auto& [noise, limit] : limits) {
    for (const PerspectiveSolid& solid : {box(), l_block(), camera_body(), bottle()}) {
      std::vector<double> errors, passed_on, residuals;
      for (std::uint64_t seed = 1; seed <= 20; ++seed) {
        const SolidDrawing truth = coarse(solid, noise, seed);
        const ReconstructedNetwork network = reconstructed(truth.drawing);
        errors.push_back(shape_error(truth, truth.drawing, network.vertices, network.coordinates.positions));
        residuals.push_back(network.coordinates.rms);
        const std::vector<Vec3> others = propagated(truth.drawing, network);
        if (all_finite(others)) passed_on.push_back(shape_error(truth, truth.drawing, network.vertices, others));
      }
      INFO(solid.name << ", noise " << noise);
      CHECK(median(errors) < limit);
      CHECK(median(residuals) < 1.5 * noise + 0.1);
      if (!passed_on.empty()) CHECK(median(errors) < (noise < 10 ? 0.6 : 0.75) * median(passed_on));
    }
  }
}

TEST_CASE("Without noise passing coordinates on gives the same as solving for all at once") {
  for (const PerspectiveSolid& solid : all_solids()) {
    const SolidDrawing truth = noisy(solid, 0, 1);
    const ReconstructedNetwork network = reconstructed(truth.drawing);
    const std::vector<Vec3> others = propagated(truth.drawing, network);
    if (!all_finite(others)) continue;  // pieces that only merged planes tie
    INFO(solid.name);
    const Vec3 eye = network.coordinates.camera.eye;
    const double scale = (network.coordinates.positions[0] - eye).norm() / others[0].norm();
    for (std::size_t v = 0; v < others.size(); ++v) {
      CHECK((scale * others[v] + eye - network.coordinates.positions[v]).norm() < 1e-9 * true_diagonal(truth));
    }
  }
}

TEST_CASE("One wrong colour is left out, and its right group found") {
  for (const double noise : {0.0, 2.0, 5.0, 10.0}) {
    for (const PerspectiveSolid& solid : {box(), l_block(), camera_body(), bottle(), stack(3)}) {
      for (std::uint64_t seed = 1; seed <= 6; ++seed) {
        SolidDrawing truth = coarse(solid, noise, seed);
        Random random(seed * 31 + 7);
        const NetworkCurve& curve =
            solid.network.curves[random.below(static_cast<std::uint32_t>(solid.network.curves.size()))];
        PerspectiveStroke& wrong = stroke_of(truth.drawing, curve.id);
        const StrokeGroup right = wrong.group;
        wrong.group = wrong_group(right, random);
        const ReconstructedNetwork network = reconstructed(truth.drawing);
        INFO(solid.name << ", noise " << noise << ", seed " << seed << ", " << wrong.id);
        if (noise > 5) continue;  // small contradictions drown in such noise
        REQUIRE(network.coordinates.contradictions.size() == 1);
        const Contradiction& found = network.coordinates.contradictions[0];
        CHECK(truth.drawing.strokes[found.stroke].id == wrong.id);
        CHECK(found.fix == right);
        const std::vector<std::string> codes = codes_of(network.warnings);
        CHECK(std::ranges::count(codes, "CONTRADICTION") == 1);
        // The stroke is lifted all the same.
        CHECK(network.curves.network.curves.size() == solid.network.curves.size());
        CHECK(shape_error(truth, truth.drawing, network.vertices, network.coordinates.positions) <
              std::max(1e-9, 0.01 * noise));
      }
    }
  }
}

TEST_CASE("Wrong colours are found among hundreds of strokes, where only a few are left out in earnest") {
  for (const int boxes : {16, 30}) {
    const PerspectiveSolid solid = stack(boxes);
    for (std::uint64_t seed = 1; seed <= 6; ++seed) {
      SolidDrawing truth = coarse(solid, seed % 2 == 0 ? 1 : 0, seed);
      Random random(seed);
      std::set<std::string> wrong;
      while (wrong.size() < 1 + seed % 2) {
        const auto number = random.below(static_cast<std::uint32_t>(solid.network.curves.size()));
        PerspectiveStroke& stroke = stroke_of(truth.drawing, solid.network.curves[number].id);
        if (wrong.insert(stroke.id).second) stroke.group = wrong_group(stroke.group, random);
      }
      const ReconstructedNetwork network = reconstructed(truth.drawing);
      std::set<std::string> found;
      for (const Contradiction& contradiction : network.coordinates.contradictions)
        found.insert(truth.drawing.strokes[contradiction.stroke].id);
      INFO(boxes << " boxes, seed " << seed);
      CHECK(found == wrong);
    }
  }
}

TEST_CASE("Several wrong colours are found one after the other") {
  SolidDrawing truth = noisy(stack(4), 0, 1);
  Random random(3);
  std::set<std::string> wrong{"e00", "e09", "e17"};
  for (const std::string& id : wrong) {
    PerspectiveStroke& stroke = stroke_of(truth.drawing, id);
    stroke.group = wrong_group(stroke.group, random);
  }
  const ReconstructedNetwork network = reconstructed(truth.drawing);
  std::set<std::string> found;
  for (const Contradiction& contradiction : network.coordinates.contradictions) {
    found.insert(truth.drawing.strokes[contradiction.stroke].id);
  }
  CHECK(found == wrong);
  CHECK(shape_error(truth, truth.drawing, network.vertices, network.coordinates.positions) < 1e-8);
}

TEST_CASE("Noise alone is no contradiction") {
  for (const PerspectiveSolid& solid : all_solids()) {
    for (std::uint64_t seed = 1; seed <= 4; ++seed) {
      const ReconstructedNetwork network = reconstructed(coarse(solid, 5, seed).drawing);
      INFO(solid.name << ", seed " << seed);
      CHECK(network.coordinates.contradictions.empty());
    }
  }
}

TEST_CASE("Two corners drawn at one place are told apart from a wrong group") {
  SolidDrawing truth = coarse(l_block(), 0, 1);
  // Both vertices get the same name.
  for (PerspectiveStroke& stroke : truth.drawing.strokes) {
    for (std::string* name : {&stroke.from, &stroke.to}) {
      if (*name == "v8") *name = "v2";
    }
  }
  const ReconstructedNetwork network = reconstructed(truth.drawing);
  const std::vector<std::string> codes = codes_of(network.warnings);
  CHECK(std::ranges::count(codes, "CONTRADICTION") >= 1);
}

TEST_CASE("Straight strokes in the colours of planes run along axes where they point at a vanishing point") {
  for (const PerspectiveSolid& solid : {box(), l_block(), stack(3), camera_body()}) {
    for (const double noise : {0.0, 2.0}) {
      SolidDrawingOptions options;
      options.noise = noise;
      options.colouring = Colouring::Planes;
      const SolidDrawing truth = drawn(solid, usual_view(), options);
      const ReconstructedNetwork network = reconstructed(truth.drawing);
      INFO(solid.name << ", noise " << noise);
      std::size_t straight = 0;
      for (const NetworkCurve& curve : solid.network.curves) straight += curve.straight ? 1 : 0;
      if (noise == 0) CHECK(network.coordinates.promoted.size() == straight);
      for (const PromotedStroke& promoted : network.coordinates.promoted) {
        const std::string& id = truth.drawing.strokes[promoted.stroke].id;
        const auto curve = std::ranges::find(solid.network.curves, id, &NetworkCurve::id);
        CHECK(promoted.group == solid.groups[static_cast<std::size_t>(curve - solid.network.curves.begin())]);
      }
      CHECK(shape_error(truth, truth.drawing, network.vertices, network.coordinates.positions) <
            (noise == 0 ? 1e-9 : 0.008));
    }
  }
}

TEST_CASE("Promoted strokes stand in for missing construction lines") {
  SolidDrawingOptions options;
  options.colouring = Colouring::Planes;
  SolidDrawing truth = drawn(box(), usual_view(), options);
  int left = 0;
  std::erase_if(truth.drawing.strokes, [&](const PerspectiveStroke& stroke) {
    return stroke.role == StrokeRole::Construction && stroke.group == StrokeGroup::ParallelZ && ++left > 1;
  });
  const ReconstructedNetwork network = reconstructed(truth.drawing);
  CHECK(network.camera.camera.focal_length == Approx(truth.camera.focal_length).epsilon(1e-6));
  CHECK(network.warnings.empty());
}

TEST_CASE("Faces in one plane that nothing ties become one plane, steps stay") {
  // The rim of the pocket is tied to the top by a link; without it, and with it, the planes are those of the solid.
  for (const double noise : {0.0, 1.0, 3.0}) {
    const SolidDrawing frame = coarse(ring_frame(), noise, 4);
    const ReconstructedNetwork network = reconstructed(frame.drawing);
    CHECK(count_planes(network.coordinates.positions) == count_true_planes(frame));
    const SolidDrawing top = coarse(soap(), noise, 2);
    const ReconstructedNetwork tops = reconstructed(top.drawing);
    CHECK(count_planes(tops.coordinates.positions) == count_true_planes(top));
    CHECK(tops.coordinates.merged.size() == 3);
  }
  NetworkReconstructionOptions apart;
  apart.coordinates.merge_planes = false;
  const SolidDrawing top = coarse(soap(), 1, 2);
  CHECK(count_planes(reconstructed(top.drawing, apart).coordinates.positions) == count_true_planes(top) + 3);
}

TEST_CASE("Pieces that nothing ties are each of their own scale, and named") {
  SolidDrawingOptions options;
  options.links = false;
  const SolidDrawing truth = drawn(two_boxes(), usual_view(), options);
  const ReconstructedNetwork network = reconstructed(truth.drawing);
  REQUIRE(codes_of(network.warnings) == std::vector<std::string>{"DISCONNECTED"});
  CHECK(network.warnings[0].subjects.size() == 12);
  std::set<Index> pieces(network.coordinates.component.begin(), network.coordinates.component.end());
  CHECK(pieces == std::set<Index>{0, 1});
  CHECK(network.curves.network.curves.size() == two_boxes().network.curves.size());
  CHECK(network.coordinates.rms < 1e-7);
}

TEST_CASE("Scale and place follow from what is known") {
  SolidDrawing truth = noisy(bottle(), 0, 1);
  const Vec3 moved(5, -3, 2);
  truth.drawing.known_point->point += moved;
  for (KnownLength& known : truth.drawing.known_lengths) known.length *= 2.5;
  const ReconstructedNetwork network = reconstructed(truth.drawing);
  const std::vector<Index> to = true_vertices(truth, truth.drawing, network.vertices);
  const Vec3 fixed = truth.network.vertices[0];
  for (std::size_t v = 0; v < to.size(); ++v) {
    const Vec3 wanted = fixed + moved + 2.5 * (truth.network.vertices[to[v]] - fixed);
    CHECK((network.coordinates.positions[v] - wanted).norm() < 1e-8);
  }
  // A point in space is seen where it was drawn, through the camera in the world.
  for (std::size_t v = 0; v < to.size(); ++v) {
    const Vec2 seen = network.coordinates.camera.project(network.coordinates.positions[v]);
    CHECK((seen - network.vertices.vertices[v].position).norm() < 1e-6);
  }
}

TEST_CASE("Without a known length the eye is ten units from the origin") {
  SolidDrawingOptions options;
  options.known = false;
  const SolidDrawing truth = drawn(box(), usual_view(), options);
  const ReconstructedNetwork network = reconstructed(truth.drawing);
  CHECK(network.coordinates.camera.eye.norm() == Approx(10));
  CHECK(std::ranges::any_of(network.coordinates.positions, [](const Vec3& p) { return p.norm() < 1e-12; }));
  for (const Vec3& position : network.coordinates.positions) {
    CHECK((position - network.coordinates.camera.eye).norm() > 10 - 1e-9);
  }
}

TEST_CASE("A known length of no edge is told") {
  SolidDrawing truth = noisy(box(), 0, 1);
  truth.drawing.known_lengths = {{"nobody", 3}};
  CHECK(codes_of(reconstructed(truth.drawing).warnings) == std::vector<std::string>{"LENGTH_UNUSED"});
}

TEST_CASE("Deviations of vertices are those of their errors") {
  std::vector<double> ratios;
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    SolidDrawing truth = coarse(camera_body(), 2, seed);
    const ReconstructedNetwork network = reconstructed(truth.drawing);
    for (const double deviation : network.coordinates.deviations) {
      CHECK(deviation >= 0);
      ratios.push_back(deviation / true_diagonal(truth));
    }
  }
  CHECK(median(ratios) > 2e-4);
  CHECK(median(ratios) < 2e-2);
}
