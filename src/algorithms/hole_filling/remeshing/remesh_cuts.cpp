// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/hole_filling/remeshing/remesh_cuts.h"

#include <algorithm>
#include <cmath>

#include "croquis/base/parallel.h"
#include "croquis/geometry/self_intersection.h"
#include "croquis/implicit/box_weight.h"

namespace croquis::hole_filling {
namespace {

constexpr std::size_t faces_per_slab = 40000;
constexpr std::size_t most_pairs = 1000000;

/// Faces by slabs across the longest axis. A face is in every slab that it reaches, so that each pair whose boxes meet
/// shares one.
struct Slabs {
  std::vector<Index> first = {0};  // #slabs + 1, into faces
  std::vector<Index> faces;
};

class Slicing {
 public:
  explicit Slicing(const PolyMesh& mesh) : mesh_(mesh), box_(implicit::bounds(mesh.positions)) {
    box_.size().maxCoeff(&axis_);
    count_ = mesh.face_count() / faces_per_slab + 1;
  }

  Slabs slabs() const {
    Slabs slabs;
    slabs.first.assign(count_ + 1, 0);
    for (std::size_t f = 0; f < mesh_.face_count(); ++f) {
      const auto [low, high] = range(f);
      for (std::size_t s = low; s <= high; ++s) ++slabs.first[s + 1];
    }
    for (std::size_t s = 0; s < count_; ++s) slabs.first[s + 1] += slabs.first[s];
    slabs.faces.resize(slabs.first.back());
    std::vector<Index> next = slabs.first;
    for (std::size_t f = 0; f < mesh_.face_count(); ++f) {
      const auto [low, high] = range(f);
      for (std::size_t s = low; s <= high; ++s) slabs.faces[next[s]++] = static_cast<Index>(f);
    }
    return slabs;
  }

 private:
  std::array<std::size_t, 2> range(std::size_t face) const {
    double low = box_.high[axis_], high = box_.low[axis_];
    for (const Index v : mesh_.face(face)) {
      low = std::min(low, mesh_.positions[v][axis_]);
      high = std::max(high, mesh_.positions[v][axis_]);
    }
    return {slab_at(low), slab_at(high)};
  }

  std::size_t slab_at(double place) const {
    const double share = (place - box_.low[axis_]) / box_.size()[axis_];
    return std::min(static_cast<std::size_t>(std::max(share, 0.0) * static_cast<double>(count_)), count_ - 1);
  }

  const PolyMesh& mesh_;
  implicit::Box box_;
  Eigen::Index axis_ = 0;
  std::size_t count_ = 1;
};

PolyMesh part_of(const PolyMesh& mesh, std::span<const Index> faces) {
  std::vector<Index> vertices;
  for (const Index f : faces)
    for (const Index v : mesh.face(f)) vertices.push_back(v);
  std::sort(vertices.begin(), vertices.end());
  vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
  PolyMesh part;
  for (const Index v : vertices) part.positions.push_back(mesh.positions[v]);
  for (const Index f : faces) {
    std::array<Index, 3> corners;
    for (std::size_t i = 0; i < 3; ++i)
      corners[i] = static_cast<Index>(std::ranges::lower_bound(vertices, mesh.face(f)[i]) - vertices.begin());
    part.add_face(corners);
  }
  return part;
}

}  // namespace

std::vector<std::array<Index, 2>> find_cuts(const PolyMesh& mesh, int threads, Progress& progress) {
  if (mesh.face_count() < 2 * faces_per_slab)
    return find_self_intersections(mesh, progress, {.max_pairs = most_pairs}).pairs;
  const Slabs slabs = Slicing(mesh).slabs();
  std::vector<std::vector<std::array<Index, 2>>> found(slabs.first.size() - 1);
  for_each_part(found.size(), 1, threads, progress, [&](std::size_t slab, std::size_t) {
    const auto faces = std::span(slabs.faces).subspan(slabs.first[slab], slabs.first[slab + 1] - slabs.first[slab]);
    Progress silent;
    found[slab] = find_self_intersections(part_of(mesh, faces), silent, {.max_pairs = most_pairs}).pairs;
    for (auto& pair : found[slab]) pair = {faces[pair[0]], faces[pair[1]]};
  });
  std::vector<std::array<Index, 2>> pairs;
  for (const auto& part : found) pairs.insert(pairs.end(), part.begin(), part.end());
  std::sort(pairs.begin(), pairs.end());
  pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
  return pairs;
}

}  // namespace croquis::hole_filling
