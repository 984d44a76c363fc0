// SPDX-License-Identifier: GPL-3.0-or-later
#include "bench/scans/hole_case.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <numbers>
#include <sstream>

#include "bench/cpu_time.h"
#include "bench/scans/ply_file.h"
#include "bench/statistics.h"
#include "croquis/geometry/disjoint_sets.h"
#include "croquis/geometry/self_intersection.h"
#include "support/meshes/surface_distance.h"
#include "support/scans/virtual_scans.h"

namespace croquis::bench {
namespace {

constexpr std::size_t samples_per_hole = 400;

std::vector<std::vector<Vec3>> removed_places(const std::filesystem::path& path) {
  std::ifstream file(path);
  std::vector<std::vector<Vec3>> removed;
  for (std::string line; std::getline(file, line);) {
    if (line.starts_with("hole")) {
      removed.emplace_back();
      continue;
    }
    std::istringstream numbers(line);
    Vec3 p;
    if (removed.empty()) removed.emplace_back();
    if (numbers >> p.x() >> p.y() >> p.z()) removed.back().push_back(p);
  }
  std::erase_if(removed, [](const auto& places) { return places.empty(); });
  return removed;
}

FilledMesh ours(const PolyMesh& mesh, hole_filling::Fairness fairness, hole_filling::Preset preset) {
  hole_filling::FillOptions options;
  options.selection = hole_filling::Selection::All;
  options.fairness = fairness;
  options.preset = preset;
  options.mark_patches = false;
  Progress progress;
  FilledMesh filled;
  filled.first_new_face = mesh.face_count();
  filled.cpu_ms = cpu_ms([&] { filled.mesh = hole_filling::fill_holes(mesh, options, progress).mesh; });
  return filled;
}

struct Edge {
  Index low, high, face;
  bool joins(const Edge& other) const { return low == other.low && high == other.high; }
};

/// Of some faces, sorted by their ends.
std::vector<Edge> edges_of(const PolyMesh& mesh, std::size_t first_face) {
  std::vector<Edge> edges;
  for (std::size_t f = first_face; f < mesh.face_count(); ++f) {
    const auto t = mesh.face(f);
    for (std::size_t i = 0; i < t.size(); ++i) {
      const auto [low, high] = std::minmax(t[i], t[(i + 1) % t.size()]);
      edges.push_back({low, high, static_cast<Index>(f)});
    }
  }
  std::sort(edges.begin(), edges.end(), [](const Edge& a, const Edge& b) {
    return a.low != b.low ? a.low < b.low : a.high != b.high ? a.high < b.high : a.face < b.face;
  });
  return edges;
}

struct Lengths {
  double inner = 0, rim = 0;
  std::size_t inner_count = 0, rim_count = 0;

  double ratio() const { return inner / static_cast<double>(inner_count) * static_cast<double>(rim_count) / rim; }
};

/// Lengths of the edges of every patch: faces that share edges are one.
std::vector<Lengths> patch_lengths(const PolyMesh& mesh, std::size_t first_face) {
  const std::vector<Edge> edges = edges_of(mesh, first_face);
  DisjointSets patches(mesh.face_count());
  for (std::size_t i = 1; i < edges.size(); ++i) {
    if (edges[i].joins(edges[i - 1])) patches.unite(edges[i].face, edges[i - 1].face);
  }
  std::vector<Lengths> lengths(mesh.face_count());
  for (std::size_t i = 0; i < edges.size(); ++i) {
    Lengths& patch = lengths[patches.root(edges[i].face)];
    const double length = (mesh.positions[edges[i].low] - mesh.positions[edges[i].high]).norm();
    if (i + 1 < edges.size() && edges[i].joins(edges[i + 1])) {
      patch.inner += length;
      ++patch.inner_count;
      ++i;
    } else {
      patch.rim += length;
      ++patch.rim_count;
    }
  }
  std::erase_if(lengths, [](const Lengths& patch) { return patch.rim_count < 10 || patch.inner_count == 0; });
  return lengths;
}

/// Degrees; 0 for a triangle without area.
std::array<double, 3> angles_of(const PolyMesh& mesh, std::size_t face) {
  const auto t = mesh.face(face);
  std::array<double, 3> angles{};
  for (std::size_t i = 0; i < 3; ++i) {
    const Vec3 to = mesh.positions[t[(i + 1) % 3]] - mesh.positions[t[i]];
    const Vec3 other = mesh.positions[t[(i + 2) % 3]] - mesh.positions[t[i]];
    const double cosine = to.dot(other) / (to.norm() * other.norm());
    angles[i] = std::isfinite(cosine) ? std::acos(std::clamp(cosine, -1.0, 1.0)) * 180 / std::numbers::pi : 0;
  }
  return angles;
}

}  // namespace

HoleCase case_of(const std::string& name, const test::CutScan& cuts) {
  HoleCase holes;
  holes.name = name;
  holes.mesh = test::without_loose_vertices(cuts.mesh);
  holes.diagonal = test::diagonal_of(cuts.complete);
  for (const auto& faces : cuts.removed)
    holes.removed.push_back(test::sample_faces(cuts.complete, faces, samples_per_hole));
  return holes;
}

std::vector<HoleCase> cases_in(const std::string& folder) {
  constexpr std::string_view ending = "_cut.ply";
  std::vector<std::filesystem::path> paths;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    if (entry.path().string().ends_with(ending)) paths.push_back(entry.path());
  }
  std::sort(paths.begin(), paths.end());
  std::vector<HoleCase> cases;
  for (const auto& path : paths) {
    const std::string file_name = path.filename().string();
    HoleCase holes;
    holes.name = file_name.substr(0, file_name.size() - ending.size());
    holes.mesh = test::without_loose_vertices(read_ply(path.string()));
    holes.removed = removed_places(path.parent_path() / (holes.name + "_removed_pts.txt"));
    holes.diagonal = test::diagonal_of(holes.mesh);
    if (!holes.removed.empty()) cases.push_back(std::move(holes));
  }
  return cases;
}

const char* name_of(Method method) {
  constexpr std::array names = {"MeshLab", "CGAL C1", "CGAL C2", "smooth", "rbf", "rbf sharp", "rbf noisy"};
  return names[static_cast<std::size_t>(method)];
}

std::optional<FilledMesh> fill(const PolyMesh& mesh, Method method) {
  using hole_filling::Fairness;
  using hole_filling::Preset;
  switch (method) {
    case Method::MeshLab: return meshlab_fill(mesh);
    case Method::CgalTangent: return cgal_fill(mesh, 1);
    case Method::CgalCurved: return cgal_fill(mesh, 2);
    case Method::Smooth: return ours(mesh, Fairness::Tangent, Preset::Standard);
    case Method::Implicit: return ours(mesh, Fairness::Implicit, Preset::Standard);
    case Method::Sharp: return ours(mesh, Fairness::Implicit, Preset::Sharp);
    case Method::Noisy: return ours(mesh, Fairness::Implicit, Preset::Noisy);
  }
  return std::nullopt;
}

Accuracy accuracy(const HoleCase& holes, const FilledMesh& filled) {
  const test::SurfaceDistance patches(filled.mesh, filled.first_new_face);
  std::vector<double> means;
  Accuracy result;
  for (const auto& places : holes.removed) {
    means.push_back(1e4 * test::summary_of_distances(places, patches).mean / holes.diagonal);
    result.mean += means.back() / static_cast<double>(holes.removed.size());
  }
  result.median_hole = median(means);
  return result;
}

std::size_t border_edges(const PolyMesh& mesh) {
  const std::vector<Edge> edges = edges_of(mesh, 0);
  std::size_t count = 0;
  for (std::size_t i = 0; i < edges.size(); ++i) {
    const bool is_joined =
        (i > 0 && edges[i].joins(edges[i - 1])) || (i + 1 < edges.size() && edges[i].joins(edges[i + 1]));
    if (!is_joined) ++count;
  }
  return count;
}

PatchShape patch_shape(const PolyMesh& given, const FilledMesh& filled) {
  PatchShape shape;
  std::vector<double> ratios, least_angles;
  for (const Lengths& patch : patch_lengths(filled.mesh, filled.first_new_face)) {
    ratios.push_back(patch.ratio());
    if (patch.ratio() < 0.7 || patch.ratio() > 1.4) ++shape.uneven_patches;
  }
  if (!ratios.empty()) shape.uneven_patches /= static_cast<double>(ratios.size());
  shape.edge_ratio = median(ratios);
  for (std::size_t f = filled.first_new_face; f < filled.mesh.face_count(); ++f) {
    const auto angles = angles_of(filled.mesh, f);
    for (const double angle : angles) shape.small_angles += angle < 10;
    least_angles.push_back(*std::min_element(angles.begin(), angles.end()));
  }
  if (!least_angles.empty()) shape.small_angles /= 3 * static_cast<double>(least_angles.size());
  shape.median_min_angle = median(least_angles);
  shape.open_rims = border_edges(filled.mesh);
  Progress progress;
  shape.new_intersections = static_cast<std::ptrdiff_t>(find_self_intersections(filled.mesh, progress).count) -
                            static_cast<std::ptrdiff_t>(find_self_intersections(given, progress).count);
  return shape;
}

}  // namespace croquis::bench
