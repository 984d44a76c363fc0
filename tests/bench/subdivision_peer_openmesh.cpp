// SPDX-License-Identifier: GPL-3.0-or-later
#include <vector>

#include <OpenMesh/Core/Mesh/PolyMesh_ArrayKernelT.hh>
#include <OpenMesh/Tools/Subdivider/Uniform/CatmullClarkT.hh>

#include "bench/cpu_time.h"
#include "bench/subdivision_peers.h"

namespace croquis::bench {
namespace {

struct Traits : OpenMesh::DefaultTraits {
  using Point = OpenMesh::Vec3d;
  using Normal = OpenMesh::Vec3d;
};
using Mesh = OpenMesh::PolyMesh_ArrayKernelT<Traits>;

}  // namespace

double openmesh_catmull_clark_ms(const PolyMesh& mesh, int levels) {
  Mesh surface;
  for (const Vec3& p : mesh.positions) surface.add_vertex({p.x(), p.y(), p.z()});
  std::vector<Mesh::VertexHandle> corners;
  for (std::size_t f = 0; f < mesh.face_count(); ++f) {
    corners.clear();
    for (const Index v : mesh.face(f)) corners.emplace_back(static_cast<int>(v));
    surface.add_face(corners);
  }
  OpenMesh::Subdivider::Uniform::CatmullClarkT<Mesh, double> subdivider;
  subdivider.attach(surface);
  const double ms = cpu_ms([&] { subdivider(static_cast<std::size_t>(levels)); });
  subdivider.detach();
  return ms;
}

}  // namespace croquis::bench
