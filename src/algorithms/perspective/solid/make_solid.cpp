// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <iterator>
#include <map>
#include <utility>

#include <Eigen/Geometry>

#include "croquis/geometry/disjoint_sets.h"
#include "croquis/perspective/solid.h"

namespace croquis {
namespace {

/// The cubic with the ends, and the directions and speeds at them, of a run of cubics.
RationalCubic hermite_of(const std::vector<RationalCubic>& run, std::size_t from, std::size_t to) {
  const auto count = static_cast<double>(to - from);
  RationalCubic result;
  result.points[0] = run[from].points[0];
  result.points[1] = run[from].points[0] + count * (run[from].points[1] - run[from].points[0]);
  result.points[2] = run[to - 1].points[3] + count * (run[to - 1].points[2] - run[to - 1].points[3]);
  result.points[3] = run[to - 1].points[3];
  return result;
}

std::vector<RationalCubic> at_most_two(std::vector<RationalCubic> cubics) {
  if (cubics.size() <= 2) return cubics;
  const std::size_t middle = cubics.size() / 2;
  return {hermite_of(cubics, 0, middle), hermite_of(cubics, middle, cubics.size())};
}

void turn_pieces(std::vector<RationalCubic>& pieces) {
  std::ranges::reverse(pieces);
  for (RationalCubic& piece : pieces) piece = piece.reversed();
}

class BrepMaker {
 public:
  BrepMaker(const CurveNetwork& network, const std::vector<FittedCurve>& fitted, const FaceSet& faces)
      : network_(network), fitted_(fitted), faces_(faces) {}

  Brep run() {
    for (const NetworkShell& shell : faces_.shells) brep_.shells.push_back({shell.faces, shell.closed, shell.is_void});
    for (Index f = 0; f < faces_.faces.size(); ++f) add_face(f);
    make_vertices();
    return std::move(brep_);
  }

 private:
  void add_face(Index f) {
    const NetworkFace& source = faces_.faces[f];
    BrepFace face;
    face.shell = source.shell;
    face.outline = f;
    face.planar = source.planar;
    face.origin = source.origin;
    face.normal = source.normal;
    face.flatness = source.flatness;
    for (const CurveLoop& uses : source.loops) {
      const auto loop = static_cast<Index>(brep_.loops.size());
      const auto first = static_cast<Index>(brep_.half_edges.size());
      face.loops.push_back(loop);
      brep_.loops.push_back({f, first});
      for (Index i = 0; i < uses.size(); ++i) {
        const Index next = first + (i + 1) % static_cast<Index>(uses.size());
        brep_.half_edges.push_back({no_index, false, loop, next});
        enter_half_edge(first + i, uses[i]);
      }
    }
    brep_.faces.push_back(std::move(face));
  }

  /// An edge gets the direction of its first half-edge.
  void enter_half_edge(Index half, const CurveUse& use) {
    const auto [known, is_new] = edge_of_.try_emplace(use.curve, static_cast<Index>(brep_.edges.size()));
    if (is_new) add_edge(use);
    BrepEdge& edge = brep_.edges[known->second];
    const bool reversed = use.reversed != turned_[known->second];
    brep_.half_edges[half].edge = known->second;
    brep_.half_edges[half].reversed = reversed;
    edge.half_edges[reversed ? 1 : 0] = half;
  }

  void add_edge(const CurveUse& use) {
    const NetworkCurve& curve = network_.curves[use.curve];
    BrepEdge edge;
    edge.id = curve.id;
    edge.curve = use.curve;
    edge.start = use.reversed ? curve.end : curve.start;  // of the network, until vertices are made
    edge.end = use.reversed ? curve.start : curve.end;
    edge.pieces = curve.pieces;
    edge.straight = curve.straight;
    edge.fitted = curve.straight
                      ? std::vector{straight_cubic(curve.pieces.front().points[0], curve.pieces.back().points[3])}
                      : at_most_two(fitted_[use.curve].pieces);
    if (use.reversed) {
      turn_pieces(edge.pieces);
      turn_pieces(edge.fitted);
    }
    turned_.push_back(use.reversed);
    brep_.edges.push_back(std::move(edge));
  }

  /// One vertex for each fan of faces: ends of edges belong to one fan if they follow each other in a loop.
  void make_vertices() {
    const auto end_number = [&](Index half, bool at_end) {
      const BrepHalfEdge& h = brep_.half_edges[half];
      return 2 * h.edge + (h.reversed != at_end ? 1U : 0U);
    };
    DisjointSets fans(2 * brep_.edges.size());
    for (Index h = 0; h < brep_.half_edges.size(); ++h) {
      fans.unite(end_number(h, true), end_number(brep_.half_edges[h].next, false));
    }
    std::map<Index, Index> vertex_of;
    for (Index e = 0; e < brep_.edges.size(); ++e) {
      for (const bool at_end : {false, true}) {
        Index& end = at_end ? brep_.edges[e].end : brep_.edges[e].start;
        const auto [known, is_new] =
            vertex_of.try_emplace(fans.root(2 * e + (at_end ? 1U : 0U)), static_cast<Index>(brep_.vertices.size()));
        if (is_new) brep_.vertices.push_back({network_.vertices[end], end});
        end = known->second;
      }
    }
  }

  const CurveNetwork& network_;
  const std::vector<FittedCurve>& fitted_;
  const FaceSet& faces_;
  Brep brep_;
  std::map<Index, Index> edge_of_;  // curve -> edge
  std::vector<bool> turned_;        // edges against their curve
};

void turn_shell(FaceSet& faces, Index shell) {
  for (const Index f : faces.shells[shell].faces) {
    NetworkFace& face = faces.faces[f];
    face.normal = -face.normal;
    for (CurveLoop& loop : face.loops) {
      std::ranges::reverse(loop);
      for (CurveUse& use : loop) use.reversed = !use.reversed;
    }
  }
}

Solid span_solid(const CurveNetwork& network, const std::vector<FittedCurve>& fitted, const FaceSet& faces,
                 Progress& progress, const SolidOptions& options) {
  Solid solid;
  solid.brep = make_brep(network, fitted, faces);
  solid.warnings = find_smooth_edges(solid.brep, options.continuity);
  std::ranges::move(span_patches(solid.brep), std::back_inserter(solid.warnings));
  Progress mesh = progress.step("make triangles", 0.5);
  solid.tessellation = tessellate(solid.brep, mesh, options.tessellation);
  std::ranges::copy(solid.tessellation.warnings, std::back_inserter(solid.warnings));
  return solid;
}

}  // namespace

Brep make_brep(const CurveNetwork& network, const std::vector<FittedCurve>& fitted, const FaceSet& faces) {
  return BrepMaker(network, fitted, faces).run();
}

Solid make_solid(const CurveNetwork& network, const std::vector<FittedCurve>& fitted, const FaceSet& faces,
                 Progress& progress, const SolidOptions& options) {
  Solid solid = span_solid(network, fitted, faces, progress, options);
  FaceSet turned = faces;
  bool wrong = false;
  for (Index s = 0; s < faces.shells.size(); ++s) {
    if (!faces.shells[s].closed || (solid.tessellation.volume[s] < 0) == faces.shells[s].is_void) continue;
    turn_shell(turned, s);  // patches that bulge more than the fans that orientation was found from
    wrong = true;
  }
  if (wrong) solid = span_solid(network, fitted, turned, progress, options);
  progress.report(1);
  return solid;
}

}  // namespace croquis
