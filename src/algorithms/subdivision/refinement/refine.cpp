// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/subdivision/refinement/refine.h"

#include <algorithm>
#include <utility>

#include "algorithms/subdivision/levels/level_geometry.h"
#include "algorithms/subdivision/refinement/edge_matching.h"
#include "algorithms/subdivision/refinement/passed_tags.h"

namespace croquis::subdivision {
namespace {

std::size_t vertex_face_corners(const HalfEdges& old, const CornerFaces& around, const PlainParts& plain) {
  std::size_t left_out = 0;
  for (const Index vertex : plain.vertices.left_out()) {
    for_each_corner(old, around, vertex, [&](Index) { ++left_out; });
  }
  return old.corner_count() - left_out;
}

/// All but the number of edges.
Layout lay_out(const HalfEdges& old, const CornerFaces& around, const PlainParts& plain, const FaceList& listed,
               const NewPoints& points) {
  Layout layout;
  layout.quads_begin = static_cast<Index>(old.corner_count());
  layout.vertex_faces_begin = layout.quads_begin + 4 * plain.edges.kept_count();
  layout.listed_begin = layout.vertex_faces_begin + static_cast<Index>(vertex_face_corners(old, around, plain));
  layout.corners = layout.listed_begin + listed.vertices.size();
  layout.faces = old.face_count() + plain.edges.kept_count() + plain.vertices.kept_count() + listed.size();
  layout.vertices = points.count();
  return layout;
}

void resize(const Layout& layout, HalfEdges& next) {
  next.face_offsets.resize(layout.faces + 1);
  next.face_offsets.back() = static_cast<Index>(layout.corners);
  next.corner_vertex.resize(layout.corners);
  next.twin.resize(layout.corners);
  next.corner_edge.resize(layout.corners);
  next.edge_corner.resize(layout.edges);
  next.vertex_corner.resize(layout.vertices);
}

/// Half-edges of old faces on edges that aren't plain, ends of quads at vertices whose faces are listed, and the listed
/// faces: all whose twins don't follow from numbers.
class OpenHalfEdges {
 public:
  OpenHalfEdges(const Neighbourhood& near, const PlainParts& plain, const FlatScratch& scratch)
      : near_(near), mesh_(near.level.topology), plain_(plain), scratch_(scratch) {}

  EdgeMatching match(const FaceList& listed, const Layout& layout) {
    matching_.reserve(listed.vertices.size() + 2 * plain_.edges.left_out().size() + 8 * plain_.bordering.size());
    for (const Index edge : plain_.edges.left_out()) add_old_faces(edge);
    for (const Index vertex : plain_.bordering) add_quad_ends(vertex);
    add_listed(listed, layout.listed_begin);
    matching_.match(layout.quads_begin, layout.vertex_faces_begin);
    return std::move(matching_);
  }

 private:
  Index at(Index corner) const { return near_.points.at(corner); }

  void add_old_faces(Index edge) {
    const Index half_edge = mesh_.edge_corner[edge];
    for (const Index h : {half_edge, mesh_.twin[half_edge]}) {
      if (h != no_index) matching_.add(h, at(h), at(near_.around.next(h)));
    }
  }

  void add_quad_ends(Index vertex) {
    for_each_corner(mesh_, near_.around, vertex, [&](Index corner) {
      if (scratch_.quad_of_edge[mesh_.corner_edge[corner]] == no_index) return;
      matching_.add(quad_corner(mesh_, scratch_, corner) + 1, at(corner), at(near_.around.next(mesh_.twin[corner])));
    });
  }

  void add_listed(const FaceList& listed, Index first_corner) {
    for (std::size_t f = 0; f < listed.size(); ++f) {
      const auto face = listed[f];
      for (std::size_t i = 0; i < face.size(); ++i) {
        matching_.add(first_corner + listed.offsets[f] + static_cast<Index>(i), face[i], face[(i + 1) % face.size()]);
      }
    }
  }

  const Neighbourhood& near_;
  const HalfEdges& mesh_;
  const PlainParts& plain_;
  const FlatScratch& scratch_;
  EdgeMatching matching_;
};

void place_listed_faces(const FaceList& listed, const Layout& layout, HalfEdges& next) {
  std::copy(listed.vertices.begin(), listed.vertices.end(), next.corner_vertex.begin() + layout.listed_begin);
  auto offset = next.face_offsets.end() - 1 - static_cast<std::ptrdiff_t>(listed.size());
  for (std::size_t f = 0; f < listed.size(); ++f) *offset++ = layout.listed_begin + listed.offsets[f];
}

void connect_matched_edges(const EdgeMatching& matching, const Layout& layout, Level& next) {
  HalfEdges& mesh = next.topology;
  const Index quad_edges = layout.vertex_faces_begin - layout.quads_begin;
  for (const EdgeMatching::Edge& edge : matching.edges()) {
    mesh.twin[edge.lower] = edge.upper;
    mesh.corner_edge[edge.lower] = edge.number;
    if (edge.number >= quad_edges) mesh.edge_corner[edge.number] = edge.lower;
    if (edge.upper == no_index) {
      next.boundary.push_back(edge.lower);
    } else {
      mesh.twin[edge.upper] = edge.lower;
      mesh.corner_edge[edge.upper] = edge.number;
    }
  }
  std::sort(next.boundary.begin(), next.boundary.end());
}

/// Listed points start their fans anywhere, on the boundary at its end.
void start_fans_of_listed_points(const Neighbourhood& near, const FaceList& listed, const Layout& layout, Level& next) {
  HalfEdges& mesh = next.topology;
  const Index first_listed = near.points.own().kept_count();
  const auto start = [&](Index corner) {
    if (mesh.corner_vertex[corner] >= first_listed) mesh.vertex_corner[mesh.corner_vertex[corner]] = corner;
  };
  for (Index i = 0; i < listed.vertices.size(); ++i) start(layout.listed_begin + i);
  for (const Index corner : near.points.own().left_out()) start(corner);
  for (const Index corner : next.boundary) start(corner);
}

LevelOrigins origins_of(const HalfEdges& old, const PlainParts& plain, const NewPoints& points, FaceList listed,
                        const Layout& layout) {
  LevelOrigins origins;
  origins.own_corners = points.own();
  origins.listed = points.listed();
  origins.old_faces = static_cast<Index>(old.face_count());
  origins.quads = plain.edges.kept_count();
  origins.quads_begin = layout.quads_begin;
  origins.plain_vertices = plain.vertices;
  origins.listed_faces = std::move(listed.origins);
  return origins;
}

/// Without tags, boundary and thin vertices nothing needs a list.
bool is_plain(const Level& level) { return level.boundary.empty() && level.valence_two.empty() && level.sharp.empty(); }

}  // namespace

Refinement refine(const Level& old, const Rules& rules, const FaceMask& mask, FlatScratch& scratch,
                  const Progress& progress) {
  const HalfEdges& mesh = old.topology;
  const bool plain_only = is_plain(old);
  const CornerFaces around = plain_only ? CornerFaces() : CornerFaces(mesh);
  const TagClasses classes = plain_only ? TagClasses() : classify(old, around, rules);
  const Sectors sectors = find_sectors(old, around, classes);
  const NewPoints points(mesh, classes, sectors);
  const Neighbourhood near{old, around, classes, sectors, points};
  const PlainParts plain = find_plain_parts(mesh, around, classes);
  FaceList listed = list_special_faces(near, plain);

  Layout layout = lay_out(mesh, around, plain, listed, points);
  number_quads(mesh, plain, layout, scratch);
  const EdgeMatching matching = OpenHalfEdges(near, plain, scratch).match(listed, layout);
  layout.edges = layout.vertex_faces_begin - layout.quads_begin + matching.new_edge_count();

  Refinement result;
  resize(layout, result.level.topology);
  connect_plain_parts(mesh, points, plain, layout, scratch, result.level.topology, progress);
  place_listed_faces(listed, layout, result.level.topology);
  connect_matched_edges(matching, layout, result.level);
  start_fans_of_listed_points(near, listed, layout, result.level);
  pass_tags(near, matching, result.level);
  result.rules = make_point_rules(near, rules, mask);
  result.origins = origins_of(mesh, plain, points, std::move(listed), layout);
  result.banded = sectors.any_banded();
  return result;
}

}  // namespace croquis::subdivision
