// SPDX-License-Identifier: GPL-3.0-or-later
#include "croquis/geometry/self_intersection.h"

#include <algorithm>
#include <cstdint>
#include <utility>

#include "croquis/geometry/polygon_cut.h"
#include "geometry/box_tree.h"
#include "geometry/ranked_places.h"
#include "geometry/require_usable.h"
#include "geometry/shared_corners.h"
#include "geometry/spread_stars.h"
#include "geometry/touched_cells.h"
#include "geometry/triangle_meeting.h"

namespace croquis {
namespace {

/// So many leaves of boxes are done between two reports of progress.
constexpr std::size_t leaves_per_report = 512;

/// The triangles with an area of all faces' cuts.
class CutFaces {
 public:
  explicit CutFaces(const PolyMesh& mesh) : mesh_(mesh), meet_(mesh.positions) {
    triangles_.reserve(mesh.face_count());
    faces_.reserve(mesh.face_count());
    first_triangle_.reserve(mesh.face_count() + 1);
    for (Index f = 0; f < mesh.face_count(); ++f) {
      first_triangle_.push_back(triangle_count());
      add_face(f);
    }
    first_triangle_.push_back(triangle_count());
    is_spread_ = spread_stars(mesh.positions, triangles_);
  }

  Index triangle_count() const { return static_cast<Index>(triangles_.size()); }
  Index face(Index triangle) const { return faces_[triangle]; }

  bool meet(Index a, Index b) const {
    const SharedCorners& shared = shared_corners(triangles_[a].vertices, triangles_[b].vertices);
    for (std::size_t i = 0; i < shared.count; ++i) {
      if (is_spread_[triangles_[a].vertices[shared.first[i]]] != 0) return false;
    }
    return meet_(triangles_[a], triangles_[b], shared);
  }

  std::vector<PackedBox> boxes() const {
    const std::vector<PackedPlace> places = places_for_boxes(mesh_.positions, triangles_);
    std::vector<PackedBox> boxes;
    boxes.reserve(triangles_.size());
    for (const auto& [v, longest] : triangles_)
      boxes.push_back(extended(extended({places[v[0]], places[v[0]]}, places[v[1]]), places[v[2]]));
    return boxes;
  }

  /// Whether these two triangles, which meet, are the first pair of their faces that does.
  bool first_of_faces(Index a, Index b) const {
    const Index face_a = face(a);
    const Index face_b = face(b);
    for (Index i = first_triangle_[face_a]; i < first_triangle_[face_a + 1]; ++i) {
      const Index begin = face_a == face_b ? i + 1 : first_triangle_[face_b];
      for (Index j = begin; j < first_triangle_[face_b + 1]; ++j) {
        if (i == a && j == b) return true;
        if (meet(i, j)) return false;
      }
    }
    return true;
  }

 private:
  void add_face(Index f) {
    const auto face = mesh_.face(f);
    visit_triangles(mesh_.positions, face, [&](const std::array<Index, 3>& t) {
      MeetingTriangle triangle;
      if (!meet_.make({face[t[0]], face[t[1]], face[t[2]]}, triangle)) return;
      triangles_.push_back(triangle);
      faces_.push_back(f);
    });
  }

  const PolyMesh& mesh_;
  TriangleMeeting meet_;
  std::vector<MeetingTriangle> triangles_;
  std::vector<char> is_spread_;        ///< per vertex
  std::vector<Index> faces_;           ///< per triangle
  std::vector<Index> first_triangle_;  ///< per face, in triangles_
};

/// Keeps the lexicographically first pairs, whatever order they come in.
class PairList {
 public:
  explicit PairList(std::size_t capacity) : capacity_(capacity) {}

  void add(Index face_a, Index face_b) {
    ++result_.count;
    if (capacity_ == 0) return;
    result_.pairs.push_back({face_a, face_b});
    if (result_.pairs.size() >= 2 * capacity_) keep_first();
  }

  SelfIntersections take() {
    keep_first();
    return std::move(result_);
  }

 private:
  void keep_first() {
    std::sort(result_.pairs.begin(), result_.pairs.end());
    result_.pairs.resize(std::min(result_.pairs.size(), capacity_));
  }

  std::size_t capacity_;
  SelfIntersections result_;
};

/// What is done with each pair of triangles whose boxes meet.
class PairSearch {
 public:
  PairSearch(const CutFaces& cut, std::size_t max_pairs, Progress& progress)
      : cut_(cut), found_(max_pairs), progress_(progress) {}

  void operator()(Index first, Index second) {
    progress_.check();
    const auto [a, b] = std::minmax(first, second);
    if (cut_.meet(a, b) && cut_.first_of_faces(a, b)) found_.add(cut_.face(a), cut_.face(b));
  }

  SelfIntersections finish() {
    progress_.report(1);
    return found_.take();
  }

 private:
  const CutFaces& cut_;
  PairList found_;
  Progress& progress_;
};

void report_leaf(std::size_t leaf, const BoxTree& tree, Progress& progress) {
  if (leaf % leaves_per_report == 0)
    progress.report(static_cast<double>(leaf) / static_cast<double>(tree.leaf_count()));
}

/// The faces that may meet some of them, these among them, by themselves: most of a large mesh is far from a few
/// faces, and costs nothing more.
struct Neighbourhood {
  Neighbourhood(const PolyMesh& whole, std::span<const Index> chosen) {
    const TouchedCells cells(whole, chosen);
    std::vector<Index> numbers(whole.vertex_count(), no_index);
    auto next_chosen = chosen.begin();
    for (Index f = 0; f < whole.face_count(); ++f) {
      if (!cells.may_be_near(f)) continue;
      faces.push_back(f);
      next_chosen = std::lower_bound(next_chosen, chosen.end(), f);
      is_chosen.push_back(next_chosen != chosen.end() && *next_chosen == f ? 1 : 0);
      for (const Index v : whole.face(f)) numbers[v] = 0;
    }
    // In the whole's order, which the cut of polygons looks at.
    for (Index v = 0; v < numbers.size(); ++v) {
      if (numbers[v] == no_index) continue;
      numbers[v] = static_cast<Index>(mesh.positions.size());
      mesh.positions.push_back(whole.positions[v]);
    }
    for (const Index f : faces) {
      for (const Index v : whole.face(f)) mesh.corners.push_back(numbers[v]);
      mesh.face_offsets.push_back(static_cast<Index>(mesh.corners.size()));
    }
  }

  PolyMesh mesh;
  std::vector<Index> faces;             ///< their numbers in the whole, ascending
  std::vector<std::uint8_t> is_chosen;  ///< per face
};

std::vector<PackedBox> picked(const std::vector<PackedBox>& boxes, const std::vector<Index>& which) {
  std::vector<PackedBox> result;
  result.reserve(which.size());
  for (const Index i : which) result.push_back(boxes[i]);
  return result;
}

}  // namespace

SelfIntersections find_self_intersections(const PolyMesh& mesh, Progress& progress,
                                          const SelfIntersectionOptions& options) {
  require_usable(mesh);
  progress.check();
  const CutFaces cut(mesh);
  progress.check();
  const BoxTree tree(cut.boxes());
  PairSearch search(cut, options.max_pairs, progress);
  for (std::size_t leaf = 0; leaf < tree.leaf_count(); ++leaf) {
    report_leaf(leaf, tree, progress);
    tree.visit_pairs_of_leaf(leaf, search);
  }
  return search.finish();
}

SelfIntersections find_intersections_of(const PolyMesh& mesh, std::span<const Index> faces, Progress& progress,
                                        const SelfIntersectionOptions& options) {
  require_usable(mesh);
  progress.check();
  const Neighbourhood near(mesh, faces);
  const CutFaces cut(near.mesh);
  const auto is_chosen = [&](Index t) { return near.is_chosen[cut.face(t)] != 0; };
  std::vector<Index> chosen;
  std::vector<Index> others;
  for (Index t = 0; t < cut.triangle_count(); ++t) (is_chosen(t) ? chosen : others).push_back(t);
  const std::vector<PackedBox> boxes = cut.boxes();
  const BoxTree chosen_tree(picked(boxes, chosen));
  const BoxTree other_tree(picked(boxes, others));
  PairSearch search(cut, options.max_pairs, progress);
  for (std::size_t leaf = 0; leaf < chosen_tree.leaf_count(); ++leaf) {
    report_leaf(leaf, chosen_tree, progress);
    chosen_tree.visit_pairs_of_leaf(leaf, [&](Index i, Index j) { search(chosen[i], chosen[j]); });
    chosen_tree.visit_pairs_between(leaf, other_tree, [&](Index i, Index j) { search(chosen[i], others[j]); });
  }
  SelfIntersections found = search.finish();
  for (auto& pair : found.pairs) {
    for (Index& face : pair) face = near.faces[face];
  }
  return found;
}

}  // namespace croquis
