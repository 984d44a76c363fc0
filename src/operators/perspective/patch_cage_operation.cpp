// SPDX-License-Identifier: GPL-3.0-or-later
#include "operators/perspective/patch_cage_operation.h"

#include <memory>
#include <utility>

#include "croquis/perspective/patch_cage.h"

namespace croquis {

OperationDescription PatchCageOperation::describe() const {
  return {"patch_cage",
          1,
          "Subdivision Cage",
          "Makes a cage for subdivision of a solid: quads along its patches, polygons along its planes, sharp edges "
          "tagged.",
          {{"solid", ValueType::Brep, "Faces, edges and vertices with their curves and patches."}},
          {{"cage", ValueType::Mesh, "Quads and convex polygons, with their tags; as closed as the solid."}},
          {ParameterDescription{"segments",
                                ParameterType::Choice,
                                std::string("4"),
                                0,
                                0,
                                {"2", "4", "8", "16", "32"},
                                "",
                                "Into how many edges a curve is divided, and a straight edge of a curved face."}
               .titled("Edges along a curve")}};
}

OperationResult PatchCageOperation::compute(const Values& inputs, const ParameterValues& parameters,
                                            Context& context) const {
  PatchCageOptions options;
  options.segments = std::stoul(text_of(parameters, "segments"));
  PatchCage cage = make_patch_cage(inputs.at("solid").get<Brep>(), options, context.progress);
  OperationResult result;
  result.warnings = std::move(cage.warnings);
  result.outputs["cage"] = std::make_shared<const PolyMesh>(std::move(cage.mesh));
  return result;
}

}  // namespace croquis
