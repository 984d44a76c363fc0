// SPDX-License-Identifier: GPL-3.0-or-later
#include "operators/subdivision_plan.h"

#include <span>

#include "croquis/base/stage_key.h"

namespace croquis {
namespace {

using namespace subdivision;

std::size_t byte_size(const HalfEdges& topology) {
  const std::size_t indices = topology.face_offsets.size() + 3 * topology.corner_vertex.size() +
                              topology.edge_corner.size() + topology.vertex_corner.size();
  return indices * sizeof(Index);
}

/// Connectivity; weights are of about the same size.
std::size_t byte_size(const SubdivisionPlan& plan) {
  std::size_t bytes = 0;
  for (int k = 0; k <= level_count(plan); ++k) bytes += 2 * byte_size(level_of(plan, k).topology);
  return bytes;
}

SubdivisionPlan make_plan(const Cage& cage, const PlanSettings& settings, Progress& progress) {
  if (settings.scheme == SubdivisionScheme::DooSabin) {
    return DooSabinPlan(cage, settings.rules, Depth(settings.levels), progress);
  }
  const bool loop = settings.scheme == SubdivisionScheme::Loop;
  const UniformRules rules{loop ? UniformScheme::Loop : UniformScheme::CatmullClark, settings.rules.boundary_corners};
  return UniformPlan(cage, rules, Depth(settings.levels), progress);
}

}  // namespace

ContentHash plan_hash(const Cage& cage, const PlanSettings& settings) {
  ContentHasher hasher;
  hasher.add("subdivide/plan/1");
  hasher.add(StageKey().add(settings).bytes());
  hasher.add(cage.topology.vertex_count());
  // The rest of the connectivity follows from these two.
  hasher.add(std::span<const Index>(cage.topology.face_offsets));
  hasher.add(std::span<const Index>(cage.topology.corner_vertex));
  hasher.add(std::span<const double>(cage.sharpness));
  hasher.add(std::as_bytes(std::span(cage.pinned)));
  hasher.add(std::as_bytes(std::span(cage.settled)));
  return hasher.digest();
}

std::shared_ptr<const SubdivisionPlan> plan_of(const Cage& cage, const PlanSettings& settings, const ContentHash& hash,
                                               Memo* memo, Progress& progress) {
  return memoized<SubdivisionPlan>(
      memo, hash, [&] { return make_plan(cage, settings, progress); },
      [](const SubdivisionPlan& plan) { return byte_size(plan); });
}

int level_count(const SubdivisionPlan& plan) {
  return std::visit([](const auto& scheme) { return scheme.levels(); }, plan);
}

const Level& level_of(const SubdivisionPlan& plan, int k) {
  return std::visit([k](const auto& scheme) -> const Level& { return scheme.level(k); }, plan);
}

const Findings& warnings_of(const SubdivisionPlan& plan) {
  static const Findings none;
  const auto* uniform = std::get_if<UniformPlan>(&plan);
  return uniform == nullptr ? none : uniform->warnings();
}

void compute_positions(const SubdivisionPlan& plan, const Cage& cage, PositionBuffers& buffers, int threads) {
  std::visit([&](const auto& scheme) { scheme.positions(cage.positions, buffers, threads); }, plan);
}

}  // namespace croquis
