// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/attribute_surface/network/face_loops.h"

#include <algorithm>
#include <deque>
#include <optional>
#include <set>
#include <utility>

#include "algorithms/attribute_surface/network/network_words.h"

namespace croquis {
namespace {

const Vec3& side_end(const LoopCurves& curves, const AttributeSide& side, bool end) {
  const std::vector<Vec3>& control = curves.curves[side.curve].curve->control();
  return end != side.reversed ? control.back() : control.front();
}

class LoopCheck {
 public:
  LoopCheck(const AttributeNetwork& network, const LoopCurves& curves, double tolerance, Findings& findings)
      : network_(network), curves_(curves), tolerance_(tolerance), findings_(findings) {}

  bool closes(const AttributeFace& face) {
    if (face.loop.size() < 2) return tell_too_few(face);
    if (face.loop.size() > most_sides) return tell_too_many(face);
    if (face.loop.size() > most_tame_sides) warn_of_many(face);
    const bool made = std::ranges::all_of(
        face.loop, [&](const AttributeSide& side) { return curves_.curves[side.curve].curve != nullptr; });
    return made && meets(face);
  }

 private:
  bool meets(const AttributeFace& face) {
    bool closed = true;
    for (std::size_t i = 0; i < face.loop.size(); ++i) {
      const AttributeSide& side = face.loop[i];
      const AttributeSide& next = face.loop[(i + 1) % face.loop.size()];
      if (corner_after(curves_, side) == corner_before(curves_, next)) continue;
      const double gap = (side_end(curves_, side, true) - side_end(curves_, next, false)).norm();
      if (gap <= tolerance_) continue;
      tell_gap(face, i, gap);
      closed = false;
    }
    return closed;
  }

  /// Walked along backwards, the side or the next one would close the gap.
  std::optional<Index> to_be_flipped(const AttributeSide& side, const AttributeSide& next) const {
    const auto meet = [&](bool end, bool next_end) {
      return (side_end(curves_, side, end) - side_end(curves_, next, next_end)).norm() <= tolerance_;
    };
    if (meet(true, true)) return next.curve;
    if (meet(false, false) || meet(false, true)) return side.curve;
    return std::nullopt;
  }

  void tell_gap(const AttributeFace& face, std::size_t i, double gap) {
    const AttributeSide& side = face.loop[i];
    const AttributeSide& next = face.loop[(i + 1) % face.loop.size()];
    const std::string& first = network_.curves[side.curve].id;
    const std::string& second = network_.curves[next.curve].id;
    const auto flip = to_be_flipped(side, next);
    const std::string advice =
        flip ? "walk along curve " + quoted(network_.curves[*flip].id) + " the other way (change its sign)"
             : "move the ends together, or add the curve that is missing";
    findings_.push_back(make_error(Category::Geometry, "E_OPEN_LOOP",
                                   "The loop of face " + quoted(face.id) + " is open between curves " + quoted(first) +
                                       " and " + quoted(second) + ", whose ends are " + length_text(network_, gap) +
                                       " apart (tolerance " + length_text(network_, tolerance_) + "): " + advice + ".",
                                   {subject_of(SubjectKind::Face, face.id), subject_of(SubjectKind::Curve, first),
                                    subject_of(SubjectKind::Curve, second)}));
  }

  bool is_one_closed_curve(const AttributeFace& face) const {
    if (face.loop.size() != 1) return false;
    const auto& corners = curves_.curves[face.loop[0].curve].corners;
    return corners[0] == corners[1];
  }

  bool tell_too_few(const AttributeFace& face) {
    const std::string advice = is_one_closed_curve(face) ? "split it, best in 4" : "add the curves that close its loop";
    findings_.push_back(make_error(Category::Geometry, "E_TOO_FEW",
                                   "Face " + quoted(face.id) + " has " +
                                       (face.loop.empty() ? "no curve" : "one curve only") +
                                       ", and a surface needs 2 at least: " + advice + ".",
                                   subjects_of(face)));
    return false;
  }

  bool tell_too_many(const AttributeFace& face) {
    findings_.push_back(make_error(Category::Geometry, "E_TOO_MANY",
                                   "Face " + quoted(face.id) + " has " + std::to_string(face.loop.size()) +
                                       " curves, and a surface can have " + std::to_string(most_sides) +
                                       ": split the face, or join curves.",
                                   {subject_of(SubjectKind::Face, face.id)}));
    return false;
  }

  void warn_of_many(const AttributeFace& face) {
    findings_.push_back(make_warning(Category::Geometry, "W_TOO_MANY",
                                     "Face " + quoted(face.id) + " has " + std::to_string(face.loop.size()) +
                                         " curves: above " + std::to_string(most_tame_sides) +
                                         " surfaces become flat in the middle; split the face where it matters.",
                                     {subject_of(SubjectKind::Face, face.id)}));
  }

  std::vector<Subject> subjects_of(const AttributeFace& face) const {
    std::vector<Subject> subjects{subject_of(SubjectKind::Face, face.id)};
    for (const AttributeSide& side : face.loop) {
      subjects.push_back(subject_of(SubjectKind::Curve, network_.curves[side.curve].id));
    }
    return subjects;
  }

  const AttributeNetwork& network_;
  const LoopCurves& curves_;
  double tolerance_;
  Findings& findings_;
};

/// Turns faces round, from one to the next across their common curves.
class FaceTurns {
 public:
  FaceTurns(const AttributeNetwork& network, const std::vector<std::vector<Index>>& faces_of_curve, Findings& findings)
      : network_(network), faces_of_curve_(faces_of_curve), findings_(findings), flipped_(network.faces.size()) {}

  std::vector<bool> run() {
    for (Index first = 0; first < network_.faces.size(); ++first) {
      if (flipped_[first]) continue;
      flipped_[first] = false;
      waiting_.push_back(first);
      while (!waiting_.empty()) {
        const Index face = waiting_.front();
        waiting_.pop_front();
        for (const AttributeSide& side : network_.faces[face].loop) cross_over(face, side);
      }
    }
    std::vector<bool> result;
    for (const auto& flip : flipped_) result.push_back(*flip);
    return result;
  }

 private:
  void cross_over(Index face, const AttributeSide& side) {
    const std::vector<Index>& both = faces_of_curve_[side.curve];
    if (both.size() != 2 || std::ranges::find(both, face) == both.end()) return;
    const Index other = both[0] == face ? both[1] : both[0];
    const bool same_way = side.reversed == runs_backwards(network_.faces[other], side.curve);
    const bool wanted = *flipped_[face] != same_way;
    if (!flipped_[other]) {
      flipped_[other] = wanted;
      waiting_.push_back(other);
    } else if (*flipped_[other] != wanted && told_.insert(side.curve).second) {
      tell(network_.curves[side.curve].id, network_.faces[face].id, network_.faces[other].id);
    }
  }

  void tell(const std::string& curve, const std::string& face, const std::string& other) {
    findings_.push_back(make_warning(Category::Geometry, "W_ORIENT",
                                     "The faces " + quoted(face) + " and " + quoted(other) +
                                         " can't both be turned to one side of the surface along curve " +
                                         quoted(curve) + ", as on a Moebius strip: their normals differ there.",
                                     {subject_of(SubjectKind::Curve, curve), subject_of(SubjectKind::Face, face),
                                      subject_of(SubjectKind::Face, other)}));
  }

  const AttributeNetwork& network_;
  const std::vector<std::vector<Index>>& faces_of_curve_;
  Findings& findings_;
  std::vector<std::optional<bool>> flipped_;
  std::deque<Index> waiting_;
  std::set<Index> told_;
};

}  // namespace

std::vector<bool> closed_loops(const AttributeNetwork& network, const LoopCurves& curves, double tolerance,
                               Findings& findings) {
  LoopCheck check(network, curves, tolerance, findings);
  std::vector<bool> closed;
  for (const AttributeFace& face : network.faces) closed.push_back(check.closes(face));
  return closed;
}

std::vector<std::vector<Index>> faces_of_curves(const AttributeNetwork& network, const std::vector<bool>& closed) {
  std::vector<std::vector<Index>> result(network.curves.size());
  for (Index i = 0; i < network.faces.size(); ++i) {
    if (!closed[i]) continue;
    for (const AttributeSide& side : network.faces[i].loop) result[side.curve].push_back(i);
  }
  return result;
}

std::size_t corner_before(const LoopCurves& curves, const AttributeSide& side) {
  return curves.curves[side.curve].corners[side.reversed ? 1 : 0];
}

std::size_t corner_after(const LoopCurves& curves, const AttributeSide& side) {
  return curves.curves[side.curve].corners[side.reversed ? 0 : 1];
}

bool runs_backwards(const AttributeFace& face, Index curve) {
  return std::ranges::find(face.loop, curve, &AttributeSide::curve)->reversed;
}

std::vector<bool> flipped_faces(const AttributeNetwork& network, const std::vector<std::vector<Index>>& faces_of_curve,
                                Findings& findings) {
  return FaceTurns(network, faces_of_curve, findings).run();
}

}  // namespace croquis
