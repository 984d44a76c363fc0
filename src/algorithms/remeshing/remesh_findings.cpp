// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/remeshing/remesh_findings.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <functional>
#include <span>
#include <string>
#include <utility>

#include "croquis/base/error.h"
#include "croquis/base/text.h"
#include "croquis/hole_filling/fill_findings.h"

namespace croquis::remeshing {
namespace {

using namespace hole_filling;

constexpr std::size_t most_named = 3;  // holes in one sentence

Finding warning(std::string code, std::string message) {
  return make_warning(Category::Geometry, std::move(code), std::move(message));
}

/// "2 parts with 1 handle".
std::string described(const SurfaceTopology& topology) {
  const auto handles = static_cast<std::int64_t>(topology.components) - topology.euler / 2;
  std::string text = counted(topology.components, "part", "parts");
  if (handles > 0) text += " with " + counted(static_cast<std::size_t>(handles), "handle", "handles");
  return text;
}

std::string number(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.4g", value);
  return text;
}

std::string sentence(const PieceLosses& part, double cell) {
  std::string text = "Piece " + std::to_string(part.piece) + " of the model ";
  if (part.wanted) text += "came out as " + described(part.made) + " instead of " + described(*part.wanted);
  if (part.lost_points > 0)
    text += std::string(part.wanted ? ", and " : "has lost its surface at ") +
            counted(part.lost_points, "point", "points") + (part.wanted ? " lost their surface" : "");
  if (part.retried) return text + ", with smaller cells too: fill holes by patches, which keep the surface.";
  return text + ": choose cells of " + number(cell / 4) + " mean edges, or fill holes by patches.";
}

using Sentence = std::function<std::string(const PieceLosses&)>;

/// Of pieces to which a sentence applies, else it's empty: the first few one by one.
/// @param more what is said of the others, in one sentence
void tell_pieces(const RemeshLosses& losses, const std::string& code, const Sentence& sentence_of,
                 const std::string& more, Findings& findings) {
  constexpr std::size_t most_told = 5;
  std::size_t count = 0;
  for (const PieceLosses& part : losses.parts) {
    std::string text = sentence_of(part);
    if (text.empty() || ++count > most_told) continue;
    Finding finding = warning(code, std::move(text));
    finding.subjects = {numbered_subject(SubjectKind::Point, part.piece, {part.at.x(), part.at.y(), part.at.z()})};
    findings.push_back(std::move(finding));
  }
  if (count <= most_told) return;
  findings.push_back(warning(code, counted(count - most_told, "more piece has", "more pieces have") + more));
}

void tell_parts(const RemeshLosses& losses, Findings& findings) {
  const auto has_lost = [&](const PieceLosses& part) {
    return part.wanted || part.lost_points > 0 ? sentence(part, losses.cell) : "";
  };
  tell_pieces(losses, "W_DETAIL_LOST", has_lost, " lost detail: choose smaller cells, or fill holes by patches.",
              findings);
}

std::string room_sentence(const PieceLosses& part) {
  const RoomChange& room = part.room;
  if (!room.any() && !part.implied) return "";
  std::string text;
  const auto add = [&](const std::string& what) { text += (text.empty() ? "" : " and ") + what; };
  if (room.shrunk > 0) add("ends " + number(room.shrunk) + " short of the scan's box");
  if (room.grown > 0) add("leads " + number(room.grown) + " out of the scan's box");
  if (room.given != room.made) add("encloses " + number(room.made) + " instead of " + number(room.given));
  if (part.implied)
    add("came out as " + described(part.made) + " where the scan's own sheets make " + described(*part.implied));
  const std::string others = part.together > 1 ? " with those that it was made one solid with" : "";
  return "Piece " + std::to_string(part.piece) + " of the model" + others + " " + text +
         ": choose smaller cells, or fill holes by patches, which keep the surface.";
}

std::string loose_sentence(const PieceLosses& part) {
  if (part.loose == 0) return "";
  return "Piece " + std::to_string(part.piece) + " of the model has " + counted(part.loose, "vertex", "vertices") +
         " farther than half a cell off the scan, where its surface can't be brought nearer without cutting through "
         "itself: choose smaller cells, or fill holes by patches.";
}

/// Where what came out isn't what the scan is.
void tell_shapes(const RemeshLosses& losses, Findings& findings) {
  tell_pieces(losses, "W_SHAPE_DIFFERS", room_sentence,
              " other boxes or volumes than the scan's: choose smaller cells, or fill holes by patches.", findings);
  tell_pieces(losses, "W_OFF_SCAN", loose_sentence,
              " vertices farther than half a cell off the scan: choose smaller cells, or fill holes by patches.",
              findings);
}

/// Surface that nothing of the scan is near to, however well its holes seem to be closed. The middle of any hole of a
/// tenth of the diagonal is so far away: a little of that is nothing to tell.
constexpr double told_share = 0.01;

void tell_far(const RemeshResult& result, const RemeshLosses& losses, Findings& findings) {
  if (result.checks.far_share < told_share) return;
  std::string text = number(100 * result.checks.far_share) +
                     " % of the surface is farther than a twentieth of the model's diagonal from the scan";
  for (std::size_t i = 0; i < std::min(losses.far_holes.size(), most_named); ++i)
    text += (i == 0 ? (losses.far_holes.size() > 1 ? ", in holes " : ", in hole ") : ", ") +
            std::to_string(losses.far_holes[i]);
  if (losses.far_holes.size() > most_named)
    text += " and " + std::to_string(losses.far_holes.size() - most_named) + " more";
  Finding finding = warning("W_FAR_FROM_SCAN", text + ": look at the shape there, or leave those holes open.");
  const Vec3& at = losses.far_at;
  finding.subjects = {numbered_subject(SubjectKind::Point, 0, {at.x(), at.y(), at.z()})};
  findings.push_back(std::move(finding));
}

std::string sentence(const RefusedPiece& refused) {
  const std::string piece = "Piece " + std::to_string(refused.piece) + " of the model ";
  if (refused.other != RefusedPiece::no_piece)
    return piece + "was left out: its new surface crosses that of piece " + std::to_string(refused.other) +
           ", and no solid stands for both; take them apart, or fill holes by patches, which keep all pieces.";
  return piece + "was left out: its new surface would lack " +
         std::to_string(static_cast<int>(std::lround(100 * refused.lost_share))) +
         " % of the scan's; choose smaller cells, or fill holes by patches, which keep the surface.";
}

/// The first few one by one.
void tell_refused(const RemeshLosses& losses, const Finding& like, Findings& findings) {
  constexpr std::size_t most_told = 5;
  const std::size_t told = std::min(losses.refused.size(), most_told);
  for (const RefusedPiece& refused : std::span(losses.refused).first(told)) {
    Finding finding = like;
    finding.message = sentence(refused);
    finding.subjects = {
        numbered_subject(SubjectKind::Point, refused.piece, {refused.at.x(), refused.at.y(), refused.at.z()})};
    findings.push_back(std::move(finding));
  }
  if (told == losses.refused.size()) return;
  Finding finding = like;
  finding.message = counted(losses.refused.size() - told, "more piece was", "more pieces were") +
                    " left out for such reasons: choose smaller cells, or fill holes by patches.";
  findings.push_back(std::move(finding));
}

void tell_united(const RemeshChecks& checks, Findings& findings) {
  if (checks.united_pieces == 0) return;
  findings.push_back(warning("W_PIECES_UNITED",
                             std::to_string(checks.united_pieces) +
                                 " pieces of the model cross or nearly touch each other and were made into one solid: "
                                 "take them apart before if they should stay pieces."));
}

/// Cells never make a model many times as large without a word.
void tell_faces(const RemeshResult& result, Findings& findings) {
  constexpr double many = 4;  // times the triangles given
  constexpr std::size_t few = 20'000;
  const auto given = static_cast<double>(result.analysis.view.triangles.size());
  const double growth = static_cast<double>(result.mesh.face_count()) / given;
  if (result.coarsening > 1)
    findings.push_back(warning("W_CELLS_ENLARGED", "Cells are " + number(result.coarsening) +
                                                       " times as large as usual, since the scan's triangles are of "
                                                       "many sizes: choose smaller cells to keep the finest detail."));
  if (growth > many && result.mesh.face_count() > few)
    findings.push_back(warning("W_MANY_FACES", "The result has " + number(growth) +
                                                   " times the faces of the scan, of thin parts or large triangles: "
                                                   "choose larger cells, or fill holes by patches."));
}

void tell_views(const RemeshChecks& checks, Findings& findings) {
  if (checks.joined_views == 0) return;
  findings.push_back(warning("W_VIEWS_JOINED", std::to_string(checks.joined_views) +
                                                   " pieces of the model go on in one another like views of one thing "
                                                   "and were made one surface: align them better if it is rough."));
}

void tell_turned(const RemeshChecks& checks, Findings& findings) {
  if (checks.turned_views == 0) return;
  findings.push_back(
      warning("W_VIEWS_TURNED", counted(checks.turned_views, "piece of the model faces", "pieces of the model face") +
                                    " the other way than those that they lie upon and were turned over: "
                                    "turn them in the scan if they are sides of a thin wall."));
}

void tell_cuts(const RemeshChecks& checks, Findings& findings) {
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
  tell_refused(losses, warning("W_PIECE_REFUSED", ""), findings);
  tell_parts(losses, findings);
  tell_shapes(losses, findings);
  tell_far(result, losses, findings);
  if (result.checks.failed_loops > 0)
    findings.push_back(
        warning("W_NOT_CLOSED", counted(result.checks.failed_loops, "opening is", "openings are") +
                                    " left where none was: choose smaller cells, or fill holes by patches."));
  tell_faces(result, findings);
  tell_turned(result.checks, findings);
  tell_views(result.checks, findings);
  tell_united(result.checks, findings);
  tell_cuts(result.checks, findings);
  return findings;
}

void require_faces(const PolyMesh& made, const RemeshLosses& losses) {
  if (made.face_count() > 0) return;
  const auto error = [](std::string message) {
    return make_error(Category::Geometry, "E_NOT_REMESHED", std::move(message));
  };
  Findings findings = {
      error("Nothing of the model could be remeshed: fill its holes by patches, which keep the "
            "surface.")};
  tell_refused(losses, error(""), findings);
  throw Error(std::move(findings));
}

}  // namespace croquis::remeshing
