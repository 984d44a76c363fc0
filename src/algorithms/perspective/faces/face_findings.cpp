// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/perspective/faces/face_findings.h"

#include <algorithm>
#include <set>

#include <Eigen/Geometry>

#include "croquis/base/text.h"

namespace croquis {
namespace {

/// Sentences name at most that many strokes; the finding's subjects have all.
constexpr std::size_t strokes_in_sentence = 6;

/// Strokes that meet at less than this (radians) go on smoothly: 15 degrees.
constexpr double least_corner = 0.2618;

std::vector<std::string> stroke_ids(const CurveNetwork& network, const std::vector<Index>& curves) {
  std::vector<std::string> ids;
  for (const Index c : curves) ids.push_back(network.curves[c].id);
  std::ranges::sort(ids);
  return ids;
}

std::string named_list(const std::vector<std::string>& ids) {
  std::string text;
  for (std::size_t i = 0; i < std::min(ids.size(), strokes_in_sentence); ++i) text += (i > 0 ? ", " : "") + ids[i];
  if (ids.size() > strokes_in_sentence) text += " and " + std::to_string(ids.size() - strokes_in_sentence) + " more";
  return text;
}

std::vector<Subject> stroke_subjects(const std::vector<std::string>& ids) {
  std::vector<Subject> subjects;
  for (const std::string& id : ids) {
    Subject subject;
    subject.kind = SubjectKind::Stroke;
    subject.id = id;
    subjects.push_back(std::move(subject));
  }
  return subjects;
}

Finding stroke_warning(const char* code, const std::string& sentence, const std::vector<std::string>& ids) {
  return make_warning(Category::Geometry, code, sentence, stroke_subjects(ids));
}

std::vector<Index> curves_of_face(const NetworkFace& face) {
  std::vector<Index> curves;
  for (const CurveLoop& loop : face.loops) {
    for (const CurveUse& use : loop) curves.push_back(use.curve);
  }
  std::ranges::sort(curves);
  return curves;
}

void add_loose(const CurveNetwork& network, const FaceFindingResult& result, Findings& findings) {
  for (const std::string& id : stroke_ids(network, result.dangling)) {
    findings.push_back(stroke_warning(
        "DANGLING", "Stroke " + id + " has an end that leads nowhere, so it bounds no face: join it to other strokes.",
        {id}));
  }
  for (const std::string& id : stroke_ids(network, result.bridges)) {
    findings.push_back(stroke_warning("DANGLING",
                                      "Stroke " + id +
                                          " is the only connection of two parts, so it bounds no face: draw the other "
                                          "edges between them or remove it.",
                                      {id}));
  }
}

void add_straight_faces(const CurveNetwork& network, const FaceFindingResult& result, Findings& findings) {
  for (const NetworkFace& face : result.best.faces) {
    const std::vector<Index> curves = curves_of_face(face);
    if (face.planar || !std::ranges::all_of(curves, [&](Index c) { return network.curves[c].straight; })) continue;
    const std::vector<std::string> ids = stroke_ids(network, curves);
    findings.push_back(stroke_warning("NONPLANAR_STRAIGHT_FACE",
                                      "The straight strokes " + named_list(ids) +
                                          " bound a face that isn't flat: a stroke is probably missing between them.",
                                      ids));
  }
}

/// How many strokes that can bound faces meet at each vertex.
std::vector<int> valences(const CurveNetwork& network, const FaceFindingResult& result) {
  std::vector<int> count(network.vertices.size(), 0);
  for (Index c = 0; c < network.curves.size(); ++c) {
    if (std::ranges::binary_search(result.dangling, c) || std::ranges::binary_search(result.bridges, c)) continue;
    ++count[network.curves[c].start];
    ++count[network.curves[c].end];
  }
  return count;
}

/// Smooth faces with a corner where no third stroke leads on.
void add_missing(const CurveNetwork& network, const FaceFindingResult& result, Findings& findings) {
  const std::vector<int> valence = valences(network, result);
  std::set<std::vector<std::string>> found;
  for (const NetworkFace& face : result.best.faces) {
    if (face.planar) continue;
    const CurveLoop& loop = face.loops[0];
    for (std::size_t i = 0; i < loop.size(); ++i) {
      const NetworkCurve &a = network.curves[loop[i].curve], &b = network.curves[loop[(i + 1) % loop.size()].curve];
      const bool b_reversed = loop[(i + 1) % loop.size()].reversed;
      if (valence[loop[i].reversed ? a.start : a.end] != 2 || (a.straight && b.straight)) continue;
      const Vec3 back = loop[i].reversed ? a.direction_from_start() : a.direction_from_end();
      const Vec3 ahead = b_reversed ? b.direction_from_end() : b.direction_from_start();
      if (angle_between(-back, ahead) > least_corner) found.insert({std::min(a.id, b.id), std::max(a.id, b.id)});
    }
  }
  for (const std::vector<std::string>& ids : found) {
    findings.push_back(stroke_warning("MISSING_STROKE",
                                      "The strokes " + ids[0] + " and " + ids[1] +
                                          " meet in a corner of a smooth face from which no third stroke leads on: "
                                          "draw the edge that begins there.",
                                      ids));
  }
}

void add_ambiguous(const CurveNetwork& network, const FaceFindingResult& result, Findings& findings) {
  std::set<Index> differing;
  std::set<std::vector<Index>> best;
  for (const NetworkFace& face : result.best.faces) best.insert(curves_of_face(face));
  for (const FaceSet& set : result.alternatives) {
    for (const NetworkFace& face : set.faces) {
      const std::vector<Index> curves = curves_of_face(face);
      if (!best.contains(curves)) differing.insert(curves.begin(), curves.end());
    }
  }
  const std::vector<std::string> ids = stroke_ids(network, {differing.begin(), differing.end()});
  findings.push_back(stroke_warning("AMBIGUOUS",
                                    "The strokes " + named_list(ids) + " can be given faces in " +
                                        counted(result.alternatives.size() + 1, "way", "ways") +
                                        " that fit about as well: choose the faces there.",
                                    ids));
}

}  // namespace

Findings face_findings(const CurveNetwork& network, const FaceFindingResult& result, bool limited) {
  Findings findings;
  add_loose(network, result, findings);
  if (!result.open_curves.empty()) {
    const std::vector<std::string> ids = stroke_ids(network, result.open_curves);
    findings.push_back(stroke_warning("NOT_CLOSED",
                                      "No set of faces closes the solid; the strokes " + named_list(ids) +
                                          " lack a face: draw the edges that are missing next to them.",
                                      ids));
  }
  add_straight_faces(network, result, findings);
  add_missing(network, result, findings);
  if (!result.alternatives.empty()) add_ambiguous(network, result, findings);
  if (limited) {
    findings.push_back(make_warning(Category::Limit, "SEARCH_LIMIT",
                                    "The search for faces ended at its limit, so a better set may exist: choose some "
                                    "faces by hand or raise the parameter search-limit."));
  }
  return findings;
}

}  // namespace croquis
