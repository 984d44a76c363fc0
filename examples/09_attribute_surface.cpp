// SPDX-License-Identifier: GPL-3.0-or-later
// Curves in space become smooth patches that a point pulls: 09_attribute_surface SURFACE.obj
#include <iostream>

#include "croquis/attribute_surface/attribute_surface.h"
#include "croquis/attribute_surface/surface_measures.h"
#include "croquis/attribute_surface/surface_tessellation.h"
#include "croquis/base/error.h"
#include "croquis/io/file.h"
#include "croquis/io/mesh_file.h"

namespace {

using namespace croquis;

/// A tent: two faces that meet smoothly in the ridge between the poles, one of three curves, one of four.
AttributeNetwork tent() {
  AttributeNetwork network;
  network.name = "tent";
  network.nodes = {{"front", {0, 0, 2}},
                   {"back", {3, 0, 1.6}},
                   {"left", {1.2, 2.2, 0}},
                   {"right front", {0, -2, 0.4}},
                   {"right back", {3, -2, 0}}};
  network.curves = {{"ridge", 0, 1, {{0, 0, 2}, {1, 0, 1.6}, {2, 0, 1.4}, {3, 0, 1.6}}, CurveJoin::Smooth},
                    {"back left", 1, 2, {{3, 0, 1.6}, {2.3, 0.8, 1}, {1.7, 1.5, 0.4}, {1.2, 2.2, 0}}},
                    {"front left", 2, 0, {{1.2, 2.2, 0}, {0.9, 1.5, 0.5}, {0.4, 0.7, 1.4}, {0, 0, 2}}},
                    {"front right", 3, 0, {{0, -2, 0.4}, {0.1, -1.2, 0.9}, {0, -0.6, 1.4}, {0, 0, 2}}},
                    {"hem", 4, 3, {{3, -2, 0}, {2, -1.7, 0.3}, {1, -1.7, 0.4}, {0, -2, 0.4}}},
                    {"back right", 1, 4, {}}};  // straight
  network.faces.resize(2);
  network.faces[0].id = "left wing";
  network.faces[0].loop = {{0, false}, {1, false}, {2, false}};
  network.faces[1].id = "right wing";
  network.faces[1].loop = {{0, true}, {3, true}, {4, true}, {5, true}};
  return network;
}

}  // namespace

int main(int argc, char** argv) try {
  if (argc != 2) return 2;
  Progress progress;
  AttributeNetwork network = tent();
  const AttributeSurface slack = make_attribute_surface(network, progress);

  // A third pole under the right wing: where its surface is now, and half a metre higher.
  const FaceSurface& wing = *slack.faces[1].surface;
  const Vec3 below = wing.at(wing.domain().middle);
  PointAttribute pole{"pole", 1, below + Vec3(0, 0, 0.5), FanPlace{0, 0, 0}, {}, PointProfile::Smooth, {}};
  pole.radius = 0.6;
  network.points.push_back(pole);

  const AttributeSurface surface = make_attribute_surface(network, progress);
  for (const Finding& finding : surface.findings) std::cout << finding.code << ": " << finding.message << "\n";
  const SurfaceMeasures measures = measure(network, surface);
  std::cout << "the wing was at " << below.transpose() << "\n"
            << "the pole is met within " << measures.point_errors[0].value_or(-1) << "\n"
            << "normals along the ridge differ by " << measures.largest_normal_jump << " radians at most\n";

  const SurfaceTessellation triangles = tessellate(network, surface, progress);
  OutputTransaction output;
  output.add(argv[1], write_mesh(triangles.mesh, MeshFormat::Obj, {}, progress).bytes);
  output.commit();
  std::cout << triangles.mesh.face_count() << " triangles in " << triangles.parts.size() << " faces\n";
  return triangles.parts.size() == 2 && measures.point_errors[0].value_or(1) < 1e-12 ? 0 : 1;
} catch (const croquis::Error& error) {
  for (const croquis::Finding& finding : error.findings()) std::cerr << finding.code << ": " << finding.message << "\n";
  return 1;
}
