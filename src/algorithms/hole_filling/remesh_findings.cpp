// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/hole_filling/remesh_findings.h"

#include <string>
#include <utility>

#include "algorithms/hole_filling/fill_findings.h"

namespace croquis::hole_filling {
namespace {

std::string counted(std::size_t count, const std::string& one, const std::string& many) {
  return count == 1 ? "1 " + one : std::to_string(count) + " " + many;
}

Finding warning(std::string code, std::string message) {
  return make_warning(Category::Geometry, std::move(code), std::move(message));
}

}  // namespace

Findings remesh_findings(const PolyMesh& mesh, const RemeshResult& result, std::size_t lost, std::size_t left_out) {
  FillResult holes;  // what is to be said of holes is the same in both modes
  holes.analysis.holes = result.analysis.holes;
  holes.analysis.warnings = result.analysis.warnings;
  holes.outcomes = result.outcomes;
  Findings findings = fill_findings(mesh, holes);
  if (left_out > 0)
    findings.push_back(warning("W_PIECE_LOST", counted(left_out, "small piece was", "small pieces were") +
                                                   " left out, as asked for: lower the least size to keep them."));
  if (lost > 0)
    findings.push_back(warning("W_PIECE_LOST", counted(lost, "piece has", "pieces have") +
                                                   " no surface that cubes of this size could find: choose smaller "
                                                   "cells."));
  if (result.checks.lost_points > 0)
    findings.push_back(
        warning("W_DETAIL_LOST", counted(result.checks.lost_points, "point", "points") +
                                     " of the mesh lie on parts thinner than a cell, which came out torn "
                                     "or shorter: choose smaller cells, or fill holes by patches."));
  if (result.checks.failed_loops > 0)
    findings.push_back(
        warning("W_NOT_CLOSED", counted(result.checks.failed_loops, "opening is", "openings are") +
                                    " left where none was: choose smaller cells, or fill holes by patches."));
  if (result.checks.self_intersections > 0)
    findings.push_back(
        warning("W_CUTS_ITSELF", counted(result.checks.self_intersections, "pair of faces intersects",
                                         "pairs of faces "
                                         "intersect") +
                                     ", since sheets of the model come nearer than a cell: choose smaller cells."));
  return findings;
}

}  // namespace croquis::hole_filling
