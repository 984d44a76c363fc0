// SPDX-License-Identifier: GPL-3.0-or-later
#include "edits/edit_parameters.h"
#include "edits/moved_vertices.h"
#include "edits/one_edit.h"

namespace croquis {
namespace {

class MoveEdit final : public Edit {
 public:
  EditDescription describe() const override {
    return {"move",
            "Move",
            "Moves vertices, or those of edges and faces.",
            {ComponentKind::Vertex, ComponentKind::Edge, ComponentKind::Face},
            {text_parameter("by", "0,0,0", "How far, along x, y and z, in model units.").titled("By x, y, z")}};
  }

  MeshEdit apply(const PolyMesh& mesh, const MeshTopology& topology, ComponentKind kind,
                 std::span<const Index> elements, const ParameterValues& parameters) const override {
    const Eigen::Affine3d map(Eigen::Translation3d(vector_of(parameters, "by", Vec3::Zero())));
    return with_vertices_moved(mesh, topology, kind, elements, map);
  }
};

}  // namespace

std::unique_ptr<const Edit> make_move_edit() { return std::make_unique<MoveEdit>(); }

}  // namespace croquis
