// SPDX-License-Identifier: GPL-3.0-or-later
#include "edits/edit_parameters.h"
#include "edits/moved_vertices.h"
#include "edits/one_edit.h"

namespace croquis {
namespace {

class ScaleEdit final : public Edit {
 public:
  EditDescription describe() const override {
    return {"scale",
            "Scale",
            "Scales vertices, or those of edges and faces, from a point.",
            {ComponentKind::Vertex, ComponentKind::Edge, ComponentKind::Face},
            {text_parameter("factors", "1,1,1", "The factors along x, y and z.").titled("Times x, y, z"),
             text_parameter("about", "", "The point that stays; if not given, the mean of the vertices.")
                 .titled("About x, y, z")}};
  }

  MeshEdit apply(const PolyMesh& mesh, const MeshTopology& topology, ComponentKind kind,
                 std::span<const Index> elements, const ParameterValues& parameters) const override {
    const Vec3 about = pivot_of(mesh, topology, kind, elements, parameters);
    Eigen::Affine3d map = Eigen::Affine3d::Identity();
    map.translate(about).scale(vector_of(parameters, "factors", Vec3::Ones())).translate(-about);
    return with_vertices_moved(mesh, topology, kind, elements, map);
  }
};

}  // namespace

std::unique_ptr<const Edit> make_scale_edit() { return std::make_unique<ScaleEdit>(); }

}  // namespace croquis
