// SPDX-License-Identifier: GPL-3.0-or-later
#include <numbers>

#include "croquis/base/error.h"
#include "edits/edit_parameters.h"
#include "edits/moved_vertices.h"
#include "edits/one_edit.h"

namespace croquis {
namespace {

class RotateEdit final : public Edit {
 public:
  EditDescription describe() const override {
    return {
        "rotate",
        "Rotate",
        "Rotates vertices, or those of edges and faces, about a point.",
        {ComponentKind::Vertex, ComponentKind::Edge, ComponentKind::Face},
        {text_parameter("axis", "0,0,1", "The axis; its length doesn't matter.").titled("Axis x, y, z"),
         number_parameter("degrees", 90, -3600, 3600, "degrees", "The angle, counter-clockwise seen against the axis.")
             .titled("Angle"),
         text_parameter("about", "", "A point on the axis; if not given, the mean of the vertices.")
             .titled("About x, y, z")}};
  }

  MeshEdit apply(const PolyMesh& mesh, const MeshTopology& topology, ComponentKind kind,
                 std::span<const Index> elements, const ParameterValues& parameters) const override {
    const Vec3 axis = vector_of(parameters, "axis", Vec3::UnitZ());
    if (axis.isZero(0)) throw Error(make_error(Category::Usage, "E_INPUT", "The axis of the rotation has no length"));
    const Vec3 about = pivot_of(mesh, topology, kind, elements, parameters);
    const double radians = number_of(parameters, "degrees") * std::numbers::pi / 180;
    Eigen::Affine3d map = Eigen::Affine3d::Identity();
    map.translate(about).rotate(Eigen::AngleAxisd(radians, axis.normalized())).translate(-about);
    return with_vertices_moved(mesh, topology, kind, elements, map);
  }
};

}  // namespace

std::unique_ptr<const Edit> make_rotate_edit() { return std::make_unique<RotateEdit>(); }

}  // namespace croquis
