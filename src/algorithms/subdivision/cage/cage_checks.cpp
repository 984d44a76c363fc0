// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/subdivision/cage/cage_checks.h"

#include <algorithm>
#include <string>
#include <utility>

#include <Eigen/Geometry>

#include "algorithms/subdivision/cage/finding_list.h"
#include "croquis/geometry/polygon_area.h"

namespace croquis::subdivision {
namespace {

/// Sine of the turn to the wrong side at a corner from which a face counts as strongly non-convex; skew polygons
/// have smaller ones anyway.
constexpr double reflex_sine = 0.1;

/// Listed in the one sentence about faces that were turned over.
constexpr std::size_t max_named = 10;

/// The face that holds a corner.
std::size_t face_of_corner(const PolyMesh& mesh, Index corner) {
  const auto after = std::upper_bound(mesh.face_offsets.begin(), mesh.face_offsets.end(), corner);
  return static_cast<std::size_t>(after - mesh.face_offsets.begin()) - 1;
}

Index next_vertex(const PolyMesh& mesh, Index corner) {
  const std::size_t face = face_of_corner(mesh, corner);
  return mesh.corners[corner + std::size_t{1} == mesh.face_offsets[face + 1] ? mesh.face_offsets[face] : corner + 1];
}

/// "1, 2, 3", or the first ten and how many more.
std::string listed(const std::vector<std::size_t>& ids) {
  std::string text;
  for (std::size_t i = 0; i < std::min(ids.size(), max_named); ++i)
    text += (i > 0 ? ", " : "") + std::to_string(ids[i]);
  if (ids.size() > max_named) text += " and " + std::to_string(ids.size() - max_named) + " more";
  return text;
}

bool has_strong_reflex_corner(const PolyMesh& mesh, std::span<const Index> face) {
  const auto point = [&](std::size_t i) -> const Vec3& { return mesh.positions[face[i % face.size()]]; };
  const Vec3 normal = area_normal(mesh.positions, face).normalized();
  for (std::size_t i = 0; i < face.size(); ++i) {
    const Vec3 arriving = point(i + 1) - point(i), leaving = point(i + 2) - point(i + 1);
    if (arriving.cross(leaving).dot(normal) < -reflex_sine * arriving.norm() * leaving.norm()) return true;
  }
  return false;
}

}  // namespace

Findings check_values(const PolyMesh& mesh) {
  Findings findings = validate(mesh);
  std::erase_if(findings, [](const Finding& finding) {
    return finding.code != "E_INDEX" && finding.code != "E_NOT_FINITE" && finding.code != "E_FACE_DEGENERATE";
  });
  for (Finding& finding : findings) {
    if (finding.code == "E_FACE_DEGENERATE") finding.category = Category::Geometry;
  }
  return findings;
}

std::vector<bool> degenerate_faces(const PolyMesh& mesh) {
  std::vector<bool> degenerate(mesh.face_count());
  std::vector<std::size_t> last_face(mesh.vertex_count(), mesh.face_count());
  for (std::size_t face = 0; face < mesh.face_count(); ++face) {
    degenerate[face] = mesh.face(face).size() < 3;
    for (const Index vertex : mesh.face(face)) {
      if (last_face[vertex] == face) degenerate[face] = true;
      last_face[vertex] = face;
    }
  }
  return degenerate;
}

void check_sharing(const PolyMesh& mesh, const EdgePairing& pairing, Findings& findings) {
  FindingList shared(Severity::Error, Category::Geometry, "E_EDGE_SHARED");
  pairing.for_each_edge([&](std::span<const Index> corners) {
    if (corners.size() <= 2) return;
    const Index a = mesh.corners[corners.front()], b = next_vertex(mesh, corners.front());
    std::vector<std::size_t> faces;
    std::vector<Subject> subjects = {edge_subject(a, b)};
    for (const Index corner : corners) {
      faces.push_back(face_of_corner(mesh, corner));
      subjects.push_back(face_subject(faces.back()));
    }
    shared.add(std::move(subjects), [&] {
      return edge_name(a, b) + " is shared by faces " + listed(faces) + ": split it, so that at most two meet there";
    });
  });
  shared.move_to(findings);
}

void check_orientable(const Orientation& orientation, Findings& findings) {
  FindingList failed(Severity::Error, Category::Geometry, "E_NOT_ORIENTABLE");
  for (const auto& [a, b] : orientation.contradictions) {
    failed.add({edge_subject(a, b)}, [a = a, b = b] {
      return "The surface has one side only: at " + edge_name(a, b) +
             " its faces can't agree which way to turn; cut it open there";
    });
  }
  failed.move_to(findings);
}

void tell_flipped(const std::vector<Index>& faces, Findings& findings) {
  if (faces.empty()) return;
  const bool one = faces.size() == 1;
  std::vector<Subject> subjects;
  for (const Index face : faces) subjects.push_back(face_subject(face));
  findings.push_back(
      make_warning(Category::Geometry, "W_FLIPPED",
                   (one ? "1 face was" : std::to_string(faces.size()) + " faces were") +
                       " turned over to agree with the neighbours: " + listed({faces.begin(), faces.end()}) + ".",
                   std::move(subjects)));
}

void tell_fans(const VertexFans& fans, Findings& findings) {
  FindingList split(Severity::Warning, Category::Geometry, "W_BOWTIE");
  for (const Index vertex : fans.split) {
    split.add({vertex_subject(vertex)}, [vertex] {
      return "Surfaces touch in vertex " + std::to_string(vertex) + " alone: each is refined on its own";
    });
  }
  split.move_to(findings);
  FindingList loose(Severity::Warning, Category::Geometry, "W_LOOSE_VERTEX");
  for (const Index vertex : fans.loose) {
    loose.add({vertex_subject(vertex)}, [vertex] {
      return "Vertex " + std::to_string(vertex) + " belongs to no face: it stays in the cage and isn't refined";
    });
  }
  loose.move_to(findings);
}

void tell_reflex_corners(const PolyMesh& mesh, Findings& findings) {
  FindingList folds(Severity::Warning, Category::Geometry, "W_MAY_FOLD");
  for (std::size_t face = 0; face < mesh.face_count(); ++face) {
    if (mesh.face(face).size() < 4 || !has_strong_reflex_corner(mesh, mesh.face(face))) continue;
    folds.add({face_subject(face)}, [face] {
      return "Face " + std::to_string(face) + " is far from convex, so the surface may fold there: split it";
    });
  }
  folds.move_to(findings);
}

}  // namespace croquis::subdivision
