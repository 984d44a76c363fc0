// SPDX-License-Identifier: GPL-3.0-or-later
#include "step/step_shape.h"

#include <BRepClass3d_SolidClassifier.hxx>
#include <BRep_Builder.hxx>
#include <Precision.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Compound.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>
#include <TopoDS_Iterator.hxx>
#include <TopoDS_Shell.hxx>
#include <TopoDS_Solid.hxx>
#include <TopoDS_Wire.hxx>
#include <algorithm>
#include <array>
#include <limits>
#include <optional>

namespace croquis {
namespace {

/// An edge of the file, from its first parameter to its last one.
struct StepEdge {
  TopoDS_Edge edge;
  double last = 1;
};

/// A StepEdge on the way around a face.
struct EdgeUse {
  const StepEdge* part = nullptr;
  bool reversed = false;
};

/// Corners of a patch in its parameters.
const std::array<Vec2, 4> patch_corners = {Vec2(0, 0), Vec2(1, 0), Vec2(1, 1), Vec2(0, 1)};

TopoDS_Edge oriented(const EdgeUse& use) {
  return TopoDS::Edge(use.part->edge.Oriented(use.reversed ? TopAbs_REVERSED : TopAbs_FORWARD));
}

TopoDS_Vertex end_of(const EdgeUse& use) {
  for (TopoDS_Iterator it(use.part->edge); it.More(); it.Next()) {
    if (it.Value().Orientation() == (use.reversed ? TopAbs_FORWARD : TopAbs_REVERSED))
      return TopoDS::Vertex(it.Value());
  }
  return {};
}

Vec3 point_of(const Brep& brep, const BrepShell& shell) {
  return brep.vertices[brep.start_of(brep.loops[brep.faces[shell.faces[0]].loops[0]].first)].point;
}

/// Diagonal of the box around a shell's vertices.
double extent_of(const Brep& brep, const BrepShell& shell) {
  Vec3 low = Vec3::Constant(std::numeric_limits<double>::infinity()), high = -low;
  for (const Index f : shell.faces) {
    for (const Index half : brep.around(brep.faces[f].loops[0])) {
      low = low.cwiseMin(brep.vertices[brep.start_of(half)].point);
      high = high.cwiseMax(brep.vertices[brep.start_of(half)].point);
    }
  }
  return (high - low).norm();
}

class StepShapeBuilder {
 public:
  StepShapeBuilder(const Brep& brep, const std::vector<std::vector<BicubicFit>>& fits,
                   const std::vector<std::string>& face_names)
      : brep_(brep), fits_(fits), face_names_(face_names) {}

  StepShape run() {
    set_tolerances();
    for (Index v = 0; v < brep_.vertices.size(); ++v) {
      vertices_.push_back(make_vertex(brep_.vertices[v].point, vertex_tolerance_[v]));
    }
    for (Index e = 0; e < brep_.edges.size(); ++e) add_edge(e);
    for (const BrepShell& shell : brep_.shells) add_shell(shell);
    collect();
    return std::move(result_);
  }

 private:
  /// Planar faces may miss their edges a little: they stay joined, within tolerances that say so.
  void set_tolerances() {
    edge_tolerance_.assign(brep_.edges.size(), Precision::Confusion());
    vertex_tolerance_.assign(brep_.vertices.size(), Precision::Confusion());
    for (const BrepHalfEdge& half : brep_.half_edges) {
      const BrepFace& face = brep_.faces[brep_.loops[half.loop].face];
      if (!face.planar) continue;
      constexpr double with_rounding = 1.01;
      double& tolerance = edge_tolerance_[half.edge];
      tolerance = std::max(tolerance, with_rounding * face.flatness + Precision::Confusion());
    }
    for (Index e = 0; e < brep_.edges.size(); ++e) {
      for (const Index v : {brep_.edges[e].start, brep_.edges[e].end}) {
        vertex_tolerance_[v] = std::max(vertex_tolerance_[v], edge_tolerance_[e]);
      }
    }
  }

  TopoDS_Vertex make_vertex(const Vec3& point, double tolerance) {
    TopoDS_Vertex vertex;
    builder_.MakeVertex(vertex, to_point(point), tolerance);
    return vertex;
  }

  StepEdge make_edge(const std::vector<RationalCubic>& cubics, const TopoDS_Vertex& start, const TopoDS_Vertex& end,
                     double tolerance, const std::string& name) {
    const StepCurve curve = step_curve(cubics);
    StepEdge made{{}, curve.last};
    builder_.MakeEdge(made.edge, curve.curve, tolerance);
    builder_.Add(made.edge, start.Oriented(TopAbs_FORWARD));
    builder_.Add(made.edge, end.Oriented(TopAbs_REVERSED));
    builder_.Range(made.edge, 0, curve.last);
    if (!name.empty()) result_.names.emplace_back(made.edge, name);
    ++result_.edges;
    return made;
  }

  /// How many patches the face has that has the most of those at an edge.
  std::size_t most_patches_at(const BrepEdge& edge) const {
    std::size_t most = 0;
    for (const Index half : edge.half_edges) {
      if (half != no_index) most = std::max(most, brep_.faces[brep_.face_of(half)].patches.size());
    }
    return most;
  }

  void add_edge(Index e) {
    const BrepEdge& edge = brep_.edges[e];
    const TopoDS_Vertex &start = vertices_[edge.start], &end = vertices_[edge.end];
    const double tolerance = edge_tolerance_[e];
    const std::size_t patches = most_patches_at(edge);
    std::vector<StepEdge>& parts = parts_.emplace_back();
    if (patches <= 1) {
      parts.push_back(make_edge(patches == 0 ? edge.pieces : edge.fitted, start, end, tolerance, edge.id));
      return;
    }
    std::vector<RationalCubic> halves = edge.fitted;
    if (halves.size() == 1) {
      const auto [first, second] = halves[0].split(0.5);
      halves = {first, second};
    }
    const TopoDS_Vertex middle = make_vertex(halves[0].points[3], tolerance);
    parts.push_back(make_edge({halves[0]}, start, middle, tolerance, edge.id));
    parts.push_back(make_edge({halves[1]}, middle, end, tolerance, edge.id));
  }

  /// The parts along a half-edge, in its direction.
  std::vector<EdgeUse> along(Index half) const {
    const BrepHalfEdge& h = brep_.half_edges[half];
    std::vector<EdgeUse> uses;
    for (const StepEdge& part : parts_[h.edge]) uses.push_back({&part, h.reversed});
    if (h.reversed) std::ranges::reverse(uses);
    return uses;
  }

  TopoDS_Wire make_wire(const std::vector<EdgeUse>& uses) {
    TopoDS_Wire wire;
    builder_.MakeWire(wire);
    for (const EdgeUse& use : uses) builder_.Add(wire, oriented(use));
    wire.Closed(true);
    return wire;
  }

  TopoDS_Face make_face(const Handle(Geom_Surface) & surface, Index face) {
    TopoDS_Face made;
    builder_.MakeFace(made, surface, Precision::Confusion());
    if (face < face_names_.size()) result_.names.emplace_back(made, face_names_[face]);
    ++result_.faces;
    return made;
  }

  TopoDS_Face planar_face(Index f) {
    const BrepFace& face = brep_.faces[f];
    TopoDS_Face made = make_face(step_plane(face.origin, face.normal), f);
    for (const Index loop : face.loops) {
      std::vector<EdgeUse> uses;
      for (const Index half : brep_.around(loop)) std::ranges::copy(along(half), std::back_inserter(uses));
      builder_.Add(made, make_wire(uses));
    }
    return made;
  }

  /// @param sides the parts along each side of the patch, in its direction
  TopoDS_Face patch_face(Index f, std::size_t patch, const std::array<std::vector<EdgeUse>, 4>& sides) {
    TopoDS_Face made = make_face(step_surface(fits_[f][patch].spline), f);
    std::vector<EdgeUse> around;
    for (std::size_t side = 0; side < 4; ++side) {
      const Vec2 from = patch_corners[side], step = patch_corners[(side + 1) % 4] - from;
      const double count = static_cast<double>(sides[side].size());
      for (std::size_t k = 0; k < sides[side].size(); ++k) {
        const EdgeUse& use = sides[side][k];
        Vec2 begin = from + static_cast<double>(k) / count * step,
             end = from + static_cast<double>(k + 1) / count * step;
        if (use.reversed) std::swap(begin, end);
        const double last = use.part->last;
        builder_.UpdateEdge(use.part->edge, line_on_surface(begin, end, last), made, Precision::Confusion());
        builder_.Range(use.part->edge, made, 0, last);
        around.push_back(use);
      }
    }
    builder_.Add(made, make_wire(around));
    return made;
  }

  std::vector<TopoDS_Face> star_faces(Index f) {
    const BrepFace& face = brep_.faces[f];
    const std::vector<Index> halves = brep_.around(face.loops[0]);
    const std::size_t n = face.patches.size();
    const TopoDS_Vertex centre = make_vertex(face.patches[0].boundary[6], Precision::Confusion());
    std::vector<StepEdge> spokes;  // from the middles of the sides to the centre
    for (std::size_t i = 0; i < n; ++i) {
      const EdgeUse first = along(halves[i])[0];
      const TopoDS_Vertex middle = end_of(first);
      spokes.push_back(make_edge({face.patches[i].side(1)}, middle, centre, Precision::Confusion(), ""));
    }
    std::vector<TopoDS_Face> made;
    for (std::size_t i = 0; i < n; ++i) {
      const std::size_t before = (i + n - 1) % n;
      made.push_back(patch_face(
          f, i,
          {{{along(halves[i])[0]}, {{&spokes[i], false}}, {{&spokes[before], true}}, {along(halves[before])[1]}}}));
    }
    return made;
  }

  std::vector<TopoDS_Face> faces_of(Index f) {
    const BrepFace& face = brep_.faces[f];
    if (face.patches.empty()) return {planar_face(f)};
    if (face.patches.size() > 1) return star_faces(f);
    const std::vector<Index> halves = brep_.around(face.loops[0]);
    return {patch_face(f, 0, {along(halves[0]), along(halves[1]), along(halves[2]), along(halves[3])})};
  }

  void add_shell(const BrepShell& shell) {
    TopoDS_Shell& made = shells_.emplace_back();
    builder_.MakeShell(made);
    for (const Index f : shell.faces) {
      for (const TopoDS_Face& face : faces_of(f)) builder_.Add(made, face);
    }
    made.Closed(shell.closed);
  }

  /// The solids, each of an outer shell; then the cavities go to the smallest solid around them.
  void collect() {
    std::vector<TopoDS_Shape> roots;
    std::vector<std::pair<double, std::size_t>> solids;  // extents and positions among the roots
    for (std::size_t s = 0; s < shells_.size(); ++s) {
      const BrepShell& shell = brep_.shells[s];
      if (shell.closed && shell.is_void) continue;
      if (!shell.closed) {
        roots.push_back(shells_[s]);
        continue;
      }
      TopoDS_Solid solid;
      builder_.MakeSolid(solid);
      builder_.Add(solid, shells_[s]);
      solids.emplace_back(extent_of(brep_, shell), roots.size());
      roots.push_back(solid);
    }
    std::ranges::sort(solids);
    std::vector<std::pair<std::size_t, std::size_t>> cavities;  // root and shell
    for (std::size_t s = 0; s < shells_.size(); ++s) {
      if (!brep_.shells[s].closed || !brep_.shells[s].is_void) continue;
      for (const auto& [extent, root] : solids) {
        const BRepClass3d_SolidClassifier place(roots[root], to_point(point_of(brep_, brep_.shells[s])),
                                                Precision::Confusion());
        if (place.State() != TopAbs_IN) continue;
        cavities.emplace_back(root, s);
        break;
      }
    }
    for (const auto& [root, s] : cavities) builder_.Add(roots[root], shells_[s]);
    result_.shape = roots.size() == 1 ? roots[0] : compound(roots);
  }

  TopoDS_Shape compound(const std::vector<TopoDS_Shape>& roots) {
    TopoDS_Compound all;
    builder_.MakeCompound(all);
    for (const TopoDS_Shape& root : roots) builder_.Add(all, root);
    return all;
  }

  const Brep& brep_;
  const std::vector<std::vector<BicubicFit>>& fits_;
  const std::vector<std::string>& face_names_;
  BRep_Builder builder_;
  StepShape result_;
  std::vector<double> edge_tolerance_, vertex_tolerance_;
  std::vector<TopoDS_Vertex> vertices_;
  std::vector<std::vector<StepEdge>> parts_;  // one or two per edge of the B-rep
  std::vector<TopoDS_Shell> shells_;
};

}  // namespace

StepShape step_shape(const Brep& brep, const std::vector<std::vector<BicubicFit>>& fits,
                     const std::vector<std::string>& face_names) {
  return StepShapeBuilder(brep, fits, face_names).run();
}

}  // namespace croquis
