// SPDX-License-Identifier: GPL-3.0-or-later
#include "croquis/attribute_surface/attribute_surface.h"

#include <algorithm>
#include <cstddef>
#include <deque>
#include <optional>
#include <set>
#include <utility>
#include <vector>

#include "algorithms/attribute_surface/fences/normal_fences.h"
#include "algorithms/attribute_surface/network/loop_curves.h"
#include "algorithms/attribute_surface/network/placed_attributes.h"
#include "croquis/attribute_surface/network_elements.h"
#include "croquis/base/finding.h"
#include "croquis/base/stage_key.h"
#include "croquis/geometry/attribute_network.h"

namespace croquis {
namespace {

/// The number of the corner where a side begins.
std::size_t corner_before(const LoopCurves& curves, const AttributeSide& side) {
  return curves.curves[side.curve].corners[side.reversed ? 1 : 0];
}

std::size_t corner_after(const LoopCurves& curves, const AttributeSide& side) {
  return curves.curves[side.curve].corners[side.reversed ? 0 : 1];
}

/// Whether a face's loop runs through a curve backwards.
/// @pre it has the curve
bool runs_backwards(const AttributeFace& face, Index curve) {
  return std::ranges::find(face.loop, curve, &AttributeSide::curve)->reversed;
}

/// How many curves a loop may have; above most_tame there is a warning.
constexpr std::size_t most_sides = 64;
constexpr std::size_t most_tame_sides = 12;

const Vec3& side_end(const LoopCurves& curves, const AttributeSide& side, bool end) {
  const std::vector<Vec3>& control = curves.curves[side.curve].curve->control();
  return end != side.reversed ? control.back() : control.front();
}

class LoopCheck {
 public:
  LoopCheck(const AttributeNetwork& network, const LoopCurves& curves, double tolerance, Findings& findings)
      : network_(network), curves_(curves), tolerance_(tolerance), findings_(findings) {}

  bool closes(const AttributeFace& face) {
    if (face.loop.size() < 2) return report_too_few(face);
    if (face.loop.size() > most_sides) return report_too_many(face);
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
      report_gap(face, i, gap);
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

  void report_gap(const AttributeFace& face, std::size_t i, double gap) {
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

  bool report_too_few(const AttributeFace& face) {
    const std::string advice = is_one_closed_curve(face) ? "split it, best in 4" : "add the curves that close its loop";
    findings_.push_back(make_error(Category::Geometry, "E_TOO_FEW",
                                   "Face " + quoted(face.id) + " has " +
                                       (face.loop.empty() ? "no curve" : "one curve only") +
                                       ", and a surface needs 2 at least: " + advice + ".",
                                   subjects_of(face)));
    return false;
  }

  bool report_too_many(const AttributeFace& face) {
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
    } else if (*flipped_[other] != wanted && reported_.insert(side.curve).second) {
      report(network_.curves[side.curve].id, network_.faces[face].id, network_.faces[other].id);
    }
  }

  void report(const std::string& curve, const std::string& face, const std::string& other) {
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
  std::set<Index> reported_;
};

/// By face: whether its loop closes. Errors name what fails: E_TOO_FEW, E_TOO_MANY, E_OPEN_LOOP; W_TOO_MANY. A face
/// of a curve that failed fails without a finding of its own.
std::vector<bool> closed_loops(const AttributeNetwork& network, const LoopCurves& curves, double tolerance,
                               Findings& findings) {
  LoopCheck check(network, curves, tolerance, findings);
  std::vector<bool> closed;
  for (const AttributeFace& face : network.faces) closed.push_back(check.closes(face));
  return closed;
}

/// The faces with a closed loop around each curve.
std::vector<std::vector<Index>> faces_of_curves(const AttributeNetwork& network, const std::vector<bool>& closed) {
  std::vector<std::vector<Index>> result(network.curves.size());
  for (Index i = 0; i < network.faces.size(); ++i) {
    if (!closed[i]) continue;
    for (const AttributeSide& side : network.faces[i].loop) result[side.curve].push_back(i);
  }
  return result;
}

/// By face: whether it is to be turned round so that faces run through common curves in opposite directions. The first
/// face of each part that hangs together stays. Where that can't be: W_ORIENT, and one of them stays wrong.
std::vector<bool> flipped_faces(const AttributeNetwork& network, const std::vector<std::vector<Index>>& faces_of_curve,
                                Findings& findings) {
  return FaceTurns(network, faces_of_curve, findings).run();
}

/// Faces with more of their places turned over than this are reported.
constexpr double folded_share = 0.05;

AttributeNetwork with_overrides(const AttributeNetwork& network, const AttributeSurfaceOptions& options) {
  AttributeNetwork result = network;
  for (AttributeFace& face : result.faces) {
    face.mode = options.mode.value_or(face.mode);
    face.domain = options.domain.value_or(face.domain);
    face.fullness = options.fullness.value_or(face.fullness);
  }
  return result;
}

// ---- Keys of what is made from what

StageKey key_of(const SurfaceFrame& frame) {
  StageKey key;
  key.add(frame.mode).add(frame.domain).add(frame.fullness).add(frame.sides.size());
  for (const SurfaceSide& side : frame.sides) {
    key.add(side.curve->control()).add(side.reversed);
    key.add(side.fence.at).add(side.fence.normals).add(side.fence.magnitude);
  }
  return key;
}

template <typename Number>
void add_optional(StageKey& key, const std::optional<Number>& value) {
  key.add(value.has_value());
  if (value) key.add(*value);
}

StageKey key_of(const std::string& base, const PlacedAttributes& placed) {
  StageKey key;
  key.add(base).add(placed.points.size());
  for (const PlacedPoint& point : placed.points) {
    key.add(point.point).add(point.place).add(point.profile);
    add_optional(key, point.radius);
    add_optional(key, point.normal);
  }
  key.add(placed.curves.size());
  for (const PlacedCurve& curve : placed.curves) {
    key.add(curve.points).add(curve.places).add(curve.profile);
    add_optional(key, curve.radius);
  }
  return key;
}

// ---- Folds

/// Share of places inside where the surface is turned over against its loop.
double folded_part(const FaceSurface& surface) {
  constexpr int rings = 5;
  const DomainPolygon& polygon = surface.domain();
  Vec3 loop = Vec3::Zero();
  std::vector<Vec3> normals;
  Vec3 before = surface.at(polygon.corners.front());
  const Vec3 origin = before;
  const std::size_t sides = surface.frame().sides.size();
  for (std::size_t side = 0; side < sides; ++side) {
    for (int i = 1; i <= 8; ++i) {
      const Vec3 point = surface.at(surface.side_place(side, i / 8.0));
      loop += (before - origin).cross(point - origin);
      before = point;
    }
  }
  for (std::size_t corner = 0; corner < polygon.corners.size(); ++corner) {
    for (int ring = 1; ring <= rings; ++ring) {
      for (int part = 0; part < ring; ++part) {
        const double b = static_cast<double>(part) / (rings + 1);
        const SurfacePlace place = surface.evaluate(place_in(polygon, {corner, double(ring) / (rings + 1) - b, b}));
        normals.push_back(place.du.cross(place.dv));
      }
    }
  }
  const auto folded = std::ranges::count_if(normals, [&](const Vec3& normal) { return normal.dot(loop) < 0; });
  return static_cast<double>(folded) / static_cast<double>(normals.size());
}

/// Evaluates a network step by step.
class Evaluation {
 public:
  Evaluation(const AttributeNetwork& network, const AttributeSurfaceOptions& options)
      : network_(with_overrides(network, options)), cache_(options.cache) {}

  AttributeSurface run(Progress& progress) {
    result_.tolerance = tolerance_of(network_);
    result_.points.resize(network_.points.size());
    // 1. Curves with their ends where they meet, and loops of these.
    curves_ = meet_ends(network_, result_.tolerance, cache_, result_.findings);
    const std::vector<bool> closed = closed_loops(network_, curves_, result_.tolerance, result_.findings);
    const auto faces_of_curve = faces_of_curves(network_, closed);
    progress.report(0.1);
    // 2. Normals along the sides of smooth faces.
    std::vector<bool> wants_fences = closed;
    for (std::size_t i = 0; i < closed.size(); ++i) {
      wants_fences[i] = closed[i] && network_.faces[i].mode == AttributeMode::Smooth;
    }
    const NormalFences fences = make_fences({network_, curves_, faces_of_curve, wants_fences}, result_.findings);
    progress.report(0.2);
    // 3. The surfaces, with what lies on them.
    const std::vector<bool> flipped = flipped_faces(network_, faces_of_curve, result_.findings);
    for (Index i = 0; i < network_.faces.size(); ++i) {
      result_.faces.emplace_back();
      if (closed[i]) make_face(i, fences.sides[i]);
      result_.faces[i].flipped = flipped[i];
      progress.report(0.2 + 0.8 * static_cast<double>(i + 1) / static_cast<double>(network_.faces.size()));
    }
    add_curves(faces_of_curve, fences.smooth);
    return std::move(result_);
  }

 private:
  SurfaceFrame frame_of(const AttributeFace& face, const std::vector<NormalFence>& fences) const {
    SurfaceFrame frame{{}, face.mode, face.domain, face.fullness};
    for (std::size_t i = 0; i < face.loop.size(); ++i) {
      frame.sides.push_back({curves_.curves[face.loop[i].curve].curve, face.loop[i].reversed,
                             fences.empty() ? NormalFence() : fences[i]});
    }
    return frame;
  }

  void make_face(Index index, const std::vector<NormalFence>& fences) {
    const SurfaceFrame frame = frame_of(network_.faces[index], fences);
    const StageKey base_key = key_of(frame);
    const auto base = cached<FaceSurface>(
        cache_, "attribute surface sides", base_key, [&] { return FaceSurface(frame); },
        [](const FaceSurface& made) { return made.byte_size(); });
    AttributePlacing placing(network_, curves_, cache_, result_.findings);
    const PlacedAttributes placed = placing.place(index, *base, base_key.bytes(), result_.points);
    const StageKey key = key_of(base_key.bytes(), placed);
    SurfaceFace& face = result_.faces[index];
    face.surface = std::make_shared<const FaceSurface>(base->with(placed.points, placed.curves));
    face.content = key.bytes();
    face.folded = *cached<double>(
        cache_, "attribute surface folds", key, [&] { return folded_part(*face.surface); },
        [](double) { return sizeof(double); });
    report_face(network_.faces[index], face);
  }

  void report_face(const AttributeFace& face, const SurfaceFace& made) {
    const double beta = made.surface->domain().beta;
    if (beta > 0 && face.domain == AttributeDomain::Chordlength) {
      result_.findings.push_back(make_warning(
          Category::Geometry, "W_DOMAIN_RELAXED",
          "One curve of face " + quoted(face.id) + " is nearly as long as the others together, so its domain was " +
              "evened out (beta " + rounded_text(beta) + "): the surface is fine, its parameters are stretched there.",
          {subject_of(SubjectKind::Face, face.id)}));
    }
    if (made.folded > folded_share) {
      result_.findings.push_back(
          make_warning(Category::Geometry, "W_FOLD",
                       "Face " + quoted(face.id) + " is folded over at " + rounded_text(100 * made.folded) +
                           " % of its places: split it by a curve where its loop turns inwards or crosses itself.",
                       {subject_of(SubjectKind::Face, face.id)}));
    }
  }

  void add_curves(const std::vector<std::vector<Index>>& faces_of_curve, const std::vector<bool>& smooth) {
    for (std::size_t i = 0; i < curves_.curves.size(); ++i) {
      const LoopCurves::Curve& curve = curves_.curves[i];
      result_.curves.push_back({curve.curve, faces_of_curve[i], smooth[i], curve.corners[0], curve.corners[1]});
    }
    result_.corners = curves_.corners;
  }

  AttributeNetwork network_;
  StageCache* cache_;
  LoopCurves curves_;
  AttributeSurface result_;
};

}  // namespace

bool AttributeSurface::any() const {
  return std::ranges::any_of(faces, [](const SurfaceFace& face) { return face.surface != nullptr; });
}

AttributeSurface make_attribute_surface(const AttributeNetwork& network, Progress& progress,
                                        const AttributeSurfaceOptions& options) {
  return Evaluation(network, options).run(progress);
}

}  // namespace croquis
