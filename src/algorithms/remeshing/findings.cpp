// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/remeshing/findings.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <functional>
#include <span>
#include <string>
#include <utility>

#include "croquis/base/error.h"
#include "croquis/base/text.h"
#include "croquis/hole_filling/fill_holes.h"

namespace croquis::remeshing {
namespace {

using namespace hole_filling;

constexpr std::size_t most_named_holes = 3;   // in one sentence
constexpr std::size_t most_named_pieces = 5;  // with one code
constexpr double far_share_reported = 0.01;   // the middle of any hole of a tenth of the diagonal is far away
constexpr double many_faces = 4;              // × the triangles given
constexpr std::size_t few_faces = 20'000;     // that are never many

Finding warning(std::string code, std::string message) {
  return make_warning(Category::Geometry, std::move(code), std::move(message));
}

Subject point_subject(std::size_t piece, const Vec3& at) {
  return numbered_subject(SubjectKind::Point, piece, {at.x(), at.y(), at.z()});
}

std::string number(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.4g", value);
  return text;
}

/// "2 parts with 1 handle".
std::string described(const SurfaceTopology& topology) {
  const auto handles = static_cast<std::int64_t>(topology.components) - topology.euler / 2;
  std::string text = counted(topology.components, "part", "parts");
  if (handles > 0) text += " with " + counted(static_cast<std::size_t>(handles), "handle", "handles");
  return text;
}

std::string piece_of_model(std::size_t piece) { return "Piece " + std::to_string(piece) + " of the model "; }

/// One finding for each of the first few items that have a sentence, with a place; the others are counted.
/// @param like with the code; @param others "has" and "have", and what these do
template <typename Item>
void add_findings(const std::vector<Item>& items, const std::function<std::string(const Item&)>& sentence_of,
                  const Finding& like, const std::array<std::string, 3>& others, Findings& findings) {
  std::size_t count = 0;
  for (const Item& item : items) {
    std::string text = sentence_of(item);
    if (text.empty() || ++count > most_named_pieces) continue;
    Finding& finding = findings.emplace_back(like);
    finding.message = std::move(text);
    finding.subjects = {point_subject(item.piece, item.at)};
  }
  if (count <= most_named_pieces) return;
  findings.push_back(like);
  findings.back().message =
      counted(count - most_named_pieces, "more piece " + others[0], "more pieces " + others[1]) + others[2];
}

std::string detail_sentence(const PieceFaults& faults, double cell) {
  const bool differs = faults.expected && faults.expected->is_clear;
  if (!differs && faults.lost_points == 0) return "";
  std::string text = piece_of_model(faults.piece);
  if (differs) text += "came out as " + described(faults.made) + " instead of " + described(faults.expected->topology);
  if (faults.lost_points > 0)
    text += std::string(differs ? ", and " : "has lost its surface at ") +
            counted(faults.lost_points, "point", "points") + (differs ? " lost their surface" : "");
  if (faults.retried) return text + ", with smaller cells too: fill holes by patches, which keep the surface.";
  return text + ": choose cells of " + number(cell / 4) + " mean edges, or fill holes by patches.";
}

std::string extent_sentence(const PieceFaults& faults) {
  const ExtentChange& change = faults.change;
  const bool differs = faults.expected && !faults.expected->is_clear;
  if (!change.any() && !differs) return "";
  std::string text;
  const auto add = [&](const std::string& what) { text += (text.empty() ? "" : " and ") + what; };
  if (change.shrunk > 0) add("ends " + number(change.shrunk) + " short of the scan's box");
  if (change.grown > 0) add("leads " + number(change.grown) + " out of the scan's box");
  if (change.given != change.made) add("encloses " + number(change.made) + " instead of " + number(change.given));
  if (differs)
    add("came out as " + described(faults.made) + " where the scan's own sheets make " +
        described(faults.expected->topology));
  const std::string others = faults.together > 1 ? "with those that it was made one solid with " : "";
  return piece_of_model(faults.piece) + others + text +
         ": choose smaller cells, or fill holes by patches, which keep the surface.";
}

std::string loose_sentence(const PieceFaults& faults) {
  if (faults.loose_vertices == 0) return "";
  return piece_of_model(faults.piece) + "has " + counted(faults.loose_vertices, "vertex", "vertices") +
         " farther than half a cell off the scan, where its surface can't be brought nearer without cutting through "
         "itself: choose smaller cells, or fill holes by patches.";
}

std::string refused_sentence(const RefusedPiece& refused) {
  const std::string text = piece_of_model(refused.piece) + "was left out: its new surface ";
  if (refused.other != RefusedPiece::no_piece)
    return text + "crosses that of piece " + std::to_string(refused.other) +
           ", and no solid stands for both; take them apart, or fill holes by patches, which keep all pieces.";
  return text + "would lack " + std::to_string(static_cast<int>(std::lround(100 * refused.lost_share))) +
         " % of the scan's; choose smaller cells, or fill holes by patches, which keep the surface.";
}

void add_refused(const RemeshLosses& losses, const Finding& like, Findings& findings) {
  add_findings<RefusedPiece>(
      losses.refused, refused_sentence, like,
      {"was", "were", " left out for such reasons: choose smaller cells, or fill holes by patches."}, findings);
}

void add_faults(const RemeshLosses& losses, Findings& findings) {
  const auto add = [&](const char* code, const std::function<std::string(const PieceFaults&)>& sentence_of,
                       const std::string& others) {
    add_findings<PieceFaults>(losses.faults, sentence_of, warning(code, ""), {"has", "have", others}, findings);
  };
  add(
      "W_DETAIL_LOST", [&](const PieceFaults& faults) { return detail_sentence(faults, losses.cell); },
      " lost detail: choose smaller cells, or fill holes by patches.");
  add("W_SHAPE_DIFFERS", extent_sentence,
      " other boxes or volumes than the scan's: choose smaller cells, or fill holes by patches.");
  add("W_OFF_SCAN", loose_sentence,
      " vertices farther than half a cell off the scan: choose smaller cells, or fill holes by patches.");
}

/// Surface that nothing of the scan is near to, however well its holes seem to be closed.
void add_far(const RemeshResult& result, const RemeshLosses& losses, Findings& findings) {
  if (result.checks.far_share < far_share_reported) return;
  const std::vector<Index>& holes = losses.far_holes;
  std::string text = number(100 * result.checks.far_share) +
                     " % of the surface is farther than a twentieth of the model's diagonal from the scan";
  for (std::size_t i = 0; i < std::min(holes.size(), most_named_holes); ++i)
    text += (i > 0 ? ", " : holes.size() > 1 ? ", in holes " : ", in hole ") + std::to_string(holes[i]);
  if (holes.size() > most_named_holes) text += " and " + std::to_string(holes.size() - most_named_holes) + " more";
  findings.push_back(warning("W_FAR_FROM_SCAN", text + ": look at the shape there, or leave those holes open."));
  findings.back().subjects = {point_subject(0, losses.far_at)};
}

/// Cells never make a model many times as large without a word.
void add_sizes(const RemeshResult& result, Findings& findings) {
  const auto given = static_cast<double>(result.analysis.view.triangles.size());
  const double growth = static_cast<double>(result.mesh.face_count()) / given;
  if (result.coarsening > 1)
    findings.push_back(warning("W_CELLS_ENLARGED", "Cells are " + number(result.coarsening) +
                                                       " times as large as usual, since the scan's triangles are of "
                                                       "many sizes: choose smaller cells to keep the finest detail."));
  if (growth > many_faces && result.mesh.face_count() > few_faces)
    findings.push_back(warning("W_MANY_FACES", "The result has " + number(growth) +
                                                   " times the faces of the scan, of thin parts or large triangles: "
                                                   "choose larger cells, or fill holes by patches."));
}

void add_joints(const RemeshChecks& checks, Findings& findings) {
  if (checks.turned_views > 0)
    findings.push_back(
        warning("W_VIEWS_TURNED", counted(checks.turned_views, "piece of the model faces", "pieces of the model face") +
                                      " the other way than those that they lie upon and were turned over: "
                                      "turn them in the scan if they are sides of a thin wall."));
  if (checks.joined_views > 0)
    findings.push_back(
        warning("W_VIEWS_JOINED", std::to_string(checks.joined_views) +
                                      " pieces of the model go on in one another like views of one thing "
                                      "and were made one surface: align them better if it is rough."));
  if (checks.united_pieces > 0)
    findings.push_back(warning(
        "W_PIECES_UNITED", std::to_string(checks.united_pieces) +
                               " pieces of the model cross or nearly touch each other and were made into one solid: "
                               "take them apart before if they should stay pieces."));
  if (checks.self_intersections == 0) return;
  std::string text = counted(checks.self_intersections, "pair of faces intersects", "pairs of faces intersect");
  if (checks.piece_crossings > 0)
    text +=
        ", " + std::to_string(checks.piece_crossings) +
        " of them of different pieces of the model, which cross or nearly touch: take them apart, or choose smaller "
        "cells.";
  else
    text += ": look at the patches there, or choose smaller cells.";
  findings.push_back(warning("W_CUTS_ITSELF", text));
}

}  // namespace

Findings remesh_findings(const PolyMesh& mesh, const RemeshResult& result, const RemeshLosses& losses) {
  FillResult holes;  // findings about holes are the same in both modes
  holes.analysis.holes = result.analysis.holes;
  holes.analysis.warnings = result.analysis.warnings;
  holes.outcomes = result.outcomes;
  Findings findings = fill_findings(mesh, holes);
  if (losses.left_out > 0)
    findings.push_back(warning("W_PIECE_LOST", counted(losses.left_out, "small piece was", "small pieces were") +
                                                   " left out, as asked for: lower the least size to keep them."));
  if (losses.pieces > 0)
    findings.push_back(warning("W_PIECE_LOST", counted(losses.pieces, "piece has", "pieces have") +
                                                   " no surface that cubes of this size could find: choose smaller "
                                                   "cells."));
  add_refused(losses, warning("W_PIECE_REFUSED", ""), findings);
  add_faults(losses, findings);
  add_far(result, losses, findings);
  if (result.checks.failed_loops > 0)
    findings.push_back(
        warning("W_NOT_CLOSED", counted(result.checks.failed_loops, "opening is", "openings are") +
                                    " left where none was: choose smaller cells, or fill holes by patches."));
  add_sizes(result, findings);
  add_joints(result.checks, findings);
  return findings;
}

void require_faces(const PolyMesh& made, const RemeshLosses& losses) {
  if (made.face_count() > 0) return;
  const auto error = [](std::string message) {
    return make_error(Category::Geometry, "E_NOT_REMESHED", std::move(message));
  };
  Findings findings = {
      error("Nothing of the model could be remeshed: fill its holes by patches, which keep the surface.")};
  add_refused(losses, error(""), findings);
  throw Error(std::move(findings));
}

}  // namespace croquis::remeshing
