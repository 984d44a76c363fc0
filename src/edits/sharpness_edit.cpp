// SPDX-License-Identifier: GPL-3.0-or-later
#include "croquis/mesh_editing/tag_edit.h"
#include "edits/edit_parameters.h"
#include "edits/moved_vertices.h"
#include "edits/one_edit.h"

namespace croquis {
namespace {

class SharpnessEdit final : public Edit {
 public:
  EditDescription describe() const override {
    return {"sharpness",
            "Sharpen",
            "Tags edges, so that subdivision keeps them sharp.",
            {ComponentKind::Edge},
            {number_parameter("value", greatest_sharpness, 0, unlimited_value, "levels",
                              "For how many levels edges stay sharp; 0 removes their tags, from 10 on they stay sharp.")
                 .titled("Sharp for")}};
  }

  MeshEdit apply(const PolyMesh& mesh, const MeshTopology& topology, ComponentKind /*kind*/,
                 std::span<const Index> elements, const ParameterValues& parameters) const override {
    MeshEdit edit = with_same_elements(mesh);
    edit.mesh.tags = with_sharpness(mesh.tags, topology, elements, number_of(parameters, "value"));
    return edit;
  }
};

}  // namespace

std::unique_ptr<const Edit> make_sharpness_edit() { return std::make_unique<SharpnessEdit>(); }

}  // namespace croquis
