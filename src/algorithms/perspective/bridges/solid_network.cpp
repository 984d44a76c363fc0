// SPDX-License-Identifier: GPL-3.0-or-later
#include "croquis/perspective/solid_network.h"

#include <algorithm>
#include <set>
#include <utility>

namespace croquis {
namespace {

class NetworkMaker {
 public:
  explicit NetworkMaker(const Brep& brep) : brep_(brep) {}

  SolidNetwork run() {
    for (Index v = 0; v < brep_.vertices.size(); ++v) add_node("v" + std::to_string(v), brep_.vertices[v].point);
    for (const BrepEdge& edge : brep_.edges) add_edge(edge);
    for (Index f = 0; f < brep_.faces.size(); ++f) add_face(f);
    return std::move(result_);
  }

 private:
  /// The name, or where it is taken, as by an edge in which two parts of a solid touch, one like it.
  static std::string free_name(std::set<std::string>& taken, const std::string& name) {
    std::string free = name.empty() ? "e" : name;
    for (int number = 2; !taken.insert(free).second; ++number) free = name + "~" + std::to_string(number);
    return free;
  }

  Index add_node(const std::string& name, const Vec3& point) {
    result_.network.nodes.push_back({free_name(nodes_, name), point});
    return static_cast<Index>(result_.network.nodes.size() - 1);
  }

  void add_edge(const BrepEdge& edge) {
    std::vector<Index>& curves = curves_of_.emplace_back();
    const CurveJoin join = edge.smooth ? CurveJoin::Smooth : CurveJoin::Crease;
    const std::size_t count = edge.fitted.size();
    Index from = edge.start;
    for (std::size_t k = 0; k < count; ++k) {
      const auto& points = edge.fitted[k].points;
      const std::string name = count == 1 ? edge.id : edge.id + "/" + std::to_string(k + 1);
      const Index to = k + 1 == count ? edge.end : add_node(edge.id + "/joint", points[3]);
      AttributeCurve curve{free_name(curves_, name), from, to, {}, join};
      if (!edge.straight) {
        curve.control.assign(points.begin(), points.end());
        curve.control.front() = result_.network.nodes[from].point;
        curve.control.back() = result_.network.nodes[to].point;
      }
      curves.push_back(static_cast<Index>(result_.network.curves.size()));
      result_.network.curves.push_back(std::move(curve));
      from = to;
    }
  }

  std::vector<AttributeSide> sides_of(Index loop) const {
    std::vector<AttributeSide> sides;
    for (const Index h : brep_.around(loop)) {
      const BrepHalfEdge& half = brep_.half_edges[h];
      std::vector<Index> curves = curves_of_[half.edge];
      if (half.reversed) std::ranges::reverse(curves);
      for (const Index curve : curves) sides.push_back({curve, half.reversed});
    }
    return sides;
  }

  void leave_out(Index f, const std::string& reason) {
    const std::string name = "f" + std::to_string(f);
    result_.warnings.push_back(
        make_warning(Category::Geometry, "FACE_LEFT_OUT",
                     "Face " + name + " is left out of the attribute network: " + reason + "; its curves are there.",
                     {{SubjectKind::Face, name, {}, {}, {}}}));
  }

  void add_face(Index f) {
    const BrepFace& face = brep_.faces[f];
    if (face.loops.size() > 1) return leave_out(f, "it has a hole, and faces of networks have none");
    std::vector<AttributeSide> sides = sides_of(face.loops[0]);
    if (sides.size() < least_network_sides || sides.size() > most_network_sides)
      return leave_out(f, "it has " + std::to_string(sides.size()) + " sides, and faces of networks have 2 to 12");
    std::set<Index> seen;
    for (const AttributeSide& side : sides) {
      if (!seen.insert(side.curve).second) return leave_out(f, "it lies on both sides of one edge");
    }
    AttributeFace made;
    made.id = "f" + std::to_string(f);
    made.loop = std::move(sides);
    result_.network.faces.push_back(std::move(made));
  }

  const Brep& brep_;
  SolidNetwork result_;
  std::set<std::string> nodes_, curves_;
  std::vector<std::vector<Index>> curves_of_;  ///< per edge, from its start
};

}  // namespace

SolidNetwork network_of_solid(const Brep& brep) { return NetworkMaker(brep).run(); }

}  // namespace croquis
