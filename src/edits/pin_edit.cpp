// SPDX-License-Identifier: GPL-3.0-or-later
#include "croquis/mesh_editing/tag_edit.h"
#include "edits/moved_vertices.h"
#include "edits/one_edit.h"

namespace croquis {
namespace {

class PinEdit final : public Edit {
 public:
  EditDescription describe() const override {
    return {"pin",
            "Pin",
            "Pins vertices, so that subdivision keeps them where they are, or lets them go.",
            {ComponentKind::Vertex},
            {flag_parameter("pinned", true, "false lets the vertices go.")}};
  }

  MeshEdit apply(const PolyMesh& mesh, const MeshTopology& /*topology*/, ComponentKind /*kind*/,
                 std::span<const Index> elements, const ParameterValues& parameters) const override {
    MeshEdit edit = with_same_elements(mesh);
    edit.mesh.tags = with_pins(mesh.tags, elements, flag_of(parameters, "pinned"));
    return edit;
  }
};

}  // namespace

std::unique_ptr<const Edit> make_pin_edit() { return std::make_unique<PinEdit>(); }

}  // namespace croquis
