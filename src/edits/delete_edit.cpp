// SPDX-License-Identifier: GPL-3.0-or-later
#include "edits/one_edit.h"

namespace croquis {
namespace {

class DeleteEdit final : public Edit {
 public:
  EditDescription describe() const override {
    return {"delete", "Delete", "Removes faces, and the vertices that only they had.", {ComponentKind::Face}, {}};
  }

  MeshEdit apply(const PolyMesh& mesh, const MeshTopology& topology, ComponentKind /*kind*/,
                 std::span<const Index> elements, const ParameterValues& /*parameters*/) const override {
    return delete_faces(mesh, topology, elements);
  }
};

}  // namespace

std::unique_ptr<const Edit> make_delete_edit() { return std::make_unique<DeleteEdit>(); }

}  // namespace croquis
