// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "croquis/attribute_surface/attribute_surface.h"
#include "croquis/base/finding.h"
#include "croquis/geometry/poly_mesh.h"

/// Triangles of attribute surfaces. Faces that share a curve read the same samples of it, so they meet without gaps and
/// no vertex has to be found by its place.
namespace croquis {

class StageCache;

/// Samples along a curve in its own direction, both ends included: ends are the places of its nodes, bit for bit.
struct CurveSamples {
  std::vector<double> at;    ///< fractions of the arc length, ascending from 0 to 1
  std::vector<Vec3> points;  ///< one for each
};

struct SurfaceTessellationOptions {
  std::size_t samples = 16;         ///< parts per curve, 1..1024: rings of a fan around each face's middle
  std::optional<double> tolerance;  ///< model units, > 0: instead, as few triangles as keep to it (chord error)
  bool insert_points = true;        ///< points and inner curves are vertices
  std::size_t most_places = 60000;  ///< with a tolerance: inside a face
  std::vector<CurveSamples> given;  ///< by curve; empty, or an empty element: as above
  int threads = 1;                  ///< that evaluate faces, 0: as many as the machine has; the result is the same
  StageCache* cache = nullptr;      ///< faces from earlier runs, not owned; null: all are made again
};

/// The part of a mesh that is one face.
struct SurfacePart {
  Index face = no_index;
  std::size_t first_triangle = 0;
  std::size_t triangle_count = 0;
  std::vector<Index> vertices;  ///< of the mesh, those inside the face first
  std::vector<Vec2> places;     ///< in the domain, one for each of the vertices
};

struct SurfaceTessellation {
  PolyMesh mesh;                   ///< triangles in groups named after the faces, with the surface's normals at corners
  std::vector<SurfacePart> parts;  ///< of faces that could be evaluated, in their order
  Findings findings;               ///< W_TOLERANCE: faces that a limit keeps from the tolerance
};

/// With even samples a face of N curves has 1 + N n (n + 1) / 2 vertices, those that it shares included, and N n²
/// triangles. Points, and knots of inner curves as far apart as the samples, take the places of the vertices nearest to
/// them; those that find none left near them are added. A curve of a face of two has an even number of parts, since its
/// middle is a corner of the domain: such a face is a fan of four sides with n / 2 parts each.
/// @throws Cancelled
SurfaceTessellation tessellate(const AttributeNetwork& network, const AttributeSurface& surface, Progress& progress,
                               const SurfaceTessellationOptions& options = {});

}  // namespace croquis
