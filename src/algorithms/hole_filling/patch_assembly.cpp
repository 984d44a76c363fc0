// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cstdint>
#include <deque>
#include <numeric>
#include <string>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

#include <Eigen/Geometry>

#include "algorithms/hole_filling/fairing/fairing.h"
#include "algorithms/hole_filling/patch_making.h"
#include "croquis/base/parallel.h"
#include "croquis/geometry/edge_channels.h"
#include "croquis/hole_filling/fill_holes.h"
#include "croquis/hole_filling/hole_patch.h"

namespace croquis::hole_filling {
namespace {

/// The patches as they stand in the grown mesh: each with the numbers of its first new vertex and face.
struct Placed {
  const HolePatch* patch;
  Index first_vertex, first_face;
};

/// A copy of the mesh that doesn't move when the patches come.
PolyMesh with_space_for(std::span<const HolePatch> patches, const PolyMesh& mesh) {
  std::size_t points = 0, triangles = 0;
  for (const HolePatch& patch : patches) points += patch.points.size(), triangles += patch.triangles.size();
  PolyMesh copy;
  copy.positions.reserve(mesh.positions.size() + points);
  copy.face_offsets.reserve(mesh.face_offsets.size() + triangles);
  copy.corners.reserve(mesh.corners.size() + 3 * triangles);
  copy = mesh;
  return copy;
}

void append_elements(PolyMesh& mesh, Index vertices_given, const HolePatch& patch) {
  const auto base = static_cast<Index>(mesh.vertex_count());
  mesh.positions.insert(mesh.positions.end(), patch.points.begin(), patch.points.end());
  for (auto t : patch.triangles) {
    for (Index& vertex : t) {
      if (vertex >= vertices_given) vertex = base + (vertex - vertices_given);
    }
    mesh.add_face(t);
  }
}

/// Values of a vertex channel for a patch's new vertices: continued from its rims, or the first of them for categories.
template <typename T>
void continue_values(const HarmonicValues& graph, std::size_t width, const Placed& placed, std::vector<T>& values,
                     bool is_category) {
  const std::span<const Index> rim = graph.rim_vertices();
  Eigen::MatrixXd known(std::ssize(rim), static_cast<Eigen::Index>(width));
  const auto count = std::ssize(placed.patch->points);
  for (Eigen::Index i = 0; i < known.rows(); ++i) {
    for (Eigen::Index k = 0; k < known.cols(); ++k)
      known(i, k) = static_cast<double>(values[rim[static_cast<std::size_t>(i)] * width + static_cast<std::size_t>(k)]);
  }
  const Eigen::MatrixXd found =
      is_category ? Eigen::MatrixXd(known.row(0).replicate(count, 1)) : graph.continued(known);
  auto value = values.begin() + static_cast<std::ptrdiff_t>(placed.first_vertex * width);
  for (Eigen::Index i = 0; i < found.rows(); ++i) {
    for (Eigen::Index k = 0; k < found.cols(); ++k) *value++ = stored_value<T>(found(i, k));
  }
}

/// Unit normals of the new vertices by the patch's own faces, weighted by area.
template <typename T>
void compute_normals(const PolyMesh& mesh, const Placed& placed, std::vector<T>& values) {
  std::vector<Vec3> normals(placed.patch->points.size(), Vec3::Zero());
  for (Index f = placed.first_face; f < placed.first_face + placed.patch->triangles.size(); ++f) {
    const auto t = mesh.face(f);
    const Vec3& a = mesh.positions[t[0]];
    const Vec3 normal = (mesh.positions[t[1]] - a).cross(mesh.positions[t[2]] - a);
    for (const Index vertex : t) {
      if (vertex >= placed.first_vertex) normals[vertex - placed.first_vertex] += normal;
    }
  }
  for (std::size_t i = 0; i < normals.size(); ++i) {
    const Vec3 unit = normals[i].normalized();
    for (std::size_t axis = 0; axis < 3; ++axis)
      values[3 * (placed.first_vertex + i) + axis] = stored_value<T>(unit[static_cast<Eigen::Index>(axis)]);
  }
}

void continue_vertex_channel(const PolyMesh& mesh, std::span<const Placed> placed,
                             const std::deque<HarmonicValues>& graphs, AttributeChannel& channel) {
  std::visit(
      [&](auto& values) {
        using T = typename std::remove_reference_t<decltype(values)>::value_type;
        const auto width = static_cast<std::size_t>(channel.width);
        values.resize(mesh.vertex_count() * width, T{});
        for (std::size_t p = 0; p < placed.size(); ++p) {
          if (placed[p].patch->points.empty()) continue;
          if (channel.name == "normal" && width == 3 && std::is_floating_point_v<T>)
            compute_normals(mesh, placed[p], values);
          else
            continue_values(graphs[p], width, placed[p], values, !channel.labels.empty());
        }
      },
      channel.data);
}

/// Every face of a patch gets the values of the face beside its first rim edge; new corners and edges come after the
/// old ones and have no values.
void continue_other_channel(const PolyMesh& grown, const HoleAnalysis& analysis, std::span<const Placed> placed,
                            AttributeChannel& channel) {
  std::vector<Index> sources(grown.element_count(channel.domain), no_index);
  const std::size_t given = std::min(channel.size() / static_cast<std::size_t>(channel.width), sources.size());
  std::iota(sources.begin(), sources.begin() + static_cast<std::ptrdiff_t>(given), Index{0});
  for (const Placed& p : placed) {
    if (channel.domain != Domain::Face) break;
    const Index beside = analysis.view.face[analysis.holes[p.patch->holes.front()].corners.front() / 3];
    std::fill_n(sources.begin() + p.first_face, p.patch->triangles.size(), beside);
  }
  channel = gathered(channel, sources);
}

const std::vector<std::int32_t>* numbers_of(const PolyMesh& mesh) {
  const AttributeChannel* channel = mesh.channel(patch_channel, Domain::Face);
  if (channel == nullptr || channel->width != 1) return nullptr;
  return std::get_if<std::vector<std::int32_t>>(&channel->data);
}

/// Numbers the patches' faces; a channel of that name from an earlier filling is continued.
void number_patches(PolyMesh& mesh, Index first_number, std::span<const Placed> placed) {
  AttributeChannel* channel = mesh.channel(patch_channel, Domain::Face);
  if (channel == nullptr) {
    mesh.channels.push_back({patch_channel, Domain::Face, 1, std::vector<std::int32_t>(mesh.face_count(), -1), {}});
    channel = &mesh.channels.back();
  }
  auto* values = std::get_if<std::vector<std::int32_t>>(&channel->data);
  if (values == nullptr || channel->width != 1) return;
  auto number = static_cast<std::int32_t>(first_number);
  for (const Placed& p : placed) {
    std::fill_n(values->begin() + p.first_face, p.patch->triangles.size(), number);
    ++number;
  }
}

/// A scanner's own confidence, where it is a floating number, goes on in ours.
void report_confidence(PolyMesh& grown, const PolyMesh& mesh, const HoleAnalysis& analysis,
                       std::span<const Placed> placed, int threads) {
  AttributeChannel* channel = grown.channel(confidence_channel, Domain::Vertex);
  if (channel == nullptr) {
    grown.channels.push_back(
        {confidence_channel, Domain::Vertex, 1, std::vector<float>(grown.vertex_count(), 1.0F), {}});
    channel = &grown.channels.back();
  }
  if (channel->width != 1) return;
  std::visit(
      [&](auto& values) {
        using T = typename std::remove_reference_t<decltype(values)>::value_type;
        if constexpr (std::is_floating_point_v<T>) {
          for_each_part(placed.size(), 1, threads, [&](std::size_t begin, std::size_t) {
            const Placed& p = placed[begin];
            const std::vector<float> found = vertex_confidence(*p.patch, mesh, analysis);
            std::transform(found.begin(), found.end(), values.begin() + p.first_vertex,
                           [](float value) { return static_cast<T>(value); });
          });
        }
      },
      channel->data);
}

}  // namespace

PolyMesh append_patches(const PolyMesh& mesh, const HoleAnalysis& analysis, std::span<const HolePatch> patches,
                        bool mark_patches, int threads) {
  PolyMesh grown = with_space_for(patches, mesh);
  std::vector<Placed> placed;
  for (const HolePatch& patch : patches) {
    placed.push_back({&patch, static_cast<Index>(grown.vertex_count()), static_cast<Index>(grown.face_count())});
    append_elements(grown, static_cast<Index>(mesh.vertex_count()), patch);
  }
  if (patches.empty()) return grown;
  std::deque<HarmonicValues> graphs;  // which can't be moved
  for (AttributeChannel& channel : grown.channels) {
    if (channel.domain == Domain::Vertex && graphs.empty()) {
      for (const HolePatch& patch : patches) graphs.emplace_back(patch, static_cast<Index>(mesh.vertex_count()));
    }
    if (channel.domain == Domain::Vertex) continue_vertex_channel(grown, placed, graphs, channel);
    if (channel.domain == Domain::Face || channel.domain == Domain::Corner || channel.domain == Domain::Edge)
      continue_other_channel(grown, analysis, placed, channel);
  }
  if (!mark_patches) return grown;
  number_patches(grown, next_patch_number(mesh), placed);
  report_confidence(grown, mesh, analysis, placed, threads);
  return grown;
}

Index next_patch_number(const PolyMesh& mesh) {
  const std::vector<std::int32_t>* numbers = numbers_of(mesh);
  if (numbers == nullptr || numbers->empty()) return 0;
  return static_cast<Index>(std::max(-1, *std::max_element(numbers->begin(), numbers->end())) + 1);
}

}  // namespace croquis::hole_filling
