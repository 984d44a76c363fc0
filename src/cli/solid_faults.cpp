// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/solid_faults.h"

#include <utility>

#include "croquis/base/error.h"
#include "croquis/base/text.h"

namespace croquis::cli {
namespace {

Finding failed_check(const char* code, const std::string& file, const std::string& sentence) {
  return make_error(Category::Geometry, code, file + " " + sentence, {{SubjectKind::File, file, file, {}, {}}});
}

}  // namespace

Findings solid_faults(const MeshReport& report, const std::string& file) {
  Findings found;
  if (!report.closed) {
    found.push_back(failed_check("E_NOT_CLOSED", file,
                                 "isn't closed: it has " +
                                     counted(report.boundary_edges, "boundary edge", "boundary edges") + " in " +
                                     counted(report.boundary_loops, "loop", "loops") + "; fill its holes."));
  }
  if (report.nonmanifold_edges + report.nonmanifold_vertices > 0) {
    found.push_back(failed_check("E_NOT_MANIFOLD", file,
                                 "isn't manifold: " + counted(report.nonmanifold_edges, "edge", "edges") +
                                     " with more than two faces, " + std::to_string(report.nonmanifold_vertices) +
                                     " vertices where surfaces only touch; separate them."));
  }
  if (!report.oriented) {
    found.push_back(failed_check("E_NOT_ORIENTED", file,
                                 "isn't oriented: neighbouring faces turn in opposite directions; flip some of them."));
  }
  if (report.degenerate_faces > 0) {
    found.push_back(
        failed_check("E_DEGENERATE_FACES", file,
                     "has " + counted(report.degenerate_faces, "face", "faces") + " without area; remove them."));
  }
  if (report.self_intersections.value_or(0) > 0) {
    found.push_back(failed_check("E_SELF_INTERSECTION", file,
                                 "intersects itself in " + counted(*report.self_intersections, "pair", "pairs") +
                                     " of faces; move them apart."));
  }
  return found;
}

void judge_solid(const std::string& path, const PolyMesh& written, CommandResult& result, Progress& progress) {
  result.mesh = inspect(written, true, progress);
  const Findings faults = solid_faults(*result.mesh, path);
  if (faults.empty()) return;
  throw Error(make_error(Category::Geometry, "E_ROUNDING",
                         "The solid is valid, but not with the numbers that " + path +
                             " can hold: " + faults.front().message + " Write it as OBJ or PLY.",
                         {{SubjectKind::File, path, {}, {}, {}}}));
}

void warn_of_faults(const std::string& path, bool meant_closed, CommandResult& result) {
  for (Finding& fault : solid_faults(*result.mesh, path == "-" ? "The mesh" : path)) {
    const bool is_open = fault.code == "E_NOT_CLOSED";
    if (is_open ? !meant_closed : fault.code != "E_SELF_INTERSECTION") continue;
    result.warnings.push_back(make_warning(Category::Geometry, is_open ? "W_OPEN" : "W_SELF_INTERSECTION",
                                           std::move(fault.message), std::move(fault.subjects)));
  }
}

}  // namespace croquis::cli
