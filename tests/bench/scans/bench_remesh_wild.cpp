// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <iomanip>
#include <map>
#include <ostream>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "bench/bench.h"
#include "bench/cpu_time.h"
#include "bench/scans/ply_file.h"
#include "bench/scans/remesh_peers.h"
#include "bench/scans/scan_choice.h"
#include "bench/statistics.h"
#include "croquis/base/error.h"
#include "croquis/geometry/mesh_topology.h"
#include "croquis/remeshing/remesh.h"
#include "support/meshes/surface_distance.h"
#include "support/scans/virtual_scans.h"

namespace croquis::bench {
namespace {

using namespace hole_filling;
using namespace remeshing;
using test::KnownScan;

constexpr double far_cells = 0.5;
constexpr double far_diagonals = 0.05;
constexpr std::array poisson_depths = {7, 8, 9, 10};
constexpr double affordable = 20;  // s of the depth before: each takes about four times as long as it

/// What a surface made of a scan is like.
struct Made {
  std::string state;  ///< "made", or the code of the error
  std::size_t faces = 0;
  double beyond_cells = 0;   ///< share of vertices outside of holes' zones farther than half a cell from the scan, %
  double beyond = 0;         ///< and farther than 5 % of the diagonal, in zones or not, %
  double off_thing = 0;      ///< and as far from the thing itself, %
  double scan_off = 0;       ///< mean distance of the scan's vertices to it, 1e-4 diagonals
  double holes_off = 0;      ///< of the places that are missing, mean over holes
  std::ptrdiff_t euler = 0;  ///< V - E + F
  std::size_t open_loops = 0;
  double seconds = 0;
  bool is_made = false;
};

struct Row {
  test::ScanKind kind;
  std::uint64_t seed = 0;
  std::size_t faces = 0;
  std::ptrdiff_t euler = 0;
  Made ours;
  std::vector<std::pair<int, Made>> peers;  ///< by depth

  /// The peer that is least by a figure; nothing without any.
  const Made* best(double Made::*figure) const {
    const auto least = std::ranges::min_element(peers, {}, [&](const auto& peer) { return peer.second.*figure; });
    return least == peers.end() ? nullptr : &least->second;
  }
};

std::ptrdiff_t euler_of(const PolyMesh& mesh, const MeshTopology& topology) {
  const std::set<Index> used(mesh.corners.begin(), mesh.corners.end());
  return static_cast<std::ptrdiff_t>(used.size() + mesh.face_count()) -
         static_cast<std::ptrdiff_t>(topology.edge_count());
}

/// A hole's vertices, and how far around them a surface that closes it may go.
struct Zone {
  std::vector<Vec3> rim;
  double reach = 0;
};

/// Zones where patches or the field close something: patches go 1.5 diameters at most, the field 0.8.
std::vector<Zone> zones_of(const PolyMesh& scan, const HoleAnalysis& analysis,
                           const std::vector<HoleOutcome>& outcomes) {
  std::vector<Zone> zones;
  for (const Hole& hole : analysis.holes) {
    if (outcomes[hole.id].action != FillAction::Fill) continue;
    Zone& zone = zones.emplace_back();
    for (const Index v : hole.vertices) zone.rim.push_back(scan.positions[v]);
    zone.reach = (outcomes[hole.id].method == "remesh" ? 0.8 : 1.5) * hole.diameter;
  }
  return zones;
}

bool is_in_zone(const Vec3& place, const std::vector<Zone>& zones) {
  return std::ranges::any_of(zones, [&](const Zone& zone) {
    return std::ranges::any_of(zone.rim, [&](const Vec3& p) { return (p - place).norm() <= zone.reach; });
  });
}

Made judged(const KnownScan& scan, const PolyMesh& mesh, const std::vector<Zone>& zones) {
  Made made;
  made.is_made = true;
  made.state = "made";
  made.faces = mesh.face_count();
  const MeshTopology topology(mesh);
  made.euler = euler_of(mesh, topology);
  made.open_loops = topology.boundary_loops().size();
  const double cell = std::min(test::mean_edge_of(scan.mesh), test::diagonal_of(scan.mesh) / 40);
  const test::SurfaceDistance to_scan(scan.mesh), to_truth(scan.truth), to_made(mesh);
  const std::set<Index> used(mesh.corners.begin(), mesh.corners.end());
  for (const Index v : used) {
    const double distance = to_scan(mesh.positions[v]);
    const bool is_beyond = distance > far_diagonals * scan.diagonal;
    made.beyond += is_beyond;
    made.off_thing += is_beyond && to_truth(mesh.positions[v]) > far_diagonals * scan.diagonal;
    if (distance > far_cells * cell && !is_in_zone(mesh.positions[v], zones)) ++made.beyond_cells;
  }
  const double share = 100 / static_cast<double>(used.size());
  made.beyond *= share, made.off_thing *= share, made.beyond_cells *= share;
  const double unit = 1e4 / scan.diagonal;
  made.scan_off = unit * test::summary_of_distances(scan.mesh.positions, to_made).mean;
  std::vector<double> holes;
  for (const test::KnownHole& hole : scan.holes) {
    if (hole.kind != test::HoleKind::Opening)
      holes.push_back(unit * test::summary_of_distances(hole.places, to_made).mean);
  }
  made.holes_off = mean(holes);
  return made;
}

std::string codes_of(const Findings& findings) {
  std::map<std::string, int> counts;
  for (const Finding& finding : findings) ++counts[finding.code];
  std::string codes;
  for (const auto& [code, count] : counts) codes += " " + code + (count > 1 ? " x" + std::to_string(count) : "");
  return codes;
}

/// The faces with a corner farther than 5 % of the diagonal from scan and thing.
PolyMesh faces_off_thing(const KnownScan& scan, const PolyMesh& mesh) {
  const test::SurfaceDistance to_scan(scan.mesh), to_truth(scan.truth);
  const double most = far_diagonals * scan.diagonal;
  PolyMesh off_thing;
  for (std::size_t f = 0; f < mesh.face_count(); ++f) {
    const auto face = mesh.face(f);
    const auto is_astray = [&](Index v) {
      return to_scan(mesh.positions[v]) > most && to_truth(mesh.positions[v]) > most;
    };
    if (std::ranges::none_of(face, is_astray)) continue;
    const auto first = static_cast<Index>(off_thing.positions.size());
    for (const Index v : face) off_thing.positions.push_back(mesh.positions[v]);
    off_thing.add_triangle(first, first + 1, first + 2);
  }
  return off_thing;
}

Made made_by_us(const KnownScan& scan, const std::string& path, std::vector<Zone>& zones) {
  RemeshResult result;
  Made made;
  RemeshOptions options;
  options.fill.threads = 1;
  Progress progress;
  std::string refusal;
  const double ms = cpu_ms([&] {
    try {
      result = remesh_surface(scan.mesh, options, progress);
    } catch (const Error& error) {
      refusal = error.findings().front().code;
    }
  });
  if (refusal.empty()) {
    zones = zones_of(scan.mesh, result.analysis, result.outcomes);
    made = judged(scan, result.mesh, zones);
    made.state += codes_of(result.warnings);
    result.mesh.channels.clear();
    if (!path.empty()) {
      write_ply(result.mesh, path + "remeshed.ply");
      write_ply(faces_off_thing(scan, result.mesh), path + "off_thing.ply");
    }
  } else {
    made.state = refusal;
  }
  made.seconds = 1e-3 * ms;
  return made;
}

Row row_of(test::ScanKind kind, std::uint64_t seed, const std::string& folder) {
  const KnownScan scan = known_scan(kind, seed);
  std::string path;
  if (!folder.empty()) {
    std::filesystem::create_directories(folder);
    path = folder + "/" + name_of(kind) + "-" + std::to_string(seed) + "_";
    write_ply(scan.mesh, path + "scan.ply");
    write_ply(scan.truth, path + "truth.ply");
  }
  Row row{kind, seed, scan.mesh.face_count(), euler_of(scan.mesh, MeshTopology(scan.mesh)), {}, {}};
  std::vector<Zone> zones;
  row.ours = made_by_us(scan, path, zones);
  for (const int depth : poisson_depths) {
    if (!row.peers.empty() && row.peers.back().second.seconds > affordable) break;
    const auto run = meshlab_poisson(scan.mesh, depth);
    if (!run) continue;
    Made& made = row.peers.emplace_back(depth, judged(scan, run->mesh, zones)).second;
    made.seconds = 1e-3 * run->cpu_ms;
    if (!path.empty()) write_ply(run->mesh, path + "poisson" + std::to_string(depth) + ".ply");
  }
  return row;
}

void print(std::ostream& out, const Row& row) {
  const auto figures = [&](const std::string& state, const Made& made) {
    out << "| " << name_of(row.kind) << ' ' << row.seed << " | " << row.faces << ", " << row.euler << " | " << state
        << " | ";
    if (made.is_made)
      out << made.beyond_cells << " | " << made.beyond << " | " << made.off_thing << " | " << made.scan_off << " | "
          << made.holes_off << " | " << made.euler << ", " << made.open_loops << " | "
          << static_cast<double>(made.faces) / static_cast<double>(row.faces) << " | ";
    else
      out << " | | | | | | | ";
    out << made.seconds << " |" << std::endl;
  };
  figures(row.ours.state, row.ours);
  for (const auto& [depth, made] : row.peers) figures("Poisson " + std::to_string(depth), made);
}

/// Of one kind's scans, or of all.
void print_summary(std::ostream& out, const std::string& name, const std::vector<Row>& rows) {
  std::size_t made = 0, off_thing = 0, peer_off_thing = 0;
  std::vector<double> cells, scan, scan_time, holes, holes_time, faces;
  for (const Row& row : rows) {
    if (!row.ours.is_made) continue;
    ++made;
    off_thing += row.ours.off_thing > 1;
    cells.push_back(row.ours.beyond_cells);
    faces.push_back(static_cast<double>(row.ours.faces) / static_cast<double>(row.faces));
    if (row.peers.empty()) continue;
    const Made& nearest = *row.best(&Made::scan_off);
    const Made& closest = *row.best(&Made::holes_off);
    peer_off_thing += nearest.off_thing > 1;
    scan.push_back(row.ours.scan_off / nearest.scan_off);
    scan_time.push_back(row.ours.seconds / nearest.seconds);
    if (!(closest.holes_off > 0)) continue;  // nothing is missing
    holes.push_back(row.ours.holes_off / closest.holes_off);
    holes_time.push_back(row.ours.seconds / closest.seconds);
  }
  const auto median_and_most = [](const std::vector<double>& values) {
    std::ostringstream text;
    text << std::setprecision(3) << median(values) << ", " << quantile(values, 1);
    return text.str();
  };
  out << "| " << name << " | " << rows.size() << " | " << made << " | " << off_thing << " | " << peer_off_thing;
  for (const std::vector<double>* values : {&cells, &faces, &scan, &scan_time, &holes, &holes_time})
    out << " | " << (values->empty() ? "" : median_and_most(*values));
  out << " |\n";
}

}  // namespace

void bench_remesh_wild(std::ostream& out, const std::vector<std::string>& words) {
  const ScanChoice choice = scan_choice(words);
  out << std::setprecision(3) << "Known scans of seeds " << choice.first << " to " << choice.first + choice.count - 1
      << (choice.first < 5000 ? ", on which rules are tuned" : "")
      << ", made anew by the default options on one thread, beside MeshLab's screened Poisson of depths 7 to 10 (its "
      << "whole process; a depth is left out where the one before took more than " << affordable
      << " s). A: vertices outside of holes' zones farther than half a cell from the "
      << "scan, %; B: vertices farther than 5 % of the diagonal from the scan, T: and from the thing itself, %; C: the "
      << "scan's vertices off the result, 1e-4 diagonals; D: the surface that is missing, mean over holes.\n\n"
      << "| scan | faces, Euler number | by | A | B | T | C | D | Euler number, rims | faces / scan's | s |\n"
      << "|---|---|---|---|---|---|---|---|---|---|---|" << std::endl;
  std::vector<Row> all;
  std::vector<std::pair<std::string, std::vector<Row>>> by_kind;
  for (const test::ScanKind kind : choice.kinds) {
    std::vector<Row> rows;
    for (std::uint64_t seed = choice.first; seed < choice.first + choice.count; ++seed) {
      rows.push_back(row_of(kind, seed, choice.folder));
      print(out, rows.back());
    }
    all.insert(all.end(), rows.begin(), rows.end());
    by_kind.emplace_back(name_of(kind), std::move(rows));
  }
  by_kind.emplace_back("all", std::move(all));
  out << "\nBeside the depth that is best on C and the one that is best on D, scan by scan, with its own time; medians "
         "and the most.\n\n| | scans | made | with more than 1 % T | Poisson, best on C: with more than 1 % T | A | "
         "faces "
         "/ scan's | C / best C | time / its time | D / best D | time / its time |\n"
         "|---|---|---|---|---|---|---|---|---|---|---|\n";
  for (const auto& [name, rows] : by_kind) print_summary(out, name, rows);
}

}  // namespace croquis::bench
