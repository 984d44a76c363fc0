// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/files/project_files.h"
#include "croquis/base/error.h"
#include "croquis/tools/perspective/sheet_units.h"

namespace croquis::app {

double ProjectFiles::export_scale(const MeshExport& wanted) const {
  const double unit = metres_of_unit(wanted.unit), own = metres_of_unit(studio_.unit().empty() ? "mm" : studio_.unit());
  return unit > 0 && own > 0 ? own / unit : 1;
}

std::vector<NamedMesh> ProjectFiles::meshes_of(const MeshExport& wanted) const {
  std::vector<NodeId> nodes;
  if (wanted.objects == MeshExport::Objects::Picked) nodes = studio_.picked_or_active();
  for (const WorkObject& object : studio_.objects()) {
    const bool all = wanted.objects == MeshExport::Objects::All;
    if (all || (wanted.objects == MeshExport::Objects::Visible && object.visible)) nodes.push_back(object.node);
  }
  if (nodes.empty()) throw Error(make_error(Category::Geometry, "E_EMPTY", "There is no mesh to export"));
  const Affine3 scaling{export_scale(wanted) * Eigen::Matrix3d::Identity(), Vec3::Zero()};
  std::vector<NamedMesh> meshes;
  for (const NodeId node : nodes) {
    const WorkObject& object = *studio_.object(node);
    const auto& mesh = object.shown();
    const bool computed = mesh && object.result && mesh == object.mesh;
    if (!mesh || (computed && (object.result->failed || object.quality != Quality::Final))) {
      const std::string name = nodes.size() == 1 ? std::string() : " of \"" + readable_name(object.name) + '"';
      const char* cure = object.visible ? ": wait until it is computed" : ": show it first, so that it is computed";
      throw Error(
          make_error(Category::Geometry, "E_EMPTY", "There is no finished mesh" + name + " to export yet" + cure));
    }
    meshes.push_back({readable_name(object.name), mesh, composed(scaling, object.placement.map())});
  }
  return meshes;
}

std::shared_ptr<const PolyMesh> ProjectFiles::exported_mesh(const MeshExport& wanted) const {
  const std::vector<NamedMesh> meshes = meshes_of(wanted);
  const Affine3& map = meshes.front().map;
  const bool unmoved = map == Affine3{};
  if (meshes.size() == 1 && unmoved) return meshes.front().mesh;
  return std::make_shared<const PolyMesh>(joined(meshes));
}

}  // namespace croquis::app
