// SPDX-License-Identifier: GPL-3.0-or-later
#include "operators/chain_origins.h"

#include <algorithm>
#include <set>

namespace croquis {
namespace {

using namespace subdivision;

CageEdge edge_of_mesh(const Cage& cage, Index a, Index b) {
  const auto [low, high] = std::minmax(cage.source_vertex[a], cage.source_vertex[b]);
  return {low, high};
}

/// Doo-Sabin: the child of an edge joins what its ends became; a chord joins two points of one vertex.
class VertexOrigins {
 public:
  VertexOrigins(const DooSabinPlan& plan, int k, const Cage& cage) : plan_(plan), k_(k), cage_(cage) {}

  void add(const EdgeChain& chain, std::size_t edge, std::set<CageEdge>& found) const {
    const Index a = plan_.cage_vertex(k_, chain.vertices[edge]);
    const Index b = plan_.cage_vertex(k_, chain.vertices[(edge + 1) % chain.vertices.size()]);
    if (a != b) found.insert(edge_of_mesh(cage_, a, b));
  }

 private:
  const DooSabinPlan& plan_;
  int k_;
  const Cage& cage_;
};

/// Catmull-Clark and Loop: the child of an edge lies between children of its faces.
class FaceOrigins {
 public:
  FaceOrigins(const UniformPlan& plan, int k, const Cage& cage)
      : plan_(plan),
        k_(k),
        cage_(cage),
        topology_(plan.level(k).topology),
        faces_(topology_),
        cage_faces_(cage.topology) {}

  void add(const EdgeChain& chain, std::size_t edge, std::set<CageEdge>& found) const {
    const Index corner = topology_.edge_corner[chain.edges[edge]];
    const Index left = plan_.cage_face(k_, faces_.face(corner));
    const Index right = plan_.cage_face(k_, faces_.face(topology_.twin[corner]));
    const HalfEdges& cage = cage_.topology;
    for (Index c = cage.face_offsets[left]; c < cage.face_offsets[left + std::size_t{1}]; ++c) {
      if (cage.twin[c] == no_index || cage_faces_.face(cage.twin[c]) != right) continue;
      if (!(cage_.sharpness[cage.corner_edge[c]] > 0)) continue;
      found.insert(edge_of_mesh(cage_, cage.corner_vertex[c], cage.corner_vertex[cage.twin[c]]));
    }
  }

 private:
  const UniformPlan& plan_;
  int k_;
  const Cage& cage_;
  const HalfEdges& topology_;
  CornerFaces faces_;
  CornerFaces cage_faces_;
};

template <typename Origins>
std::vector<std::vector<CageEdge>> origins_of(const Origins& origins, std::span<const EdgeChain> chains) {
  std::vector<std::vector<CageEdge>> all;
  for (const EdgeChain& chain : chains) {
    std::set<CageEdge> found;
    for (std::size_t edge = 0; edge < chain.edges.size(); ++edge) origins.add(chain, edge, found);
    all.emplace_back(found.begin(), found.end());
  }
  return all;
}

}  // namespace

std::vector<std::vector<CageEdge>> chain_origins(const SubdivisionPlan& plan, int k, std::span<const EdgeChain> chains,
                                                 const Cage& cage) {
  if (const auto* doo_sabin = std::get_if<DooSabinPlan>(&plan)) {
    return origins_of(VertexOrigins(*doo_sabin, k, cage), chains);
  }
  return origins_of(FaceOrigins(std::get<UniformPlan>(plan), k, cage), chains);
}

}  // namespace croquis
