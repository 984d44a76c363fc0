// SPDX-License-Identifier: GPL-3.0-or-later
#include "croquis/perspective/face_finding.h"

#include <algorithm>
#include <map>
#include <set>

#include <Eigen/Geometry>

#include "algorithms/perspective/faces/cover_search.h"
#include "algorithms/perspective/faces/free_faces.h"
#include "algorithms/perspective/faces/plane_faces.h"
#include "algorithms/perspective/faces/shells.h"
#include "croquis/base/text.h"
#include "croquis/geometry/disjoint_sets.h"

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
    subjects.push_back({SubjectKind::Stroke, id, {}, {}, {}});
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

/// The warnings about a result that has everything else.
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

/// Of the nodes for sets that close, how many a search for partial ones gets: these serve while somebody still draws.
constexpr std::size_t partial_share = 10;

/// Edges that are covered together, and what was found for them.
struct CoverPart {
  std::vector<Index> edges;
  std::vector<Index> members;
  CoverResult result;
};

class FaceFinder {
 public:
  FaceFinder(const CurveNetwork& network, Progress& progress, const FaceFindingOptions& options)
      : network_(network),
        progress_(progress),
        options_(options),
        graph_(make_solid_graph(network)),
        planes_(planes_of(network, graph_, options.plane_tolerance * graph_.size)) {}

  FaceFindingResult run() {
    for (Index e = 0; e < graph_.edges.size(); ++e) open_.insert(e);
    Progress candidates = progress_.step("find loops", 0.2);
    for (Index p = 0; p < planes_.size(); ++p) add(faces_in_plane(graph_, planes_[p], p));
    add_free({FreeFaceKind::WithCurves, options_.max_sides, nullptr}, candidates);
    candidates.report(1);
    Progress search = progress_.step("choose faces", 0.7);
    cover(false, search);
    if (!open_.empty()) cover_partly(search);
    search.report(1);
    FaceFindingResult result = make_result();
    progress_.report(1);
    return result;
  }

 private:
  /// Takes candidates that are neither forbidden nor known; of those with the same edges the cheapest counts.
  void add(std::vector<FaceCandidate> faces) {
    for (FaceCandidate& face : faces) {
      const std::set<std::string> name = name_of_face(face);
      const auto is_named = [&](const FaceName& other) { return std::set(other.begin(), other.end()) == name; };
      if (std::ranges::any_of(options_.forbidden, is_named)) continue;
      const auto [known, is_new] = by_edges_.try_emplace(face.edges, static_cast<Index>(candidates_.size()));
      if (is_new) {
        if (std::ranges::any_of(options_.fixed, is_named)) fixed_.insert(known->second);
        candidates_.push_back(std::move(face));
      } else if (face.cost < candidates_[known->second].cost && face.plane == candidates_[known->second].plane) {
        candidates_[known->second] = std::move(face);
      }
    }
  }

  std::set<std::string> name_of_face(const FaceCandidate& face) const {
    std::set<std::string> name;
    if (options_.fixed.empty() && options_.forbidden.empty()) return name;
    for (const Index e : face.edges) name.insert(network_.curves[graph_.edges[e].curve].id);
    return name;
  }

  void add_free(const FreeFaceSearch& wanted, Progress& progress) {
    FreeFaces found = free_faces(graph_, planes_, wanted, progress);
    loops_cut_short_ = loops_cut_short_ || found.cut_short;
    add(std::move(found.candidates));
  }

  /// The open edges in parts that share no candidate.
  std::vector<CoverPart> parts() const {
    DisjointSets sets(graph_.edges.size());
    std::vector<Index> usable;
    for (Index c = 0; c < candidates_.size(); ++c) {
      const std::vector<Index>& edges = candidates_[c].edges;
      if (!std::ranges::all_of(edges, [&](Index e) { return open_.contains(e); })) continue;
      usable.push_back(c);
      for (const Index e : edges) sets.unite(edges[0], e);
    }
    std::map<Index, CoverPart> by_root;
    for (const Index e : open_) by_root[sets.root(e)].edges.push_back(e);
    for (const Index c : usable) by_root[sets.root(candidates_[c].edges[0])].members.push_back(c);
    std::vector<CoverPart> result;
    for (auto& [root, part] : by_root) result.push_back(std::move(part));
    return result;
  }

  CoverResult search_part(const CoverPart& part, bool partial, Progress& progress) {
    CoverProblem problem{graph_, candidates_, part.edges, part.members, {}, partial};
    std::ranges::set_intersection(part.members, fixed_, std::back_inserter(problem.fixed));
    problem.margin = options_.margin;
    problem.max_covers = options_.max_alternatives + 1;
    problem.node_limit = partial ? options_.node_limit / partial_share : options_.node_limit;
    CoverResult result = search_covers(problem, progress);
    nodes_ += result.nodes;
    return result;
  }

  /// Covers the open edges part by part; what is covered is open no longer.
  void cover(bool partial, Progress& progress) {
    for (CoverPart& part : parts()) {
      part.result = search_part(part, partial, progress);
      limited_ = limited_ || part.result.limited;
      if (part.result.covers.empty()) continue;
      for (const Index e : part.edges) open_.erase(e);
      settled_.push_back(std::move(part));
    }
  }

  /// Where nothing closes: sides that then have no face may be those of a face that is long, or straight all around.
  void cover_partly(Progress& progress) {
    std::vector<std::uint8_t> lacking(graph_.edges.size(), 0);
    for (const CoverPart& part : parts()) {
      const CoverResult result = search_part(part, true, progress);
      std::map<Index, int> sides;
      if (!result.covers.empty()) {
        for (const Index c : result.covers[0].chosen) {
          for (const Index e : candidates_[c].edges) ++sides[e];
        }
      }
      for (const Index e : part.edges) lacking[e] = sides[e] < 2 ? 1 : 0;
    }
    const std::size_t late = std::max(options_.max_sides, options_.max_sides_late);
    add_free({FreeFaceKind::AllStraight, late, &lacking}, progress);
    add_free({FreeFaceKind::WithCurves, late, &lacking}, progress);
    cover(true, progress);
  }

  /// The best choice of every part, but of one part another one.
  FaceSet face_set(std::size_t changed_part, std::size_t number) const {
    std::vector<Index> chosen;
    double cost = 0;
    for (std::size_t p = 0; p < settled_.size(); ++p) {
      const Cover& cover = settled_[p].result.covers[p == changed_part ? number : 0];
      chosen.insert(chosen.end(), cover.chosen.begin(), cover.chosen.end());
      cost += cover.cost;
    }
    std::ranges::sort(chosen);
    return make_shells(graph_, candidates_, chosen, cost);
  }

  FaceFindingResult make_result() const {
    FaceFindingResult result;
    result.best = face_set(0, 0);
    for (std::size_t p = 0; p < settled_.size(); ++p) {
      for (std::size_t i = 1; i < settled_[p].result.covers.size(); ++i) result.alternatives.push_back(face_set(p, i));
    }
    std::ranges::stable_sort(result.alternatives, {}, &FaceSet::cost);
    if (result.alternatives.size() > options_.max_alternatives) result.alternatives.resize(options_.max_alternatives);
    result.dangling = graph_.dangling;
    result.bridges = graph_.bridges;
    result.open_curves = open_curves(result.best);
    result.candidates = candidates_.size();
    result.internal_rejected = count_internal(graph_, candidates_, chosen_faces());
    result.nodes = nodes_;
    const bool limited = limited_ || (loops_cut_short_ && !result.open_curves.empty());
    result.warnings = face_findings(network_, result, limited);
    return result;
  }

  std::vector<Index> chosen_faces() const {
    std::vector<Index> chosen;
    for (const CoverPart& part : settled_) {
      chosen.insert(chosen.end(), part.result.covers[0].chosen.begin(), part.result.covers[0].chosen.end());
    }
    std::ranges::sort(chosen);
    return chosen;
  }

  std::vector<Index> open_curves(const FaceSet& set) const {
    std::map<Index, int> sides;
    for (const GraphEdge& edge : graph_.edges) sides[edge.curve] = 0;
    for (const NetworkFace& face : set.faces) {
      for (const CurveLoop& loop : face.loops) {
        for (const CurveUse& use : loop) ++sides[use.curve];
      }
    }
    std::vector<Index> open;
    for (const auto& [curve, count] : sides) {
      if (count < 2) open.push_back(curve);
    }
    return open;
  }

  const CurveNetwork& network_;
  Progress& progress_;
  const FaceFindingOptions& options_;
  SolidGraph graph_;
  std::vector<EdgePlane> planes_;
  std::vector<FaceCandidate> candidates_;
  std::map<std::vector<Index>, Index> by_edges_;
  std::set<Index> fixed_;
  std::set<Index> open_;  ///< edges that no cover was found for
  std::vector<CoverPart> settled_;
  bool loops_cut_short_ = false, limited_ = false;
  std::size_t nodes_ = 0;
};

}  // namespace

FaceFindingResult find_faces(const CurveNetwork& network, Progress& progress, const FaceFindingOptions& options) {
  return FaceFinder(network, progress, options).run();
}

}  // namespace croquis
