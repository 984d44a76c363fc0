// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/hole_filling/patching/implicit_patch.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <utility>

#include "algorithms/hole_filling/continuation/rim_field.h"
#include "algorithms/hole_filling/fairing/harmonic_values.h"
#include "algorithms/hole_filling/fairing/patch_displacement.h"
#include "algorithms/hole_filling/fairing/patch_editing.h"
#include "algorithms/hole_filling/fairing/patch_relaxation.h"
#include "algorithms/hole_filling/patching/patcher.h"
#include "algorithms/hole_filling/patching/site_memory.h"
#include "algorithms/hole_filling/patching/untangling.h"
#include "algorithms/hole_filling/triangulation/triangle_cost.h"
#include "croquis/hole_filling/wide_holes.h"
#include "croquis/implicit/surface_improvement.h"

namespace croquis::hole_filling {
namespace {

constexpr double stiffness = 3;  // the smoothing's factor, when careful
constexpr int usual_rounds = 3;
constexpr int careful_rounds = 5;        // and of patches that begin with cubes, whose triangles are worse
constexpr int draft_rounds = 2;          // of a patch that is only to be pulled
constexpr int smoothings_per_round = 2;  // per round

/// Newton's steps square what is left: one shorter than this ends within 1e-3 of an edge of the surface, and the next
/// smoothing moves farther than that anyway. × cell
constexpr double draft_accuracy = 0.03;
constexpr double final_accuracy = 1e-4;

/// Steps are damped where the field is flatter than 0.2, and then take too many to get there. What is near the surface
/// already after the draft comes to rest on it by Newton's own, down to this gradient.
constexpr double least_settling_gradient = 0.01;
constexpr int most_settling_steps = 6;

/// A patch that moves farther from its rims than this is given up: the surface around doesn't close. × size
constexpr double longest_way = 1.5;

constexpr std::size_t most_guides = 80;
constexpr int size_rounds = 10;

/// Of how far the rim is off, which is a hundredth of an edge.
constexpr double meeting_accuracy = 1e-4;

/// The zero set has a vertex this near to any place that it goes through, or it doesn't go there. × edge
constexpr double farthest_pin = 1.5;

/// The new vertices of a patch as the editing takes them, and back.
class Loosening {
 public:
  Loosening(const HoleSite& site, const HolePatch& patch) : rim_(vertices_of(patch.triangles)), site_(site) {
    rim_.erase(std::lower_bound(rim_.begin(), rim_.end(), given(site)), rim_.end());
  }

  LoosePatch loosen(const HolePatch& patch) const {
    LoosePatch loose;
    loose.rim_points = rim_.size();
    for (const Index v : rim_) loose.points.push_back(site_.mesh->positions[v]);
    loose.points.insert(loose.points.end(), patch.points.begin(), patch.points.end());
    for (auto t : patch.triangles) {
      for (Index& v : t) v = v < given(site_) ? rim_number(v) : v - given(site_) + rim_count();
      loose.triangles.push_back(t);
    }
    loose.sizes = mean_lengths({loose.points.data(), loose.rim_points}, rim_edges());
    spread_sizes(loose);
    return loose;
  }

  HolePatch fasten(const LoosePatch& loose) const {
    HolePatch patch{site_.holes, {loose.points.begin() + rim_count(), loose.points.end()}, loose.triangles};
    for (auto& t : patch.triangles) {
      for (Index& v : t) v = v < rim_count() ? rim_[v] : v - rim_count() + given(site_);
    }
    return patch;
  }

 private:
  static Index given(const HoleSite& site) { return static_cast<Index>(site.mesh->vertex_count()); }
  Index rim_count() const { return static_cast<Index>(rim_.size()); }
  Index rim_number(Index v) const {
    return static_cast<Index>(std::lower_bound(rim_.begin(), rim_.end(), v) - rim_.begin());
  }

  std::vector<std::array<Index, 2>> rim_edges() const {
    std::vector<std::array<Index, 2>> edges;
    for (Index i = 0; i < site_.vertices.size(); ++i)
      edges.push_back({rim_number(site_.vertices[i]), rim_number(site_.vertices[site_.polygon.next(i)])});
    return edges;
  }

  /// Continues the rim's sizes inwards, ring by ring; what lies deeper than there are rounds has their mean.
  static void spread_sizes(LoosePatch& loose) {
    const double mean =
        std::accumulate(loose.sizes.begin(), loose.sizes.end(), 0.0) / static_cast<double>(loose.rim_points);
    loose.sizes.resize(loose.points.size(), mean);
    for (int round = 0; round < size_rounds; ++round) {
      std::vector<double> sums(loose.points.size(), 0), counts(loose.points.size(), 0);
      for (const auto& [a, b, c] : loose.triangles) {
        sums[a] += loose.sizes[b] + loose.sizes[c];
        sums[b] += loose.sizes[c] + loose.sizes[a];
        sums[c] += loose.sizes[a] + loose.sizes[b];
        for (const Index v : {a, b, c}) counts[v] += 2;
      }
      for (std::size_t v = loose.rim_points; v < loose.points.size(); ++v) {
        if (counts[v] > 0) loose.sizes[v] = sums[v] / counts[v];
      }
    }
  }

  std::vector<Index> rim_;
  const HoleSite& site_;
};

/// Wants larger triangles where there would be more than `most`.
void limit_count(LoosePatch& loose, std::size_t most) {
  double predicted = 0;
  for (const auto& [a, b, c] : loose.triangles) {
    const double size = (loose.sizes[a] + loose.sizes[b] + loose.sizes[c]) / 3;
    predicted += triangle_area(loose.points[a], loose.points[b], loose.points[c]) / (std::sqrt(3.0) / 4 * size * size);
  }
  const double growth = std::sqrt(std::max(1.0, predicted / static_cast<double>(most)));
  for (std::size_t v = loose.rim_points; v < loose.sizes.size(); ++v) loose.sizes[v] *= growth;
}

/// Of the equilateral triangle of mean area.
double mean_edge(const LoosePatch& loose) {
  double area = 0;
  for (const auto& [a, b, c] : loose.triangles)
    area += triangle_area(loose.points[a], loose.points[b], loose.points[c]);
  return std::sqrt(4 / std::sqrt(3.0) * area / static_cast<double>(loose.triangles.size()));
}

/// Where the place to begin from decides whether a patch comes to rest.
bool is_wide(const HoleSite& site) {
  return std::any_of(site.holes.begin(), site.holes.end(), [&](Index id) { return is_wide(*site.analysis, id); });
}

class ImplicitPatcher : public Patcher {
 public:
  ImplicitPatcher(const ImplicitOptions& options, std::size_t most_triangles, bool careful, int rounds)
      : options_(options),
        most_triangles_(most_triangles),
        careful_(careful),
        rounds_(rounds),
        start_(faired_patcher(1, most_triangles, careful_)),
        quick_start_(evenly_faired_patcher(most_triangles)) {}

  const char* method() const override { return careful_ ? "implicit-careful" : "implicit"; }

  std::optional<HolePatch> attempt(const HoleSite& site, Progress& progress) const override {
    if (!site.wish.through.empty()) return pulled(site, progress);
    const bool is_quick = !careful_ && !is_wide(site);
    const auto start = (is_quick ? quick_start_ : start_)->attempt(site, progress);
    if (!start || start->points.empty()) return start;
    return continued(site, *start, {}, progress);
  }

  std::optional<HolePatch> laid_onto(const HoleSite& site, const RimField& surface, const HolePatch& start,
                                     Progress& progress) const {
    const Loosening loosening(site, start);
    LoosePatch loose = loosening.loosen(start);
    // From creases, and over wide holes, smoothing twice may lead too far away.
    const int projected = rounds_ > usual_rounds || is_wide(site) ? 1 : smoothings_per_round;
    if (!move_onto(surface, loose, site.wish.through, projected, progress)) return std::nullopt;
    const std::vector<std::size_t> pins = nearest_free(loose, site.wish.through);
    if (pins.size() < site.wish.through.size()) return std::nullopt;
    HolePatch patch = loosening.fasten(loose);
    meet_rim(site, surface, patch);
    for (std::size_t i = 0; i < pins.size(); ++i) patch.points[pins[i] - loose.rim_points] = site.wish.through[i];
    patch.domain_points = surface.domain_points;
    return patch;
  }

 private:
  std::optional<HolePatch> continued(const HoleSite& site, const HolePatch& start, std::vector<PassingPoint> guides,
                                     Progress& progress) const {
    progress.check();
    const auto surface = fitted_once(site, options_, {careful_ ? stiffness : 1, careful_, std::move(guides)});
    if (!surface) return std::nullopt;
    auto patch = laid_onto(site, *surface, start, progress);
    if (patch && careful_) untangle(site, *patch, progress);
    return patch;
  }

  /// The patch as it comes is pulled to the places that it is to go through; what it looks like then guides the fit.
  /// The places alone would be met by a spike.
  std::optional<HolePatch> pulled(const HoleSite& site, Progress& progress) const {
    HoleSite plain = site;
    plain.wish.through.clear();
    plain.memory = nullptr;
    auto start = ImplicitPatcher(options_, most_triangles_, careful_, draft_rounds).attempt(plain, progress);
    if (!start) start = start_->attempt(plain, progress);
    if (!start || !displace_through(*site.mesh, *start, site.wish.through)) return std::nullopt;
    const double spacing = 2 * mean_rim_edge(site);
    return continued(site, *start, spread_points(*site.mesh, *start, spacing, most_guides), progress);
  }

  /// @param projected after so many smoothings, a divisor of those of a round; in the last round after each
  bool move_onto(const RimField& surface, LoosePatch& loose, const std::vector<Vec3>& through, int projected,
                 Progress& progress) const {
    implicit::ProjectionOptions projection;
    projection.cell = std::max(surface.edge, mean_edge(loose));
    projection.iterations = 20 + static_cast<int>(std::min(200.0, 2 * surface.size / projection.cell));
    projection.accuracy = draft_accuracy;
    projection.threads = 1;
    for (int round = 0; round < rounds_; ++round) {
      progress.check();
      const bool is_last = round + 1 == rounds_;
      const std::vector<std::uint8_t> fixed = pinned(loose, through);
      if (round == 0) implicit::project(loose.points, fixed, surface.field(), projection);
      std::size_t not_converged = 0;
      for (int i = 0; i < smoothings_per_round; ++i) {
        relax(loose, fixed);
        if (!is_last && (i + 1) % projected != 0) continue;
        if (is_last && i + 1 == smoothings_per_round) projection.accuracy = final_accuracy;
        not_converged = implicit::project(loose.points, fixed, surface.field(), projection).not_converged;
      }
      if (is_last && not_converged > 0) not_converged = settle(surface, fixed, projection, loose);
      if (has_run_away(surface, loose, through) || (is_last && not_converged > 0)) return false;
      if (is_last) break;
      limit_count(loose, most_triangles_);
      if (!bring_to_size(loose)) return false;
    }
    return true;
  }

  /// @return how many points are still not on the surface
  static std::size_t settle(const RimField& surface, const std::vector<std::uint8_t>& fixed,
                            implicit::ProjectionOptions projection, LoosePatch& loose) {
    projection.least_gradient = least_settling_gradient;
    projection.iterations = most_settling_steps;
    return implicit::project(loose.points, fixed, surface.field(), projection).not_converged;
  }

  /// The new vertex nearest to each of the places, each another one; fewer when there aren't so many near enough.
  static std::vector<std::size_t> nearest_free(const LoosePatch& loose, const std::vector<Vec3>& places) {
    std::vector<std::size_t> pins;
    for (const Vec3& place : places) {
      std::size_t best = loose.points.size();
      for (std::size_t v = loose.rim_points; v < loose.points.size(); ++v) {
        if ((best == loose.points.size() || (loose.points[v] - place).norm() < (loose.points[best] - place).norm()) &&
            std::find(pins.begin(), pins.end(), v) == pins.end())
          best = v;
      }
      if (best == loose.points.size() || (loose.points[best] - place).norm() > farthest_pin * loose.sizes[best]) break;
      pins.push_back(best);
    }
    return pins;
  }

  /// Vertices near the places that the patch goes through come to lie there.
  /// @return marks of what stays: they and the rims
  static std::vector<std::uint8_t> pinned(LoosePatch& loose, const std::vector<Vec3>& places) {
    std::vector<std::uint8_t> fixed(loose.points.size(), 0);
    std::fill_n(fixed.begin(), loose.rim_points, std::uint8_t{1});
    const std::vector<std::size_t> pins = nearest_free(loose, places);
    for (std::size_t i = 0; i < pins.size(); ++i) {
      loose.points[pins[i]] = places[i];
      fixed[pins[i]] = 1;
    }
    return fixed;
  }

  static bool has_run_away(const RimField& surface, const LoosePatch& loose, const std::vector<Vec3>& through) {
    Vec3 low = loose.points.front(), high = low;
    const auto include = [&](const Vec3& p) {
      low = low.cwiseMin(p);
      high = high.cwiseMax(p);
    };
    std::for_each_n(loose.points.begin(), loose.rim_points, include);
    std::for_each(through.begin(), through.end(), include);
    const Vec3 reach = Vec3::Constant(longest_way * surface.size);
    return !std::all_of(loose.points.begin(), loose.points.end(), [&](const Vec3& p) {
      return (p.array() >= (low - reach).array()).all() && (p.array() <= (high + reach).array()).all();
    });
  }

  /// Smoothing keeps the field a little off the rim: the patch follows by a harmonic displacement.
  static void meet_rim(const HoleSite& site, const RimField& surface, HolePatch& patch) {
    const PatchGraph graph(patch, static_cast<Index>(site.mesh->vertex_count()));
    std::vector<Vec3> feet;
    for (const Index v : graph.rim_vertices()) feet.push_back(site.mesh->positions[v]);
    implicit::ProjectionOptions projection;
    projection.cell = surface.edge;
    projection.accuracy = final_accuracy;
    projection.threads = 1;
    implicit::project(feet, {}, surface.field(), projection);
    for (std::size_t i = 0; i < feet.size(); ++i) feet[i] = site.mesh->positions[graph.rim_vertices()[i]] - feet[i];
    const std::vector<Vec3> moves = graph.harmonic(feet, meeting_accuracy);
    for (std::size_t i = 0; i < moves.size(); ++i) patch.points[i] += moves[i];
  }

  ImplicitOptions options_;
  std::size_t most_triangles_;
  bool careful_;
  int rounds_;
  std::shared_ptr<const Patcher> start_, quick_start_;
};

}  // namespace

std::shared_ptr<const Patcher> implicit_patcher(const ImplicitOptions& options, std::size_t most_triangles,
                                                bool careful) {
  const int rounds = careful ? careful_rounds : usual_rounds;
  return std::make_shared<ImplicitPatcher>(options, most_triangles, careful, rounds);
}

std::optional<HolePatch> lay_onto(const HoleSite& site, const RimField& surface, const HolePatch& start,
                                  std::size_t most_triangles, Progress& progress) {
  return ImplicitPatcher({}, most_triangles, false, careful_rounds).laid_onto(site, surface, start, progress);
}

}  // namespace croquis::hole_filling
