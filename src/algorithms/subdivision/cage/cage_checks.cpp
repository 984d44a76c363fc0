// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/subdivision/cage/cage_checks.h"

#include <algorithm>
#include <array>
#include <span>
#include <string>
#include <utility>

#include <Eigen/Geometry>

#include "croquis/geometry/edge_channels.h"
#include "croquis/geometry/polygon_area.h"

namespace croquis::subdivision {
namespace {

constexpr std::size_t max_kept = 100;

/// Sine of the turn to the wrong side at a corner from which a face counts as strongly non-convex; skew polygons
/// have smaller ones anyway.
constexpr double reflex_sine = 0.1;

/// Listed in the one sentence about faces that were turned over.
constexpr std::size_t max_named = 10;

/// Findings of one code, one per element. More than max_kept would hide the others; the last one kept gives their
/// number.
struct FindingList {
  Severity severity;
  std::string code;
  Findings kept = {};
  std::size_t count = 0;

  /// @param sentence without its full stop; called for those that are kept
  template <typename Sentence>
  void add(std::vector<Subject> subjects, const Sentence& sentence) {
    if (++count <= max_kept) kept.push_back({severity, Category::Geometry, code, sentence(), std::move(subjects)});
  }

  void move_to(Findings& findings) {
    if (count > max_kept) kept.back().message += "; " + std::to_string(count - max_kept) + " more are like it";
    for (Finding& finding : kept) {
      finding.message += ".";
      findings.push_back(std::move(finding));
    }
  }
};

Subject face_subject(std::size_t face) { return numbered_subject(SubjectKind::Face, face); }

Subject vertex_subject(std::size_t vertex) { return numbered_subject(SubjectKind::Vertex, vertex); }

std::string edge_name(std::size_t a, std::size_t b) {
  return "edge (" + std::to_string(a) + "," + std::to_string(b) + ")";
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

std::array<Index, 2> edge_ends(const HalfEdges& mesh, const CornerFaces& around, Index edge) {
  const Index corner = mesh.edge_corner[edge];
  return {mesh.corner_vertex[corner], mesh.corner_vertex[around.next(corner)]};
}

/// #V: sharp edges that meet there in the first refinement, boundaries included.
std::vector<Index> sharp_edge_counts(const Cage& cage, const CornerFaces& around) {
  std::vector<Index> counts(cage.topology.vertex_count(), 0);
  for (Index edge = 0; edge < cage.topology.edge_count(); ++edge) {
    if (cage.sharpness[edge] < 1 && cage.topology.twin[cage.topology.edge_corner[edge]] != no_index) continue;
    for (const Index vertex : edge_ends(cage.topology, around, edge)) ++counts[vertex];
  }
  return counts;
}

std::vector<bool> pinned_sources(const PolyMesh& mesh, FindingList& useless) {
  std::vector<bool> pinned(mesh.vertex_count());
  for (const Index vertex : mesh.tags.pins) {
    if (vertex < mesh.vertex_count()) {
      pinned[vertex] = true;
      continue;
    }
    useless.add({vertex_subject(vertex)}, [&] {
      return "There is no vertex " + std::to_string(vertex) + " to pin in a mesh of " +
             std::to_string(mesh.vertex_count()) + " vertices";
    });
  }
  return pinned;
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

void check_sharing(const MeshTopology& topology, Findings& findings) {
  std::vector<std::pair<std::array<Index, 2>, Index>> shared_edges;  // by lower, then higher vertex
  for (Index edge = 0; edge < topology.edge_count(); ++edge) {
    if (topology.edge_corners(edge).size() <= 2) continue;
    const auto [low, high] = std::minmax({topology.edge_vertices(edge)[0], topology.edge_vertices(edge)[1]});
    shared_edges.push_back({{low, high}, edge});
  }
  std::sort(shared_edges.begin(), shared_edges.end());
  FindingList shared{Severity::Error, "E_EDGE_SHARED"};
  for (const auto& [ends, edge] : shared_edges) {
    const std::array<Index, 2> vertices = topology.edge_vertices(edge);
    std::vector<std::size_t> faces;
    std::vector<Subject> subjects = {edge_subject(vertices[0], vertices[1])};
    for (const Index corner : topology.edge_corners(edge)) {
      faces.push_back(topology.face(corner));
      subjects.push_back(face_subject(faces.back()));
    }
    shared.add(std::move(subjects), [&] {
      return edge_name(vertices[0], vertices[1]) + " is shared by faces " + listed(faces) +
             ": split it, so that at most two meet there";
    });
  }
  shared.move_to(findings);
}

void check_orientable(const MeshTopology& topology, const std::vector<Index>& conflicts, Findings& findings) {
  FindingList failed{Severity::Error, "E_NOT_ORIENTABLE"};
  for (const Index corner : conflicts) {
    if (corner == no_index) continue;
    const Index from = topology.vertex(corner), to = topology.vertex(topology.next(corner));
    failed.add({edge_subject(from, to)}, [&] {
      return "The surface has one side only: at " + edge_name(from, to) +
             " its faces can't agree which way to turn; cut it open there";
    });
  }
  failed.move_to(findings);
}

void report_flipped(const std::vector<Index>& faces, Findings& findings) {
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

void report_fans(const MeshTopology& topology, Findings& findings) {
  FindingList split{Severity::Warning, "W_BOWTIE"};
  FindingList loose{Severity::Warning, "W_LOOSE_VERTEX"};
  for (Index vertex = 0; vertex < topology.vertex_count(); ++vertex) {
    const Index fans = topology.fan_count(vertex);
    if (fans > 1) {
      split.add({vertex_subject(vertex)}, [&] {
        return "Surfaces touch in vertex " + std::to_string(vertex) + " alone: each is refined on its own";
      });
    } else if (fans == 0) {
      loose.add({vertex_subject(vertex)}, [&] {
        return "Vertex " + std::to_string(vertex) + " belongs to no face: it stays in the cage and isn't refined";
      });
    }
  }
  split.move_to(findings);
  loose.move_to(findings);
}

void report_reflex_corners(const PolyMesh& mesh, Findings& findings) {
  FindingList folds{Severity::Warning, "W_MAY_FOLD"};
  for (std::size_t face = 0; face < mesh.face_count(); ++face) {
    if (mesh.face(face).size() < 4 || !has_strong_reflex_corner(mesh, mesh.face(face))) continue;
    folds.add({face_subject(face)}, [face] {
      return "Face " + std::to_string(face) + " is far from convex, so the surface may fold there: split it";
    });
  }
  folds.move_to(findings);
}

void read_sharpness(const PolyMesh& mesh, const MeshTopology& topology, const std::vector<Index>& cage_corner,
                    Cage& cage, Findings& warnings) {
  cage.sharpness.assign(cage.topology.edge_count(), 0);
  FindingList no_edge{Severity::Warning, "W_TAG_NO_EDGE"};
  FindingList bad_value{Severity::Warning, "W_TAG_SHARPNESS"};
  for (const Crease& crease : mesh.tags.creases) {
    const Index a = crease.vertices[0], b = crease.vertices[1];
    const Index edge = find_edge(topology, a, b);
    if (edge == no_index) {
      no_edge.add({edge_subject(a, b)}, [&] {
        return "A tag names " + edge_name(a, b) + ", but no edge joins these vertices: it is left out";
      });
    } else if (!(crease.sharpness >= 0)) {
      bad_value.add({edge_subject(a, b)}, [&] {
        return "The tag of " + edge_name(a, b) +
               " is left out: its sharpness is negative or no number, where 0 to 10 or infinite is meant";
      });
    } else {
      const Index half_edge = cage_corner[topology.edge_corners(edge).front()];
      cage.sharpness[cage.topology.corner_edge[half_edge]] =
          crease.sharpness > greatest_sharpness ? infinite_sharpness : crease.sharpness;
    }
  }
  no_edge.move_to(warnings);
  bad_value.move_to(warnings);
}

void read_pins(const PolyMesh& mesh, CageUse use, Cage& cage, Findings& warnings) {
  cage.pinned.assign(cage.topology.vertex_count(), 0);
  if (mesh.tags.pins.empty()) return;
  FindingList useless{Severity::Warning, "W_PIN_NO_EFFECT"};
  const std::vector<bool> pinned = pinned_sources(mesh, useless);
  const std::vector<Index> sharp_edges = sharp_edge_counts(cage, CornerFaces(cage.topology));
  std::vector<bool> works(mesh.vertex_count(), use == CageUse::UniformSchemes);
  for (Index vertex = 0; vertex < cage.topology.vertex_count(); ++vertex) {
    const Index source = cage.source_vertex[vertex];
    cage.pinned[vertex] = pinned[source];
    if (sharp_edges[vertex] > 0) works[source] = true;
  }
  for (std::size_t vertex = 0; vertex < mesh.vertex_count(); ++vertex) {
    if (!pinned[vertex] || works[vertex]) continue;
    useless.add({vertex_subject(vertex)}, [vertex] {
      return "Vertex " + std::to_string(vertex) + " is pinned, but no sharp edge ends there: the pin changes nothing";
    });
  }
  useless.move_to(warnings);
}

void report_vanishing_tags(const Cage& cage, const Rules& rules, Findings& warnings) {
  if (rules.chain_ends != ChainEnds::Retract) return;
  FindingList vanishing{Severity::Warning, "W_TAG_VANISHES"};
  const CornerFaces around(cage.topology);
  const std::vector<Index> sharp_edges = sharp_edge_counts(cage, around);
  for (Index edge = 0; edge < cage.topology.edge_count(); ++edge) {
    if (cage.sharpness[edge] < 1) continue;
    const auto [a, b] = edge_ends(cage.topology, around, edge);
    if (sharp_edges[a] != 1 || sharp_edges[b] != 1 || cage.pinned[a] != 0 || cage.pinned[b] != 0) continue;
    const Index source_a = cage.source_vertex[a], source_b = cage.source_vertex[b];
    vanishing.add({edge_subject(source_a, source_b)}, [source_a, source_b] {
      return "The tag of " + edge_name(source_a, source_b) +
             " stands alone and shrinks to the middle of its edge: pin its ends, or let chain ends be smooth";
    });
  }
  vanishing.move_to(warnings);
}

}  // namespace croquis::subdivision
