// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include <Eigen/Geometry>

#include "algorithms/perspective/solid/plane_axes.h"
#include "algorithms/perspective/solid/plane_outlines.h"
#include "croquis/geometry/brep.h"
#include "croquis/geometry/disjoint_sets.h"
#include "croquis/geometry/planar_triangulation.h"
#include "croquis/perspective/solid.h"

namespace croquis {
namespace {

/// An edge as the vertices of a mesh, from its start to its end.
struct EdgeSamples {
  std::vector<Index> vertices;
  std::size_t middle = 0;     ///< position of the sample where the two halves of a side of patches meet
  std::vector<Vec3> normals;  ///< of smooth edges, common to both faces; else empty
};

/// Into how many spans the sides of each patch of a face are cut: of single patches sides 0 and 2, then 1 and 3; of
/// stars each patch's side 0, then its side 1.
struct FaceSpans {
  std::vector<std::array<std::size_t, 2>> along;
};

struct BrepSamples {
  std::vector<EdgeSamples> edges;
  std::vector<FaceSpans> faces;
  std::vector<Vec3> corner_normal;  ///< per half-edge, of its face at its start; zero where no smooth edge rules it
};

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
    if (const double* level = common_level({&cubic, 1}, axis)) p[axis] = *level;
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

/// Samples every edge once, as its own bends and those of its patches need, and appends the points to the mesh.
BrepSamples sample_edges(const Brep& brep, const TessellationOptions& options, PolyMesh& mesh) {
  return EdgeSampler(brep, options, mesh).run();
}

/// A corner of triangles: a vertex and the normal that a face has there.
struct SurfaceCorner {
  Index vertex = no_index;
  Vec3 normal = Vec3::Zero();
};

/// A side of a patch as corners, from its start to its end, evenly spaced in the parameter.
using SideCorners = std::vector<SurfaceCorner>;

/// Where a corner of the patch has no normal, the one nearby.
Vec3 normal_at(const GregoryPatch& patch, double u, double v) {
  constexpr double inside = 1e-3;
  const Vec3 normal = patch.at(u, v).normal();
  if (!normal.isZero(0)) return normal;
  return patch.at(std::clamp(u, inside, 1 - inside), std::clamp(v, inside, 1 - inside)).normal();
}

Vec3 middle_normal(const BrepFace& star) {
  Vec3 sum = Vec3::Zero();
  for (const GregoryPatch& patch : star.patches) sum += normal_at(patch, 1, 1);
  return sum.normalized();
}

Finding outlines_cross(const Brep& brep, const BrepFace& face) {
  std::vector<Subject> subjects{numbered_subject(SubjectKind::Face, face.outline)};
  for (const Index loop : face.loops) {
    for (const Index half : brep.around(loop)) {
      subjects.push_back({SubjectKind::Stroke, brep.edges[brep.half_edges[half].edge].id, {}, {}, {}});
    }
  }
  return make_warning(
      Category::Geometry, "PATCH_FOLDED",
      "The outlines of the plane face " + std::to_string(face.outline) + " cross each other: move its strokes apart.",
      std::move(subjects));
}

class Tessellator {
 public:
  Tessellator(const Brep& brep, Progress& progress, const TessellationOptions& options)
      : brep_(brep), progress_(progress), samples_(sample_edges(brep, options, result_.mesh)) {}

  Tessellation run() {
    for (Index f = 0; f < brep_.faces.size(); ++f) {
      progress_.report(f, brep_.faces.size());
      face_ = f;
      if (brep_.faces[f].planar) {
        add_planar();
      } else if (brep_.faces[f].patches.size() == 1) {
        add_single_patch();
      } else {
        add_star();
      }
    }
    finish();
    progress_.report(1);
    return std::move(result_);
  }

 private:
  const BrepFace& face() const { return brep_.faces[face_]; }

  void add(const SurfaceCorner& a, const SurfaceCorner& b, const SurfaceCorner& c) {
    result_.mesh.add_triangle(a.vertex, b.vertex, c.vertex);
    for (const SurfaceCorner* corner : {&a, &b, &c}) {
      for (int i = 0; i < 3; ++i) normals_.push_back(corner->normal[i]);
    }
    face_numbers_.push_back(static_cast<std::int32_t>(face().outline));
  }

  Index new_vertex(const Vec3& p) {
    result_.mesh.positions.push_back(p);
    return static_cast<Index>(result_.mesh.positions.size() - 1);
  }

  /// The vertices along a half-edge.
  std::vector<Index> vertices_along(Index half) const {
    return croquis::vertices_along(brep_, half, samples_.edges[brep_.half_edges[half].edge].vertices);
  }

  // Planar faces.

  void add_planar() {
    const PlaneOutlines outlines =
        plane_outlines(brep_, face(), result_.mesh.positions, [&](Index half) { return vertices_along(half); });
    const PlanarTriangulationResult plane = triangulate(outlines.places, outlines.sides);
    if (!plane.conflict.empty()) {
      add_fan(outlines);
      return;
    }
    const Vec3& normal = face().normal;
    for (const auto& [a, b, c] : triangles_inside(plane.triangulation)) {
      add({outlines.vertices[a], normal}, {outlines.vertices[b], normal}, {outlines.vertices[c], normal});
    }
  }

  /// For outlines that cross: closed all the same.
  void add_fan(const PlaneOutlines& outlines) {
    const std::vector<Index>& vertices = outlines.vertices;
    Vec3 middle = Vec3::Zero();
    for (const Index vertex : vertices) middle += result_.mesh.positions[vertex] / static_cast<double>(vertices.size());
    const Vec3& normal = face().normal;
    const SurfaceCorner apex{new_vertex(middle), normal};
    for (const auto& [a, b] : outlines.sides) add({vertices[a], normal}, {vertices[b], normal}, apex);
    result_.warnings.push_back(outlines_cross(brep_, face()));
  }

  // Patches.

  /// @param first,last positions among the half-edge's samples
  SideCorners corners_along(Index half, std::size_t first, std::size_t last, const GregoryPatch& patch,
                            std::size_t side) const {
    const EdgeSamples& edge = samples_.edges[brep_.half_edges[half].edge];
    const bool reversed = brep_.half_edges[half].reversed;
    const std::vector<Index> vertices = vertices_along(half);
    SideCorners corners;
    for (std::size_t i = first; i <= last; ++i) {
      const auto [u, v] = place_on_side(side, static_cast<double>(i - first) / static_cast<double>(last - first));
      Vec3 normal = Vec3::Zero();
      if (i == 0) normal = samples_.corner_normal[half];
      if (i + 1 == vertices.size()) normal = samples_.corner_normal[brep_.half_edges[half].next];
      if (normal.isZero(0) && !edge.normals.empty()) normal = edge.normals[reversed ? vertices.size() - 1 - i : i];
      if (normal.isZero(0)) normal = normal_at(patch, u, v);
      corners.push_back({vertices[i], normal});
    }
    return corners;
  }

  std::size_t last_of(Index half) const { return vertices_along(half).size() - 1; }
  std::size_t middle_of(Index half) const {
    const EdgeSamples& edge = samples_.edges[brep_.half_edges[half].edge];
    return brep_.half_edges[half].reversed ? edge.vertices.size() - 1 - edge.middle : edge.middle;
  }

  void add_single_patch() {
    const GregoryPatch& patch = face().patches[0];
    const std::vector<Index> halves = brep_.around(face().loops[0]);
    std::array<SideCorners, 4> sides;
    for (std::size_t i = 0; i < 4; ++i) sides[i] = corners_along(halves[i], 0, last_of(halves[i]), patch, i);
    add_patch(patch, sides, samples_.faces[face_].along[0]);
  }

  void add_star() {
    const std::vector<GregoryPatch>& patches = face().patches;
    const std::vector<Index> halves = brep_.around(face().loops[0]);
    const std::vector<std::array<std::size_t, 2>>& spans = samples_.faces[face_].along;
    const std::size_t n = patches.size();
    const SurfaceCorner middle{new_vertex(patches[0].boundary[6]), middle_normal(face())};
    std::vector<SideCorners> spokes;
    for (std::size_t i = 0; i < n; ++i) {
      const std::size_t count = std::max<std::size_t>(2, std::max(spans[i][1], spans[(i + 1) % n][0]));
      spokes.push_back(spoke_corners(halves[i], patches[i], count, middle));
    }
    for (std::size_t i = 0; i < n; ++i) {
      const std::size_t before = (i + n - 1) % n;
      SideCorners back(spokes[before].rbegin(), spokes[before].rend());
      add_patch(patches[i],
                {corners_along(halves[i], 0, middle_of(halves[i]), patches[i], 0), spokes[i], std::move(back),
                 corners_along(halves[before], middle_of(halves[before]), last_of(halves[before]), patches[i], 3)},
                spans[i]);
    }
  }

  /// From the middle of a side to the middle of the face.
  SideCorners spoke_corners(Index half, const GregoryPatch& patch, std::size_t count, const SurfaceCorner& middle) {
    SideCorners corners = corners_along(half, 0, middle_of(half), patch, 0);
    corners.erase(corners.begin(), corners.end() - 1);
    for (std::size_t i = 1; i < count; ++i) {
      const double t = static_cast<double>(i) / static_cast<double>(count);
      corners.push_back({new_vertex(patch.at(1, t).at), normal_at(patch, 1, t)});
    }
    corners.push_back(middle);
    return corners;
  }

  /// A grid inside, and between it and each side a strip.
  void add_patch(const GregoryPatch& patch, const std::array<SideCorners, 4>& sides,
                 const std::array<std::size_t, 2>& spans) {
    const std::size_t nu = std::max({std::size_t{2}, spans[0], sides[0].size() - 1, sides[2].size() - 1});
    const std::size_t nv = std::max({std::size_t{2}, spans[1], sides[1].size() - 1, sides[3].size() - 1});
    std::vector<std::vector<SurfaceCorner>> grid(nv - 1);
    for (std::size_t j = 1; j < nv; ++j) {
      for (std::size_t i = 1; i < nu; ++i) {
        const PatchPoint p = patch.at(static_cast<double>(i) / static_cast<double>(nu),
                                      static_cast<double>(j) / static_cast<double>(nv));
        grid[j - 1].push_back({new_vertex(p.at), p.normal()});
      }
    }
    for (std::size_t j = 0; j + 1 < grid.size(); ++j) {
      for (std::size_t i = 0; i + 1 < grid[j].size(); ++i) {
        add_quad(grid[j][i], grid[j][i + 1], grid[j + 1][i + 1], grid[j + 1][i]);
      }
    }
    SideCorners right, left;
    for (const auto& row : grid) {
      right.push_back(row.back());
      left.insert(left.begin(), row.front());
    }
    const SideCorners top(grid.back().rbegin(), grid.back().rend());
    add_strip(sides[0], grid.front());
    add_strip(sides[1], right);
    add_strip(sides[2], top);
    add_strip(sides[3], left);
  }

  double squared_distance(const SurfaceCorner& a, const SurfaceCorner& b) const {
    return (result_.mesh.positions[a.vertex] - result_.mesh.positions[b.vertex]).squaredNorm();
  }

  void add_quad(const SurfaceCorner& a, const SurfaceCorner& b, const SurfaceCorner& c, const SurfaceCorner& d) {
    if (squared_distance(a, c) <= squared_distance(b, d)) {
      add(a, b, c);
      add(a, c, d);
    } else {
      add(a, b, d);
      add(b, c, d);
    }
  }

  /// Triangles between a side and the row of the grid inside next to it, both from left to right.
  void add_strip(const SideCorners& side, const SideCorners& row) {
    const double side_step = 1 / static_cast<double>(side.size() - 1);
    const double row_step = 1 / static_cast<double>(row.size() + 1);
    std::size_t i = 0, j = 0;
    while (i + 1 < side.size() || j + 1 < row.size()) {
      // The middle of the next span decides; the row has its first place one step in.
      const double side_next = (static_cast<double>(i) + 0.5) * side_step;
      const double row_next = (static_cast<double>(j) + 1.5) * row_step;
      if (j + 1 >= row.size() || (i + 1 < side.size() && side_next <= row_next)) {
        add(side[i], side[i + 1], row[j]);
        ++i;
      } else {
        add(side[i], row[j + 1], row[j]);
        ++j;
      }
    }
  }

  void finish() {
    PolyMesh& mesh = result_.mesh;
    mesh.channels.push_back({"normal", Domain::Corner, 3, std::move(normals_), {}});
    result_.volume.assign(brep_.shells.size(), 0);
    for (std::size_t t = 0; t < mesh.face_count(); ++t) {
      const std::span<const Index> corners = mesh.face(t);
      const Vec3 &a = mesh.positions[corners[0]], &b = mesh.positions[corners[1]], &c = mesh.positions[corners[2]];
      result_.volume[brep_.faces[static_cast<std::size_t>(face_numbers_[t])].shell] += a.dot(b.cross(c)) / 6;
    }
    std::vector<std::string> names;
    for (const BrepFace& face : brep_.faces) {
      if (face.outline == names.size()) names.push_back("f" + std::to_string(face.outline));
    }
    mesh.channels.push_back({"group", Domain::Face, 1, std::move(face_numbers_), std::move(names)});
  }

  const Brep& brep_;
  Progress& progress_;
  Tessellation result_;
  BrepSamples samples_;
  Index face_ = 0;
  std::vector<double> normals_;
  std::vector<std::int32_t> face_numbers_;
};

}  // namespace

Tessellation tessellate(const Brep& brep, Progress& progress, const TessellationOptions& options) {
  return Tessellator(brep, progress, options).run();
}

}  // namespace croquis
