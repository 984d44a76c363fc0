// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <iomanip>
#include <map>
#include <numbers>
#include <string>
#include <vector>

#include <Eigen/Geometry>

#include "bench/bench.h"
#include "bench/cpu_time.h"
#include "bench/peak_memory.h"
#include "croquis/base/error.h"
#include "croquis/perspective/face_finding.h"
#include "croquis/perspective/network_reconstruction.h"
#include "croquis/perspective/solid.h"
#include "support/perspective/solid_drawing.h"

namespace croquis::bench {
namespace {

using namespace croquis::test;

constexpr int seeds_per_row = 20;
constexpr std::uint64_t first_seed = 501;  // that no tuning saw

double median_of(std::vector<double> values) {
  if (values.empty()) return std::nan("");
  std::ranges::sort(values);
  return values[values.size() / 2];
}

/// The true place of each vertex of a drawing; strokes are known by their curves' ids.
std::vector<Vec3> true_places(const SolidDrawing& drawn, const DrawingVertices& vertices) {
  std::map<std::string, const NetworkCurve*> curves;
  for (const NetworkCurve& curve : drawn.network.curves) curves[curve.id] = &curve;
  std::vector<Vec3> places(vertices.vertices.size(), Vec3::Constant(std::nan("")));
  for (std::size_t v = 0; v < places.size(); ++v) {
    for (const StrokeEnd& end : vertices.vertices[v].ends) {
      const PerspectiveStroke& stroke = drawn.drawing.strokes[end.stroke];
      const auto curve = curves.find(stroke.id);
      if (curve == curves.end()) continue;
      const Vec3 &a = drawn.network.vertices[curve->second->start], &b = drawn.network.vertices[curve->second->end];
      const Vec2& at = end.at_end ? stroke.end() : stroke.start();
      places[v] = (drawn.camera.project(a) - at).norm() < (drawn.camera.project(b) - at).norm() ? a : b;
    }
  }
  return places;
}

/// Root mean square distance after the best scale and translation, × diagonal of the true bounding box.
double relative_error(const std::vector<Vec3>& found, const std::vector<Vec3>& truth) {
  Eigen::AlignedBox3d box;
  Vec3 middle = Vec3::Zero(), true_middle = Vec3::Zero();
  double count = 0;
  for (std::size_t v = 0; v < truth.size(); ++v) {
    if (!truth[v].allFinite()) continue;
    if (!found[v].allFinite()) return std::nan("");
    box.extend(truth[v]);
    middle += found[v], true_middle += truth[v], count += 1;
  }
  middle /= count, true_middle /= count;
  double both = 0, own = 0;
  for (std::size_t v = 0; v < truth.size(); ++v) {
    if (!truth[v].allFinite()) continue;
    both += (found[v] - middle).dot(truth[v] - true_middle);
    own += (found[v] - middle).squaredNorm();
  }
  double sum = 0;
  for (std::size_t v = 0; v < truth.size(); ++v) {
    if (truth[v].allFinite()) sum += (both / own * (found[v] - middle) - (truth[v] - true_middle)).squaredNorm();
  }
  return std::sqrt(sum / count) / box.diagonal().norm();
}

/// The vertex that the solved one nearest to the eye is: where the source begins.
Index nearest_vertex(const VertexCoordinates& coordinates) {
  Index nearest = 0;
  for (Index v = 1; v < coordinates.positions.size(); ++v) {
    if (coordinates.camera.depth(coordinates.positions[v]) < coordinates.camera.depth(coordinates.positions[nearest]))
      nearest = v;
  }
  return nearest;
}

struct Errors {
  std::vector<double> global, passed_on;
  int failed = 0;
};

Errors errors_of(const PerspectiveSolid& solid, const View& view, double noise) {
  Errors errors;
  for (int k = 0; k < seeds_per_row; ++k) {
    SolidDrawingOptions options;
    options.noise = noise * view.image_size.x();
    options.end_jitter = std::min(options.noise / 4, 1.0);  // so that ends meet within what is snapped
    options.vertex_ids = false;
    options.seed = first_seed + static_cast<std::uint64_t>(k);
    const SolidDrawing drawing = drawn(solid, view, options);
    Progress progress;
    try {
      const ReconstructedNetwork network = reconstruct_network(drawing.drawing, {}, progress);
      const std::vector<Vec3> truth = true_places(drawing, network.vertices);
      errors.global.push_back(relative_error(network.coordinates.positions, truth));
      const Index from = nearest_vertex(network.coordinates);
      const double depth = network.coordinates.camera.depth(network.coordinates.positions[from]);
      errors.passed_on.push_back(relative_error(
          propagate(drawing.drawing, network.vertices, network.camera, network.coordinates.groups, from, depth),
          truth));
    } catch (const Error&) {
      ++errors.failed;
    }
  }
  std::erase_if(errors.passed_on, [](double error) { return std::isnan(error); });
  return errors;
}

void bench_accuracy(std::ostream& out) {
  out << "Error of vertices without ids, rms after scale and translation, % of the diagonal; medians of "
      << seeds_per_row << " drawings, noise in % of the sheet's width.\n"
      << "Peer: coordinates passed on from edge to edge, as the source has it, with the same camera and vertices.\n\n"
      << "| solid | noise | global | passed on | ratio | no camera |\n|---|---|---|---|---|---|\n"
      << std::fixed;
  for (const PerspectiveSolid& solid : {box(), l_block(), camera_ring(), bottle()}) {
    for (const double noise : {0.002, 0.005, 0.01}) {
      const Errors errors = errors_of(solid, three_point_views()[1], noise);
      const double global = median_of(errors.global), passed_on = median_of(errors.passed_on);
      out << "| " << solid.name << " | " << std::setprecision(1) << 100 * noise << " | " << std::setprecision(2)
          << 100 * global << " | " << 100 * passed_on << " | " << global / passed_on << " | " << errors.failed << " |"
          << std::endl;
    }
  }
}

/// All steps of one drawing, each timed on its own.
void bench_drawing(std::ostream& out, const PerspectiveSolid& solid) {
  SolidDrawingOptions options;
  options.noise = 1;
  options.vertex_ids = false;
  options.seed = first_seed;
  const SolidDrawing drawing = drawn(solid, three_point_views()[1], options);
  Progress progress;
  const NetworkReconstructionOptions plain;
  const ReconstructedNetwork network = reconstruct_network(drawing.drawing, plain, progress);
  NetworkReconstructionOptions held;
  held.held_camera = network.camera;
  const FaceFindingResult faces = find_faces(network.curves.network, progress);
  const auto lines = std::ranges::count_if(network.camera.lines, &VanishingLine::used);

  const int runs = network.curves.network.curves.size() > 150 ? 3 : 9;
  const double camera = median_cpu_ms(runs, [&] { estimate_camera(drawing.drawing, CameraOptions(), progress); });
  const double curves = median_cpu_ms(runs, [&] { reconstruct_network(drawing.drawing, held, progress); });
  const double all_curves = median_cpu_ms(runs, [&] { reconstruct_network(drawing.drawing, plain, progress); });
  const double finding = median_cpu_ms(runs, [&] { find_faces(network.curves.network, progress); });
  const double solid_ms =
      median_cpu_ms(runs, [&] { make_solid(network.curves.network, network.fitted, faces.best, progress); });
  PeakMemory memory;
  memory.restart();
  reconstruct_network(drawing.drawing, plain, progress);
  find_faces(network.curves.network, progress);
  const double mebibytes = memory.used();
  out << "| " << solid.name << " | " << network.curves.network.curves.size() << " | "
      << network.vertices.vertices.size() << " | " << lines << " | " << faces.best.faces.size() << " | "
      << std::setprecision(1) << camera << " | " << curves << " | " << finding << " | " << solid_ms << " | "
      << all_curves + finding + solid_ms << " | " << curves + finding + solid_ms << " | " << mebibytes << " |"
      << std::endl;
}

}  // namespace

void bench_perspective(std::ostream& out) {
  bench_accuracy(out);
  out << "\nTimes in ms (1 px of noise, no ids). Held: the camera is kept, as while a stroke is dragged.\n\n"
      << "| solid | edges | vertices | lines | faces | camera | vertices and curves, held | faces | solid | all | all, "
         "held | MiB |\n|---|---|---|---|---|---|---|---|---|---|---|---|\n";
  for (const PerspectiveSolid& solid : {box(), l_block(), bottle(), camera_ring(), ring_frame(), ball()})
    bench_drawing(out, solid);
  for (const int boxes : {5, 12, 25, 50, 124}) bench_drawing(out, stack(boxes));
}

}  // namespace croquis::bench
