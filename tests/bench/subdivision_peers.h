// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>

#include "croquis/geometry/poly_mesh.h"

/// Other libraries' uniform subdivision of closed meshes, measured without the conversion to their mesh and back.
namespace croquis::bench {

double cgal_doo_sabin_ms(const PolyMesh& mesh, int levels);
double openmesh_catmull_clark_ms(const PolyMesh& mesh, int levels);

/// OpenSubdiv's uniform Catmull-Clark refinement: topology of all levels, and positions of all levels in single
/// precision.
class OpenSubdivPeer {
 public:
  OpenSubdivPeer(const PolyMesh& mesh, int levels);
  ~OpenSubdivPeer();

  double refine_ms();     ///< topology and positions
  double positions_ms();  ///< positions alone, into memory that is kept

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace croquis::bench
