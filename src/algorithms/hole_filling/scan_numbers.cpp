// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/hole_filling/scan_numbers.h"

#include <algorithm>
#include <utility>

namespace croquis::hole_filling {
namespace {

using Box = Eigen::AlignedBox3d;

// How far methods look from the rims and the places that a patch is to go through.
constexpr double diameters = 2;
constexpr double edges = 12;  // of mean length

Box looked_at(const HoleSite& site) {
  Box box;
  for (const Vec3& point : site.polygon.points) box.extend(point);
  for (const Vec3& place : site.wish.through) box.extend(place);
  const Vec3 reach = Vec3::Constant(diameters * widest_diameter(site) + edges * mean_rim_edge(site));
  return {box.min() - reach, box.max() + reach};
}

}  // namespace

ScanNumbers::ScanNumbers(const PolyMesh& scan, const TrimmedScan* trimmed, const HoleAnalysis& analysis,
                         std::string scan_key)
    : scan_(scan), trimmed_(trimmed), analysis_(analysis), scan_key_(std::move(scan_key)) {
  const PolyMesh& mesh = trimmed == nullptr ? scan : trimmed->part.mesh;
  for (const Hole& hole : analysis.holes) {
    Box& box = rim_boxes_.emplace_back();
    for (const Index vertex : hole.vertices) box.extend(mesh.positions[vertex]);
  }
  if (trimmed != nullptr) find_removed();
}

void ScanNumbers::find_removed() {
  auto kept = trimmed_->part.faces.begin();
  for (Index face = 0; face < scan_.face_count(); ++face) {
    if (kept != trimmed_->part.faces.end() && *kept == face) {
      ++kept;
      continue;
    }
    RemovedFace removed{face, {}};
    for (const Index vertex : scan_.face(face)) removed.box.extend(scan_.positions[vertex]);
    if (removed.box.isEmpty()) continue;
    widest_ = std::max(widest_, removed.box.sizes().x());
    removed_.push_back(removed);
  }
  std::ranges::stable_sort(removed_, {}, [](const RemovedFace& removed) { return removed.box.min().x(); });
}

void ScanNumbers::add_removed(const Box& box, StageKey& key) const {
  std::vector<Index> faces;
  if (!box.isEmpty()) {
    auto removed = std::ranges::lower_bound(removed_, box.min().x() - widest_, {},
                                            [](const RemovedFace& each) { return each.box.min().x(); });
    for (; removed != removed_.end() && removed->box.min().x() <= box.max().x(); ++removed) {
      if (removed->box.intersects(box)) faces.push_back(removed->face);
    }
  }
  std::sort(faces.begin(), faces.end());
  key.add(faces);
}

void ScanNumbers::add_removed(const HolePatch& patch, StageKey& key) const {
  Box box;
  for (const Vec3& point : patch.points) box.extend(point);
  add_removed(box, key);
}

void ScanNumbers::add_surroundings(const HoleSite& site, StageKey& key) const {
  key.add(std::string_view(scan_key_)).add(site.holes.size());
  for (const Index id : site.holes) {
    const Hole& hole = analysis_.holes[id];
    key.add(hole.kind)
        .add(analysis_.component_diagonal[hole.component])
        .add(analysis_.component_size[hole.component])
        .add(hole.vertices.size());
    for (const Index vertex : hole.vertices) key.add(scan_vertex(vertex));
  }
  const Box box = looked_at(site);
  add_removed(box, key);
  for (const Hole& hole : analysis_.holes) {
    if (rim_boxes_[hole.id].intersects(box)) key.add(name_of(hole));
  }
}

std::array<Index, 2> ScanNumbers::name_of(const Hole& hole) const {
  return {scan_vertex(hole.vertices[0]), scan_vertex(hole.vertices[1])};
}

Index ScanNumbers::mesh_vertex(Index vertex) const {
  if (trimmed_ == nullptr) return vertex;
  const std::vector<Index>& kept = trimmed_->part.vertices;
  return static_cast<Index>(std::lower_bound(kept.begin(), kept.end(), vertex) - kept.begin());
}

Index ScanNumbers::mesh_vertex_count() const {
  return static_cast<Index>(trimmed_ == nullptr ? scan_.vertex_count() : trimmed_->part.mesh.vertex_count());
}

Attempt ScanNumbers::in_scan(std::optional<HolePatch> patch) const {
  if (!patch) return {};
  Attempt attempt;
  for (const Index id : patch->arrives_at) attempt.arrives_at.push_back(name_of(analysis_.holes[id]));
  const Index given = mesh_vertex_count(), first = static_cast<Index>(scan_.vertex_count());
  for (auto& triangle : patch->triangles) {
    for (Index& vertex : triangle) vertex = vertex < given ? scan_vertex(vertex) : vertex - given + first;
  }
  patch->holes.clear();
  patch->arrives_at.clear();
  attempt.patch = std::move(patch);
  return attempt;
}

std::optional<HolePatch> ScanNumbers::in_mesh(const Attempt& attempt, const std::vector<Index>& holes) const {
  if (!attempt.patch) return std::nullopt;
  HolePatch patch = *attempt.patch;
  const Index given = mesh_vertex_count(), first = static_cast<Index>(scan_.vertex_count());
  for (auto& triangle : patch.triangles) {
    for (Index& vertex : triangle) vertex = vertex < first ? mesh_vertex(vertex) : vertex - first + given;
  }
  patch.holes = holes;
  for (const std::array<Index, 2>& name : attempt.arrives_at) {
    const auto rim = std::ranges::find_if(analysis_.holes, [&](const Hole& hole) { return name_of(hole) == name; });
    if (rim != analysis_.holes.end()) patch.arrives_at.push_back(rim->id);
  }
  return patch;
}

}  // namespace croquis::hole_filling
