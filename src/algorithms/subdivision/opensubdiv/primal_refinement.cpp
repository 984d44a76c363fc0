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

/// OpenSubdiv tells its errors to one function of the whole process, in the thread that asked.
std::string& last_message() {
  thread_local std::string message;
  return message;
}

void keep_message(Far::ErrorType, const char* message) { last_message() = message; }

void listen_to_errors() {
  static std::once_flag installed;
  std::call_once(installed, [] { Far::SetErrorCallback(keep_message); });
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

Sdc::SchemeType scheme_type(PrimalScheme scheme) {
  return scheme == PrimalScheme::Loop ? Sdc::SCHEME_LOOP : Sdc::SCHEME_CATMARK;
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
  options.SetVtxBoundaryInterpolation(topology.corners_stay ? Sdc::Options::VTX_BOUNDARY_EDGE_AND_CORNER
                                                            : Sdc::Options::VTX_BOUNDARY_EDGE_ONLY);
  options.SetCreasingMethod(Sdc::Options::CREASE_UNIFORM);
  listen_to_errors();
  Refiner refiner(Factory::Create(descriptor, Factory::Options(scheme_type(topology.scheme), options)));
  require_no_error(refiner != nullptr);
  return refiner;
}

void read_faces(const Far::TopologyLevel& level, PrimalLevel& result) {
  for (int f = 0; f < level.GetNumFaces(); ++f) {
    const auto corners = level.GetFaceVertices(f);
    result.face_sizes.push_back(static_cast<Index>(corners.size()));
    for (int c = 0; c < corners.size(); ++c) result.corners.push_back(static_cast<Index>(corners[c]));
    result.face_parents.push_back(static_cast<Index>(level.GetFaceParentFace(f)));
  }
}

void read_creases(const Far::TopologyLevel& level, PrimalLevel& result) {
  for (int e = 0; e < level.GetNumEdges(); ++e) {
    const double sharpness = static_cast<double>(level.GetEdgeSharpness(e));
    if (sharpness <= 0 || level.IsEdgeBoundary(e)) continue;
    const auto ends = level.GetEdgeVertices(e);
    result.creases.push_back({{static_cast<Index>(ends[0]), static_cast<Index>(ends[1])},
                              level.IsEdgeInfSharp(e) ? infinite_sharpness : sharpness});
  }
}

/// Rows of each level over the level before: small, and exact in doubles.
void read_rows(const Far::TopologyRefiner& refiner, std::vector<PrimalLevel>& levels) {
  using Factory = Far::StencilTableFactoryReal<double>;
  Factory::Options options;
  options.generateIntermediateLevels = true;
  options.factorizeIntermediateLevels = false;
  options.maxLevel = static_cast<unsigned>(levels.size()) & 0xfU;
  const std::unique_ptr<const Far::StencilTableReal<double>> table(Factory::Create(refiner, options));
  require_no_error(table != nullptr);
  auto size = table->GetSizes().begin();
  auto column = table->GetControlIndices().begin();
  auto weight = table->GetWeights().begin();
  for (PrimalLevel& level : levels) {
    for (std::size_t v = 0; v < level.vertex_count; ++v, ++size) {
      level.rows.columns.insert(level.rows.columns.end(), column, column + *size);
      level.rows.weights.insert(level.rows.weights.end(), weight, weight + *size);
      level.rows.offsets.push_back(static_cast<Index>(level.rows.columns.size()));
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
    if (weight != 0) entries.emplace_back(column, weight);
  }
};

struct ColumnNumbers {
  Index operator[](int i) const { return static_cast<Index>(i); }
};

WeightRows rows_of(const std::vector<RowWriter>& writers) {
  WeightRows rows;
  for (const RowWriter& writer : writers) {
    for (const auto& [column, weight] : writer.entries) {
      rows.columns.push_back(column);
      rows.weights.push_back(weight);
    }
    rows.offsets.push_back(static_cast<Index>(rows.columns.size()));
  }
  return rows;
}

void read_limit(const Far::TopologyRefiner& refiner, std::size_t vertex_count, PrimalRefinement& result) {
  std::vector<RowWriter> places(vertex_count), first(vertex_count), second(vertex_count);
  Far::PrimvarRefinerReal<double>(refiner).Limit(ColumnNumbers(), places, first, second);
  require_no_error(true);
  result.limit = rows_of(places);
  result.first_tangent = rows_of(first);
  result.second_tangent = rows_of(second);
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

PrimalRefinement refine(const PrimalTopology& topology, int levels, Progress& progress) {
  const Refiner refiner = make_refiner(topology);
  Far::TopologyRefiner::UniformOptions options(levels);
  options.fullTopologyInLastLevel = true;  // limit masks and tags need it
  progress.report(0.2);
  refiner->RefineUniform(options);
  progress.report(0.4);
  PrimalRefinement result;
  std::vector<Index> pins = topology.pins;
  for (int k = 1; k <= levels; ++k) {
    const Far::TopologyLevel& level = refiner->GetLevel(k);
    PrimalLevel& read = result.levels.emplace_back();
    read.vertex_count = static_cast<std::size_t>(level.GetNumVertices());
    read_faces(level, read);
    read_creases(level, read);
    read.pins = pins = children(refiner->GetLevel(k - 1), pins);
    progress.check();
  }
  progress.report(0.6);
  if (levels > 0) read_rows(*refiner, result.levels);
  progress.report(0.8);
  read_limit(*refiner, levels > 0 ? result.levels.back().vertex_count : topology.vertex_count, result);
  progress.report(1);
  return result;
}

}  // namespace croquis::subdivision
