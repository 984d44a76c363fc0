// SPDX-License-Identifier: GPL-3.0-or-later
#include <map>
#include <memory>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include <catch2/catch.hpp>

#include "croquis/base/stage_cache.h"
#include "croquis/silhouette/attachment.h"
#include "silhouette/solids.h"
#include "support/key_recorder.h"
#include "support/member_changes.h"
#include "support/sketches/sketch_generator.h"

using namespace croquis;
using namespace croquis::silhouette;
using test::solid_of;

namespace {

/// Keeps everything and counts what had to be made.
class CountingCache final : public StageCache {
 public:
  std::shared_ptr<const void> get(std::string_view stage, std::string_view content,
                                  const std::function<Stage()>& make) override {
    const auto key = std::pair(std::string(stage), std::string(content));
    const auto known = kept_.find(key);
    if (known != kept_.end()) return known->second.result;
    const Stage made = make();
    ++made_[key.first];
    CHECK(made.bytes > 0);
    return kept_.emplace(key, made).first->second.result;
  }

  /// Per stage since the last call.
  std::map<std::string, int> made() { return std::exchange(made_, {}); }

 private:
  std::map<std::pair<std::string, std::string>, Stage> kept_;
  std::map<std::string, int> made_;
};

void check_same(const Solid& a, const Solid& b) {
  CHECK(a.mesh.positions == b.mesh.positions);
  CHECK(a.mesh.corners == b.mesh.corners);
  CHECK(a.skeleton.positions == b.skeleton.positions);
  CHECK(a.skeleton.line_vertices == b.skeleton.line_vertices);
  CHECK(a.diagnostics.silhouette_iou == b.diagnostics.silhouette_iou);
  CHECK(a.diagnostics.minimum_gap == b.diagnostics.minimum_gap);
  CHECK(a.objects.size() == b.objects.size());
  CHECK(a.findings.size() == b.findings.size());
}

/// A dog beside linked rings.
Drawing two_parts() {
  Drawing both = test::dog_sketch().drawing;
  for (Stroke& stroke : both.strokes) stroke.id = "dog " + stroke.id;
  for (const Stroke& stroke : test::translated(test::linked_rings_sketch(), {1500, 0}).drawing.strokes) {
    both.strokes.push_back(stroke);
  }
  return both;
}

/// Moves the middle of a stroke a little, its ends not at all.
Drawing dragged(Drawing drawing, std::size_t stroke, double distance) {
  std::vector<StrokeSample>& samples = drawing.strokes[stroke].samples;
  const auto last = static_cast<double>(samples.size() - 1);
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const double t = static_cast<double>(i) / last;
    samples[i].position.y() += distance * 16 * t * t * (1 - t) * (1 - t);
  }
  return drawing;
}

Options all_attached(const Drawing& drawing) {
  Options options;
  Progress progress;
  for (const LabelledFigure& figure : label(drawing, options, progress).figures) {
    for (const AttachSuggestion& pair : attach_suggestions(figure)) {
      options.attach.push_back({figure.objects[pair.a].name, figure.objects[pair.b].name});
    }
  }
  return options;
}

}  // namespace

TEST_CASE("stages kept from earlier runs give the same bytes as making everything anew") {
  CountingCache cache;
  Drawing drawing = two_parts();
  for (const bool attach : {false, true}) {
    Options plain = attach ? all_attached(drawing) : Options{};
    for (int step = 0; step < 3; ++step) {
      const Drawing moved = dragged(drawing, 3, step);
      Options kept = plain;
      kept.cache = &cache;
      check_same(solid_of(moved, kept), solid_of(moved, plain));
    }
    plain.depth.weight_distance = 0.03;
    Options kept = plain;
    kept.cache = &cache;
    check_same(solid_of(drawing, kept), solid_of(drawing, plain));
  }
}

TEST_CASE("a dragged stroke makes its own part of the drawing anew and no other") {
  CountingCache cache;
  Options options;
  options.cache = &cache;
  const Drawing drawing = two_parts();
  solid_of(drawing, options);
  const std::map<std::string, int> all{
      {"silhouette labels", 1}, {"silhouette axis", 2}, {"silhouette sheets", 2}, {"silhouette solid", 2}};
  CHECK(cache.made() == all);
  solid_of(dragged(drawing, 3, 1), options);
  const std::map<std::string, int> one{
      {"silhouette labels", 1}, {"silhouette axis", 1}, {"silhouette sheets", 1}, {"silhouette solid", 1}};
  CHECK(cache.made() == one);
  solid_of(drawing, options);
  CHECK(cache.made().empty());
}

TEST_CASE("changed weights and attachments leave labels, axes and sheets as they are") {
  CountingCache cache;
  Options options = all_attached(two_parts());
  options.cache = &cache;
  const Drawing drawing = two_parts();
  solid_of(drawing, options);
  cache.made();
  options.depth.weight_curvature = 0.5;
  solid_of(drawing, options);
  CHECK(cache.made() == std::map<std::string, int>{{"silhouette solid", 2}});
  options.attach.pop_back();
  solid_of(drawing, options);
  CHECK(cache.made() == std::map<std::string, int>{{"silhouette solid", 1}});
}

TEST_CASE("sheets are sampled anew where a part becomes thinner than wide, and for no other change of its thickness") {
  CountingCache cache;
  Options options;
  options.cache = &cache;
  Drawing drawing = test::linked_rings_sketch().drawing;
  const auto made_with = [&](const std::string& thickness) {
    for (Stroke& stroke : drawing.strokes) stroke.data["thickness"] = thickness;
    cache.made();
    solid_of(drawing, options);
    return cache.made();
  };
  using Made = std::map<std::string, int>;
  const Made solid_only{{"silhouette labels", 1}, {"silhouette solid", 1}};
  const Made with_sheets{{"silhouette labels", 1}, {"silhouette sheets", 1}, {"silhouette solid", 1}};
  solid_of(drawing, options);
  CHECK(made_with("1.5") == solid_only);
  CHECK(made_with("0.8") == with_sheets);
  CHECK(made_with("0.5") == solid_only);
  CHECK(made_with("2") == solid_only);
}

TEST_CASE("a draft shows the same objects with fewer vertices, and shares its labels with the final result") {
  CountingCache cache;
  const Drawing drawing = two_parts();
  Options options = all_attached(drawing);
  options.cache = &cache;
  options.quality = Quality::Draft;
  const Solid draft = solid_of(drawing, options);
  options.quality = Quality::Final;
  cache.made();
  const Solid final = solid_of(drawing, options);
  CHECK(cache.made() == std::map<std::string, int>{{"silhouette sheets", 2}, {"silhouette solid", 2}});
  CHECK(draft.objects.size() == final.objects.size());
  CHECK(draft.mesh.vertex_count() < final.mesh.vertex_count() * 7 / 10);
  const MeshReport figures = test::report_of(draft.mesh);
  CHECK(figures.closed);
  CHECK(figures.oriented);
  const auto wide = *figures.bounds;
  const auto fine = *test::report_of(final.mesh).bounds;
  const double tolerance = 0.02 * (fine[1] - fine[0]).norm();
  CHECK((wide[0] - fine[0]).norm() < tolerance);
  CHECK((wide[1] - fine[1]).norm() < tolerance);
}

TEST_CASE(
    "every option of strokes and completion changes the key of the labels, every one of depths that of the solid") {
  const Drawing drawing = test::linked_rings_sketch().drawing;
  const auto label_key = [&](Options options) {
    return test::stage_key("silhouette labels", [&](StageCache* cache) {
      options.cache = cache;
      Progress progress;
      label(drawing, options, progress);
    });
  };
  Progress progress;
  const LabelledDrawing labelled = label(drawing, Options(), progress);
  const auto solid_key = [&](Options options) {
    return test::stage_key("silhouette solid", [&](StageCache* cache) {
      options.cache = cache;
      inflate(labelled, drawing, options, progress);
    });
  };
  std::set<std::string> label_keys = {label_key({})}, solid_keys = {solid_key({})};
  std::size_t label_count = 1, solid_count = 1;
  const auto with = [](auto Options::*part, const auto& changed) {
    Options options;
    options.*part = changed;
    return options;
  };
  for (const StrokeOptions& changed : test::changes_of(StrokeOptions())) {
    label_keys.insert(label_key(with(&Options::strokes, changed)));
    ++label_count;
  }
  for (const CompletionOptions& changed : test::changes_of(CompletionOptions())) {
    label_keys.insert(label_key(with(&Options::completion, changed)));
    ++label_count;
  }
  label_keys.insert(label_key(with(&Options::attach_suggested, true)));  // it leads lines into their neighbours
  ++label_count;
  for (const DepthOptions& changed : test::changes_of(DepthOptions())) {
    solid_keys.insert(solid_key(with(&Options::depth, changed)));
    ++solid_count;
  }
  CHECK(label_keys.size() == label_count);
  CHECK(solid_keys.size() == solid_count);
  CHECK_FALSE(label_keys.contains(""));
  CHECK_FALSE(solid_keys.contains(""));
}
