// SPDX-License-Identifier: GPL-3.0-or-later
// Operations that make curves of an attribute network of other things.
#include <memory>
#include <numbers>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "croquis/attribute_surface/contour_network.h"
#include "croquis/attribute_surface/edge_network.h"
#include "croquis/base/error.h"
#include "croquis/base/index_list.h"
#include "croquis/base/text.h"
#include "croquis/geometry/edge_channels.h"
#include "croquis/geometry/mesh_topology.h"
#include "croquis/mesh_editing/mesh_selection.h"
#include "croquis/perspective/solid_network.h"
#include "operators/operations.h"

namespace croquis {
namespace {

OperationResult result_of_network(AttributeNetwork network, Findings warnings) {
  OperationResult result;
  result.outputs["network"] = std::make_shared<const AttributeNetwork>(std::move(network));
  result.warnings = std::move(warnings);
  return result;
}

OperationResult compute_attribute_network(const Values& inputs, const ParameterValues&, Context& context) {
  SolidNetwork made = network_of_solid(inputs.at("solid").get<Brep>());
  context.progress.report(1);
  return result_of_network(std::move(made.network), std::move(made.warnings));
}

void list_contour_parameters(ContourNetworkOptions& options, ParameterList& list) {
  list.number("tolerance", options.tolerance, 1e-6, 0.1, {"× the drawing's diagonal", ParameterLength::Input},
              "How far curves may be from what was drawn: smaller takes more curves.")
      .titled("Off the strokes by at most", {"fine", "coarse"});
  list.number("join", options.join, 0, 0.1, {"× the drawing's diagonal", ParameterLength::Input},
              "Ends of strokes that are so near to each other, or to a stroke, meet.")
      .titled("Ends meet within");
  list.angle("corner", options.corner, 5, 180, "Strokes that turn more have a corner there; 180 for none.")
      .titled("Corner above");
}

OperationResult compute_contour_network(const Values& inputs, ContourNetworkOptions options, Context& context) {
  ContourNetwork made = network_of_contours(inputs.at("drawing").get<Drawing>(), options, context.progress);
  return result_of_network(std::move(made.network), std::move(made.warnings));
}

struct EdgeNetworkSettings {
  EdgeNetworkOptions options;
  bool sharp = false;  ///< edges above the angle, else those of one face
  double angle = 30;   ///< degrees
  std::string edges;   ///< these instead, where it isn't empty
};

void list_edge_parameters(EdgeNetworkSettings& settings, ParameterList& list) {
  list.choice("select", settings.sharp, {"boundary", "sharp"},
              "Edges of one face, or those where faces meet at more than angle.")
      .titled("Edges", {"of the border", "sharp ones"});
  list.list("edges", "Edges instead, each by its vertices, counted from 0: 3-7,7-12.",
            [&](const std::string& edges) { settings.edges = edges; })
      .at(ParameterPlace::Nowhere);
  list.number("angle", settings.angle, 0, 180, "degrees", "Faces that meet at more have a sharp edge.")
      .titled("Sharp above");
  list.number("tolerance", settings.options.tolerance, 1e-6, 0.1, {"× the model's diagonal", ParameterLength::Input},
              "How far curves may be from vertices: smaller takes more curves.")
      .titled("Off the edges by at most", {"fine", "coarse"});
  list.angle("corner", settings.options.corner, 0, 180,
             "Rows of edges that turn more have a corner there; 180 for none.")
      .titled("Corner above");
  list.flag("slopes", settings.options.slopes,
            "Give curves the mesh's normals, so that faces spanned between them continue it smoothly.")
      .titled("Continue the faces around");
}

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

std::vector<EdgeEnds> named_edges(const std::string& text, const MeshTopology& topology) {
  std::vector<EdgeEnds> edges;
  Findings findings;
  for (const std::string_view word : text_parts(text, ",; ")) {
    const std::vector<Index> ends = ends_of(word);
    if (ends.size() != 2) {
      findings.push_back(refused_value("edges", word, "pairs of vertices, counted from 0, such as 3-7,7-12"));
    } else if (find_edge(topology, ends[0], ends[1]) == no_index) {
      findings.push_back(make_error(Category::Usage, "E_PARAMETER",
                                    "'" + std::string(word) + "' is no value for edges: no edge joins these vertices.",
                                    {{SubjectKind::Parameter, "edges", {}, {}, {}}}));
    } else {
      edges.push_back({ends[0], ends[1]});
    }
  }
  if (!findings.empty()) throw Error(std::move(findings));
  return edges;
}

OperationResult compute_edge_network(const Values& inputs, EdgeNetworkSettings settings, Context& context) {
  const PolyMesh& mesh = inputs.at("mesh").get<PolyMesh>();
  const MeshTopology topology(mesh);
  std::vector<EdgeEnds> edges;
  if (!settings.edges.empty()) {
    edges = named_edges(settings.edges, topology);
  } else {
    for (const Index edge :
         settings.sharp ? edges_sharper_than(topology, mesh, settings.angle) : boundary_edges(topology))
      edges.push_back(topology.edge_vertices(edge));
  }
  return result_of_network(network_of_edges(mesh, edges, settings.options, context.progress), {});
}

}  // namespace

std::unique_ptr<const Operation> attribute_network_operation() {
  return std::make_unique<Operation>(
      OperationDescription{
          "attribute_network",
          1,
          "Attribute Network",
          "Makes an attribute network of a solid: its curves, and a face for each loop of 2 to 12 of them.",
          {{"solid", ValueType::Brep, "Faces, edges and vertices with their curves."}},
          {{"network", ValueType::AttributeNetwork, "The solid's curves and faces as an attribute network."}}},
      compute_attribute_network);
}

std::unique_ptr<const Operation> contour_network_operation() {
  return operation_of(
      {"contour_network",
       1,
       "Contours as Curves",
       "Makes curves of an attribute network of the strokes of a drawing; faces are spanned between them afterwards.",
       {{"drawing", ValueType::Drawing, "Strokes on their plane."}},
       {{"network", ValueType::AttributeNetwork, "Curves that share nodes where strokes meet."}}},
      list_contour_parameters, compute_contour_network);
}

std::unique_ptr<const Operation> edge_network_operation() {
  return operation_of(
      {"edge_network",
       1,
       "Edges as Curves",
       "Makes curves of an attribute network along edges of a mesh; faces are spanned between them afterwards.",
       {{"mesh", ValueType::Mesh, "Polygons."}},
       {{"network", ValueType::AttributeNetwork, "Curves along the edges, with nodes at vertices."}}},
      list_edge_parameters, compute_edge_network);
}

}  // namespace croquis
