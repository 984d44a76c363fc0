// SPDX-License-Identifier: GPL-3.0-or-later
#include "croquis/attribute_surface/attribute_surface.h"

#include <algorithm>
#include <utility>

#include "algorithms/attribute_surface/fences/normal_fences.h"
#include "algorithms/attribute_surface/network/face_loops.h"
#include "algorithms/attribute_surface/network/loop_curves.h"
#include "algorithms/attribute_surface/network/network_words.h"
#include "algorithms/attribute_surface/network/placed_attributes.h"
#include "croquis/attribute_surface/network_elements.h"
#include "croquis/base/stage_key.h"

namespace croquis {
namespace {

/// Faces with more of their places turned over than this are told.
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
    tell_face(network_.faces[index], face);
  }

  void tell_face(const AttributeFace& face, const SurfaceFace& made) {
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
