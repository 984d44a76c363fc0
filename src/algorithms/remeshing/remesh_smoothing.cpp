// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/remeshing/remesh_smoothing.h"

#include <algorithm>
#include <cstdint>
#include <limits>
#include <utility>

#include <Eigen/Geometry>

#include "algorithms/remeshing/vertices_per_part.h"
#include "croquis/base/parallel.h"
#include "croquis/geometry/single_precision.h"

namespace croquis::remeshing {
namespace {

using namespace hole_filling;

constexpr std::size_t vertices_per_step = 50'000;  // vertices that a mesh advances by
constexpr double most_drift = 2;  // × cell: no vertex moves so far, and none needs the field further below

}  // namespace

SweptSmoothing::SweptSmoothing(const ImprovedField& field, const ImprovementOptions& options)
    : field_(field), options_(options) {
  begin_anew();
}

void SweptSmoothing::begin_anew() {
  stages_.assign(static_cast<std::size_t>(std::max(options_.smoothing, 1)), {});
  rounded_ = 0;
}

std::vector<Vec3> SweptSmoothing::take() { return std::move(stages_.back().places); }

void SweptSmoothing::advance(implicit::LayeredMesh& made, bool is_last, Progress& progress) {
  if (options_.precision == Precision::Single) round_to_single(std::span(made.positions).subspan(rounded_));
  rounded_ = made.positions.size();
  stages_.back().places.reserve(made.positions.capacity());
  const std::vector<Index>& bounds = made.first_vertices;
  const auto done = static_cast<Index>(stages_.back().end());
  auto layer = static_cast<std::size_t>(std::ranges::upper_bound(bounds, done) - bounds.begin());
  layer -= std::min<std::size_t>(layer, 2);  // the one that is under way has triangles in the layer before
  const Index first = bounds[layer];
  std::vector<Index> corners(made.corners.begin() + made.first_corners[layer], made.corners.end());
  for (Index& corner : corners) corner -= first;
  const TriangleFans fans(made.positions.size() - first, corners);
  advance({made.positions, fans, first}, bounds, is_last, progress);
  double lowest = std::numeric_limits<double>::infinity();
  for (std::size_t v = stages_.back().end(); v < made.positions.size(); ++v)
    lowest = std::min(lowest, made.positions[v][field_.axis]);
  if (!is_last) forget(lowest);
}

void SweptSmoothing::run(const std::vector<Vec3>& positions, const std::vector<Index>& corners, Progress& progress) {
  const TriangleFans fans(positions.size(), corners);
  std::vector<Index> reach(positions.size());  // one past the last neighbour of all vertices so far
  for (std::size_t v = 0; v < reach.size(); ++v) {
    reach[v] = std::max(static_cast<Index>(v + 1), v > 0 ? reach[v - 1] : 0);
    for (const Index corner : fans.at(v))
      reach[v] = std::max({reach[v], fans.next(corner) + 1, fans.previous(corner) + 1});
  }
  std::vector<Index> bounds = {0};
  while (bounds.back() < positions.size()) {
    const std::size_t least = std::min<std::size_t>(bounds.back() + vertices_per_step, positions.size());
    bounds.push_back(std::max(static_cast<Index>(least), bounds.size() > 1 ? reach[bounds.back() - 1] : 0));
  }
  std::vector<double> lowest(bounds.size(), std::numeric_limits<double>::infinity());
  for (std::size_t b = bounds.size() - 1; b-- > 0;) {
    lowest[b] = lowest[b + 1];
    for (std::size_t v = bounds[b]; v < bounds[b + 1]; ++v) lowest[b] = std::min(lowest[b], positions[v][field_.axis]);
  }
  stages_.back().places.reserve(positions.size());
  const double share = 1 / static_cast<double>(bounds.size());
  for (std::size_t b = 1; b < bounds.size(); ++b) {
    Progress advancing = progress.step("smooth", share);
    // Neighbours of vertices below one bound lie below the next.
    advance({positions, fans, 0}, std::span(bounds).first(b), b + 1 == bounds.size(), advancing);
    const auto undone = std::ranges::upper_bound(bounds, stages_.back().end()) - bounds.begin() - 1;
    forget(lowest[static_cast<std::size_t>(undone)]);
  }
}

void SweptSmoothing::forget(double lowest) const {
  if (field_.forget_below) field_.forget_below(lowest - most_drift * options_.cell);
}

/// Round r needs the one before it up to one bound further.
void SweptSmoothing::advance(const Window& window, std::span<const Index> bounds, bool is_last, Progress& progress) {
  const double share = 1 / static_cast<double>(stages_.size());
  for (std::size_t s = 0; s < stages_.size(); ++s) {
    if (!is_last && bounds.size() < s + 1) break;
    const std::size_t end = is_last ? window.raw.size() : bounds[bounds.size() - 1 - s];
    Progress advancing = progress.step("smooth", share);
    if (end > stages_[s].end()) advance_stage(s, end, window, advancing);
  }
  drop_what_is_done(bounds);
}

const Vec3& SweptSmoothing::before(std::size_t stage, std::size_t vertex, const Window& window) const {
  return stage == 0 ? window.raw[vertex] : stages_[stage - 1].at(vertex);
}

/// Of the triangles' centroids, weighted by area, from the vertex itself for the digits of models far away.
Vec3 SweptSmoothing::centroid(std::size_t stage, std::size_t vertex, const Window& window) const {
  const Vec3& here = before(stage, vertex, window);
  Vec3 sum = Vec3::Zero();
  double areas = 0;
  for (const Index corner : window.fans.at(vertex - window.first)) {
    const Vec3 b = before(stage, window.first + window.fans.next(corner), window) - here;
    const Vec3 c = before(stage, window.first + window.fans.previous(corner), window) - here;
    const double area = b.cross(c).norm();
    sum += area / 3 * (b + c);
    areas += area;
  }
  return areas > 0 ? Vec3(here + sum / areas) : here;
}

void SweptSmoothing::advance_stage(std::size_t stage, std::size_t end, const Window& window, Progress& progress) {
  Stage& made = stages_[stage];
  const std::size_t begin = made.end(), offset = begin - made.first;
  made.places.resize(end - made.first);
  std::vector<std::uint8_t> fixed(end - begin);
  Progress smoothing = progress.step("smooth", 0.2);
  for_each_part(end - begin, vertices_per_part, options_.threads, smoothing, [&](std::size_t from, std::size_t to) {
    for (std::size_t i = from; i < to; ++i) {
      const std::size_t v = begin + i;
      fixed[i] = window.fans.link(v - window.first) == TriangleFans::Link::Cycle ? 0 : 1;
      const bool stays = fixed[i] != 0 || options_.smoothing == 0;
      made.places[offset + i] = stays ? before(stage, v, window) : centroid(stage, v, window);
    }
  });
  Progress projecting = progress.step("project " + std::to_string(end - begin) + " vertices", 0.8);
  onto_surface(std::span(made.places).subspan(offset), fixed, field_, options_, projecting);
}

/// Vertices from one bound on have no neighbours below the bound before.
void SweptSmoothing::drop_what_is_done(std::span<const Index> bounds) {
  for (std::size_t s = 0; s + 1 < stages_.size(); ++s) {
    Stage& stage = stages_[s];
    const auto next = std::ranges::lower_bound(bounds, static_cast<Index>(stages_[s + 1].end()));
    if (next == bounds.begin()) continue;
    const std::size_t needed = std::clamp<std::size_t>(*(next - 1), stage.first, stage.end());
    stage.places.erase(stage.places.begin(), stage.places.begin() + static_cast<std::ptrdiff_t>(needed - stage.first));
    stage.first = needed;
  }
}

}  // namespace croquis::remeshing
