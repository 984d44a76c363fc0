// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/remeshing/remesh_attributes.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <type_traits>
#include <utility>
#include <variant>

#include <Eigen/Geometry>

#include "algorithms/remeshing/vertices_per_part.h"
#include "croquis/base/parallel.h"
#include "croquis/hole_filling/channel_names.h"
#include "croquis/hole_filling/patch_confidence.h"

namespace croquis::remeshing {
namespace {

using namespace hole_filling;

constexpr double least_from_rim = 0.2;  // × cell: nearer is still the surface given

/// Weights of the point of a triangle nearest to p (Ericson 2005, section 5.1.5: by the regions of its corners and
/// edges).
std::array<double, 3> nearest_in_triangle(const Vec3& p, const Vec3& a, const Vec3& b, const Vec3& c) {
  const Vec3 ab = b - a, ac = c - a, ap = p - a, bp = p - b, cp = p - c;
  const double d1 = ab.dot(ap), d2 = ac.dot(ap), d3 = ab.dot(bp), d4 = ac.dot(bp), d5 = ab.dot(cp), d6 = ac.dot(cp);
  if (d1 <= 0 && d2 <= 0) return {1, 0, 0};
  if (d3 >= 0 && d4 <= d3) return {0, 1, 0};
  if (d6 >= 0 && d5 <= d6) return {0, 0, 1};
  const double va = d3 * d6 - d5 * d4, vb = d5 * d2 - d1 * d6, vc = d1 * d4 - d3 * d2;
  if (vc <= 0 && d1 >= 0 && d3 <= 0) return {1 - d1 / (d1 - d3), d1 / (d1 - d3), 0};
  if (vb <= 0 && d2 >= 0 && d6 <= 0) return {1 - d2 / (d2 - d6), 0, d2 / (d2 - d6)};
  const double along = d4 - d3, back = d5 - d6;
  if (va <= 0 && along >= 0 && back >= 0) return {0, back / (along + back), along / (along + back)};
  const double sum = va + vb + vc;
  return sum > 0 ? std::array{va / sum, vb / sum, vc / sum} : std::array{1.0, 0.0, 0.0};
}

template <typename T>
T rounded_value(double value) {
  if constexpr (std::is_floating_point_v<T>) {
    return static_cast<T>(value);
  } else {
    const double low = static_cast<double>(std::numeric_limits<T>::min());
    const double high = static_cast<double>(std::numeric_limits<T>::max());
    return static_cast<T>(std::clamp(std::round(value), low, high));
  }
}

bool is_normal(const AttributeChannel& channel) {
  return channel.name == "normal" && channel.width == 3 &&
         (std::holds_alternative<std::vector<float>>(channel.data) ||
          std::holds_alternative<std::vector<double>>(channel.data));
}

/// Value of one vertex in one channel.
void interpolate(const AttributeChannel& from, const std::array<Index, 3>& corners, const NearestScanPlace& place,
                 std::size_t vertex, AttributeChannel& to) {
  const std::size_t heaviest =
      static_cast<std::size_t>(std::max_element(place.weights.begin(), place.weights.end()) - place.weights.begin());
  const auto width = static_cast<std::size_t>(from.width);
  std::visit(
      [&](auto& values) {
        const auto& given = std::get<std::remove_reference_t<decltype(values)>>(from.data);
        using T = typename std::remove_reference_t<decltype(values)>::value_type;
        for (std::size_t i = 0; i < width; ++i) {
          double sum = 0;
          for (std::size_t k = 0; k < 3; ++k)
            sum += place.weights[k] > 0 ? place.weights[k] * static_cast<double>(given[corners[k] * width + i]) : 0;
          values[vertex * width + i] =
              from.labels.empty() ? rounded_value<T>(sum) : given[corners[heaviest] * width + i];
        }
      },
      to.data);
}

void resize(AttributeChannel& channel, std::size_t count) {
  std::visit([&](auto& values) { values.resize(count * static_cast<std::size_t>(channel.width)); }, channel.data);
}

/// What one transfer works on.
class Transfer {
 public:
  Transfer(const PolyMesh& mesh, const HoleAnalysis& analysis, const RemeshPiece& piece,
           const std::vector<RimPlace>& rims, double cell)
      : mesh_(mesh),
        analysis_(analysis),
        piece_(piece),
        cell_(cell),
        rim_of_(piece.vertices.size(), no_index),
        rims_(rims) {
    for (Index r = 0; r < rims.size(); ++r) {
      const auto found = std::lower_bound(piece.vertices.begin(), piece.vertices.end(), rims[r].vertex);
      if (rims[r].hole == no_index || found == piece.vertices.end() || *found != rims[r].vertex) continue;
      rim_of_[static_cast<std::size_t>(found - piece.vertices.begin())] = r;
      const Index hole = rims[r].hole;
      if (!bend_.contains(hole)) bend_[hole] = rim_bend(mesh, analysis, {&hole, 1});
    }
  }

  /// The hole that a new vertex lies in, if it does.
  Index hole_at(const Vec3& place, const NearestScanPlace& nearest) const {
    if (nearest.point >= rim_of_.size() || nearest.distance < least_from_rim * cell_) return no_index;
    const Index rim = rim_of_[nearest.point];
    if (rim == no_index) return no_index;
    const Vec3 away = place - mesh_.positions[rims_[rim].vertex];
    return away.dot(rims_[rim].outwards) > 0 ? rims_[rim].hole : no_index;
  }

  float confidence(Index hole, double distance) const {
    return static_cast<float>(confidence_in(predicted_error(distance / diagonal_around(hole), bend_.at(hole), 0)));
  }

  /// Of the largest piece that the hole belongs to: an island is small beside what is around it.
  double diagonal_around(Index hole) const {
    const auto diagonal_of = [&](Index id) { return analysis_.component_diagonal[analysis_.holes[id].component]; };
    double largest = diagonal_of(hole);
    for (const Index companion : analysis_.holes[hole].companions) largest = std::max(largest, diagonal_of(companion));
    return largest;
  }

  /// The vertices of the mesh whose values count; three times the same where there is no triangle.
  std::array<Index, 3> corners(const NearestScanPlace& place) const {
    if (place.triangle != no_index) return analysis_.view.triangles[place.triangle];
    const Index v = piece_.vertices[place.point];
    return {v, v, v};
  }

 private:
  const PolyMesh& mesh_;
  const HoleAnalysis& analysis_;
  const RemeshPiece& piece_;
  double cell_;
  std::vector<Index> rim_of_;     // of the piece's vertices, into rims_
  std::map<Index, double> bend_;  // of the holes beside the piece
  const std::vector<RimPlace>& rims_;
};

}  // namespace

NearestSurface::NearestSurface(const PolyMesh& mesh, const SurfaceView& view, const TriangleFans& fans,
                               const RemeshPiece& piece, const RemeshPoints& points, int threads)
    : mesh_(mesh), view_(view), fans_(fans), piece_(piece), points_(points), tree_(points.positions, threads) {}

NearestScanPlace NearestSurface::nearest(const Vec3& place) const {
  NearestScanPlace found;
  found.point = tree_.nearest(place);
  found.distance = (place - points_.positions[found.point]).norm();
  const auto look_at = [&](Index triangle) {
    const auto& [a, b, c] = view_.triangles[triangle];
    const Vec3 &pa = mesh_.positions[a], &pb = mesh_.positions[b], &pc = mesh_.positions[c];
    const auto weights = nearest_in_triangle(place, pa, pb, pc);
    const double distance = (place - (weights[0] * pa + weights[1] * pb + weights[2] * pc)).norm();
    if (found.triangle != no_index && distance >= found.distance) return;
    found.triangle = triangle;
    found.weights = weights;
    found.distance = distance;
  };
  if (found.point >= piece_.vertices.size()) {
    look_at(points_.triangles[found.point - piece_.vertices.size()]);
  } else {
    for (const Index corner : fans_.at(piece_.vertices[found.point])) look_at(corner / 3);
  }
  return found;
}

std::vector<AttributeChannel> channels_like(const PolyMesh& mesh) {
  std::vector<AttributeChannel> channels;
  for (const AttributeChannel& channel : mesh.channels) {
    if (channel.domain != Domain::Vertex || channel.name == confidence_channel) continue;
    AttributeChannel empty = {channel.name, channel.domain, channel.width, {}, channel.labels};
    std::visit([&](const auto& values) { empty.data = std::remove_cvref_t<decltype(values)>(); }, channel.data);
    channels.push_back(std::move(empty));
  }
  return channels;
}

void make_room(std::size_t count, std::vector<AttributeChannel>& channels, HoleMarks& marks) {
  for (AttributeChannel& channel : channels) resize(channel, count);
  marks.hole.resize(count, no_index);
  marks.confidence.resize(count, 1);
}

void keep_values(std::span<const Index> vertices, std::span<const Index> faces, std::vector<AttributeChannel>& channels,
                 HoleMarks& marks, std::vector<std::int32_t>& labels) {
  const auto keep = [](std::span<const Index> kept, std::size_t width, auto& values) {
    for (std::size_t i = 0; i < kept.size(); ++i)
      for (std::size_t k = 0; k < width; ++k) values[i * width + k] = values[kept[i] * width + k];
    values.resize(kept.size() * width);
    values.shrink_to_fit();
  };
  for (AttributeChannel& channel : channels)
    std::visit([&](auto& values) { keep(vertices, static_cast<std::size_t>(channel.width), values); }, channel.data);
  keep(vertices, 1, marks.hole);
  keep(vertices, 1, marks.confidence);
  keep(faces, 1, labels);
}

void transfer(PolyMesh& made, const NewVertices& vertices, const NearestSurface& nearest, const PolyMesh& mesh,
              const HoleAnalysis& analysis, const RemeshPiece& piece, const std::vector<RimPlace>& rims, double cell,
              int threads, HoleMarks& marks, Progress& progress) {
  std::vector<const AttributeChannel*> given;
  for (const AttributeChannel& channel : made.channels) given.push_back(mesh.channel(channel.name, Domain::Vertex));
  const Transfer work(mesh, analysis, piece, rims, cell);
  for_each_part(vertices.count, vertices_per_part, threads, progress, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      if (!vertices.piece_at.empty() && vertices.piece_at[i] != vertices.piece) continue;
      const std::size_t v = vertices.first + i;
      const NearestScanPlace place = nearest.nearest(made.positions[v]);
      const Index hole = work.hole_at(made.positions[v], place);
      marks.hole[v] = hole;
      if (hole != no_index) marks.confidence[v] = work.confidence(hole, place.distance);
      for (std::size_t c = 0; c < given.size(); ++c)
        if (!is_normal(made.channels[c])) interpolate(*given[c], work.corners(place), place, v, made.channels[c]);
    }
  });
}

Vec3 face_normal(const PolyMesh& mesh, std::size_t face) {
  const auto corners = mesh.face(face);
  const Vec3& a = mesh.positions[corners[0]];
  return (mesh.positions[corners[1]] - a).cross(mesh.positions[corners[2]] - a);
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
    const Vec3 normal = face_normal(mesh, f);
    for (std::size_t i = 0; i < 3; ++i) {
      const Index a = mesh.corners[3 * f + i], b = mesh.corners[3 * f + (i + 1) % 3],
                  c = mesh.corners[3 * f + (i + 2) % 3];
      patch.angle = std::fmin(
          patch.angle, angle_between(mesh.positions[b] - mesh.positions[a], mesh.positions[c] - mesh.positions[a]));
      for (const Index corner : fans.at(b)) {
        if (fans.next(corner) == a && patches[corner / 3] != patches[f])
          patch.jump = std::fmax(patch.jump, angle_between(normal, face_normal(mesh, corner / 3)));
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
  const auto channel = std::find_if(mesh.channels.begin(), mesh.channels.end(), is_normal);
  if (channel == mesh.channels.end()) return;
  const TriangleFans fans(mesh.vertex_count(), mesh.corners);
  for_each_part(mesh.vertex_count(), vertices_per_part, threads, progress, [&](std::size_t begin, std::size_t end) {
    for (std::size_t v = begin; v < end; ++v) {
      Vec3 sum = Vec3::Zero();
      for (const Index corner : fans.at(v)) {
        const Vec3& here = mesh.positions[v];
        sum += (mesh.positions[fans.next(corner)] - here).cross(mesh.positions[fans.previous(corner)] - here);
      }
      const Vec3 unit = sum.norm() > 0 ? Vec3(sum.normalized()) : sum;
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
