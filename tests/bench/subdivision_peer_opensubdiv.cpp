// SPDX-License-Identifier: GPL-3.0-or-later
#include <vector>

#include <opensubdiv/far/primvarRefiner.h>
#include <opensubdiv/far/topologyDescriptor.h>

#include "bench/cpu_time.h"
#include "bench/subdivision_peers.h"

namespace croquis::bench {
namespace {

namespace Far = OpenSubdiv::Far;
namespace Sdc = OpenSubdiv::Sdc;

struct Point {
  float x = 0, y = 0, z = 0;

  void Clear() { x = y = z = 0; }
  void AddWithWeight(const Point& other, float weight) {
    x += weight * other.x;
    y += weight * other.y;
    z += weight * other.z;
  }
};

}  // namespace

struct OpenSubdivPeer::State {
  int levels;
  std::vector<int> face_sizes, corners;
  std::unique_ptr<Far::TopologyRefiner> refiner;
  std::vector<std::vector<Point>> points;

  void refine_topology() {
    Far::TopologyDescriptor descriptor;
    descriptor.numVertices = static_cast<int>(points.front().size());
    descriptor.numFaces = static_cast<int>(face_sizes.size());
    descriptor.numVertsPerFace = face_sizes.data();
    descriptor.vertIndicesPerFace = corners.data();
    using Factory = Far::TopologyRefinerFactory<Far::TopologyDescriptor>;
    refiner.reset(Factory::Create(descriptor, Factory::Options(Sdc::SCHEME_CATMARK, Sdc::Options())));
    Far::TopologyRefiner::UniformOptions options(levels);
    options.fullTopologyInLastLevel = true;  // ours is too
    refiner->RefineUniform(options);
  }

  void compute_positions() {
    const Far::PrimvarRefiner primvars(*refiner);
    for (int k = 1; k <= levels; ++k) {
      auto& level = points[static_cast<std::size_t>(k)];
      level.resize(static_cast<std::size_t>(refiner->GetLevel(k).GetNumVertices()));
      primvars.Interpolate(k, points[static_cast<std::size_t>(k - 1)], level);
    }
  }
};

OpenSubdivPeer::OpenSubdivPeer(const PolyMesh& mesh, int levels) : state_(std::make_unique<State>()) {
  state_->levels = levels;
  for (std::size_t f = 0; f < mesh.face_count(); ++f)
    state_->face_sizes.push_back(static_cast<int>(mesh.face(f).size()));
  state_->corners.assign(mesh.corners.begin(), mesh.corners.end());
  state_->points.resize(static_cast<std::size_t>(levels) + 1);
  for (const Vec3& p : mesh.positions) {
    state_->points[0].push_back({static_cast<float>(p.x()), static_cast<float>(p.y()), static_cast<float>(p.z())});
  }
}

OpenSubdivPeer::~OpenSubdivPeer() = default;

double OpenSubdivPeer::refine_ms() {
  for (std::size_t k = 1; k < state_->points.size(); ++k) state_->points[k] = {};
  return cpu_ms([&] {
    state_->refine_topology();
    state_->compute_positions();
  });
}

double OpenSubdivPeer::positions_ms() {
  return cpu_ms([&] { state_->compute_positions(); });
}

}  // namespace croquis::bench
