// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/subdivision/cage/cage_checks.h"

#include <algorithm>
#include <numeric>
#include <utility>

#include <Eigen/Geometry>

#include "croquis/geometry/face_orientation.h"
#include "croquis/geometry/polygon_area.h"

namespace croquis::subdivision {
namespace {

/// Calls use(corner, low end, high end) for each corner of the faces that count.
template <typename Use>
void for_each_half_edge(const PolyMesh& mesh, const std::vector<bool>& left_out, Use&& use) {
  for (std::size_t face = 0; face < mesh.face_count(); ++face) {
    if (left_out[face]) continue;
    const Index begin = mesh.face_offsets[face], end = mesh.face_offsets[face + 1];
    Index from = mesh.corners[end - 1];
    for (Index corner = end - 1, next = begin; next < end; corner = next++) {
      const Index to = mesh.corners[next];
      use(corner, std::min(from, to), std::max(from, to));
      from = to;
    }
  }
}

/// The neighbour across each corner's edge, and whether both run the same way.
struct Neighbours {
  std::vector<Index> face;  ///< #C
  std::vector<bool> disagrees;
};

std::vector<Index> faces_of_corners(const PolyMesh& mesh) {
  std::vector<Index> faces(mesh.corners.size());
  for (Index face = 0; face < mesh.face_count(); ++face) {
    std::fill(faces.begin() + mesh.face_offsets[face], faces.begin() + mesh.face_offsets[face + std::size_t{1}], face);
  }
  return faces;
}

Neighbours find_neighbours(const PolyMesh& mesh, const EdgePairing& pairing) {
  const std::vector<Index> face_of = faces_of_corners(mesh);
  Neighbours neighbours{std::vector<Index>(mesh.corners.size(), no_index), std::vector<bool>(mesh.corners.size())};
  pairing.for_each_edge([&](std::span<const Index> corners) {
    if (corners.size() != 2) return;
    const auto [a, b] = std::pair(corners[0], corners[1]);
    neighbours.face[a] = face_of[b];
    neighbours.face[b] = face_of[a];
    neighbours.disagrees[a] = neighbours.disagrees[b] = mesh.corners[a] == mesh.corners[b];
  });
  return neighbours;
}

/// The vertices of the edge that begins at a corner.
std::array<Index, 2> ends_of(const PolyMesh& mesh, Index corner) {
  const auto after = std::upper_bound(mesh.face_offsets.begin(), mesh.face_offsets.end(), corner);
  const Index next = corner + 1 == *after ? *(after - 1) : corner + 1;
  return {mesh.corners[corner], mesh.corners[next]};
}

struct Fan {
  Index vertex;        ///< before the split
  Index first_corner;  ///< from which turning counter-clockwise reaches all
};

/// The clockwise end of the fan, or the corner itself where it closes.
Index fan_start(const HalfEdges& mesh, const CornerFaces& around, Index corner) {
  Index start = corner;
  while (mesh.twin[start] != no_index) {
    start = around.next(mesh.twin[start]);
    if (start == corner) break;
  }
  return start;
}

/// Fans by their lowest corners; sets the fan of each corner.
std::vector<Fan> number_fans(const HalfEdges& mesh, std::vector<Index>& fan_of_corner) {
  const CornerFaces around(mesh);
  std::vector<Fan> fans;
  fan_of_corner.assign(mesh.corner_count(), no_index);
  for (Index corner = 0; corner < mesh.corner_count(); ++corner) {
    if (fan_of_corner[corner] != no_index) continue;
    const auto fan = static_cast<Index>(fans.size());
    fans.push_back({mesh.corner_vertex[corner], fan_start(mesh, around, corner)});
    for (Index c = fans.back().first_corner; c != no_index && fan_of_corner[c] == no_index;
         c = mesh.twin[around.previous(c)]) {
      fan_of_corner[c] = fan;
    }
  }
  return fans;
}

constexpr std::size_t max_kept = 100;

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

EdgePairing::EdgePairing(const PolyMesh& mesh, const std::vector<bool>& left_out)
    : low_offsets_(mesh.vertex_count() + 1, 0) {
  for_each_half_edge(mesh, left_out, [&](Index, Index low, Index) { ++low_offsets_[low + std::size_t{1}]; });
  std::partial_sum(low_offsets_.begin(), low_offsets_.end(), low_offsets_.begin());

  std::vector<std::pair<Index, Index>> high_and_corner(low_offsets_.back());
  std::vector<Index> free_place(low_offsets_.begin(), low_offsets_.end() - 1);
  for_each_half_edge(mesh, left_out, [&](Index corner, Index low, Index high) {
    high_and_corner[free_place[low]++] = {high, corner};
  });

  entries_.resize(high_and_corner.size());
  corners_.resize(high_and_corner.size());
  for (Index low = 0; low < mesh.vertex_count(); ++low) {
    const Index begin = low_offsets_[low], end = low_offsets_[low + std::size_t{1}];
    std::sort(high_and_corner.begin() + begin, high_and_corner.begin() + end);
    for (Index i = begin; i < end; ++i) {
      entries_[i] = {low, high_and_corner[i].first};
      corners_[i] = high_and_corner[i].second;
    }
  }
}

std::span<const Index> EdgePairing::corners(Index a, Index b) const {
  const auto [low, high] = std::minmax(a, b);
  if (high + std::size_t{1} >= low_offsets_.size()) return {};
  const auto begin = entries_.begin() + low_offsets_[low];
  const auto end = entries_.begin() + low_offsets_[low + std::size_t{1}];
  const auto first = std::lower_bound(begin, end, high, [](const Entry& e, Index value) { return e.high < value; });
  const auto last = std::upper_bound(first, end, high, [](Index value, const Entry& e) { return value < e.high; });
  return std::span<const Index>(corners_).subspan(static_cast<std::size_t>(first - entries_.begin()),
                                                  static_cast<std::size_t>(last - first));
}

Orientation orient(const PolyMesh& mesh, const EdgePairing& pairing) {
  const Neighbours neighbours = find_neighbours(mesh, pairing);
  const FaceOrientation found = orient_faces(mesh.face_count(), [&](Index face, auto&& visit) {
    for (Index corner = mesh.face_offsets[face]; corner < mesh.face_offsets[face + std::size_t{1}]; ++corner) {
      if (neighbours.face[corner] != no_index) visit(corner, neighbours.face[corner], neighbours.disagrees[corner]);
    }
  });
  Orientation orientation{{found.turned.begin(), found.turned.end()}, {}};
  for (const Index corner : found.conflict) {
    if (corner != no_index) orientation.contradictions.push_back(ends_of(mesh, corner));
  }
  return orientation;
}

VertexFans split_vertices_into_fans(HalfEdges& mesh, std::size_t vertex_count) {
  std::vector<Index> fan_of_corner;
  const std::vector<Fan> fans = number_fans(mesh, fan_of_corner);

  VertexFans result;
  std::vector<Index> offsets(vertex_count + 1, 0);
  for (const Fan& fan : fans) ++offsets[fan.vertex + std::size_t{1}];
  for (Index vertex = 0; vertex < vertex_count; ++vertex) {
    if (offsets[vertex + std::size_t{1}] == 0) result.loose.push_back(vertex);
    if (offsets[vertex + std::size_t{1}] > 1) result.split.push_back(vertex);
  }
  std::partial_sum(offsets.begin(), offsets.end(), offsets.begin());

  result.source_vertex.resize(fans.size());
  mesh.vertex_corner.resize(fans.size());
  std::vector<Index> number(fans.size());
  for (std::size_t fan = 0; fan < fans.size(); ++fan) {
    number[fan] = offsets[fans[fan].vertex]++;
    result.source_vertex[number[fan]] = fans[fan].vertex;
    mesh.vertex_corner[number[fan]] = fans[fan].first_corner;
  }
  for (std::size_t corner = 0; corner < mesh.corner_count(); ++corner) {
    mesh.corner_vertex[corner] = number[fan_of_corner[corner]];
  }
  return result;
}

FindingList::FindingList(Severity severity, Category category, std::string code)
    : severity_(severity), category_(category), code_(std::move(code)) {}

void FindingList::add(std::vector<Subject> subjects, const std::function<std::string()>& sentence) {
  if (++count_ > max_kept) return;
  kept_.push_back({severity_, category_, code_, sentence(), std::move(subjects)});
}

void FindingList::move_to(Findings& findings) {
  if (count_ > max_kept) kept_.back().message += "; " + std::to_string(count_ - max_kept) + " more are like it";
  for (Finding& finding : kept_) {
    finding.message += ".";
    findings.push_back(std::move(finding));
  }
  kept_.clear();
  count_ = 0;
}

Subject face_subject(std::size_t face) { return numbered_subject(SubjectKind::Face, face); }

Subject vertex_subject(std::size_t vertex) { return numbered_subject(SubjectKind::Vertex, vertex); }

std::string edge_name(std::size_t a, std::size_t b) {
  return "edge (" + std::to_string(a) + "," + std::to_string(b) + ")";
}

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

void read_sharpness(const TagSource& source, Cage& cage, Findings& warnings) {
  cage.sharpness.assign(cage.topology.edge_count(), 0);
  FindingList no_edge(Severity::Warning, Category::Geometry, "W_TAG_NO_EDGE");
  FindingList bad_value(Severity::Warning, Category::Geometry, "W_TAG_SHARPNESS");
  for (const auto& [vertices, sharpness] : source.mesh.tags.creases) {
    const auto [a, b] = vertices;
    const auto corners = source.pairing.corners(a, b);
    if (corners.empty()) {
      no_edge.add({edge_subject(a, b)}, [a = a, b = b] {
        return "A tag names " + edge_name(a, b) + ", but no edge joins these vertices: it is left out";
      });
    } else if (!(sharpness >= 0)) {
      bad_value.add({edge_subject(a, b)}, [a = a, b = b] {
        return "The tag of " + edge_name(a, b) +
               " is left out: its sharpness is negative or no number, where 0 to 10 or infinite is meant";
      });
    } else {
      const Index edge = cage.topology.corner_edge[source.cage_corner[corners.front()]];
      cage.sharpness[edge] = sharpness > greatest_sharpness ? infinite_sharpness : sharpness;
    }
  }
  no_edge.move_to(warnings);
  bad_value.move_to(warnings);
}

void read_pins(const PolyMesh& mesh, CageUse use, Cage& cage, Findings& warnings) {
  cage.pinned.assign(cage.topology.vertex_count(), 0);
  if (mesh.tags.pins.empty()) return;
  FindingList useless(Severity::Warning, Category::Geometry, "W_PIN_NO_EFFECT");
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

void tell_vanishing_tags(const Cage& cage, const Rules& rules, Findings& warnings) {
  if (rules.chain_ends != ChainEnds::Retract) return;
  FindingList vanishing(Severity::Warning, Category::Geometry, "W_TAG_VANISHES");
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
