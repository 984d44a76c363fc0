// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <tuple>
#include <vector>

#include "croquis/base/members.h"
#include "croquis/geometry/vector.h"

namespace croquis {
class StageCache;
}

namespace croquis::silhouette {

/// Lengths of the drawing stage are in sketch units u: the diagonal of the sketch's bounding box / 1000, so that a
/// drawing and its enlargement give the same solid. Lengths of the depth stage are in L, the median skeleton radius.

enum class Preset {
  Auto,   ///< any lines, what the options are by themselves: as Tablet but where the drawing is exact
  Clean,  ///< exact lines, vector drawings, snapped pens: ends meet what they belong to, outlines don't cross
  Tablet  ///< hand-drawn lines: smoothed, ends may miss by a share of what is drawn
};

/// What becomes of outlines that cross in full view.
enum class Crossings {
  Front,  ///< the closed stroke that was drawn later covers the other one, unless it is set to lie behind
  Refuse  ///< E_CROSS
};

/// Stroke preparation.
struct StrokeOptions {
  double step = 6;           ///< u, 2..20: spacing of contour samples
  double tiny = 12;          ///< u: shorter strokes are ignored with a warning
  double close = 8;          ///< u: ends nearer than this close the stroke
  double gap = 18;           ///< u: ends of two strokes nearer than this may be one line
  double snap = 14;          ///< u: how far an end may stop short of, or overshoot, the line it passes behind
  int smoothing_passes = 8;  ///< 0..20: Taubin passes
  Crossings crossings = Crossings::Front;
  /// What a hand may miss, in parts of the size of what it draws; with 0 only the lengths above count.
  double close_share = 0.05;  ///< of a stroke's length: the gap or overlap of its ends that closes it
  double aside_share = 0.03;  ///< of its length: how far aside of one another the ends of a closed stroke may lie
  double reach_share = 0.04;  ///< of an object's size: how far an end may miss the line that it passes behind
  bool adapts = true;  ///< where the drawing is exact, what hands miss and add is left out: Clean's values are taken
};
constexpr auto members(const StrokeOptions& options) {
  return std::tie(options.step, options.tiny, options.close, options.gap, options.snap, options.smoothing_passes,
                  options.crossings, options.close_share, options.aside_share, options.reach_share, options.adapts);
}
static_assert(lists_every_member<StrokeOptions>);

/// Completion of hidden contours.
struct CompletionOptions {
  double length_weight = 1;
  double curvature_weight = 0.3;
  double maximum_cost = 40;  ///< dearer candidates are not tried
  /// Ways to connect hidden ends that are tried for a part: a count, never a clock, so that the same drawing always
  /// gives the same answer. What is right can nearly always be labelled by the first ways; what is wrong tries them
  /// all.
  int maximum_matchings = 8;
};
constexpr auto members(const CompletionOptions& options) {
  return std::tie(options.length_weight, options.curvature_weight, options.maximum_cost, options.maximum_matchings);
}
static_assert(lists_every_member<CompletionOptions>);

/// The three qualities of the depth solve and what keeps parts apart. An object may override the weights.
struct DepthOptions {
  double weight_curvature = 1;      ///< 1e-3..1
  double weight_orientation = 0.1;  ///< 1e-3..1
  double weight_distance = 0.1;     ///< 1e-3..1
  double minimum_gap = 0.1;         ///< L, 0.01..1: least distance between sheets in front of one another
  double node_spacing = 0.3;        ///< local radii, 0.1..1: spacing of skeleton nodes along a branch
  double accuracy = 1e-4;           ///< L: objects whose heights may be farther from the best ones are refused
  /// Objects that are deeper, all together, than so many times the widths of what lies over what are refused: a part
  /// that is tilted between two others reaches beyond them.
  double depth_allowance = 2;
};
constexpr auto members(const DepthOptions& options) {
  return std::tie(options.weight_curvature, options.weight_orientation, options.weight_distance, options.minimum_gap,
                  options.node_spacing, options.accuracy, options.depth_allowance);
}
static_assert(lists_every_member<DepthOptions>);

/// What details of the drawing become.
enum class DetailShape {
  Line,    ///< lines on the surface
  Groove,  ///< cut into it
  Ridge    ///< raised from it
};

struct DetailOptions {
  DetailShape shape = DetailShape::Line;
  double width = 8;  ///< u, 2..50: of a groove or ridge, which is a quarter as deep
};

enum class Quality {
  Draft,  ///< to be looked at while something is dragged: coarser, unproven, attached parts not yet joined
  Final
};

/// How two objects that overlap are held.
enum class Hold {
  Apart,    ///< they keep the gap
  Resting,  ///< they touch, the upper one lying on the lower one: a wing on a body; each stays a surface of its own
  Joined    ///< they grow together to one surface: limb and body
};

/// Two objects that are held otherwise than apart, or apart where they would be attached by themselves.
struct AttachedPair {
  std::string a;  ///< names of objects; a stroke's id stands for the object that it bounds
  std::string b;
  double kappa = 0.55;  ///< 0..1: least distance of joined ones' middles, in parts of that of touching ones
  Hold hold = Hold::Joined;
  double blend = 0;  ///< 0..1: radius of the seam of joined ones, in radii of the thinner one; 0: a sharp seam
};

struct Options {
  StrokeOptions strokes;
  CompletionOptions completion;
  DepthOptions depth;
  std::vector<AttachedPair> attach;  ///< of two entries for one pair the later counts
  bool attach_suggested = false;     ///< pairs not named above are held as `attach_suggestions` says
  DetailOptions details;
  std::vector<Index> swaps;          ///< overlaps of tubes that are turned round, see `swap_overlaps`
  Quality quality = Quality::Final;  ///< of the surface; the labelled figure is the same for both
  StageCache* cache = nullptr;       ///< results of earlier runs, not owned; null: everything is computed

  static Options of(Preset preset) {
    Options options;
    options.strokes.adapts = preset == Preset::Auto;
    if (preset == Preset::Clean) {
      options.strokes.snap = 10;
      options.strokes.smoothing_passes = 2;
      options.strokes.crossings = Crossings::Refuse;
      options.strokes.close_share = 0;
      options.strokes.aside_share = 0;
      options.strokes.reach_share = 0;
    }
    return options;
  }
};

}  // namespace croquis::silhouette
