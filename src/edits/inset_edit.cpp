// SPDX-License-Identifier: GPL-3.0-or-later
#include "edits/edit_parameters.h"
#include "edits/one_edit.h"

namespace croquis {
namespace {

class InsetEdit final : public Edit {
 public:
  EditDescription describe() const override {
    return {"inset",
            "Inset",
            "Draws the border of faces inwards and fills the strip between with quads.",
            {ComponentKind::Face},
            {number_parameter("width", 0, 0, unlimited_value, "model units", "Width of the strip.")},
            EditStart{"width", 0.1}};
  }

  MeshEdit apply(const PolyMesh& mesh, const MeshTopology& topology, ComponentKind /*kind*/,
                 std::span<const Index> elements, const ParameterValues& parameters) const override {
    return inset_faces(mesh, topology, elements, number_of(parameters, "width"));
  }
};

}  // namespace

std::unique_ptr<const Edit> make_inset_edit() { return std::make_unique<InsetEdit>(); }

}  // namespace croquis
