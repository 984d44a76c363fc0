// SPDX-License-Identifier: GPL-3.0-or-later
// Recorded steps of sketches, and what replays can expect of them.
#include <algorithm>

#include "app/replay/replay_lookup.h"
#include "app/tools/silhouette/silhouette_tool.h"
#include "croquis/operators/inflate_result.h"
#include "croquis/silhouette/stroke_data.h"
#include "croquis/tools/recording/general_steps.h"
#include "croquis/tools/silhouette/sketch_steps.h"

namespace croquis::app {
namespace {

StrokeSample sample_at(const Vec2& place) {
  StrokeSample sample;
  sample.position = place;
  return sample;
}

template <class Item, class Test>
std::size_t count_of(const std::vector<Item>& items, const Test& test) {
  return static_cast<std::size_t>(std::ranges::count_if(items, test));
}

std::size_t held_pairs(const InflateResult& inflated, silhouette::Hold hold) {
  return count_of(inflated.attached, [hold](const silhouette::SolidAttachment& pair) { return pair.hold == hold; });
}

}  // namespace

std::vector<const recorded::StepKind*> SilhouetteTool::steps() const {
  return {&recorded::step_kind<recorded::StrokeDrawn>(), &recorded::step_kind<recorded::Drag>(),
          &recorded::step_kind<recorded::Click>(), &recorded::step_kind<recorded::Box>(),
          &recorded::step_kind<recorded::StrokeReading>()};
}

bool SilhouetteTool::replay(const recorded::Step& step) {
  if (const auto* stroke = step.as<recorded::StrokeDrawn>()) {
    if (!host().shows_views()) host().start_sketch();
    const Modifiers modifiers{.shift = stroke->behind};
    sketch_.replay_gesture(stroke->points, stroke->device == "eraser", modifiers, stroke->scale);
  } else if (const auto* setting = step.as<recorded::StrokeReading>()) {
    sketch_.tool().set(*setting);
  } else if (const auto* drag = step.as<recorded::Drag>()) {
    sketch_.tool().drag(drag->stroke, drag->anchor, drag->by);
  } else if (const auto* click = step.as<recorded::Click>(); click != nullptr && !click->place) {
    sketch_.replay_gesture({sample_at(click->at)}, false, modifiers_of(click->modifiers), 0);
  } else if (const auto* box = step.as<recorded::Box>(); box != nullptr && !box->from_place) {
    const std::vector<StrokeSample> way{sample_at(box->from), sample_at((box->from + box->to) / 2), sample_at(box->to)};
    sketch_.replay_gesture(way, false, modifiers_of(box->modifiers), 0);
  } else {
    return false;
  }
  return true;
}

std::optional<std::size_t> SilhouetteTool::parts_of(const WorkObject& object) const {
  if (object.node != studio().solid_node()) return std::nullopt;
  const InflateResult* inflated = result_of<InflateResult>(object.result.get());
  return inflated == nullptr || object.result->failed ? 0 : inflated->objects.size();
}

Expectations SilhouetteTool::expectations() {
  Expectations own;
  own.counts["strokes"] = [this](const std::string&) { return studio().drawing().strokes.size(); };
  own.counts["strokes-behind"] = [this](const std::string&) {
    return count_of(studio().drawing().strokes,
                    [](const Stroke& stroke) { return stroke.data.contains(silhouette::behind_key); });
  };
  const auto add = [&](const char* name, const auto& count) {
    own.counts[name] = [this, count](const std::string&) {
      const auto result = studio().result();
      const InflateResult* inflated = result_of<InflateResult>(result.get());
      return inflated == nullptr || result->failed ? 0 : count(*inflated);
    };
  };
  add("inner-holes", [](const InflateResult& inflated) {
    return count_of(inflated.nested, [](const NestedStroke& nested) { return nested.hole; });
  });
  add("inner-parts", [](const InflateResult& inflated) {
    return count_of(inflated.nested, [](const NestedStroke& nested) { return !nested.hole; });
  });
  const auto add_kinds = [&](const char* name, std::vector<silhouette::StrokeKind> kinds) {
    add(name, [kinds = std::move(kinds)](const InflateResult& inflated) {
      return count_of(inflated.kinds, [&](const auto& read) { return std::ranges::count(kinds, read.second) > 0; });
    });
  };
  add_kinds("details", {silhouette::StrokeKind::Detail, silhouette::StrokeKind::Scribble});
  add_kinds("tubes", {silhouette::StrokeKind::Tube});
  add_kinds("left-out", {silhouette::StrokeKind::Ignored});
  add("crossings-in-view", [](const InflateResult& inflated) { return inflated.crossings_in_view.size(); });
  add("joined-pairs", [](const InflateResult& inflated) { return held_pairs(inflated, silhouette::Hold::Joined); });
  add("resting-pairs", [](const InflateResult& inflated) { return held_pairs(inflated, silhouette::Hold::Resting); });
  return own;
}

}  // namespace croquis::app
