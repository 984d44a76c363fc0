// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/remeshing/attributes.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <type_traits>
#include <utility>
#include <variant>

#include <Eigen/Geometry>

#include "croquis/base/parallel.h"
#include "croquis/geometry/edge_channels.h"
#include "croquis/geometry/polygon_area.h"
#include "croquis/hole_filling/fill_holes.h"
#include "croquis/hole_filling/hole_patch.h"

namespace croquis::remeshing {
namespace {

using namespace hole_filling;

constexpr double least_from_rim = 0.2;  // × cell: nearer is still the surface given

bool is_normal(const AttributeChannel& channel) {
  return channel.name == "normal" && channel.width == 3 &&
         (std::holds_alternative<std::vector<float>>(channel.data) ||
          std::holds_alternative<std::vector<double>>(channel.data));
}

/// Value of one vertex in one channel: of labels that of the heaviest corner.
void interpolate(const AttributeChannel& from, const std::array<Index, 3>& corners,
                 const std::array<double, 3>& weights, std::size_t vertex, AttributeChannel& to) {
  const auto heaviest = static_cast<std::size_t>(std::ranges::max_element(weights) - weights.begin());
  const auto width = static_cast<std::size_t>(from.width);
  std::visit(
      [&](auto& values) {
        const auto& given = std::get<std::remove_reference_t<decltype(values)>>(from.data);
        using T = typename std::remove_reference_t<decltype(values)>::value_type;
        for (std::size_t i = 0; i < width; ++i) {
          double sum = 0;
          for (std::size_t k = 0; k < 3; ++k)
            sum += weights[k] > 0 ? weights[k] * static_cast<double>(given[corners[k] * width + i]) : 0;
          values[vertex * width + i] =
              from.labels.empty() ? stored_value<T>(sum) : given[corners[heaviest] * width + i];
        }
      },
      to.data);
}

/// What the confidence in a closed hole goes by.
struct ClosedHole {
  double bend = 0;      // of its surroundings: see rim_bend
  double diagonal = 0;  // of the largest piece that it belongs to: an island is small beside what is around it
};

ClosedHole closed_hole(const PolyMesh& mesh, const HoleAnalysis& analysis, const Hole& hole) {
  ClosedHole closed{rim_bend(mesh, analysis, {&hole.id, 1}), analysis.component_diagonal[hole.component]};
  for (const Index companion : hole.companions)
    closed.diagonal = std::max(closed.diagonal, analysis.component_diagonal[analysis.holes[companion].component]);
  return closed;
}

}  // namespace

std::vector<AttributeChannel> channels_like(const PolyMesh& mesh, std::size_t vertex_count) {
  std::vector<AttributeChannel> channels;
  for (const AttributeChannel& channel : mesh.channels) {
    if (channel.domain != Domain::Vertex || channel.name == confidence_channel) continue;
    AttributeChannel like = {channel.name, channel.domain, channel.width, {}, channel.labels};
    std::visit(
        [&](const auto& values) {
          like.data = std::remove_cvref_t<decltype(values)>(vertex_count * static_cast<std::size_t>(channel.width));
        },
        channel.data);
    channels.push_back(std::move(like));
  }
  return channels;
}

void keep_values(std::span<const Index> vertices, std::span<const Index> faces, std::vector<AttributeChannel>& channels,
                 HoleMarks& marks, std::vector<std::int32_t>& labels) {
  const auto keep = [](std::span<const Index> kept, auto& values) {
    for (std::size_t i = 0; i < kept.size(); ++i) values[i] = values[kept[i]];
    values.resize(kept.size());
    values.shrink_to_fit();
  };
  for (AttributeChannel& channel : channels) channel = gathered(channel, vertices);
  keep(vertices, marks.hole);
  keep(vertices, marks.confidence);
  keep(faces, labels);
}

void transfer(PolyMesh& made, const RemeshPart& part, std::size_t piece, const NearestScan& given,
              const HoleAnalysis& analysis, const RemeshPieces& pieces, double cell, HoleMarks& marks,
              Progress& progress) {
  const PolyMesh& mesh = given.mesh();
  std::vector<const AttributeChannel*> sources;
  for (const AttributeChannel& channel : made.channels) sources.push_back(mesh.channel(channel.name, Domain::Vertex));
  std::vector<const RimPlace*> rim_at(given.piece().vertices.size(), nullptr);  // of holes that are closed
  std::map<Index, ClosedHole> holes;
  pieces.for_each_rim(given.piece(), [&](Index own, const RimPlace& rim) {
    if (rim.hole == no_index) return;
    rim_at[own] = &rim;
    if (!holes.contains(rim.hole)) holes[rim.hole] = closed_hole(mesh, analysis, analysis.holes[rim.hole]);
  });
  const auto rim_beside = [&](const Vec3& place, const NearestScanPlace& nearest) -> const RimPlace* {
    if (nearest.point >= rim_at.size() || nearest.distance < least_from_rim * cell) return nullptr;
    const RimPlace* rim = rim_at[nearest.point];
    const bool is_beyond = rim != nullptr && (place - mesh.positions[rim->vertex]).dot(rim->outwards) > 0;
    return is_beyond ? rim : nullptr;
  };
  const auto set_values = [&](std::size_t v) {
    const NearestScanPlace nearest = given.nearest(made.positions[v]);
    if (const RimPlace* rim = rim_beside(made.positions[v], nearest)) {
      marks.hole[v] = rim->hole;
      const ClosedHole& hole = holes.at(rim->hole);
      const double error = predicted_error(nearest.distance / hole.diagonal, hole.bend, 0);
      marks.confidence[v] = static_cast<float>(confidence_in(error));
    }
    std::array<Index, 3> corners;  // three times the same vertex where there is no triangle
    if (nearest.triangle != no_index)
      corners = given.view().triangles[nearest.triangle];
    else
      corners.fill(given.piece().vertices[nearest.point]);
    for (std::size_t c = 0; c < sources.size(); ++c)
      if (!is_normal(made.channels[c])) interpolate(*sources[c], corners, nearest.weights, v, made.channels[c]);
  };
  const auto is_own = [&](std::size_t i) { return part.piece_at.empty() || part.piece_at[i] == piece; };
  for_each_part(part.vertex_count, vertices_per_part, given.threads(), progress,
                [&](std::size_t begin, std::size_t end) {
                  for (std::size_t i = begin; i < end; ++i)
                    if (is_own(i)) set_values(part.first_vertex + i);
                });
}

void measure_patches(const PolyMesh& mesh, const std::vector<std::int32_t>& patches, const std::vector<Index>& patch_of,
                     std::vector<HoleOutcome>& outcomes) {
  constexpr double unknown = std::numeric_limits<double>::quiet_NaN();
  struct Measures {
    double jump = unknown, angle = unknown;
  };
  std::map<std::int32_t, Measures> measures;
  const TriangleFans fans(mesh.vertex_count(), mesh.corners);
  for (std::size_t f = 0; f < patches.size(); ++f) {
    if (patches[f] < 0) continue;
    Measures& patch = measures[patches[f]];
    const Vec3 normal = area_normal(mesh, f);
    for (std::size_t i = 0; i < 3; ++i) {
      const Index a = mesh.corners[3 * f + i], b = mesh.corners[3 * f + (i + 1) % 3],
                  c = mesh.corners[3 * f + (i + 2) % 3];
      patch.angle = std::fmin(
          patch.angle, angle_between(mesh.positions[b] - mesh.positions[a], mesh.positions[c] - mesh.positions[a]));
      for (const Index corner : fans.at(b)) {
        if (fans.next(corner) == a && patches[corner / 3] != patches[f])
          patch.jump = std::fmax(patch.jump, angle_between(normal, area_normal(mesh, corner / 3)));
      }
    }
  }
  for (std::size_t hole = 0; hole < outcomes.size(); ++hole) {
    const auto found =
        patch_of[hole] == no_index ? measures.end() : measures.find(static_cast<std::int32_t>(patch_of[hole]));
    const Measures known = found == measures.end() ? Measures() : found->second;
    outcomes[hole].max_normal_jump = known.jump;
    outcomes[hole].min_angle = known.angle;
  }
}

void compute_normals(PolyMesh& mesh, int threads, Progress& progress) {
  const auto channel = std::ranges::find_if(mesh.channels, is_normal);
  if (channel == mesh.channels.end()) return;
  const TriangleFans fans(mesh.vertex_count(), mesh.corners);
  for_each_part(mesh.vertex_count(), vertices_per_part, threads, progress, [&](std::size_t begin, std::size_t end) {
    for (std::size_t v = begin; v < end; ++v) {
      Vec3 sum = Vec3::Zero();
      for (const Index corner : fans.at(v)) {
        const Vec3& here = mesh.positions[v];
        sum += (mesh.positions[fans.next(corner)] - here).cross(mesh.positions[fans.previous(corner)] - here);
      }
      const Vec3 unit = unit_or_zero(sum);
      for (std::size_t i = 0; i < 3; ++i) {
        const double value = unit[static_cast<Eigen::Index>(i)];
        if (auto* singles = std::get_if<std::vector<float>>(&channel->data))
          (*singles)[3 * v + i] = static_cast<float>(value);
        else
          std::get<std::vector<double>>(channel->data)[3 * v + i] = value;
      }
    }
  });
}

}  // namespace croquis::remeshing
