// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/subdivision/cage/cage_tags.h"

#include <array>
#include <cmath>
#include <string>

#include "algorithms/subdivision/cage/finding_list.h"

namespace croquis::subdivision {
namespace {

std::array<Index, 2> edge_ends(const HalfEdges& mesh, const CornerFaces& around, Index edge) {
  const Index corner = mesh.edge_corner[edge];
  return {mesh.corner_vertex[corner], mesh.corner_vertex[around.next(corner)]};
}

/// #V: sharp edges that meet there in the first refinement, boundaries included.
std::vector<Index> sharp_edge_counts(const Cage& cage, const CornerFaces& around) {
  std::vector<Index> counts(cage.topology.vertex_count(), 0);
  for (Index edge = 0; edge < cage.topology.edge_count(); ++edge) {
    if (cage.sharpness[edge] < 1 && cage.topology.twin[cage.topology.edge_corner[edge]] != no_index) continue;
    for (const Index vertex : edge_ends(cage.topology, around, edge)) ++counts[vertex];
  }
  return counts;
}

std::vector<bool> pinned_sources(const PolyMesh& mesh, FindingList& useless) {
  std::vector<bool> pinned(mesh.vertex_count());
  for (const Index vertex : mesh.tags.pins) {
    if (vertex < mesh.vertex_count()) {
      pinned[vertex] = true;
      continue;
    }
    useless.add({vertex_subject(vertex)}, [&] {
      return "There is no vertex " + std::to_string(vertex) + " to pin in a mesh of " +
             std::to_string(mesh.vertex_count()) + " vertices";
    });
  }
  return pinned;
}

}  // namespace

void read_sharpness(const TagSource& source, Cage& cage, Findings& warnings) {
  cage.sharpness.assign(cage.topology.edge_count(), 0);
  FindingList no_edge(Severity::Warning, Category::Geometry, "W_TAG_NO_EDGE");
  FindingList bad_value(Severity::Warning, Category::Geometry, "W_TAG_SHARPNESS");
  for (const auto& [vertices, sharpness] : source.mesh.tags.creases) {
    const auto [a, b] = vertices;
    const auto corners = source.pairing.corners(a, b);
    if (corners.empty()) {
      no_edge.add({edge_subject(a, b)}, [a = a, b = b] {
        return "A tag names " + edge_name(a, b) + ", but no edge joins these vertices: it is left out";
      });
    } else if (!(sharpness >= 0)) {
      bad_value.add({edge_subject(a, b)}, [a = a, b = b] {
        return "The tag of " + edge_name(a, b) +
               " is left out: its sharpness is negative or no number, where 0 to 10 or infinite is meant";
      });
    } else {
      const Index edge = cage.topology.corner_edge[source.cage_corner[corners.front()]];
      cage.sharpness[edge] = sharpness > greatest_sharpness ? infinite_sharpness : sharpness;
    }
  }
  no_edge.move_to(warnings);
  bad_value.move_to(warnings);
}

void read_pins(const PolyMesh& mesh, CageUse use, Cage& cage, Findings& warnings) {
  cage.pinned.assign(cage.topology.vertex_count(), 0);
  if (mesh.tags.pins.empty()) return;
  FindingList useless(Severity::Warning, Category::Geometry, "W_PIN_NO_EFFECT");
  const std::vector<bool> pinned = pinned_sources(mesh, useless);
  const std::vector<Index> sharp_edges = sharp_edge_counts(cage, CornerFaces(cage.topology));
  std::vector<bool> works(mesh.vertex_count(), use == CageUse::UniformSchemes);
  for (Index vertex = 0; vertex < cage.topology.vertex_count(); ++vertex) {
    const Index source = cage.source_vertex[vertex];
    cage.pinned[vertex] = pinned[source];
    if (sharp_edges[vertex] > 0) works[source] = true;
  }
  for (std::size_t vertex = 0; vertex < mesh.vertex_count(); ++vertex) {
    if (!pinned[vertex] || works[vertex]) continue;
    useless.add({vertex_subject(vertex)}, [vertex] {
      return "Vertex " + std::to_string(vertex) + " is pinned, but no sharp edge ends there: the pin changes nothing";
    });
  }
  useless.move_to(warnings);
}

void tell_vanishing_tags(const Cage& cage, const Rules& rules, Findings& warnings) {
  if (rules.chain_ends != ChainEnds::Retract) return;
  FindingList vanishing(Severity::Warning, Category::Geometry, "W_TAG_VANISHES");
  const CornerFaces around(cage.topology);
  const std::vector<Index> sharp_edges = sharp_edge_counts(cage, around);
  for (Index edge = 0; edge < cage.topology.edge_count(); ++edge) {
    if (cage.sharpness[edge] < 1) continue;
    const auto [a, b] = edge_ends(cage.topology, around, edge);
    if (sharp_edges[a] != 1 || sharp_edges[b] != 1 || cage.pinned[a] != 0 || cage.pinned[b] != 0) continue;
    const Index source_a = cage.source_vertex[a], source_b = cage.source_vertex[b];
    vanishing.add({edge_subject(source_a, source_b)}, [source_a, source_b] {
      return "The tag of " + edge_name(source_a, source_b) +
             " stands alone and shrinks to the middle of its edge: pin its ends, or let chain ends be smooth";
    });
  }
  vanishing.move_to(warnings);
}

}  // namespace croquis::subdivision
