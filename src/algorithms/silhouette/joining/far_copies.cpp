// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/silhouette/joining/far_copies.h"

#include <algorithm>
#include <deque>
#include <optional>
#include <set>
#include <utility>

namespace croquis::silhouette {
namespace {

/// The nearest object, along attachments, that isn't copied.
std::optional<Index> owner_of(Index object, const std::vector<Index>& copied, const Attachments& attachments) {
  std::set<Index> seen{object};
  std::deque<Index> waiting{object};
  while (!waiting.empty()) {
    const Index now = waiting.front();
    waiting.pop_front();
    if (!std::ranges::binary_search(copied, now)) return now;
    for (const auto& [pair, how] : attachments.held) {
      if (pair.first != now && pair.second != now) continue;
      const Index other = pair.first == now ? pair.second : pair.first;
      if (seen.insert(other).second) waiting.push_back(other);
    }
  }
  return std::nullopt;
}

PolyMesh mirrored(const PolyMesh& mesh, double depth) {
  PolyMesh made;
  made.positions = mesh.positions;
  for (Vec3& position : made.positions) position.z() = 2 * depth - position.z();
  for (Index f = 0; f < mesh.face_count(); ++f) {
    const auto corners = mesh.face(f);
    made.add_triangle(corners[0], corners[2], corners[1]);
  }
  return made;
}

}  // namespace

double middle_depth(const PolyMesh& surface) {
  double sum = 0;
  for (const Vec3& position : surface.positions) sum += position.z();
  return sum / static_cast<double>(surface.vertex_count());
}

std::vector<Index> add_far_copies(const LabelledFigure& figure, const std::vector<Index>& copied, HeldSurfaces& held) {
  const std::size_t drawn = held.surfaces.size();
  const Attachments attachments = held.attachments;
  const std::map<ObjectPair, double> seams = held.seams;
  const auto surface_of = [&](Index object) {
    return static_cast<std::size_t>(
        std::ranges::find(held.surfaces, object, [](const Shell& shell) { return shell.objects.front(); }) -
        held.surfaces.begin());
  };
  std::vector<Index> alone;
  for (const Index object : copied) {
    const std::optional<Index> owner = owner_of(object, copied, attachments);
    if (!owner) alone.push_back(object);
    const std::size_t own = surface_of(object);
    if (!owner || own >= drawn || surface_of(*owner) >= drawn) continue;
    const Index number = copy_of(figure, object);
    const double depth = middle_depth(held.surfaces[surface_of(*owner)].mesh);
    held.surfaces.push_back({mirrored(held.surfaces[own].mesh, depth), {number}, {}, held.surfaces[own].euler});
    held.faults.push_back(held.faults[own]);
    for (const auto& [pair, how] : attachments.held) {
      if (pair.first != object && pair.second != object) continue;
      const Index other = pair.first == object ? pair.second : pair.first;
      const bool other_is_copied = std::ranges::binary_search(copied, other);
      if (other != *owner && !other_is_copied) continue;
      const ObjectPair same = std::minmax(other_is_copied ? copy_of(figure, other) : other, number);
      held.attachments.held[same] = how;
      if (const auto seam = seams.find(pair); seam != seams.end()) held.seams[same] = seam->second;
    }
  }
  return alone;
}

}  // namespace croquis::silhouette
