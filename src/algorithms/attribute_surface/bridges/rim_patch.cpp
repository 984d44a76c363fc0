// SPDX-License-Identifier: GPL-3.0-or-later
#include "croquis/attribute_surface/rim_patch.h"

#include <algorithm>
#include <numeric>
#include <set>
#include <utility>

#include <Eigen/Geometry>

#include "algorithms/attribute_surface/bridges/rim_face.h"
#include "algorithms/attribute_surface/bridges/rim_normal.h"
#include "croquis/geometry/edge_channels.h"
#include "croquis/geometry/mesh_topology.h"
#include "croquis/geometry/self_intersection.h"

namespace croquis {
namespace {

/// Attributes of the elements given are kept; new faces take those of a face beside them, new vertices those of a
/// vertex of their rim.
class ChannelSources {
 public:
  explicit ChannelSources(const PolyMesh& mesh)
      : vertices(mesh.vertex_count()), faces(mesh.face_count()), corners(mesh.corners.size()) {
    for (auto* list : {&vertices, &faces, &corners}) std::iota(list->begin(), list->end(), Index{0});
  }

  void apply(const PolyMesh& before, PolyMesh& after) const {
    after.channels.clear();
    for (const AttributeChannel& channel : before.channels) {
      switch (channel.domain) {
        case Domain::Vertex: after.channels.push_back(gathered(channel, vertices)); break;
        case Domain::Face: after.channels.push_back(gathered(channel, faces)); break;
        case Domain::Corner: after.channels.push_back(gathered(channel, corners)); break;
        case Domain::Line:
        case Domain::Edge: after.channels.push_back(channel); break;
      }
    }
    renumber_edge_channels(before, {}, after);
  }

  std::vector<Index> vertices, faces, corners;
};

class RimPatcher {
 public:
  RimPatcher(const PolyMesh& mesh, const RimPatchOptions& options, Progress& progress)
      : mesh_(mesh), options_(options), progress_(progress), topology_(mesh), sources_(mesh) {
    grown_ = mesh;
    grown_.channels.clear();
  }

  RimPatches run(std::span<const std::vector<Index>> rims) {
    RimPatches result;
    for (std::size_t r = 0; r < rims.size(); ++r) {
      result.outcomes.push_back(close(rims[r]));
      progress_.report(static_cast<double>(r + 1) / static_cast<double>(rims.size()));
    }
    sources_.apply(mesh_, grown_);
    result.mesh = std::move(grown_);
    return result;
  }

 private:
  /// The face beside the edge of a rim, or no_index where the edge isn't the end of one face that runs along it.
  Index face_beside(Index from, Index to) const {
    if (from >= mesh_.vertex_count() || to >= mesh_.vertex_count()) return no_index;
    const Index edge = find_edge(topology_, from, to);
    if (edge == no_index || topology_.edge_corners(edge).size() != 1) return no_index;
    const Index corner = topology_.edge_corners(edge)[0];
    return topology_.vertex(corner) == from ? topology_.face(corner) : no_index;
  }

  std::string fault_of(const std::vector<Index>& rim) const {
    if (rim.size() < 3) return "it has fewer than 3 edges";
    for (std::size_t i = 0; i < rim.size(); ++i) {
      const Index next = rim[(i + 1) % rim.size()];
      if (face_beside(rim[i], next) == no_index) return "the faces along its rim don't agree in direction";
      if (mesh_.positions[rim[i]] == mesh_.positions[next]) return "two vertices of its rim are at one place";
    }
    return "";
  }

  RimOutcome close(const std::vector<Index>& rim) {
    RimOutcome outcome;
    outcome.reason = fault_of(rim);
    if (!outcome.reason.empty()) return outcome;
    const std::vector<Index> vertices(rim.rbegin(), rim.rend());  // the patch runs along the rim the other way
    RimLoop loop;
    for (const Index vertex : vertices) {
      progress_.check();
      loop.points.push_back(mesh_.positions[vertex]);
      loop.normals.push_back(rim_normal(mesh_, topology_, vertex));
      if (loop.normals.back() == Vec3::Zero()) outcome.reason = "faces along its rim have no area";
    }
    if (!outcome.reason.empty()) return outcome;
    for (const std::size_t sides : attempts()) {
      RimPatchOptions options = options_;
      options.sides = sides;
      const RimFace face(loop, options);
      outcome.sides = face.surface().frame().sides.size();
      outcome.curve_distance = face.curve_distance();
      outcome.reason.clear();
      add(face, vertices, face_beside(rim[0], rim[1]), outcome);
      if (outcome.closed) break;
    }
    return outcome;
  }

  /// Where corners of the domain lie on a smooth part of a rim, a surface may fold beside them; with more of them it
  /// does less.
  std::vector<std::size_t> attempts() const {
    if (options_.sides != 0) return {options_.sides};
    return {0, 6, 8, 12};
  }

  /// The triangles over the face's domain, or none with the outcome's reason.
  PatchTriangles triangles_of(const RimFace& face, const std::vector<Index>& outline, std::vector<Vec3>& points) {
    PatchTriangles patch = fill_domain(face.surface().domain(), face.outline(), options_.density * face.spacing());
    for (std::size_t i = 0; i < patch.places.size(); ++i)
      points.push_back(i < outline.size() ? mesh_.positions[outline[i]] : face.at(patch.places[i]));
    even_out(points, patch.triangles);
    const auto is_taken = [&](Index a, Index b) {
      if (a >= outline.size() || b >= outline.size()) return false;
      return find_edge(topology_, outline[a], outline[b]) != no_index ||
             chords_.contains(chord(outline[a], outline[b]));
    };
    cut_edges(is_taken, patch);
    for (std::size_t i = points.size(); i < patch.places.size(); ++i) points.push_back(face.at(patch.places[i]));
    return patch;
  }

  static std::pair<Index, Index> chord(Index a, Index b) { return std::minmax(a, b); }

  void add(const RimFace& face, const std::vector<Index>& vertices, Index beside, RimOutcome& outcome) {
    std::vector<Index> numbers;
    for (std::size_t i = 0; i < vertices.size(); ++i)
      numbers.push_back(vertices[(face.first_point() + i) % vertices.size()]);
    std::vector<Vec3> points;
    const PatchTriangles patch = triangles_of(face, numbers, points);
    if (patch.triangles.empty()) outcome.reason = "its rim has edges too short beside the others";
    if (patch.triangles.empty()) return;
    const std::size_t old_vertices = grown_.vertex_count(), old_faces = grown_.face_count();
    for (std::size_t i = numbers.size(); i < points.size(); ++i) {
      numbers.push_back(static_cast<Index>(grown_.vertex_count()));
      grown_.positions.push_back(points[i]);
    }
    for (const auto& t : patch.triangles) grown_.add_triangle(numbers[t[0]], numbers[t[1]], numbers[t[2]]);
    if (is_cut(old_faces)) {
      grown_.positions.resize(old_vertices);
      grown_.corners.resize(grown_.face_offsets[old_faces]);
      grown_.face_offsets.resize(old_faces + 1);
      outcome.reason = "its patch would cut through itself or the mesh";
      return;
    }
    outcome.closed = true;
    outcome.first_face = old_faces;
    outcome.face_count = patch.triangles.size();
    note(vertices, beside, patch, numbers);
  }

  /// Whether new faces meet each other or the mesh anywhere but in what they share.
  bool is_cut(std::size_t first_face) {
    std::vector<Index> faces(grown_.face_count() - first_face);
    std::iota(faces.begin(), faces.end(), static_cast<Index>(first_face));
    Progress checking = progress_.step("check", 0);
    return find_intersections_of(grown_, faces, checking).count > 0;
  }

  void note(const std::vector<Index>& vertices, Index beside, const PatchTriangles& patch,
            const std::vector<Index>& numbers) {
    sources_.vertices.resize(grown_.vertex_count(), vertices.front());
    sources_.faces.resize(grown_.face_count(), beside);
    sources_.corners.resize(grown_.corners.size(), no_index);
    for (const auto& t : patch.triangles) {
      for (std::size_t i = 0; i < 3; ++i) {
        const Index a = t[i], b = t[(i + 1) % 3];
        if (a < vertices.size() && b < vertices.size()) chords_.insert(chord(numbers[a], numbers[b]));
      }
    }
  }

  const PolyMesh& mesh_;
  const RimPatchOptions& options_;
  Progress& progress_;
  const MeshTopology topology_;
  ChannelSources sources_;
  PolyMesh grown_;
  std::set<std::pair<Index, Index>> chords_;  ///< edges of patches between vertices of the mesh
};

}  // namespace

RimPatches patch_rims(const PolyMesh& mesh, std::span<const std::vector<Index>> rims, const RimPatchOptions& options,
                      Progress& progress) {
  return RimPatcher(mesh, options, progress).run(rims);
}

}  // namespace croquis
