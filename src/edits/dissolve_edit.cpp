// SPDX-License-Identifier: GPL-3.0-or-later
#include "edits/one_edit.h"

namespace croquis {
namespace {

class DissolveEdit final : public Edit {
 public:
  EditDescription describe() const override {
    return {"dissolve",
            "Dissolve",
            "Removes edges or vertices and makes one face of those around each.",
            {ComponentKind::Edge, ComponentKind::Vertex},
            {}};
  }

  MeshEdit apply(const PolyMesh& mesh, const MeshTopology& topology, ComponentKind kind,
                 std::span<const Index> elements, const ParameterValues& /*parameters*/) const override {
    return kind == ComponentKind::Edge ? dissolve_edges(mesh, topology, elements)
                                       : dissolve_vertices(mesh, topology, elements);
  }
};

}  // namespace

std::unique_ptr<const Edit> make_dissolve_edit() { return std::make_unique<DissolveEdit>(); }

}  // namespace croquis
