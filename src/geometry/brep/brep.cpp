// SPDX-License-Identifier: GPL-3.0-or-later
#include "croquis/geometry/brep.h"

#include <algorithm>
#include <limits>

namespace croquis {
namespace {

class BrepCheck {
 public:
  explicit BrepCheck(const Brep& brep) : brep_(brep) {}

  Findings run() {
    check_indices();
    if (findings_.empty()) check_members();
    if (findings_.empty()) {
      for (Index l = 0; l < brep_.loops.size(); ++l) check_loop(l);
      for (Index e = 0; e < brep_.edges.size(); ++e) check_edge(e);
      check_genus();
    }
    return std::move(findings_);
  }

 private:
  void complain(const std::string& sentence, SubjectKind kind, std::size_t index) {
    findings_.push_back(make_error(Category::Internal, "E_INTERNAL", sentence, {numbered_subject(kind, index)}));
  }

  static bool known(Index i, std::size_t count) { return i < count; }

  void check_indices() {
    for (std::size_t h = 0; h < brep_.half_edges.size(); ++h) {
      const BrepHalfEdge& half = brep_.half_edges[h];
      if (!known(half.edge, brep_.edges.size()) || !known(half.loop, brep_.loops.size()) ||
          !known(half.next, brep_.half_edges.size())) {
        complain("A half-edge refers to something that isn't there.", SubjectKind::Edge, h);
      }
    }
    for (std::size_t e = 0; e < brep_.edges.size(); ++e) {
      const BrepEdge& edge = brep_.edges[e];
      const bool halves =
          std::ranges::all_of(edge.half_edges, [&](Index h) { return h == no_index || h < brep_.half_edges.size(); });
      if (!halves || !known(edge.start, brep_.vertices.size()) || !known(edge.end, brep_.vertices.size())) {
        complain("An edge refers to something that isn't there.", SubjectKind::Edge, e);
      }
    }
    for (std::size_t l = 0; l < brep_.loops.size(); ++l) {
      if (!known(brep_.loops[l].face, brep_.faces.size()) || !known(brep_.loops[l].first, brep_.half_edges.size())) {
        complain("A loop refers to something that isn't there.", SubjectKind::Edge, l);
      }
    }
    for (std::size_t f = 0; f < brep_.faces.size(); ++f) {
      const BrepFace& face = brep_.faces[f];
      const bool loops = std::ranges::all_of(face.loops, [&](Index l) { return known(l, brep_.loops.size()); });
      if (!known(face.shell, brep_.shells.size()) || face.loops.empty() || !loops) {
        complain("A face has no shell or no loop.", SubjectKind::Face, f);
      }
    }
  }

  /// Everything belongs to one thing, which knows it.
  void check_members() {
    std::vector<Index> owners(brep_.loops.size(), no_index);
    for (Index f = 0; f < brep_.faces.size(); ++f) {
      for (const Index loop : brep_.faces[f].loops) {
        if (owners[loop] != no_index || brep_.loops[loop].face != f)
          complain("A face and its loop don't know each other.", SubjectKind::Face, f);
        owners[loop] = f;
      }
    }
    if (std::ranges::find(owners, no_index) != owners.end())
      complain("A loop belongs to no face.", SubjectKind::Face, 0);
    std::vector<char> placed(brep_.faces.size(), 0);
    for (Index s = 0; s < brep_.shells.size(); ++s) {
      for (const Index face : brep_.shells[s].faces) {
        if (face >= brep_.faces.size() || brep_.faces[face].shell != s || placed[face] != 0) {
          complain("A shell and its face don't know each other.", SubjectKind::Face, face);
        } else {
          placed[face] = 1;
        }
      }
    }
    if (std::ranges::find(placed, 0) != placed.end()) complain("A face belongs to no shell.", SubjectKind::Face, 0);
  }

  void check_loop(Index loop) {
    Index half = brep_.loops[loop].first;
    for (std::size_t steps = 0; steps <= brep_.half_edges.size(); ++steps) {
      const Index next = brep_.half_edges[half].next;
      if (brep_.half_edges[half].loop != loop || brep_.end_of(half) != brep_.start_of(next)) break;
      half = next;
      if (half == brep_.loops[loop].first) return check_patches(brep_.loops[loop], steps + 1);
    }
    complain("A loop isn't closed.", SubjectKind::Face, brep_.loops[loop].face);
  }

  /// One patch over four sides, or one for each side around the middle.
  void check_patches(const BrepLoop& loop, std::size_t sides) {
    const BrepFace& face = brep_.faces[loop.face];
    const std::size_t patches = face.patches.size();
    const bool fits =
        face.planar ? patches == 0
                    : patches == 0 || (face.loops.size() == 1 && (patches == sides || (patches == 1 && sides == 4)));
    if (!fits) complain("The patches of a face don't fit its sides.", SubjectKind::Face, loop.face);
  }

  void check_edge(Index e) {
    const BrepEdge& edge = brep_.edges[e];
    if (edge.pieces.empty() || edge.fitted.empty() || edge.fitted.size() > 2)
      complain("An edge has no curve, or one of too many pieces.", SubjectKind::Edge, e);
    for (const bool reversed : {false, true}) {
      const Index half = edge.half_edges[reversed ? 1 : 0];
      if (half == no_index) continue;
      if (brep_.half_edges[half].edge != e || brep_.half_edges[half].reversed != reversed) {
        complain("An edge and its half-edge don't know each other.", SubjectKind::Edge, e);
      }
    }
  }

  void check_genus() {
    const BrepFigures figures = inspect(brep_);
    if (figures.open_edges > 0) return;
    const auto euler = static_cast<std::int64_t>(figures.vertices + figures.faces) -
                       static_cast<std::int64_t>(figures.edges + figures.rings);
    if (euler % 2 != 0 || *figures.genus < 0) {
      complain("The numbers of vertices, edges, faces and rings fit no solid.", SubjectKind::Face, 0);
    }
  }

  const Brep& brep_;
  Findings findings_;
};

}  // namespace

Index Brep::start_of(Index half_edge) const {
  const BrepHalfEdge& half = half_edges[half_edge];
  return half.reversed ? edges[half.edge].end : edges[half.edge].start;
}

Index Brep::end_of(Index half_edge) const {
  const BrepHalfEdge& half = half_edges[half_edge];
  return half.reversed ? edges[half.edge].start : edges[half.edge].end;
}

Index Brep::twin(Index half_edge) const {
  const BrepHalfEdge& half = half_edges[half_edge];
  return edges[half.edge].half_edges[half.reversed ? 0 : 1];
}

std::vector<Index> Brep::around(Index loop) const {
  std::vector<Index> result;
  Index half = loops[loop].first;
  do {
    result.push_back(half);
    half = half_edges[half].next;
  } while (half != loops[loop].first);
  return result;
}

double size_of(const Brep& brep) {
  Vec3 low = Vec3::Constant(std::numeric_limits<double>::infinity()), high = -low;
  for (const BrepEdge& edge : brep.edges) {
    for (const RationalCubic& piece : edge.pieces) {
      for (const Vec3& p : piece.points) {
        low = low.cwiseMin(p);
        high = high.cwiseMax(p);
      }
    }
  }
  return brep.edges.empty() ? 0 : (high - low).norm();
}

BrepFigures inspect(const Brep& brep) {
  BrepFigures figures;
  figures.vertices = brep.vertices.size();
  figures.edges = brep.edges.size();
  figures.faces = brep.faces.size();
  figures.shells = brep.shells.size();
  for (const BrepFace& face : brep.faces) figures.rings += face.loops.size() - 1;
  for (const BrepEdge& edge : brep.edges) {
    if (edge.half_edges[0] == no_index || edge.half_edges[1] == no_index) ++figures.open_edges;
  }
  if (figures.open_edges > 0) return figures;
  const auto euler = static_cast<std::int64_t>(figures.vertices + figures.faces) -
                     static_cast<std::int64_t>(figures.edges + figures.rings);
  figures.genus = static_cast<std::int64_t>(figures.shells) - euler / 2;
  return figures;
}

Findings validate(const Brep& brep) { return BrepCheck(brep).run(); }

}  // namespace croquis
