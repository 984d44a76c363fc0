// SPDX-License-Identifier: GPL-3.0-or-later
#include "tools/silhouette/mirror_strokes.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "croquis/base/parameter.h"
#include "croquis/base/text.h"
#include "croquis/geometry/polyline.h"
#include "croquis/silhouette/stroke_data.h"
#include "croquis/tools/strokes/stroke_source.h"
#include "tools/silhouette/stroke_places.h"

namespace croquis {
namespace {

using Samples = std::vector<StrokeSample>;

Stroke* find_to_mirror(Drawing& drawing, const std::string& id) {
  const auto found = std::ranges::find(drawing.strokes, id, &Stroke::id);
  return found == drawing.strokes.end() ? nullptr : &*found;
}

std::string said(const Stroke& stroke, const char* key) {
  const auto found = stroke.data.find(key);
  return found == stroke.data.end() ? std::string() : found->second;
}

StrokeSample reflected(StrokeSample sample, double axis) {
  sample.position.x() = 2 * axis - sample.position.x();
  sample.tilt.x() = -sample.tilt.x();
  return sample;
}

/// A part of a stroke on one side of the line.
struct Side {
  Samples samples;
  bool begins_at_line = false, ends_at_line = false;
};

StrokeSample on_line(const StrokeSample& a, const StrokeSample& b, double axis) {
  const double t = (axis - a.position.x()) / (b.position.x() - a.position.x());
  StrokeSample sample = a;
  sample.position = Vec2(axis, a.position.y() + t * (b.position.y() - a.position.y()));
  sample.pressure += t * (b.pressure - a.pressure);
  sample.time += t * (b.time - a.time);
  return sample;
}

/// The parts between the places where the samples cross the line; of a closed stroke the last goes on into the first.
std::vector<Side> sides_of(const Stroke& stroke, double axis) {
  const auto side = [&](const StrokeSample& sample) { return sample.position.x() < axis ? -1 : 1; };
  std::vector<Side> parts(1);
  for (std::size_t k = 0; k < stroke.samples.size(); ++k) {
    const StrokeSample& sample = stroke.samples[k];
    parts.back().samples.push_back(sample);
    const bool last = k + 1 == stroke.samples.size();
    if (last && !stroke.closed) break;
    const StrokeSample& next = stroke.samples[last ? 0 : k + 1];
    if (side(sample) == side(next)) continue;
    const StrokeSample crossing = on_line(sample, next, axis);
    parts.back().samples.push_back(crossing);
    parts.back().ends_at_line = true;
    parts.push_back({{crossing}, true, false});
  }
  if (stroke.closed && parts.size() > 1) {
    Samples& end = parts.back().samples;
    end.insert(end.end(), parts.front().samples.begin(), parts.front().samples.end());
    parts.back().ends_at_line = true;
    parts.erase(parts.begin());
  }
  return parts;
}

/// Where most has changed, if the stroke has the same samples as before.
std::optional<double> changed_at(const Stroke& stroke, const Stroke* old) {
  if (old == nullptr || old->samples.size() != stroke.samples.size()) return std::nullopt;
  double most = 0, least = (stroke.samples.front().position - old->samples.front().position).norm();
  std::optional<double> at;
  for (std::size_t k = 0; k < stroke.samples.size(); ++k) {
    const double way = (stroke.samples[k].position - old->samples[k].position).norm();
    if (way > most) at = stroke.samples[k].position.x();
    most = std::max(most, way);
    least = std::min(least, way);
  }
  return least < 0.99 * most ? at : std::nullopt;  // moved as a whole it changes nowhere
}

/// The longest part of the stroke beside the line; its free ends go to the line where they are near.
/// @param wanted x of a place on its side; none: of either
Side main_side(const Stroke& stroke, double axis, double reach, std::optional<double> wanted) {
  std::vector<Side> parts = sides_of(stroke, axis);
  const auto is_wanted = [&](const Side& part) {
    const double middle = part.samples[part.samples.size() / 2].position.x();
    return !wanted || (middle < axis) == (*wanted < axis);
  };
  if (std::ranges::any_of(parts, is_wanted)) std::erase_if(parts, [&](const Side& part) { return !is_wanted(part); });
  const auto length_of = [](const Side& part) { return length(places_of(part.samples), false); };
  Side side = *std::ranges::max_element(parts, {}, length_of);
  if (stroke.closed) return side;
  const auto take_to_line = [&](StrokeSample& end, bool& at_line) {
    if (at_line || std::abs(end.position.x() - axis) > reach) return;
    end.position.x() = axis;
    at_line = true;
  };
  take_to_line(side.samples.front(), side.begins_at_line);
  take_to_line(side.samples.back(), side.ends_at_line);
  return side;
}

/// Completes the stroke by its mirror image. @param old what it was before the edit, or null
/// @return false: it lies beside the line, and is as it was
bool complete(Stroke& stroke, const Stroke* old, double axis, double reach) {
  Side side = main_side(stroke, axis, reach, changed_at(stroke, old));
  if (!side.begins_at_line && !side.ends_at_line) return false;
  if (!side.ends_at_line) {
    std::ranges::reverse(side.samples);
    std::swap(side.begins_at_line, side.ends_at_line);
  }
  stroke.closed = side.begins_at_line;
  Samples all = side.samples;
  const std::size_t first = stroke.closed ? 1 : 0;  // a closed stroke doesn't repeat its first sample
  for (std::size_t k = side.samples.size() - 1; k-- > first;) all.push_back(reflected(side.samples[k], axis));
  for (std::size_t k = 0; k < all.size(); ++k) all[k].time = all.front().time + static_cast<double>(k) * 1e-3;
  stroke.samples = std::move(all);
  return true;
}

/// The ids that a stroke lies behind, as they are on the other side.
std::string behind_on_other_side(const Drawing& drawing, const std::string& names) {
  std::string text;
  for (const std::string_view name : text_parts(names, ",")) {
    const Stroke* stroke = find_stroke(drawing, name);
    const std::string twin = stroke == nullptr ? std::string() : said(*stroke, silhouette::twin_key);
    text += (text.empty() ? "" : ",") + (twin.empty() ? std::string(name) : twin);
  }
  return text;
}

/// Makes a stroke's twin what the stroke is, seen in the mirror. The twin is added where there is none.
void follow(const std::string& id, double axis, DrawingEdit& edit) {
  const Stroke stroke = *find_stroke(edit.drawing, id);
  const std::string name = said(stroke, silhouette::twin_key);
  Stroke* twin = name.empty() ? nullptr : find_to_mirror(edit.drawing, name);
  Stroke made = stroke;
  made.id = twin != nullptr ? twin->id : new_stroke_id(edit.drawing);
  made.data[silhouette::twin_key] = id;
  for (StrokeSample& sample : made.samples) sample = reflected(sample, axis);
  if (const auto behind = made.data.find(silhouette::behind_key); behind != made.data.end())
    behind->second = behind_on_other_side(edit.drawing, behind->second);
  (twin != nullptr ? edit.changed : edit.added).push_back(made.id);
  find_to_mirror(edit.drawing, id)->data[silhouette::twin_key] = made.id;
  if (twin != nullptr)
    *find_to_mirror(edit.drawing, name) = std::move(made);
  else
    edit.drawing.strokes.push_back(std::move(made));
}

void end_symmetry(Stroke& stroke) {
  stroke.data.erase(silhouette::mirror_key);
  stroke.data.erase(silhouette::twin_key);
}

}  // namespace

DrawingEdit on_both_sides(const Drawing& before, DrawingEdit edit) {
  std::vector<std::string> done;
  for (const std::string& id : std::vector(edit.removed)) {
    const std::string twin = said(*find_stroke(before, id), silhouette::twin_key);
    if (twin.empty() || contains(edit.removed, twin) || find_stroke(edit.drawing, twin) == nullptr) continue;
    std::erase_if(edit.drawing.strokes, [&](const Stroke& stroke) { return stroke.id == twin; });
    edit.removed.push_back(twin);
  }
  std::erase_if(edit.changed, [&](const std::string& id) { return contains(edit.removed, id); });
  std::vector<std::string> ids = edit.changed;
  ids.insert(ids.end(), edit.added.begin(), edit.added.end());
  for (const std::string& id : ids) {
    Stroke* stroke = find_to_mirror(edit.drawing, id);
    double axis = 0;
    if (stroke == nullptr || contains(done, id) || !read_number(said(*stroke, silhouette::mirror_key), axis)) continue;
    const Stroke* old = find_stroke(before, id);
    if (old == nullptr) stroke->data.erase(silhouette::twin_key);  // a piece of another stroke
    const double reach = CloseOptions().distance * drawn_scale(edit.drawing, *stroke);
    const bool is_pair = !said(*stroke, silhouette::twin_key).empty();
    if (!is_pair && old != nullptr && old->closed && !stroke->closed) {
      end_symmetry(*stroke);
      continue;
    }
    if (is_pair || !complete(*stroke, old, axis, reach)) {
      follow(id, axis, edit);
      done.push_back(said(*find_stroke(edit.drawing, id), silhouette::twin_key));
    }
  }
  return edit;
}

}  // namespace croquis
