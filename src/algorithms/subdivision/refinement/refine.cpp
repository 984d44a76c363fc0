// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/subdivision/refinement/refine.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "algorithms/subdivision/levels/level_geometry.h"
#include "algorithms/subdivision/refinement/special_faces.h"
#include "croquis/base/error.h"
#include "croquis/geometry/vector.h"
#include "croquis/subdivision/level.h"
#include "croquis/subdivision/rules.h"

namespace croquis::subdivision {
namespace {

/// Half-edges of the next level whose twin doesn't follow from numbers: paired by their vertices.
///
/// Only the tagged neighbourhood comes here, with n log n.
class EdgeMatching {
 public:
  struct Edge {
    Index low = no_index, high = no_index;     ///< vertices
    Index lower = no_index, upper = no_index;  ///< half-edges; the upper one is missing on the boundary
    Index number = no_index;
  };

  void reserve(std::size_t count) { open_.reserve(count); }

  /// @param from, to its vertices
  void add(Index half_edge, Index from, Index to);

  /// Pairs what was added and numbers the edges. The quads of plain edges have numbers for theirs already: of half-edge
  /// h, h - quads_begin.
  /// @throws Error (E_INTERNAL) when that is no manifold
  void match(Index quads_begin, Index quads_end);

  const std::vector<Edge>& edges() const { return edges_; }  ///< ascending by (low, high)
  std::size_t new_edge_count() const { return new_edges_; }  ///< those not numbered before

  /// The number of the edge between two vertices.
  /// @throws Error (E_INTERNAL) where there is none
  Index edge_between(Index a, Index b) const;

 private:
  struct Open {
    std::uint64_t ends;  ///< the lower vertex above the higher one: sorts by both
    Index half_edge;
    bool ascending;  ///< runs from the lower to the higher
  };

  std::vector<Open> open_;
  std::vector<Edge> edges_;
  std::size_t new_edges_ = 0;
};

[[noreturn]] void fail(const char* what, Index a, Index b) {
  throw Error(make_error(Category::Internal, "E_INTERNAL",
                         std::string(what) + " between the new vertices " + std::to_string(a) + " and " +
                             std::to_string(b) + ": a mistake of the refinement, please report the cage."));
}

void EdgeMatching::add(Index half_edge, Index from, Index to) {
  const auto [low, high] = std::minmax(from, to);
  open_.push_back({std::uint64_t{low} << 32 | high, half_edge, from < to});
}

void EdgeMatching::match(Index quads_begin, Index quads_end) {
  std::sort(open_.begin(), open_.end(), [](const Open& a, const Open& b) {
    return a.ends != b.ends ? a.ends < b.ends : a.half_edge < b.half_edge;
  });
  edges_.reserve((open_.size() + 1) / 2);
  const auto is_quads = [&](Index half_edge) { return half_edge >= quads_begin && half_edge < quads_end; };
  for (std::size_t i = 0; i < open_.size();) {
    const std::uint64_t ends = open_[i].ends;
    Edge edge{static_cast<Index>(ends >> 32), static_cast<Index>(ends), open_[i].half_edge, no_index, no_index};
    const auto same = [&](std::size_t j) { return j < open_.size() && open_[j].ends == ends; };
    if (same(i + 1)) {
      if (open_[i].ascending == open_[i + 1].ascending || same(i + 2)) fail("Faces don't fit", edge.low, edge.high);
      edge.upper = open_[i + 1].half_edge;
    }
    if (is_quads(edge.lower)) {
      edge.number = edge.lower - quads_begin;
    } else if (edge.upper != no_index && is_quads(edge.upper)) {
      edge.number = edge.upper - quads_begin;
    } else {
      edge.number = quads_end - quads_begin + static_cast<Index>(new_edges_++);
    }
    i += edge.upper == no_index ? 1 : 2;
    edges_.push_back(edge);
  }
}

Index EdgeMatching::edge_between(Index a, Index b) const {
  const auto key = std::minmax(a, b);
  const auto found = std::lower_bound(edges_.begin(), edges_.end(), key, [](const Edge& edge, const auto& wanted) {
    return std::pair(edge.low, edge.high) < std::pair(wanted.first, wanted.second);
  });
  if (found == edges_.end() || found->low != key.first || found->high != key.second) fail("No edge", a, b);
  return found->number;
}

class TagPasser {
 public:
  TagPasser(const Neighbourhood& near, const EdgeMatching& matching, Level& next)
      : near_(near), matching_(matching), next_(next) {}

  void run() {
    for (Index line = 0; line < near_.classes.lines.size(); ++line) pass_line(line);
    for (const Sector& sector : near_.sectors.list) pass_chord(sector);
    std::sort(next_.sharp.begin(), next_.sharp.end(),
              [](const SharpEdge& a, const SharpEdge& b) { return a.edge < b.edge; });
    for (const Index vertex : near_.classes.special) pass_vertex(vertex);
    std::sort(next_.pins.begin(), next_.pins.end());
    std::sort(next_.settled.begin(), next_.settled.end());
    std::sort(next_.valence_two.begin(), next_.valence_two.end());
  }

 private:
  void tag(Index a, Index b, double sharpness) {
    if (sharpness > 0) next_.sharp.push_back({matching_.edge_between(a, b), sharpness});
  }

  void pass_line(Index line) {
    const SharpLine& sharp = near_.classes.lines[line];
    if (sharp.on_boundary()) return;
    tag(near_.points.chain(line, 0), near_.points.chain(line, 1), sharp.sharpness - 1);
    for (std::size_t end = 0; end < 2; ++end) {
      const Index kept = near_.points.kept(sharp.vertices[end]), point = near_.points.chain(line, end);
      if (kept != no_index && kept != point) tag(kept, point, sharp.sharpness - 1);
    }
  }

  /// Where a chain passes a vertex, its two sectors have the same chord: taken from the first.
  void pass_chord(const Sector& sector) {
    if (near_.classes.class_of[sector.vertex] != VertexClass::Crease || sector.first_line > sector.last_line) return;
    const SharpLine &first = near_.classes.lines[sector.first_line], &last = near_.classes.lines[sector.last_line];
    if (first.on_boundary() || last.on_boundary()) return;
    tag(near_.points.chain_at(near_.classes, sector.first_line, sector.vertex),
        near_.points.chain_at(near_.classes, sector.last_line, sector.vertex),
        std::min(first.sharpness, last.sharpness) - 1);
  }

  void pass_vertex(Index vertex) {
    const bool pinned = near_.classes.pinned[vertex] != 0;
    if (near_.classes.class_of[vertex] == VertexClass::Corner) {
      const Index kept = near_.points.kept(vertex);
      if (pinned) next_.pins.push_back(kept);
      next_.settled.push_back(kept);
      if (has_two_faces(vertex)) next_.valence_two.push_back(kept);
    } else if (pinned && near_.classes.class_of[vertex] == VertexClass::Dart) {
      next_.pins.push_back(chain_end(vertex));
    }
  }

  /// An inner corner with two faces has two sectors, and keeps two faces; once its edges are smooth that matters.
  bool has_two_faces(Index vertex) const {
    return std::binary_search(near_.level.valence_two.begin(), near_.level.valence_two.end(), vertex);
  }

  Index chain_end(Index vertex) const {
    const auto sector = std::lower_bound(near_.sectors.list.begin(), near_.sectors.list.end(), vertex,
                                         [](const Sector& s, Index value) { return s.vertex < value; });
    return near_.points.chain_at(near_.classes, sector->first_line, vertex);
  }

  const Neighbourhood& near_;
  const EdgeMatching& matching_;
  Level& next_;
};

/// Passes the tags of a level down: sharpness less one to the children of tagged edges and to the chords that join them
/// at creases; pins and settled corners to the points that stay.
void pass_tags(const Neighbourhood& near, const EdgeMatching& matching, Level& next) {
  TagPasser(near, matching, next).run();
}

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
