// SPDX-License-Identifier: GPL-3.0-or-later
// Operations that make a cage for subdivision of exact surfaces.
#include <memory>
#include <string>
#include <utility>

#include "croquis/attribute_surface/surface_cage.h"
#include "croquis/base/error.h"
#include "croquis/perspective/patch_cage.h"
#include "operators/operations.h"

namespace croquis {
namespace {

void list_segments(std::size_t& segments, const char* sentence, ParameterList& list) {
  list.choice_of_numbers("segments", segments, {2, 4, 8, 16, 32}, sentence).titled("Edges along a curve");
}

void list_patch_cage_parameters(PatchCageOptions& options, ParameterList& list) {
  list_segments(options.segments, "Into how many edges a curve is divided, and a straight edge of a curved face.",
                list);
}

void list_surface_cage_parameters(SurfaceCageOptions& options, ParameterList& list) {
  list_segments(options.segments, "Into how many edges a curve is divided.", list);
}

OperationResult compute_patch_cage(const Values& inputs, PatchCageOptions options, Context& context) {
  PatchCage cage = make_patch_cage(inputs.at("solid").get<Brep>(), options, context.progress);
  OperationResult result;
  result.warnings = std::move(cage.warnings);
  result.outputs["cage"] = std::make_shared<const PolyMesh>(std::move(cage.mesh));
  return result;
}

OperationResult compute_surface_cage(const Values& inputs, SurfaceCageOptions options, Context& context) {
  const AttributeNetwork& network = inputs.at("network").get<AttributeNetwork>();
  Progress evaluating = context.progress.step("evaluate the network", 0.7);
  AttributeSurface surface = make_attribute_surface(network, evaluating);
  if (!surface.any()) {
    Findings findings{make_error(Category::Geometry, "E_NO_FACES", "No face of the network could be evaluated.")};
    findings.insert(findings.end(), surface.findings.begin(), surface.findings.end());
    throw Error(std::move(findings));
  }
  Progress making = context.progress.step("make quads", 0.3);
  OperationResult result;
  result.outputs["cage"] = std::make_shared<const PolyMesh>(make_surface_cage(network, surface, options, making));
  result.warnings = std::move(surface.findings);
  return result;
}

}  // namespace

std::unique_ptr<const Operation> patch_cage_operation() {
  return operation_of(
      {"patch_cage",
       1,
       "Subdivision Cage",
       "Makes a cage for subdivision of a solid: quads along its patches, polygons along its planes, sharp edges "
       "tagged.",
       {{"solid", ValueType::Brep, "Faces, edges and vertices with their curves and patches."}},
       {{"cage", ValueType::Mesh, "Quads and convex polygons, with their tags; as closed as the solid."}}},
      list_patch_cage_parameters, compute_patch_cage);
}

std::unique_ptr<const Operation> surface_cage_operation() {
  return operation_of(
      {"surface_cage",
       1,
       "Surface Cage",
       "Makes a cage of quads for subdivision of a network of curves, with its creases tagged as sharp.",
       {{"network", ValueType::AttributeNetwork, "Curves, the faces between them, points and slopes."}},
       {{"cage", ValueType::Mesh, "Quads whose vertices lie on the surface; as closed as the network."}}},
      list_surface_cage_parameters, compute_surface_cage);
}

}  // namespace croquis
