// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/remeshing/remesh_cuts.h"

#include <algorithm>
#include <cstdint>

#include "algorithms/remeshing/vertices_per_part.h"
#include "croquis/base/parallel.h"
#include "croquis/geometry/self_intersection.h"
#include "croquis/implicit/box_weight.h"

namespace croquis::remeshing {
namespace {

using namespace hole_filling;

constexpr std::size_t most_faces_per_slab = 40000;
constexpr std::size_t least_faces_per_slab = 5000;  // in thinner slabs many faces are looked at twice
constexpr std::size_t enough_slabs = 16;            // to keep threads busy
constexpr std::size_t most_cut_pairs = 1000000;

std::size_t slab_count(std::size_t faces) {
  return std::max(faces / most_faces_per_slab + 1, std::min(faces / least_faces_per_slab, enough_slabs));
}

/// Faces by slabs across the longest axis. A face is in every slab that it reaches, so that each pair whose boxes meet
/// shares one.
struct Slabs {
  std::vector<Index> first = {0};  // #slabs + 1, into faces
  std::vector<Index> faces;
  std::vector<std::uint32_t> slab;  // in which every vertex lies
  std::vector<Index> number;        // of every vertex among those of its slab
  std::vector<Index> vertex_count;  // per slab
};

std::vector<std::uint32_t> slabs_of_vertices(const PolyMesh& mesh, std::size_t count, int threads, Progress& progress) {
  const implicit::Box box = implicit::bounds(mesh.positions);
  Eigen::Index axis = 0;
  const double length = box.size().maxCoeff(&axis);
  std::vector<std::uint32_t> slabs(mesh.vertex_count());
  for_each_part(slabs.size(), vertices_per_part, threads, progress, [&](std::size_t begin, std::size_t end) {
    for (std::size_t v = begin; v < end; ++v) {
      const double share = std::max(0.0, (mesh.positions[v][axis] - box.low[axis]) / length);  // 0 for NaN
      slabs[v] =
          static_cast<std::uint32_t>(std::min(static_cast<std::size_t>(share * static_cast<double>(count)), count - 1));
    }
  });
  return slabs;
}

void number_vertices(Slabs& slabs, std::size_t count) {
  slabs.vertex_count.assign(count, 0);
  slabs.number.reserve(slabs.slab.size());
  for (const std::uint32_t slab : slabs.slab) slabs.number.push_back(slabs.vertex_count[slab]++);
}

void sort_faces(const PolyMesh& mesh, Slabs& slabs, std::size_t count) {
  const auto range = [&](std::size_t f) {
    const auto face = mesh.face(f);
    return std::minmax({slabs.slab[face[0]], slabs.slab[face[1]], slabs.slab[face[2]]});
  };
  slabs.first.assign(count + 1, 0);
  for (std::size_t f = 0; f < mesh.face_count(); ++f) {
    const auto [low, high] = range(f);
    for (std::size_t s = low; s <= high; ++s) ++slabs.first[s + 1];
  }
  for (std::size_t s = 0; s < count; ++s) slabs.first[s + 1] += slabs.first[s];
  slabs.faces.resize(slabs.first.back());
  std::vector<Index> next = slabs.first;
  for (std::size_t f = 0; f < mesh.face_count(); ++f) {
    const auto [low, high] = range(f);
    for (std::size_t s = low; s <= high; ++s) slabs.faces[next[s]++] = static_cast<Index>(f);
  }
}

Slabs slabs_of(const PolyMesh& mesh, std::size_t count, int threads, Progress& progress) {
  Slabs slabs;
  slabs.slab = slabs_of_vertices(mesh, count, threads, progress);
  number_vertices(slabs, count);
  sort_faces(mesh, slabs, count);
  return slabs;
}

/// The faces of a slab by themselves: vertices that lie in it, then those that lie beyond.
PolyMesh part_of(const PolyMesh& mesh, const Slabs& slabs, std::size_t slab, std::span<const Index> faces) {
  std::vector<Index> beyond;
  for (const Index f : faces)
    for (const Index v : mesh.face(f))
      if (slabs.slab[v] != slab) beyond.push_back(v);
  std::sort(beyond.begin(), beyond.end());
  beyond.erase(std::unique(beyond.begin(), beyond.end()), beyond.end());
  PolyMesh part;
  part.positions.assign(slabs.vertex_count[slab], Vec3::Zero());
  for (const Index v : beyond) part.positions.push_back(mesh.positions[v]);
  const auto number = [&](Index v) {
    if (slabs.slab[v] != slab)
      return slabs.vertex_count[slab] + static_cast<Index>(std::ranges::lower_bound(beyond, v) - beyond.begin());
    part.positions[slabs.number[v]] = mesh.positions[v];
    return slabs.number[v];
  };
  for (const Index f : faces) {
    const auto face = mesh.face(f);
    part.add_triangle(number(face[0]), number(face[1]), number(face[2]));
  }
  return part;
}

}  // namespace

std::vector<std::array<Index, 2>> find_cuts(const PolyMesh& mesh, int threads, Progress& progress) {
  const std::size_t count = slab_count(mesh.face_count());
  if (count == 1) return find_self_intersections(mesh, progress, {.max_pairs = most_cut_pairs}).pairs;
  Progress slicing = progress.step("look for cuts", 0.02);
  const Slabs slabs = slabs_of(mesh, count, threads, slicing);
  Progress looking = progress.step("look for cuts", 0.98);
  std::vector<std::vector<std::array<Index, 2>>> found(count);
  for_each_part(count, 1, threads, looking, [&](std::size_t slab, std::size_t) {
    const auto faces = std::span(slabs.faces).subspan(slabs.first[slab], slabs.first[slab + 1] - slabs.first[slab]);
    Progress silent = progress.silent();
    found[slab] =
        find_self_intersections(part_of(mesh, slabs, slab, faces), silent, {.max_pairs = most_cut_pairs}).pairs;
    for (auto& pair : found[slab]) pair = {faces[pair[0]], faces[pair[1]]};
  });
  std::vector<std::array<Index, 2>> pairs;
  for (const auto& part : found) pairs.insert(pairs.end(), part.begin(), part.end());
  std::sort(pairs.begin(), pairs.end());
  pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
  return pairs;
}

}  // namespace croquis::remeshing
