// SPDX-License-Identifier: GPL-3.0-or-later
#include "croquis/base/error.h"
#include "edits/edit_parameters.h"
#include "edits/one_edit.h"

namespace croquis {
namespace {

class ExtrudeEdit final : public Edit {
 public:
  EditDescription describe() const override {
    return {"extrude",
            "Extrude",
            "Lifts faces off and joins them to where they were by walls.",
            {ComponentKind::Face},
            {text_parameter("by", "", "How far, along x, y and z, in model units; if not given, `distance` counts.")
                 .titled("By x, y, z"),
             number_parameter("distance", 0, -unlimited_value, unlimited_value, "model units",
                              "How far along the mean normal of the faces; not used where `by` is given.")},
            EditStart{"distance", 0.1}};
  }

  MeshEdit apply(const PolyMesh& mesh, const MeshTopology& topology, ComponentKind /*kind*/,
                 std::span<const Index> elements, const ParameterValues& parameters) const override {
    if (!is_given(parameters, "by") && number_of(parameters, "distance") == 0) {
      throw Error(make_error(Category::Usage, "E_INPUT", "Give `by` or `distance`: how far the faces are extruded"));
    }
    const Vec3 along = number_of(parameters, "distance") * mean_normal(mesh, elements);
    return extrude_faces(mesh, topology, elements, vector_of(parameters, "by", along));
  }
};

}  // namespace

std::unique_ptr<const Edit> make_extrude_edit() { return std::make_unique<ExtrudeEdit>(); }

}  // namespace croquis
