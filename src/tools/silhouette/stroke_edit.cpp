// SPDX-License-Identifier: GPL-3.0-or-later
#include "croquis/tools/silhouette/stroke_edit.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <Eigen/Geometry>

#include "croquis/base/error.h"
#include "croquis/base/limits.h"
#include "croquis/base/parameter.h"
#include "croquis/base/text.h"
#include "croquis/geometry/polyline.h"
#include "croquis/silhouette/stroke_data.h"
#include "tools/pointer/segment_distance.h"
#include "tools/silhouette/closing.h"
#include "tools/silhouette/redraw.h"
#include "tools/silhouette/stroke_places.h"

namespace croquis {
namespace {

bool meets_box(const Stroke& stroke, const PickBox& box) {
  for (std::size_t i = 0; i < segment_count(stroke); ++i) {
    if (meets_box(segment_begin(stroke, i), segment_end(stroke, i), box)) return true;
  }
  return false;
}

constexpr const char* scale_key = "scale";
constexpr const char* id_prefix = "stroke ";

/// A sketch's unit is a thousandth of its diagonal, as in the silhouette's options.
constexpr double units_per_diagonal = 1000;

double number_or_zero(const std::string& text) {
  double value = 0;
  return read_number(text, value) ? value : 0;
}

double diagonal(const Drawing& drawing) {
  Eigen::AlignedBox2d box;
  for (const Stroke& stroke : drawing.strokes) {
    for (const StrokeSample& sample : stroke.samples) box.extend(sample.position);
  }
  return box.isEmpty() ? 0 : box.diagonal().norm();
}

Stroke* find_to_change(Drawing& drawing, std::string_view id) {
  const Stroke* stroke = find_stroke(drawing, id);
  return stroke == nullptr ? nullptr : &drawing.strokes[static_cast<std::size_t>(stroke - drawing.strokes.data())];
}

void require_samples(const std::vector<StrokeSample>& samples) {
  if (samples.empty()) {
    throw Error(make_error(Category::Malformed, "E_NO_STROKES", "The stroke has no samples; draw it again."));
  }
  for (const StrokeSample& sample : samples) {
    if (!are_usable_numbers(sample.position)) {
      throw Error(
          make_error(Category::Malformed, "E_NOT_FINITE", "The stroke has a place that is not finite; draw it again."));
    }
  }
}

Stroke drawn_stroke(const Drawing& drawing, std::vector<StrokeSample> samples, const DrawOptions& options) {
  Stroke stroke;
  stroke.id = new_stroke_id(drawing);
  CloseOptions close_options = options.closing;
  close_options.units_per_pixel = options.units_per_pixel;
  const bool stays_open = passes_behind(drawing, samples, close_options);
  if (const auto closing = stays_open ? std::nullopt : find_closing(samples, close_options)) {
    stroke.closed = true;
    samples = {samples.begin() + static_cast<std::ptrdiff_t>(closing->first),
               samples.begin() + static_cast<std::ptrdiff_t>(closing->last) + 1};
  }
  const double start = samples.front().time;
  for (StrokeSample& sample : samples) sample.time -= start;
  stroke.samples = std::move(samples);
  while (stroke.closed && stroke.samples.back().position == stroke.samples.front().position) stroke.samples.pop_back();
  stroke.data[scale_key] = to_text(options.units_per_pixel);
  if (options.behind) stroke.data[silhouette::behind_key] = silhouette::behind_all;
  if (options.mirror) stroke.data[silhouette::mirror_key] = number_text(*options.mirror);
  return stroke;
}

/// Lets the stroke replace the part of an old one that it follows most closely, and takes that one's id.
bool redraw_best(Drawing& drawing, Stroke& stroke, const DrawOptions& options) {
  if (stroke.closed) return false;
  const RedrawLimits limits{options.redraw_distance * options.units_per_pixel, options.redraw_degrees};
  Stroke* best = nullptr;
  Redrawn redrawn;
  for (Stroke& old : drawing.strokes) {
    std::optional<Redrawn> candidate = redraw(old, stroke, limits);
    if (!candidate || (best != nullptr && candidate->distance >= redrawn.distance)) continue;
    best = &old;
    redrawn = std::move(*candidate);
  }
  if (best == nullptr) return false;
  best->samples = std::move(redrawn.samples);
  stroke.id = best->id;
  return true;
}

/// Distance from the dragged anchor at which its influence ends, to either side.
struct Falloff {
  double before = 0;  ///< arc length back to the neighbouring anchor, 0 when there is none
  double after = 0;
};

/// 1 at the anchor, 0 at its neighbour, without a kink at either: 1 - 3t² + 2t³.
double weight(double distance, double reach) {
  if (distance >= reach) return 0;
  const double t = distance / reach;
  return 1 - t * t * (3 - 2 * t);
}

class AnchorDrag {
 public:
  AnchorDrag(Stroke& stroke, const StrokeFit& fit, std::size_t anchor)
      : stroke_(stroke),
        centre_(fit.anchors[anchor].sample),
        closed_(fit.closed && stroke.closed),
        places_(places_of(stroke.samples)) {
    lengths_ = arc_lengths(places_, closed_);
    const std::size_t count = fit.anchors.size();
    falloff_.before = reach_to(fit, anchor > 0 || closed_, (anchor + count - 1) % count, false);
    falloff_.after = reach_to(fit, anchor + 1 < count || closed_, (anchor + 1) % count, true);
  }

  void apply(const Vec2& by) {
    for (std::size_t i = 0; i < places_.size(); ++i) {
      const bool is_centre = lengths_[i] == lengths_[centre_];  // samples of a pen held still included
      const double share = is_centre ? 1 : std::max(share_ahead(i), share_behind(i));
      if (share > 0) stroke_.samples[i].position += share * by;
    }
  }

 private:
  double around() const { return lengths_.back(); }

  /// Arc length from the anchor forward to a sample; of open strokes negative when it lies behind.
  double ahead(std::size_t i) const {
    const double length = lengths_[i] - lengths_[centre_];
    return closed_ && length < 0 ? length + around() : length;
  }

  double reach_to(const StrokeFit& fit, bool exists, std::size_t neighbour, bool forward) const {
    if (!exists) return 0;
    const std::size_t sample = fit.anchors[neighbour].sample;
    if (sample == centre_) return around() / 2;  // a loop of one anchor bends up to its other side
    const double length = ahead(sample);
    if (forward) return length;
    return closed_ ? around() - length : -length;
  }

  double share_ahead(std::size_t i) const {
    const double length = ahead(i);
    return length > 0 ? weight(length, falloff_.after) : 0;
  }

  double share_behind(std::size_t i) const {
    const double length = closed_ ? around() - ahead(i) : -ahead(i);
    return length > 0 ? weight(length, falloff_.before) : 0;
  }

  Stroke& stroke_;
  std::size_t centre_;
  bool closed_;
  std::vector<Vec2> places_;
  std::vector<double> lengths_;
  Falloff falloff_;
};

}  // namespace

std::optional<PickedStroke> nearest_place(const Stroke& stroke, const Vec2& place, const PickReach& reach) {
  std::optional<PickedStroke> best;
  double limit = reach.units();
  for (std::size_t i = 0; i < segment_count(stroke); ++i) {
    const Vec2& begin = segment_begin(stroke, i);
    const Vec2& end = segment_end(stroke, i);
    const double t = nearest_parameter(place, begin, end);
    const Vec2 foot = begin + t * (end - begin);
    const double distance = (foot - place).norm();
    if (distance > limit || (best && distance == limit)) continue;
    best = {stroke.id, i, t, foot, distance};
    limit = distance;
  }
  return best;
}

std::optional<PickedStroke> nearest_stroke(const Drawing& drawing, const Vec2& place, const PickReach& reach) {
  std::optional<PickedStroke> best;
  for (const Stroke& stroke : drawing.strokes) {
    std::optional<PickedStroke> picked = nearest_place(stroke, place, reach);
    if (picked && (!best || picked->distance <= best->distance)) best = std::move(picked);
  }
  return best;
}

std::optional<std::size_t> nearest_anchor(std::span<const StrokeAnchor> anchors, const Vec2& place,
                                          const PickReach& reach) {
  std::optional<std::size_t> best;
  double limit = reach.units();
  for (std::size_t k = 0; k < anchors.size(); ++k) {
    const double distance = (anchors[k].position - place).norm();
    if (distance > limit || (best && distance == limit)) continue;
    best = k;
    limit = distance;
  }
  return best;
}

std::vector<std::string> strokes_in_box(const Drawing& drawing, const PickBox& box) {
  std::vector<std::string> ids;
  for (const Stroke& stroke : drawing.strokes) {
    if (meets_box(stroke, box)) ids.push_back(stroke.id);
  }
  return ids;
}

const Stroke* find_stroke(const Drawing& drawing, std::string_view id) {
  const auto found = std::find_if(drawing.strokes.begin(), drawing.strokes.end(),
                                  [id](const Stroke& stroke) { return stroke.id == id; });
  return found == drawing.strokes.end() ? nullptr : &*found;
}

std::string new_stroke_id(const Drawing& drawing) {
  const std::string_view prefix = id_prefix;
  std::int64_t highest = 0;
  for (const Stroke& stroke : drawing.strokes) {
    if (!stroke.id.starts_with(prefix)) continue;
    const double number = number_or_zero(stroke.id.substr(prefix.size()));
    if (number >= 1 && number < 1e15) highest = std::max(highest, static_cast<std::int64_t>(number));
  }
  return std::string(prefix) + std::to_string(highest + 1);
}

double drawn_scale(const Drawing& drawing, const Stroke& stroke) {
  const auto found = stroke.data.find(scale_key);
  const double kept = found == stroke.data.end() ? 0 : number_or_zero(found->second);
  if (kept > 0 && std::isfinite(kept)) return kept;
  const double unit = diagonal(drawing) / units_per_diagonal;
  return unit > 0 && std::isfinite(unit) ? unit : 1;
}

StrokeFit fit_in_drawing(const Drawing& drawing, const Stroke& stroke) {
  FitOptions options;
  options.units_per_pixel = drawn_scale(drawing, stroke);
  return fit_stroke(stroke, options);
}

DrawingEdit draw_stroke(const Drawing& drawing, std::vector<StrokeSample> samples, const DrawOptions& options) {
  require_samples(samples);
  DrawingEdit edit{drawing, {}, {}, {}};
  Stroke stroke = drawn_stroke(drawing, std::move(samples), options);
  if (options.tube) {
    stroke.data[silhouette::kind_key] = silhouette::to_string(silhouette::StrokeKind::Tube);
    stroke.data[silhouette::radius_key] = number_text(*options.tube);
  }
  if (options.redraws && !options.behind && !options.tube && redraw_best(edit.drawing, stroke, options)) {
    edit.changed.push_back(stroke.id);
    return edit;
  }
  edit.added.push_back(stroke.id);
  edit.drawing.strokes.push_back(std::move(stroke));
  return edit;
}

DrawingEdit move_strokes(const Drawing& drawing, const std::vector<std::string>& ids, const Vec2& by) {
  DrawingEdit edit{drawing, {}, {}, {}};
  for (Stroke& stroke : edit.drawing.strokes) {
    if (!contains(ids, stroke.id)) continue;
    for (StrokeSample& sample : stroke.samples) sample.position += by;
    edit.changed.push_back(stroke.id);
  }
  let_ends_follow(drawing, edit);
  return edit;
}

DrawingEdit drag_anchor(const Drawing& drawing, std::string_view id, const StrokeFit& fit, std::size_t anchor,
                        const Vec2& by) {
  DrawingEdit edit{drawing, {}, {}, {}};
  Stroke* stroke = find_to_change(edit.drawing, id);
  const bool fits =
      stroke != nullptr && anchor < fit.anchors.size() && fit.anchors.back().sample < stroke->samples.size();
  if (!fits) {
    throw Error(make_error(Category::Usage, "E_INPUT",
                           "There is no stroke " + std::string(id) + " with a point " + std::to_string(anchor) +
                               "; choose one of the drawing.",
                           {{SubjectKind::Stroke, std::string(id), {}, {}, {}}}));
  }
  AnchorDrag(*stroke, fit, anchor).apply(by);
  edit.changed.push_back(stroke->id);
  let_ends_follow(drawing, edit);
  return edit;
}

DrawingEdit remove_strokes(const Drawing& drawing, const std::vector<std::string>& ids) {
  DrawingEdit edit{drawing, {}, {}, {}};
  std::erase_if(edit.drawing.strokes, [&](const Stroke& stroke) {
    const bool gone = contains(ids, stroke.id);
    if (gone) edit.removed.push_back(stroke.id);
    return gone;
  });
  return edit;
}

}  // namespace croquis
