// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/remeshing/solids/union_check.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <numbers>
#include <vector>

#include <Eigen/Geometry>

#include "algorithms/remeshing/remesh_trimming.h"
#include "croquis/base/parallel.h"

namespace croquis::remeshing {
namespace {

using namespace hole_filling;

using Members = std::span<const std::unique_ptr<const SignedSurface>>;

constexpr double stray_beyond = 2;       // × cell
constexpr double missed_beyond = 1.25;   // × cell, as for single pieces
constexpr std::size_t most_asked = 200;  // of the places that seem lost: for each every triangle is looked at
constexpr double goes_round = 0.6;       // more than a plane, from right below it
constexpr std::size_t check_grain = 4096;

bool has_strays(const PolyMesh& made, Members members, double far, int threads, Progress& progress) {
  std::atomic<bool> found = false;
  for_each_part(made.vertex_count(), check_grain, threads, progress, [&](std::size_t begin, std::size_t end) {
    for (std::size_t v = begin; v < end && !found; ++v) {
      const bool is_backed = std::ranges::any_of(
          members, [&](const auto& member) { return std::abs(member->at(made.positions[v]).distance) <= far; });
      if (!is_backed) found = true;
    }
  });
  return found;
}

bool is_enclosed(const Vec3& place, std::size_t own, Members members) {
  for (std::size_t m = 0; m < members.size(); ++m)
    if (m != own && std::abs(winding_number(members[m]->mesh(), place)) > goes_round) return true;
  return false;
}

bool loses_too_much(const PolyMesh& made, std::size_t own, Members members, double cell, int threads,
                    Progress& progress) {
  const std::vector<Vec3>& places = members[own]->mesh().positions;
  const std::vector<Index> missed = far_points(made, places, missed_beyond * cell, threads, progress);
  const double share = static_cast<double>(missed.size()) / static_cast<double>(places.size());
  if (share <= most_lost) return false;
  const std::size_t stride = missed.size() / most_asked + 1;
  std::size_t asked = 0, lost = 0;
  for (std::size_t i = 0; i < missed.size(); i += stride, ++asked) {
    progress.check();
    lost += is_enclosed(places[missed[i]], own, members) ? 0U : 1U;
  }
  return share * static_cast<double>(lost) / static_cast<double>(asked) > most_lost;
}

}  // namespace

double winding_number(const PolyMesh& surface, const Vec3& place) {
  double sum = 0;  // of solid angles, halved (Van Oosterom and Strackee 1983)
  for (std::size_t f = 0; f < surface.face_count(); ++f) {
    const auto face = surface.face(f);
    const Vec3 a = surface.positions[face[0]] - place, b = surface.positions[face[1]] - place,
               c = surface.positions[face[2]] - place;
    const double la = a.norm(), lb = b.norm(), lc = c.norm();
    sum += std::atan2(a.dot(b.cross(c)), la * lb * lc + a.dot(b) * lc + b.dot(c) * la + c.dot(a) * lb);
  }
  return sum / (2 * std::numbers::pi);
}

UnionFaults faults_of(const PolyMesh& made, Members members, double cell, int threads, Progress& progress) {
  UnionFaults faults;
  faults.has_strays = made.face_count() == 0 || has_strays(made, members, stray_beyond * cell, threads, progress);
  if (std::ranges::all_of(members, [](const auto& member) { return member->is_closed(); })) return faults;
  for (std::size_t m = 0; m < members.size(); ++m)
    if (loses_too_much(made, m, members, cell, threads, progress)) faults.losers.push_back(m);
  return faults;
}

}  // namespace croquis::remeshing
