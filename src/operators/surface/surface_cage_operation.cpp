// SPDX-License-Identifier: GPL-3.0-or-later
#include "operators/surface/surface_cage_operation.h"

#include <memory>
#include <string>
#include <utility>

#include "croquis/attribute_surface/surface_cage.h"
#include "croquis/base/error.h"

namespace croquis {

OperationDescription SurfaceCageOperation::describe() const {
  return {"surface_cage",
          1,
          "Surface Cage",
          "Makes a cage of quads for subdivision of a network of curves, with its creases tagged as sharp.",
          {{"network", ValueType::AttributeNetwork, "Curves, the faces between them, points and slopes."}},
          {{"cage", ValueType::Mesh, "Quads whose vertices lie on the surface; as closed as the network."}},
          {ParameterDescription{"segments",
                                ParameterType::Choice,
                                std::string("4"),
                                0,
                                0,
                                {"2", "4", "8", "16", "32"},
                                "",
                                "Into how many edges a curve is divided."}
               .titled("Edges along a curve")}};
}

OperationResult SurfaceCageOperation::compute(const Values& inputs, const ParameterValues& parameters,
                                              Context& context) const {
  const AttributeNetwork& network = inputs.at("network").get<AttributeNetwork>();
  Progress evaluating = context.progress.step("evaluate the network", 0.7);
  AttributeSurface surface = make_attribute_surface(network, evaluating);
  if (!surface.any()) {
    Findings findings{make_error(Category::Geometry, "E_NO_FACES", "No face of the network could be evaluated.")};
    findings.insert(findings.end(), surface.findings.begin(), surface.findings.end());
    throw Error(std::move(findings));
  }
  SurfaceCageOptions options;
  options.segments = std::stoul(text_of(parameters, "segments"));
  Progress making = context.progress.step("make quads", 0.3);
  OperationResult result;
  result.outputs["cage"] = std::make_shared<const PolyMesh>(make_surface_cage(network, surface, options, making));
  result.warnings = std::move(surface.findings);
  return result;
}

}  // namespace croquis
