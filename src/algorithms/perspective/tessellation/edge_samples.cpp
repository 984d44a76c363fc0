// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/perspective/tessellation/edge_samples.h"

#include <algorithm>
#include <cmath>

#include <Eigen/Geometry>

#include "croquis/geometry/disjoint_sets.h"

namespace croquis {
namespace {

constexpr std::size_t probe_spans = 8;

/// Spans that a curve needs: its greatest distance from the chords of 8 spans falls with the square of their number.
template <typename At>
std::size_t spans_for(const At& at, double tolerance, std::size_t most) {
  double greatest = 0;
  Vec3 before = at(0.0);
  for (std::size_t i = 0; i < probe_spans; ++i) {
    const Vec3 middle = at((static_cast<double>(i) + 0.5) / probe_spans);
    const Vec3 after = at(static_cast<double>(i + 1) / probe_spans);
    greatest = std::max(greatest, (middle - (before + after) / 2).norm());
    before = after;
  }
  const double needed = std::ceil(static_cast<double>(probe_spans) * std::sqrt(greatest / tolerance) - 1e-6);
  return static_cast<std::size_t>(std::clamp(needed, 1.0, static_cast<double>(most)));
}

/// A point of a curve; coordinates that all control points share are kept to the bit.
Vec3 sample_of(const RationalCubic& cubic, double t) {
  Vec3 p = cubic.at(t);
  for (int axis = 0; axis < 3; ++axis) {
    const double level = cubic.points[0][axis];
    if (std::ranges::all_of(cubic.points, [&](const Vec3& q) { return q[axis] == level; })) p[axis] = level;
  }
  return p;
}

class EdgeSampler {
 public:
  EdgeSampler(const Brep& brep, const TessellationOptions& options, PolyMesh& mesh)
      : brep_(brep), mesh_(mesh), tolerance_(options.chord_tolerance * size_of(brep)), most_(options.most_spans) {}

  BrepSamples run() {
    for (const BrepVertex& vertex : brep_.vertices) mesh_.positions.push_back(vertex.point);
    half_spans_.assign(brep_.edges.size(), 0);
    for (const BrepFace& face : brep_.faces) measure_face(face);
    for (Index e = 0; e < brep_.edges.size(); ++e) samples_.edges.push_back(sample_edge(e));
    set_corner_normals();
    return std::move(samples_);
  }

 private:
  void measure_face(const BrepFace& face) {
    FaceSpans spans;
    for (const GregoryPatch& patch : face.patches)
      spans.along.push_back({patch_spans(patch, true), patch_spans(patch, false)});
    const std::vector<Index> halves = brep_.around(face.loops[0]);
    const std::size_t n = face.patches.size();
    for (std::size_t i = 0; n > 0 && i < halves.size(); ++i) {
      std::size_t& needed = half_spans_[brep_.half_edges[halves[i]].edge];
      if (n == 1) {
        needed = std::max(needed, (spans.along[0][i % 2] + 1) / 2);
      } else {
        // The first half is side 0 of its patch, the second one side 3 of the next.
        needed = std::max({needed, spans.along[i][0], spans.along[(i + 1) % n][1]});
      }
    }
    samples_.faces.push_back(std::move(spans));
  }

  std::size_t patch_spans(const GregoryPatch& patch, bool along_u) const {
    std::size_t most = 1;
    for (const double level : {0.0, 0.25, 0.5, 0.75, 1.0}) {
      const auto at = [&](double t) { return along_u ? patch.at(t, level).at : patch.at(level, t).at; };
      most = std::max(most, spans_for(at, tolerance_, most_));
    }
    return most;
  }

  EdgeSamples sample_edge(Index e) {
    const BrepEdge& edge = brep_.edges[e];
    if (half_spans_[e] == 0 && edge.straight) return {{edge.start, edge.end}, 0, {}};
    // Without patches there are no halves, but the exact pieces.
    if (half_spans_[e] == 0) return sample_run(edge, edge.pieces, 0);
    std::vector<RationalCubic> halves = edge.fitted;
    if (halves.size() == 1) {
      const auto [first, second] = halves[0].split(0.5);
      halves = {first, second};
    }
    EdgeSamples samples = sample_run(edge, halves, half_spans_[e]);
    if (edge.smooth) set_edge_normals(edge, halves, samples);
    return samples;
  }

  /// @param least spans of each cubic, at least; the same number for all of them
  EdgeSamples sample_run(const BrepEdge& edge, const std::vector<RationalCubic>& cubics, std::size_t least) {
    std::size_t spans = std::max<std::size_t>(least, cubics.size() == 1 && !edge.straight ? 2 : 1);
    for (const RationalCubic& cubic : cubics) {
      spans = std::max(spans, spans_for([&](double t) { return cubic.at(t); }, tolerance_, most_));
    }
    EdgeSamples samples{{edge.start}, spans, {}};
    for (std::size_t c = 0; c < cubics.size(); ++c) {
      for (std::size_t i = 1; i <= spans; ++i) {
        if (c + 1 == cubics.size() && i == spans) continue;
        samples.vertices.push_back(static_cast<Index>(mesh_.positions.size()));
        mesh_.positions.push_back(sample_of(cubics[c], static_cast<double>(i) / static_cast<double>(spans)));
      }
    }
    samples.vertices.push_back(edge.end);
    return samples;
  }

  const BrepFace* planar_face_of(const BrepEdge& edge) const {
    for (const Index h : edge.half_edges) {
      const BrepFace& face = brep_.faces[brep_.face_of(h)];
      if (face.planar) return &face;
    }
    return nullptr;
  }

  void set_edge_normals(const BrepEdge& edge, const std::vector<RationalCubic>& halves, EdgeSamples& samples) const {
    const BrepFace* planar = planar_face_of(edge);
    const std::size_t last = samples.vertices.size() - 1;
    for (std::size_t i = 0; i <= last; ++i) {
      const double t = static_cast<double>(i) / static_cast<double>(last);
      const std::size_t half = i < samples.middle ? 0 : 1;
      const Vec3 along = halves[half].derivative(2 * t - static_cast<double>(half));
      const Vec3 across = (1 - t) * edge.across[0] + t * edge.across[1];
      samples.normals.push_back(planar != nullptr ? planar->normal : Vec3(along.cross(across).normalized()));
    }
  }

  /// Corners that smooth edges connect share one normal.
  void set_corner_normals() {
    DisjointSets corners(brep_.half_edges.size());
    for (const BrepEdge& edge : brep_.edges) {
      if (!edge.smooth) continue;
      corners.unite(edge.half_edges[0], brep_.half_edges[edge.half_edges[1]].next);
      corners.unite(brep_.half_edges[edge.half_edges[0]].next, edge.half_edges[1]);
    }
    std::vector<Vec3> normal(brep_.half_edges.size(), Vec3::Zero());
    for (Index e = 0; e < brep_.edges.size(); ++e) {
      if (!brep_.edges[e].smooth) continue;
      for (const bool at_end : {false, true}) {
        Vec3& shared = normal[corners.root(brep_.edges[e].half_edges[at_end ? 1 : 0])];
        const std::vector<Vec3>& along = samples_.edges[e].normals;
        if (shared.isZero(0)) shared = at_end ? along.back() : along.front();
      }
    }
    for (Index h = 0; h < brep_.half_edges.size(); ++h) samples_.corner_normal.push_back(normal[corners.root(h)]);
  }

  const Brep& brep_;
  PolyMesh& mesh_;
  double tolerance_;
  std::size_t most_;
  std::vector<std::size_t> half_spans_;  // per edge, as its patches need; 0 without patches
  BrepSamples samples_;
};

}  // namespace

BrepSamples sample_edges(const Brep& brep, const TessellationOptions& options, PolyMesh& mesh) {
  return EdgeSampler(brep, options, mesh).run();
}

}  // namespace croquis
