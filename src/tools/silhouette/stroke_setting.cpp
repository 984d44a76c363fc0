// SPDX-License-Identifier: GPL-3.0-or-later
#include "croquis/tools/silhouette/stroke_setting.h"

#include <algorithm>
#include <map>
#include <vector>

#include "croquis/base/error.h"
#include "croquis/base/parameter.h"
#include "croquis/base/text.h"
#include "tools/silhouette/stroke_places.h"

namespace croquis {
namespace {

using Data = std::map<std::string, std::string>;

Stroke& stroke_of(Drawing& drawing, const std::string& id) {
  const auto found = std::find_if(drawing.strokes.begin(), drawing.strokes.end(),
                                  [&](const Stroke& stroke) { return stroke.id == id; });
  if (found != drawing.strokes.end()) return *found;
  throw Error(make_error(Category::Usage, "E_INPUT",
                         "The drawing has no stroke \"" + id + "\"; choose one of those it has.",
                         {{SubjectKind::Stroke, id, {}, {}, {}}}));
}

/// Sets an entry; an empty value takes it away.
void set_entry(Data& data, const std::string& key, const std::string& value) {
  if (value.empty())
    data.erase(key);
  else
    data[key] = value;
}

/// The strokes that one is set to lie behind: those of `drawing` drawn before it where that is all of them.
std::vector<std::string> set_behind_of(const Drawing& drawing, const Stroke& stroke) {
  std::vector<std::string> names;
  for (const Stroke& other : drawing.strokes) {
    if (other.id != stroke.id && silhouette::is_set_behind(stroke, other)) names.push_back(other.id);
  }
  return names;
}

void set_behind(Stroke& stroke, const std::vector<std::string>& names) {
  std::string text;
  for (const std::string& name : names) text += (text.empty() ? "" : ",") + name;
  set_entry(stroke.data, silhouette::behind_key, text);
}

/// Where what is said of the part that a stroke bounds is kept.
Data& part_data(Drawing& drawing, Stroke& stroke) {
  return stroke.object.empty() ? stroke.data : drawing.object_data[stroke.object];
}

/// What is said there; empty for nothing.
std::string said_of_part(const Drawing& drawing, const std::string& id, const char* key) {
  const Stroke* stroke = find_stroke(drawing, id);
  if (stroke == nullptr) return {};
  const auto group = drawing.object_data.find(stroke->object);
  if (!stroke->object.empty() && group == drawing.object_data.end()) return {};
  const Data& data = stroke->object.empty() ? stroke->data : group->second;
  const auto found = data.find(key);
  return found == data.end() ? std::string() : found->second;
}

}  // namespace

void forget_ends(Drawing& drawing, const std::string& id) {
  for (Stroke& stroke : drawing.strokes) {
    for (const char* key : {silhouette::joined_key, silhouette::apart_key}) {
      std::string left;
      for (const std::string_view entry : silhouette::data_list(stroke, key)) {
        const bool names = entry.find(' ' + id + ' ') != std::string_view::npos;
        if (stroke.id != id && !names) left.append(left.empty() ? "" : ", ").append(entry);
      }
      set_entry(stroke.data, key, left);
    }
  }
}

DrawingEdit set_kind(const Drawing& drawing, const std::string& id, silhouette::StrokeKind kind) {
  DrawingEdit edit{drawing, {}, {id}, {}};
  const bool given = kind != silhouette::StrokeKind::Visible;
  if (!given) forget_ends(edit.drawing, id);
  set_entry(stroke_of(edit.drawing, id).data, silhouette::kind_key, given ? silhouette::to_string(kind) : "");
  return edit;
}

DrawingEdit set_in_front(const Drawing& drawing, const std::string& front, const std::string& behind) {
  DrawingEdit edit{drawing, {}, {front, behind}, {}};
  Stroke& upper = stroke_of(edit.drawing, front);
  Stroke& lower = stroke_of(edit.drawing, behind);
  if (silhouette::is_set_behind(upper, lower)) {
    std::vector<std::string> others = set_behind_of(drawing, upper);
    std::erase(others, behind);
    set_behind(upper, others);
  }
  // What was drawn first lies behind by itself, unless it is open: then it may be read as a limb in front.
  const bool needs_setting = &lower > &upper || !lower.closed;
  if (needs_setting && !silhouette::is_set_behind(lower, upper)) {
    std::vector<std::string> others = set_behind_of(drawing, lower);
    others.push_back(front);
    set_behind(lower, others);
  }
  return edit;
}

DrawingEdit set_thickness(const Drawing& drawing, const std::string& id, double factor) {
  DrawingEdit edit{drawing, {}, {id}, {}};
  const double limited = std::clamp(factor, least_thickness, most_thickness);
  Data& data = part_data(edit.drawing, stroke_of(edit.drawing, id));
  set_entry(data, silhouette::thickness_key, limited == 1 ? "" : to_text(limited));
  return edit;
}

DrawingEdit set_title(const Drawing& drawing, const std::string& id, const std::string& title) {
  DrawingEdit edit{drawing, {}, {id}, {}};
  set_entry(part_data(edit.drawing, stroke_of(edit.drawing, id)), silhouette::title_key, title);
  return edit;
}

DrawingEdit set_far_copy(const Drawing& drawing, const std::string& id, bool copied) {
  DrawingEdit edit{drawing, {}, {id}, {}};
  set_entry(part_data(edit.drawing, stroke_of(edit.drawing, id)), silhouette::copy_key,
            copied ? silhouette::copy_far : "");
  return edit;
}

bool has_far_copy(const Drawing& drawing, const std::string& id) {
  return said_of_part(drawing, id, silhouette::copy_key) == silhouette::copy_far;
}

DrawingEdit set_over(const Drawing& drawing, const std::string& id, const std::string& words) {
  DrawingEdit edit{drawing, {}, {id}, {}};
  set_entry(stroke_of(edit.drawing, id).data, silhouette::over_key, words);
  return edit;
}

DrawingEdit set_fill(const Drawing& drawing, const std::string& id, const std::string& color) {
  DrawingEdit edit{drawing, {}, {id}, {}};
  set_entry(part_data(edit.drawing, stroke_of(edit.drawing, id)), silhouette::fill_key, color);
  return edit;
}

DrawingEdit set_mirror(const Drawing& drawing, const std::string& id, const std::string& axis) {
  DrawingEdit edit{drawing, {}, {id}, {}};
  Stroke& stroke = stroke_of(edit.drawing, id);
  set_entry(stroke.data, silhouette::mirror_key, axis);
  if (!axis.empty()) return edit;
  for (Stroke& other : edit.drawing.strokes) {
    const auto twin = other.data.find(silhouette::twin_key);
    if (&other == &stroke || twin == other.data.end() || twin->second != id) continue;
    for (const char* key : {silhouette::mirror_key, silhouette::twin_key}) set_entry(other.data, key, "");
    edit.changed.push_back(other.id);
  }
  set_entry(stroke.data, silhouette::twin_key, "");
  return edit;
}

std::string fill_of(const Drawing& drawing, const std::string& id) {
  return said_of_part(drawing, id, silhouette::fill_key);
}

DrawingEdit set_data(const Drawing& drawing, const std::vector<std::array<std::string, 3>>& says) {
  DrawingEdit edit{drawing, {}, {}, {}};
  for (const auto& [id, key, value] : says) {
    set_entry(stroke_of(edit.drawing, id).data, key, value);
    if (std::ranges::count(edit.changed, id) == 0) edit.changed.push_back(id);
  }
  return edit;
}

std::string title_of(const Drawing& drawing, const std::string& id) {
  return said_of_part(drawing, id, silhouette::title_key);
}

double thickness_of(const Drawing& drawing, const std::string& id) {
  double factor = 1;
  const bool read = read_number(said_of_part(drawing, id, silhouette::thickness_key), factor);
  return read && factor > 0 ? std::clamp(factor, least_thickness, most_thickness) : 1;
}

}  // namespace croquis
