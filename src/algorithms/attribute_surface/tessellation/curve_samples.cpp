// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/attribute_surface/tessellation/curve_samples.h"

#include <algorithm>
#include <map>
#include <utility>

namespace croquis {
namespace {

/// Parts are halved no more often than that.
constexpr int most_halvings = 12;

double distance_to_chord(const Vec3& place, const Vec3& from, const Vec3& to) {
  const Vec3 along = to - from;
  const double square = along.squaredNorm();
  const double t = square > 0 ? std::clamp((place - from).dot(along) / square, 0.0, 1.0) : 0;
  return (place - from - t * along).norm();
}

/// How far a part of a curve is from its chord, at a quarter, half and three quarters.
double chord_error(const ArcLengthCurve& curve, double from, double to) {
  const Vec3 first = curve.at(from), last = curve.at(to);
  double error = 0;
  for (const double part : {0.25, 0.5, 0.75})
    error = std::max(error, distance_to_chord(curve.at(from + part * (to - from)), first, last));
  return error;
}

void halve(const ArcLengthCurve& curve, double tolerance, double from, double to, int halvings,
           std::vector<double>& fractions) {
  if (halvings > 0 && chord_error(curve, from, to) > tolerance) {
    const double middle = 0.5 * (from + to);
    halve(curve, tolerance, from, middle, halvings - 1, fractions);
    halve(curve, tolerance, middle, to, halvings - 1, fractions);
  } else {
    fractions.push_back(to);
  }
}

std::vector<double> even_fractions(std::size_t parts) {
  std::vector<double> fractions;
  for (std::size_t i = 0; i <= parts; ++i) fractions.push_back(static_cast<double>(i) / static_cast<double>(parts));
  return fractions;
}

/// How many parts a curve needs at least, so that no two triangles have the same corners.
class LeastParts {
 public:
  LeastParts(const AttributeNetwork& network, const AttributeSurface& surface)
      : surface_(surface), uses_(network.curves.size(), Use::None) {
    for (std::size_t f = 0; f < surface.faces.size(); ++f) {
      if (surface.faces[f].surface == nullptr) continue;
      const auto& loop = network.faces[f].loop;
      for (const AttributeSide& side : loop)
        uses_[side.curve] = std::max(uses_[side.curve], loop.size() == 2 ? Use::OfTwo : Use::Side);
    }
    for (std::size_t c = 0; c < uses_.size(); ++c) {
      if (is_used(c)) ++curves_between_[ends_of(c)];
    }
  }

  bool is_used(std::size_t curve) const { return uses_[curve] != Use::None; }

  /// Of a face of two curves: the middle is a corner of its domain, so it is a sample.
  bool has_middle(std::size_t curve) const { return uses_[curve] == Use::OfTwo; }

  std::size_t of(std::size_t curve) const {
    const auto ends = ends_of(curve);
    if (ends.first == ends.second) return has_middle(curve) ? 4 : 3;
    return curves_between_.at(ends) > 1 || has_middle(curve) ? 2 : 1;
  }

 private:
  enum class Use { None, Side, OfTwo };

  std::pair<std::size_t, std::size_t> ends_of(std::size_t curve) const {
    return std::minmax(surface_.curves[curve].start, surface_.curves[curve].end);
  }

  const AttributeSurface& surface_;
  std::vector<Use> uses_;
  std::map<std::pair<std::size_t, std::size_t>, int> curves_between_;
};

std::vector<double> fractions_of(const ArcLengthCurve& curve, std::size_t index, const LeastParts& least,
                                 const SurfaceTessellationOptions& options) {
  if (options.tolerance) return fractions_by_chords(curve, *options.tolerance, least.of(index));
  std::size_t parts = std::max(options.samples, least.of(index));
  if (least.has_middle(index)) parts += parts % 2;
  return even_fractions(parts);
}

}  // namespace

std::vector<double> fractions_by_chords(const ArcLengthCurve& curve, double tolerance, std::size_t least) {
  std::vector<double> fractions{0};
  const std::vector<double> parts = even_fractions(least);
  for (std::size_t i = 0; i + 1 < parts.size(); ++i)
    halve(curve, tolerance, parts[i], parts[i + 1], most_halvings, fractions);
  return fractions;
}

std::vector<CurveSamples> sample_curves(const AttributeNetwork& network, const AttributeSurface& surface,
                                        const SurfaceTessellationOptions& options) {
  const LeastParts least(network, surface);
  std::vector<CurveSamples> samples(network.curves.size());
  for (std::size_t c = 0; c < samples.size(); ++c) {
    if (!least.is_used(c)) continue;
    const ArcLengthCurve& curve = *surface.curves[c].curve;
    CurveSamples& made = samples[c];
    if (c < options.given.size() && !options.given[c].at.empty()) {
      made = options.given[c];
    } else {
      made.at = fractions_of(curve, c, least, options);
      made.points.reserve(made.at.size());
      for (const double at : made.at) made.points.push_back(curve.at(at));
    }
    made.points.front() = curve.control().front();
    made.points.back() = curve.control().back();
  }
  return samples;
}

}  // namespace croquis
