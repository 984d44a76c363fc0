// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/tools/silhouette/outline_choices.h"

#include <algorithm>
#include <set>
#include <utility>

#include <Eigen/Geometry>

#include "croquis/silhouette/stroke_data.h"
#include "croquis/tools/silhouette/stroke_edit.h"

namespace croquis::app {

using silhouette::is_set_behind;
using silhouette::StrokeKind;

std::vector<NestedStroke> nested_outlines(const InflateResult& inflated, const Drawing& drawing) {
  std::vector<NestedStroke> outlines;
  for (NestedStroke nested : inflated.nested) {
    const Stroke* stroke = find_stroke(drawing, nested.stroke);
    if (stroke == nullptr) continue;
    const auto kind = silhouette::stroke_kind(*stroke);
    if (kind == StrokeKind::Hole || kind == StrokeKind::Part) {
      nested.hole = kind == StrokeKind::Hole;
      nested.chosen = true;
    }
    outlines.push_back(std::move(nested));
  }
  return outlines;
}

std::vector<StrokesInView> crossings_in_view(const InflateResult& inflated, const Drawing& drawing) {
  std::vector<StrokesInView> crossings;
  std::set<std::pair<std::string, std::string>> seen;
  for (StrokesInView crossing : inflated.crossings_in_view) {
    const Stroke* front = find_stroke(drawing, crossing.front);
    const Stroke* behind = find_stroke(drawing, crossing.behind);
    if (front == nullptr || behind == nullptr || !seen.insert(std::minmax(crossing.front, crossing.behind)).second)
      continue;
    const bool was_taken_back = crossing.chosen && !is_set_behind(*behind, *front);
    if (is_set_behind(*front, *behind) || was_taken_back) {
      std::swap(crossing.front, crossing.behind);
      crossing.chosen = !was_taken_back;
    }
    crossings.push_back(std::move(crossing));
  }
  return crossings;
}

std::vector<ReadStroke> read_strokes(const InflateResult& inflated, const Drawing& drawing,
                                     const std::vector<std::string>& selected) {
  constexpr std::size_t most_shown = 12;
  std::vector<ReadStroke> chosen, others;
  for (const auto& [id, found] : inflated.kinds) {
    const Stroke* stroke = find_stroke(drawing, id);
    if (stroke == nullptr || stroke->samples.empty()) continue;
    const StrokeKind told = silhouette::stroke_kind(*stroke).value_or(StrokeKind::Visible);
    const bool is_told = told != StrokeKind::Visible;
    const StrokeKind kind = is_told ? told : found;
    const ReadStroke read{id, kind, is_told, stroke->samples[stroke->samples.size() / 2].position};
    const bool has_chip = kind == StrokeKind::Hole || kind == StrokeKind::Part || kind == StrokeKind::Blob;
    if (std::ranges::find(selected, id) != selected.end())
      chosen.push_back(read);
    else if (kind != StrokeKind::Contour && kind != StrokeKind::Hidden && !has_chip)
      others.push_back(read);
  }
  if (others.size() > most_shown) others.clear();
  chosen.insert(chosen.end(), others.begin(), others.end());
  return chosen;
}

ChosenPart chosen_part(const InflateResult& inflated, const Drawing& drawing,
                       const std::vector<std::string>& selected) {
  const auto is_in = [](const std::vector<std::string>& ids, const std::string& id) {
    return std::ranges::find(ids, id) != ids.end();
  };
  const InflatedObject* chosen = nullptr;
  for (const InflatedObject& object : inflated.objects) {
    if (std::ranges::none_of(object.strokes, [&](const std::string& id) { return is_in(selected, id); })) continue;
    if (chosen != nullptr) return {};
    chosen = &object;
  }
  ChosenPart part;
  if (chosen == nullptr) return part;
  part.object = chosen->name;
  Eigen::AlignedBox2d box;
  for (const Stroke& stroke : drawing.strokes) {
    if (!is_in(chosen->strokes, stroke.id)) continue;
    if (part.stroke.empty()) part.stroke = stroke.id;
    for (const StrokeSample& sample : stroke.samples) box.extend(sample.position);
  }
  if (!box.isEmpty()) part.at = {box.center().x(), box.max().y()};
  return part;
}

}  // namespace croquis::app
