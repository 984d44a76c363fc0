// SPDX-License-Identifier: GPL-3.0-or-later
#include "croquis/attribute_surface/edge_network.h"

#include <algorithm>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "algorithms/attribute_surface/bridges/chain_curves.h"
#include "algorithms/attribute_surface/bridges/rim_normal.h"
#include "croquis/base/error.h"
#include "croquis/geometry/bezier_fit.h"
#include "croquis/geometry/bounds.h"
#include "croquis/geometry/mesh_topology.h"

namespace croquis {
namespace {

constexpr std::size_t ring_parts = 4;
constexpr std::size_t most_slopes = 33;  // of a curve: normals turn evenly between them

/// A row of vertices along chosen edges, between two that are nodes.
using VertexRow = std::vector<Index>;

class EdgeNetworkMaker {
 public:
  EdgeNetworkMaker(const PolyMesh& mesh, const EdgeNetworkOptions& options, double tolerance, Progress& progress)
      : mesh_(mesh), options_(options), progress_(progress), curves_(network_, tolerance) {
    if (options.slopes) topology_.emplace(mesh);
  }

  AttributeNetwork run(std::span<const EdgeEnds> edges) {
    for (const auto& [a, b] : edges) {
      neighbours_[a].insert(b);
      neighbours_[b].insert(a);
    }
    for (const auto& [vertex, around] : neighbours_) {
      if (is_node(vertex)) nodes_.insert(vertex);
    }
    for (const Index node : nodes_) {
      for (const Index next : neighbours_[node]) follow(node, next);
    }
    for (const auto& [vertex, around] : neighbours_) {
      if (!nodes_.contains(vertex) && !done_.contains({vertex, *around.begin()})) follow(vertex, *around.begin());
    }
    progress_.report(1);
    return std::move(network_);
  }

 private:
  const Vec3& at(Index vertex) const { return mesh_.positions[vertex]; }

  bool is_node(Index vertex) const {
    const std::set<Index>& around = neighbours_.at(vertex);
    if (around.size() != 2) return true;
    return angle_between(at(vertex) - at(*around.begin()), at(*around.rbegin()) - at(vertex)) > options_.corner;
  }

  /// Walks along edges up to the next node, or around to the beginning.
  void follow(Index from, Index next) {
    if (done_.contains({from, next})) return;
    progress_.check();
    VertexRow row{from, next};
    while (!nodes_.contains(row.back()) && row.back() != from) {
      const std::set<Index>& around = neighbours_[row.back()];
      row.push_back(*around.begin() == row[row.size() - 2] ? *around.rbegin() : *around.begin());
    }
    for (std::size_t i = 0; i + 1 < row.size(); ++i) {
      done_.insert({row[i], row[i + 1]});
      done_.insert({row[i + 1], row[i]});
    }
    const std::string name = "e" + std::to_string(rows_++);
    row.front() == row.back() ? add_ring(row, name) : add_row(row, name, {}, {});
  }

  /// Where to cut a ring: its first vertex, and those nearest to even parts.
  std::vector<std::size_t> ring_cuts(const VertexRow& ring) const {
    std::vector<double> lengths{0};
    for (std::size_t i = 1; i < ring.size(); ++i)
      lengths.push_back(lengths.back() + (at(ring[i]) - at(ring[i - 1])).norm());
    std::vector<std::size_t> cuts{0};
    for (std::size_t k = 1; k < ring_parts; ++k) {
      const double wanted = lengths.back() * static_cast<double>(k) / static_cast<double>(ring_parts);
      const auto after = std::ranges::lower_bound(lengths, wanted);
      auto i = static_cast<std::size_t>(after - lengths.begin());
      if (i > 0 && wanted - lengths[i - 1] < lengths[i] - wanted) --i;
      if (i > cuts.back() && i + 1 < ring.size()) cuts.push_back(i);
    }
    cuts.push_back(ring.size() - 1);
    return cuts;
  }

  void add_ring(const VertexRow& ring, const std::string& name) {
    std::vector<Vec3> places;
    for (const Index vertex : ring) places.push_back(at(vertex));
    places.pop_back();
    const std::vector<std::size_t> cuts = ring_cuts(ring);
    const auto direction = [&](std::size_t i) -> std::optional<Vec3> {
      const std::size_t place = i % places.size();
      if (nodes_.contains(ring[place])) return std::nullopt;  // a corner, or where others meet
      const Vec3 along = row_direction(places, place, 0, true);
      return along == Vec3::Zero() ? std::nullopt : std::optional(along);
    };
    for (std::size_t k = 0; k + 1 < cuts.size(); ++k) {
      const VertexRow part(ring.begin() + static_cast<std::ptrdiff_t>(cuts[k]),
                           ring.begin() + static_cast<std::ptrdiff_t>(cuts[k + 1]) + 1);
      add_row(part, name + "/" + std::to_string(k + 1), direction(cuts[k]), direction(cuts[k + 1]));
    }
  }

  Index node_at(Index vertex) {
    const auto [known, is_new] = node_of_.try_emplace(vertex, no_index);
    if (is_new) {
      known->second = curves_.add_node(at(vertex));
      network_.nodes[known->second].id = "v" + std::to_string(vertex);
    }
    return known->second;
  }

  void add_row(const VertexRow& row, const std::string& name, const std::optional<Vec3>& leaving,
               const std::optional<Vec3>& arriving) {
    CurveChain chain{name, node_at(row.front()), node_at(row.back()), {}, leaving, arriving};
    VertexRow kept;
    for (const Index vertex : row) {
      if (!chain.points.empty() && chain.points.back() == at(vertex)) continue;
      chain.points.push_back(at(vertex));
      kept.push_back(vertex);
    }
    if (chain.points.size() < 2) return;
    for (const ChainCurve& made : curves_.add(chain)) {
      AttributeNode& end = network_.nodes[network_.curves[made.curve].to];
      end.id = "v" + std::to_string(made.last + 1 == kept.size() ? row.back() : kept[made.last]);
      if (options_.slopes) add_slope(made, kept, chain.points);
    }
  }

  /// Fractions of the curve's length are taken from the chords between vertices.
  void add_slope(const ChainCurve& made, const VertexRow& row, const std::vector<Vec3>& points) {
    SlopeAttribute slope;
    slope.curve = made.curve;
    std::vector<double> lengths{0};
    for (std::size_t i = made.first; i < made.last; ++i)
      lengths.push_back(lengths.back() + (points[i + 1] - points[i]).norm());
    const std::size_t steps = made.last - made.first, count = std::min(steps, most_slopes - 1);
    for (std::size_t k = 0; k <= count; ++k) {
      const std::size_t i = k * steps / count;
      const Vec3 normal = rim_normal(mesh_, *topology_, row[made.first + i]);
      if (normal == Vec3::Zero()) continue;
      slope.at.push_back(lengths[i] / lengths.back());
      slope.normals.push_back(normal);
    }
    if (!slope.at.empty()) network_.slopes.push_back(std::move(slope));
  }

  const PolyMesh& mesh_;
  const EdgeNetworkOptions& options_;
  Progress& progress_;
  AttributeNetwork network_;
  ChainCurves curves_;
  std::optional<MeshTopology> topology_;
  std::map<Index, std::set<Index>> neighbours_;  ///< along the chosen edges
  std::set<Index> nodes_;                        ///< vertices where rows end
  std::set<EdgeEnds> done_;                      ///< directed
  std::map<Index, Index> node_of_;               ///< per vertex
  std::size_t rows_ = 0;
};

}  // namespace

AttributeNetwork network_of_edges(const PolyMesh& mesh, std::span<const EdgeEnds> edges,
                                  const EdgeNetworkOptions& options, Progress& progress) {
  if (edges.empty()) {
    throw Error(make_error(Category::Geometry, "E_NO_EDGES",
                           "No edge of the mesh is chosen: name some, or choose others by select and angle."));
  }
  const BoundingBox box = bounds_of(mesh);
  const double tolerance = options.tolerance * ((*box)[1] - (*box)[0]).norm();
  return EdgeNetworkMaker(mesh, options, tolerance, progress).run(edges);
}

}  // namespace croquis
