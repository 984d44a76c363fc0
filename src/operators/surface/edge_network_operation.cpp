// SPDX-License-Identifier: GPL-3.0-or-later
#include "operators/surface/edge_network_operation.h"

#include <memory>
#include <numbers>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "croquis/attribute_surface/edge_network.h"
#include "croquis/base/error.h"
#include "croquis/base/index_list.h"
#include "croquis/base/text.h"
#include "croquis/geometry/edge_channels.h"
#include "croquis/geometry/mesh_topology.h"
#include "croquis/mesh_editing/mesh_selection.h"

namespace croquis {
namespace {

constexpr double edge_degree = std::numbers::pi / 180;

/// The two numbers of "A-B", or none.
std::vector<Index> ends_of(std::string_view word) {
  const std::size_t dash = word.find('-');
  std::vector<Index> ends;
  if (dash == std::string_view::npos) return ends;
  const std::string_view first = word.substr(0, dash), second = word.substr(dash + 1);
  const bool are_numbers = first.find('-') == std::string_view::npos && second.find('-') == std::string_view::npos;
  if (are_numbers && append_indices(first, ends)) append_indices(second, ends);
  return ends;
}

Finding refused_edge(const std::string& word, const std::string& reason) {
  return make_error(Category::Usage, "E_PARAMETER", "'" + word + "' is no value for edges: " + reason + ".",
                    {{SubjectKind::Parameter, "edges", {}, {}, {}}});
}

std::vector<EdgeEnds> named_edges(const std::string& text, const MeshTopology& topology) {
  std::vector<EdgeEnds> edges;
  Findings findings;
  for (const std::string_view word : text_parts(text, ",; ")) {
    const std::vector<Index> ends = ends_of(word);
    if (ends.size() != 2) {
      findings.push_back(
          refused_edge(std::string(word), "it takes pairs of vertices, counted from 0, such as 3-7,7-12"));
    } else if (find_edge(topology, ends[0], ends[1]) == no_index) {
      findings.push_back(refused_edge(std::string(word), "no edge joins these vertices"));
    } else {
      edges.push_back({ends[0], ends[1]});
    }
  }
  if (!findings.empty()) throw Error(std::move(findings));
  return edges;
}

std::vector<EdgeEnds> chosen_edges(const PolyMesh& mesh, const ParameterValues& parameters) {
  const MeshTopology topology(mesh);
  if (const std::string& names = text_of(parameters, "edges"); !names.empty()) return named_edges(names, topology);
  const bool is_boundary = text_of(parameters, "select") == "boundary";
  std::vector<EdgeEnds> ends;
  for (const Index edge :
       is_boundary ? boundary_edges(topology) : edges_sharper_than(topology, mesh, number_of(parameters, "angle")))
    ends.push_back(topology.edge_vertices(edge));
  return ends;
}

}  // namespace

OperationDescription EdgeNetworkOperation::describe() const {
  return {"edge_network",
          1,
          "Edges as Curves",
          "Makes curves of an attribute network along edges of a mesh; faces are spanned between them afterwards.",
          {{"mesh", ValueType::Mesh, "Polygons."}},
          {{"network", ValueType::AttributeNetwork, "Curves along the edges, with nodes at vertices."}},
          {choice_parameter("select", {"boundary", "sharp"},
                            "Edges of one face, or those where faces meet at more than angle.")
               .titled("Edges", {"of the border", "sharp ones"}),
           list_parameter("edges", "Edges instead, each by its vertices, counted from 0: 3-7,7-12.")
               .at(ParameterPlace::Nowhere),
           number_parameter("angle", 30, 0, 180, "degrees", "Faces that meet at more have a sharp edge.")
               .titled("Sharp above"),
           number_parameter("tolerance", 0.002, 1e-6, 0.1, "× the model's diagonal",
                            "How far curves may be from vertices: smaller takes more curves.")
               .titled("Off the edges by at most"),
           number_parameter("corner", 40, 0, 180, "degrees",
                            "Rows of edges that turn more have a corner there; 180 for none.")
               .titled("Corner above"),
           flag_parameter("slopes", false,
                          "Give curves the mesh's normals, so that faces spanned between them continue it smoothly.")
               .titled("Continue the faces around")}};
}

OperationResult EdgeNetworkOperation::compute(const Values& inputs, const ParameterValues& parameters,
                                              Context& context) const {
  const PolyMesh& mesh = inputs.at("mesh").get<PolyMesh>();
  EdgeNetworkOptions options;
  options.tolerance = number_of(parameters, "tolerance");
  options.corner = number_of(parameters, "corner") * edge_degree;
  options.slopes = flag_of(parameters, "slopes");
  AttributeNetwork network = network_of_edges(mesh, chosen_edges(mesh, parameters), options, context.progress);
  OperationResult result;
  result.outputs["network"] = std::make_shared<const AttributeNetwork>(std::move(network));
  return result;
}

}  // namespace croquis
