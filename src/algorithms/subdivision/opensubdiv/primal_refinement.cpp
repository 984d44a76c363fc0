// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/subdivision/opensubdiv/primal_refinement.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <mutex>
#include <string>
#include <utility>

#include <opensubdiv/far/error.h>
#include <opensubdiv/far/primvarRefiner.h>
#include <opensubdiv/far/stencilTableFactory.h>
#include <opensubdiv/far/topologyDescriptor.h>

#include "croquis/base/error.h"

namespace croquis::subdivision {
namespace {

namespace Far = OpenSubdiv::Far;
namespace Sdc = OpenSubdiv::Sdc;

using Refiner = std::unique_ptr<Far::TopologyRefiner>;

/// OpenSubdiv reports errors to one function of the whole process, in the calling thread.
std::string& last_message() {
  thread_local std::string message;
  return message;
}

void keep_message(Far::ErrorType, const char* message) { last_message() = message; }

/// Left alone, OpenSubdiv writes warnings to standard output, which may be a report.
void drop_warning(const char*) {}

void listen_to_errors() {
  static std::once_flag installed;
  std::call_once(installed, [] {
    Far::SetErrorCallback(keep_message);
    Far::SetWarningCallback(drop_warning);
  });
  last_message().clear();
}

void require_no_error(bool made) {
  std::string message = std::exchange(last_message(), {});
  if (made && message.empty()) return;
  std::replace(message.begin(), message.end(), '\n', ' ');
  throw Error(make_error(Category::Geometry, "E_SUBDIVISION",
                         "OpenSubdiv can't refine this mesh: " + (message.empty() ? "no reason given" : message)));
}

std::vector<int> as_ints(std::span<const Index> values) { return {values.begin(), values.end()}; }

/// The arrays that a Far::TopologyDescriptor points to.
struct DescriptorArrays {
  explicit DescriptorArrays(const PrimalTopology& topology)
      : face_sizes(as_ints(topology.face_sizes)), corners(as_ints(topology.corners)), pins(as_ints(topology.pins)) {
    for (const Crease& crease : topology.creases) {
      for (const Index vertex : crease.vertices) crease_ends.push_back(static_cast<int>(vertex));
      crease_weights.push_back(static_cast<float>(std::min(crease.sharpness, greatest_sharpness)));
    }
    pin_weights.assign(pins.size(), Sdc::Crease::SHARPNESS_INFINITE);
  }

  std::vector<int> face_sizes, corners, crease_ends, pins;
  std::vector<float> crease_weights, pin_weights;
};

Sdc::SchemeType scheme_type(UniformScheme scheme) {
  return scheme == UniformScheme::Loop ? Sdc::SCHEME_LOOP : Sdc::SCHEME_CATMARK;
}

Refiner make_refiner(const PrimalTopology& topology) {
  using Factory = Far::TopologyRefinerFactory<Far::TopologyDescriptor>;
  const DescriptorArrays arrays(topology);
  Far::TopologyDescriptor descriptor;
  descriptor.numVertices = static_cast<int>(topology.vertex_count);
  descriptor.numFaces = static_cast<int>(arrays.face_sizes.size());
  descriptor.numVertsPerFace = arrays.face_sizes.data();
  descriptor.vertIndicesPerFace = arrays.corners.data();
  descriptor.numCreases = static_cast<int>(arrays.crease_weights.size());
  descriptor.creaseVertexIndexPairs = arrays.crease_ends.data();
  descriptor.creaseWeights = arrays.crease_weights.data();
  descriptor.numCorners = static_cast<int>(arrays.pins.size());
  descriptor.cornerVertexIndices = arrays.pins.data();
  descriptor.cornerWeights = arrays.pin_weights.data();
  Sdc::Options options;
  const bool corners_stay = topology.rules.boundary_corners == BoundaryCorners::Corner;
  options.SetVtxBoundaryInterpolation(corners_stay ? Sdc::Options::VTX_BOUNDARY_EDGE_AND_CORNER
                                                   : Sdc::Options::VTX_BOUNDARY_EDGE_ONLY);
  options.SetCreasingMethod(Sdc::Options::CREASE_UNIFORM);
  listen_to_errors();
  Refiner refiner(Factory::Create(descriptor, Factory::Options(scheme_type(topology.rules.scheme), options)));
  require_no_error(refiner != nullptr);
  return refiner;
}

/// Fills twins, edges and boundary from the edges of the corners.
void join_half_edges(std::size_t edge_count, Level& level) {
  HalfEdges& mesh = level.topology;
  mesh.twin.assign(mesh.corner_count(), no_index);
  mesh.edge_corner.assign(edge_count, no_index);
  for (Index corner = 0; corner < mesh.corner_count(); ++corner) {
    Index& first = mesh.edge_corner[mesh.corner_edge[corner]];
    if (first == no_index) {
      first = corner;
    } else {
      mesh.twin[corner] = first;
      mesh.twin[first] = corner;
    }
  }
  for (Index corner = 0; corner < mesh.corner_count(); ++corner) {
    if (mesh.twin[corner] == no_index) level.boundary.push_back(corner);
  }
}

/// Fans begin at the corner that leaves along the boundary, or at any where they close.
void find_vertex_corners(std::size_t vertex_count, Level& level) {
  HalfEdges& mesh = level.topology;
  mesh.vertex_corner.assign(vertex_count, no_index);
  for (Index corner = 0; corner < mesh.corner_count(); ++corner) {
    Index& first = mesh.vertex_corner[mesh.corner_vertex[corner]];
    if (first == no_index) first = corner;
  }
  for (const Index corner : level.boundary) mesh.vertex_corner[mesh.corner_vertex[corner]] = corner;
}

void read_topology(const Far::TopologyLevel& source, Level& level) {
  HalfEdges& mesh = level.topology;
  for (int f = 0; f < source.GetNumFaces(); ++f) {
    for (const int vertex : source.GetFaceVertices(f)) mesh.corner_vertex.push_back(static_cast<Index>(vertex));
    for (const int edge : source.GetFaceEdges(f)) mesh.corner_edge.push_back(static_cast<Index>(edge));
    mesh.face_offsets.push_back(static_cast<Index>(mesh.corner_vertex.size()));
  }
  join_half_edges(static_cast<std::size_t>(source.GetNumEdges()), level);
  find_vertex_corners(static_cast<std::size_t>(source.GetNumVertices()), level);
}

void read_sharp_edges(const Far::TopologyLevel& source, Level& level) {
  for (int e = 0; e < source.GetNumEdges(); ++e) {
    const double sharpness = static_cast<double>(source.GetEdgeSharpness(e));
    if (sharpness <= 0 || source.IsEdgeBoundary(e)) continue;
    level.sharp.push_back({static_cast<Index>(e), source.IsEdgeInfSharp(e) ? infinite_sharpness : sharpness});
  }
}

PrimalLevel read_level(const Far::TopologyRefiner& refiner, int k) {
  const Far::TopologyLevel& source = refiner.GetLevel(k);
  PrimalLevel result;
  read_topology(source, result.level);
  read_sharp_edges(source, result.level);
  for (int f = 0; k > 0 && f < source.GetNumFaces(); ++f) {
    result.face_parents.push_back(static_cast<Index>(source.GetFaceParentFace(f)));
  }
  return result;
}

/// Rows of each level over the level before: small, and exact in doubles.
void read_rows(const Far::TopologyRefiner& refiner, std::vector<PrimalLevel>& levels) {
  using Factory = Far::StencilTableFactoryReal<double>;
  Factory::Options options;
  options.generateIntermediateLevels = true;
  options.factorizeIntermediateLevels = false;
  options.maxLevel = static_cast<unsigned>(levels.size() - 1) & 0xfU;
  const std::unique_ptr<const Far::StencilTableReal<double>> table(Factory::Create(refiner, options));
  require_no_error(table != nullptr);
  auto size = table->GetSizes().begin();
  auto column = table->GetControlIndices().begin();
  auto weight = table->GetWeights().begin();
  for (std::size_t k = 1; k < levels.size(); ++k) {
    WeightRows& rows = levels[k].rows;
    for (std::size_t v = 0; v < levels[k].level.topology.vertex_count(); ++v, ++size) {
      rows.columns.insert(rows.columns.end(), column, column + *size);
      rows.weights.insert(rows.weights.end(), weight, weight + *size);
      rows.end_row();
      column += *size;
      weight += *size;
    }
  }
}

/// Passed to OpenSubdiv as a "value", it writes down the weights that it is given.
struct RowWriter {
  std::vector<std::pair<Index, double>> entries;

  void Clear() { entries.clear(); }
  void AddWithWeight(Index column, double weight) {
    constexpr std::size_t regular_size = 9;  // a vertex of four quads and its neighbours
    if (entries.empty()) entries.reserve(regular_size);
    if (weight != 0) entries.emplace_back(column, weight);
  }
};

struct ColumnNumbers {
  Index operator[](int i) const { return static_cast<Index>(i); }
};

WeightRows rows_of(const std::vector<RowWriter>& writers) {
  WeightRows rows;
  for (const RowWriter& writer : writers) {
    for (const auto& [column, weight] : writer.entries) rows.add(column, weight);
    rows.end_row();
  }
  return rows;
}

std::vector<Index> children(const Far::TopologyLevel& level, std::span<const Index> vertices) {
  std::vector<Index> result;
  for (const Index vertex : vertices) {
    result.push_back(static_cast<Index>(level.GetVertexChildVertex(static_cast<int>(vertex))));
  }
  std::sort(result.begin(), result.end());
  return result;
}

}  // namespace

PrimalTopology primal_topology(const Level& level, const UniformRules& rules) {
  const HalfEdges& mesh = level.topology;
  PrimalTopology topology;
  topology.rules = rules;
  topology.vertex_count = mesh.vertex_count();
  for (std::size_t f = 0; f < mesh.face_count(); ++f) {
    topology.face_sizes.push_back(static_cast<Index>(mesh.face(f).size()));
  }
  topology.corners.assign(mesh.corner_vertex.begin(), mesh.corner_vertex.end());
  for (const SharpEdge& sharp : level.sharp) {
    const Index corner = mesh.edge_corner[sharp.edge];
    topology.creases.push_back({{mesh.corner_vertex[corner], mesh.corner_vertex[mesh.twin[corner]]}, sharp.sharpness});
  }
  topology.pins = level.pins;
  return topology;
}

std::vector<PrimalLevel> refine(const PrimalTopology& topology, int levels, Progress& progress) {
  const Refiner refiner = make_refiner(topology);
  Far::TopologyRefiner::UniformOptions options(levels);
  options.fullTopologyInLastLevel = true;  // edges of the last level are needed for its tags
  progress.report(0.2);
  refiner->RefineUniform(options);
  progress.report(0.4);
  std::vector<PrimalLevel> result;
  for (int k = 0; k <= levels; ++k) {
    PrimalLevel level = read_level(*refiner, k);
    level.level.pins = k == 0 ? topology.pins : children(refiner->GetLevel(k - 1), result.back().level.pins);
    result.push_back(std::move(level));
    progress.check();
  }
  progress.report(0.7);
  if (levels > 0) read_rows(*refiner, result);
  progress.report(1);
  return result;
}

PrimalLimit limit(const PrimalTopology& topology, Progress& progress) {
  const Refiner refiner = make_refiner(topology);
  progress.report(0.3);
  std::vector<RowWriter> points(topology.vertex_count), first(topology.vertex_count), second(topology.vertex_count);
  Far::PrimvarRefinerReal<double>(*refiner).Limit(ColumnNumbers(), points, first, second);
  require_no_error(true);
  progress.report(1);
  return {rows_of(points), rows_of(first), rows_of(second)};
}

}  // namespace croquis::subdivision
