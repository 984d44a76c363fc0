// SPDX-License-Identifier: GPL-3.0-or-later
#include "bench/scans/wild_holes.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <map>
#include <optional>
#include <set>
#include <utility>

#include "bench/cpu_time.h"
#include "bench/scans/hole_case.h"
#include "bench/scans/hole_peers.h"
#include "bench/scans/ply_file.h"
#include "croquis/geometry/disjoint_sets.h"
#include "croquis/geometry/self_intersection.h"
#include "croquis/hole_filling/fill_holes.h"
#include "support/meshes/surface_distance.h"

namespace croquis::bench {
namespace {

using namespace hole_filling;
using test::KnownHole;
using test::KnownScan;

using Edge = std::pair<Index, Index>;  // low, high

Edge edge_between(Index a, Index b) { return std::minmax(a, b); }

double diameter_of(const PolyMesh& mesh, const std::vector<Edge>& rim) {
  double square = 0;
  for (const auto& [a, b] : rim) {
    for (const auto& [c, d] : rim) square = std::max(square, (mesh.positions[a] - mesh.positions[c]).squaredNorm());
  }
  return std::sqrt(square);
}

/// For every vertex the lowest at the same place but for rounding: what seams have twice counts as one.
std::vector<Index> lowest_at_place(const PolyMesh& mesh, double diagonal) {
  const double slack = 1e-12 * diagonal;
  std::vector<Index> order(mesh.vertex_count()), lowest(mesh.vertex_count());
  for (Index v = 0; v < order.size(); ++v) order[v] = lowest[v] = v;
  std::ranges::sort(order, {}, [&](Index v) { return mesh.positions[v].x(); });
  for (std::size_t i = 0; i < order.size(); ++i) {
    for (std::size_t k = i + 1; k < order.size(); ++k) {
      const Vec3 apart = mesh.positions[order[k]] - mesh.positions[order[i]];
      if (apart.x() > slack) break;
      if (apart.norm() > slack) continue;
      const Index low = std::min(lowest[order[i]], lowest[order[k]]);
      lowest[order[i]] = lowest[order[k]] = low;
    }
  }
  return lowest;
}

/// The faces behind those given, in patches: joined across edges.
class Patches {
 public:
  explicit Patches(const FilledMesh& filled) : filled_(filled), sets_(filled.mesh.face_count()) {
    for (std::size_t f = filled.first_new_face; f < filled.mesh.face_count(); ++f) {
      const auto t = filled.mesh.face(f);
      for (std::size_t i = 0; i < t.size(); ++i) {
        const Edge edge = edge_between(t[i], t[(i + 1) % t.size()]);
        const auto [found, is_new] = face_at_.try_emplace(edge, static_cast<Index>(f));
        if (!is_new) sets_.unite(found->second, static_cast<Index>(f));
      }
    }
    for (auto f = static_cast<Index>(filled.first_new_face); f < filled.mesh.face_count(); ++f)
      faces_of_[sets_.root(f)].push_back(f);
  }

  FilledHole filled(const KnownHole& hole, const std::vector<Edge>& rim, double diagonal) {
    std::set<Index> patches;
    FilledHole made;
    made.is_closed = true;
    for (const Edge& edge : rim) {
      const auto found = face_at_.find(edge);
      if (found == face_at_.end()) {
        made.is_closed = false;
      } else {
        patches.insert(sets_.root(found->second));
      }
    }
    if (!made.is_closed) return made;
    std::vector<Index> faces;
    for (const Index patch : patches) faces.insert(faces.end(), faces_of_[patch].begin(), faces_of_[patch].end());
    const test::SurfaceDistance distance(filled_.mesh, faces);
    made.error = 1e4 * test::summary_of_distances(hole.places, distance).mean / diagonal;
    return made;
  }

 private:
  const FilledMesh& filled_;
  DisjointSets sets_;
  std::map<Edge, Index> face_at_;
  std::map<Index, std::vector<Index>> faces_of_;
};

std::ptrdiff_t intersections(const PolyMesh& mesh) {
  Progress progress;
  return static_cast<std::ptrdiff_t>(find_self_intersections(mesh, progress, {0}).count);
}

/// One scan under measurement.
class Measurement {
 public:
  Measurement(test::ScanKind kind, std::uint64_t seed)
      : scan_(known_scan(kind, seed)), lowest_(lowest_at_place(scan_.mesh, scan_.diagonal)) {
    record_.kind = kind;
    record_.seed = seed;
    record_.triangles = scan_.mesh.face_count();
    record_.open_edges = border_edges(joined(scan_.mesh));
    given_intersections_ = intersections(joined(scan_.mesh));
    for (const KnownHole& hole : scan_.holes) {
      rims_.push_back(rim_edges(hole));
      HoleRecord& record = record_.holes.emplace_back();
      record.scan = kind;
      record.seed = seed;
      record.number = record_.holes.size() - 1;
      record.kind = hole.kind;
      record.rim_edges = hole.rim.size();
      record.diameter = diameter_of(scan_.mesh, rims_.back()) / scan_.diagonal;
      record.has_seams = scan_.has_seams;
    }
  }

  ScanRecord run(const std::string& folder) {
    if (!folder.empty()) std::filesystem::create_directories(folder);
    folder_ = folder;
    save(scan_.truth, "truth");
    save(scan_.mesh, "scan");
    fill_by_us();
    fill_by_cgal(Filler::Tangent, 1);
    fill_by_cgal(Filler::Curved, 2);
    const auto filled = meshlab_fill(scan_.mesh);
    if (filled && begins_with_scan(filled->mesh)) {
      judge(Filler::MeshLab, *filled);
    } else {
      record_.edges_left[static_cast<std::size_t>(Filler::MeshLab)] = -1;
    }
    return std::move(record_);
  }

 private:
  void save(const PolyMesh& mesh, const std::string& what) const {
    if (folder_.empty()) return;
    write_ply(mesh, folder_ + "/" + name_of(record_.kind) + "-" + std::to_string(record_.seed) + "_" + what + ".ply");
  }

  /// The number of a vertex once seams are joined. New ones have none in common.
  Index number(Index vertex) const { return vertex < lowest_.size() ? lowest_[vertex] : vertex; }

  PolyMesh joined(PolyMesh mesh) const {
    for (Index& v : mesh.corners) v = number(v);
    return mesh;
  }

  std::vector<Edge> rim_edges(const KnownHole& hole) const {
    std::vector<Edge> edges;
    for (const Index corner : hole.rim) {
      const Index next = corner % 3 == 2 ? corner - 2 : corner + 1;
      edges.push_back(edge_between(number(scan_.mesh.corners[corner]), number(scan_.mesh.corners[next])));
    }
    return edges;
  }

  bool begins_with_scan(const PolyMesh& mesh) const {
    return mesh.corners.size() >= scan_.mesh.corners.size() &&
           std::equal(scan_.mesh.corners.begin(), scan_.mesh.corners.end(), mesh.corners.begin());
  }

  void judge(Filler filler, const FilledMesh& made) {
    const auto i = static_cast<std::size_t>(filler);
    const FilledMesh filled{joined(made.mesh), made.first_new_face, made.cpu_ms};
    record_.cpu_ms[i] = filled.cpu_ms;
    record_.edges_left[i] = static_cast<std::ptrdiff_t>(border_edges(filled.mesh));
    record_.new_intersections[i] = intersections(filled.mesh) - given_intersections_;
    Patches patches(filled);
    for (HoleRecord& hole : record_.holes) {
      const double cpu = hole.filled[i].cpu_ms;
      hole.filled[i] = patches.filled(scan_.holes[hole.number], rims_[hole.number], scan_.diagonal);
      hole.filled[i].cpu_ms = cpu;
    }
    save(made.mesh, name_of(filler));
  }

  void fill_by_cgal(Filler filler, unsigned continuity) {
    const FilledRims made = cgal_fill_rims(scan_.mesh, continuity);
    std::map<Edge, std::size_t> rim_at;
    for (std::size_t r = 0; r < made.rims.size(); ++r) {
      const auto& rim = made.rims[r].vertices;
      for (std::size_t i = 0; i < rim.size(); ++i)
        rim_at[edge_between(number(rim[i]), number(rim[(i + 1) % rim.size()]))] = r;
    }
    for (HoleRecord& hole : record_.holes) {
      std::set<std::size_t> own;
      for (const Edge& edge : rims_[hole.number]) {
        if (rim_at.contains(edge)) own.insert(rim_at[edge]);
      }
      double& cpu = hole.filled[static_cast<std::size_t>(filler)].cpu_ms = 0;
      for (const std::size_t r : own) cpu += made.rims[r].cpu_ms;
    }
    judge(filler, made.filled);
  }

  FillResult filled_by_us(const FillOptions& options, FilledMesh& filled) const {
    Progress progress;
    FillResult result;
    filled.cpu_ms = cpu_ms([&] { result = fill_holes(scan_.mesh, options, progress); });
    filled.first_new_face = scan_.mesh.face_count();
    filled.mesh = result.mesh;
    filled.mesh.channels.clear();
    return result;
  }

  /// The holes of the analysis that have edges of each known one's rim.
  std::vector<std::set<Index>> holes_found(const HoleAnalysis& analysis) const {
    std::map<Edge, Index> hole_at;
    for (const Hole& hole : analysis.holes) {
      for (std::size_t i = 0; i < hole.vertices.size(); ++i) {
        const Index next = hole.vertices[(i + 1) % hole.vertices.size()];
        hole_at[edge_between(number(hole.vertices[i]), number(next))] = hole.id;
      }
    }
    std::vector<std::set<Index>> found(rims_.size());
    for (std::size_t h = 0; h < rims_.size(); ++h) {
      for (const auto& [a, b] : rims_[h]) {
        const auto hole = hole_at.find({a, b});
        if (hole != hole_at.end()) found[h].insert(hole->second);
      }
    }
    return found;
  }

  void fill_by_us() {
    FilledMesh filled;
    const FillResult result = filled_by_us({}, filled);
    record_.is_kept = result.outside_unchanged;
    const auto found = holes_found(result.analysis);
    judge(Filler::Ours, filled);
    FillOptions nothing;
    nothing.selection = Selection::None;
    FilledMesh untouched;
    filled_by_us(nothing, untouched);
    for (HoleRecord& hole : record_.holes) {
      const std::set<Index>& own = found[hole.number];
      if (own.empty()) continue;
      note_outcome(hole, result, own);
      std::size_t edges = 0;
      for (const Index id : own) edges += result.analysis.holes[id].vertices.size();
      hole.has_own_rim = 5 * edges < 6 * hole.rim_edges;  // a few loose triangles may hang there
      if (hole.has_own_rim) fill_alone(hole, {own.begin(), own.end()}, untouched.cpu_ms);
    }
  }

  void note_outcome(HoleRecord& hole, const FillResult& result, const std::set<Index>& own) const {
    for (const Index id : own) {
      const HoleOutcome& outcome = result.outcomes[id];
      if (outcome.action == FillAction::Leave) hole.is_left = true;
      if (outcome.action != FillAction::Fill) continue;
      if (hole.method.find(outcome.method) == std::string::npos) hole.method += " " + outcome.method;
      if (!(hole.confidence <= outcome.confidence)) hole.confidence = outcome.confidence;
    }
  }

  /// How long this one takes; and what comes of it, where the default options leave it.
  void fill_alone(HoleRecord& hole, const std::vector<Index>& own, double untouched_ms) {
    FillOptions options;
    options.only = own;
    FilledMesh filled;
    const FillResult result = filled_by_us(options, filled);
    FilledHole& made = hole.is_left ? hole.asked : hole.filled[0];
    if (hole.is_left) {
      hole.method.clear();
      hole.confidence = unknown;
      note_outcome(hole, result, {own.begin(), own.end()});
      const FilledMesh whole{joined(filled.mesh), filled.first_new_face, filled.cpu_ms};
      Patches patches(whole);
      made = patches.filled(scan_.holes[hole.number], rims_[hole.number], scan_.diagonal);
      save(filled.mesh, "asked" + std::to_string(hole.number));
    }
    made.cpu_ms = std::max(0.0, filled.cpu_ms - untouched_ms);
  }

  KnownScan scan_;
  std::vector<Index> lowest_;  // see lowest_at_place
  ScanRecord record_;
  std::ptrdiff_t given_intersections_ = 0;
  std::vector<std::vector<Edge>> rims_;
  std::string folder_;
};

}  // namespace

const char* name_of(Filler filler) {
  constexpr std::array names = {"ours", "CGAL C1", "CGAL C2", "MeshLab"};
  return names[static_cast<std::size_t>(filler)];
}

ScanRecord fill_known_scan(test::ScanKind kind, std::uint64_t seed, const std::string& folder) {
  return Measurement(kind, seed).run(folder);
}

}  // namespace croquis::bench
