// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <ctime>
#include <functional>
#include <iomanip>
#include <limits>
#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include <sys/resource.h>

#include "algorithms/silhouette/skeleton/chordal_axis.h"
#include "algorithms/silhouette/skeleton/depth.h"
#include "bench/bench.h"
#include "bench/cpu_time.h"
#include "bench/factorisation_peer.h"
#include "croquis/base/error.h"
#include "croquis/base/stage_cache.h"
#include "croquis/silhouette/labelled_figure.h"
#include "croquis/silhouette/solid.h"
#include "support/sketches/characters/rosette.h"
#include "support/sketches/sketch_generator.h"

namespace croquis::bench {
namespace {

using silhouette::LabelledDrawing;
using silhouette::LabelledFigure;
using silhouette::Options;
using silhouette::Solid;

constexpr int runs = 5;

/// Of whole drawings: other work on the machine only ever adds time, so that the least of some runs is what repeats.
constexpr int stage_runs = 15;

/// Processor time between the reports of a Progress, by the step they name: the least of several runs.
class StageTimes {
 public:
  Progress progress() {
    last_ = std::clock();
    step_.clear();
    now_.clear();
    return Progress([this](double, const std::string& step) { change(step); });
  }

  void end() {
    change("");
    for (const auto& [step, ms] : now_) {
      const auto best = ms_.try_emplace(step, ms).first;
      best->second = std::min(best->second, ms);
    }
  }

  double ms(const std::string& step) const {
    const auto found = ms_.find(step);
    return found == ms_.end() ? 0 : found->second;
  }

  const std::vector<std::string>& order() const { return order_; }

 private:
  void change(const std::string& step) {
    if (step == step_) return;
    const std::clock_t now = std::clock();
    if (!step_.empty()) {
      if (std::find(order_.begin(), order_.end(), step_) == order_.end()) order_.push_back(step_);
      now_[step_] += 1e3 * static_cast<double>(now - last_) / CLOCKS_PER_SEC;
    }
    last_ = now;
    step_ = step;
  }

  std::map<std::string, double> ms_;
  std::map<std::string, double> now_;  ///< of the run under way
  std::vector<std::string> order_;
  std::string step_;
  std::clock_t last_ = 0;
};

struct Measured {
  std::string name;
  std::size_t strokes = 0;
  std::size_t samples = 0;
  std::size_t vertices = 0;
  StageTimes stages;
  double label_ms = 0;
  double total_ms = 0;
  double triangulation_ms = 0;  ///< one constrained Delaunay triangulation of the same samples
};

double triangulate_all(const LabelledDrawing& labelled) {
  return median_cpu_ms(runs, [&] {
    for (const LabelledFigure& figure : labelled.figures) triangulate(figure.points, figure.segments);
  });
}

Measured measure(const test::NamedSketch& sketch) {
  Measured result;
  result.name = sketch.name;
  const Drawing& drawing = sketch.sketch.drawing;
  result.strokes = drawing.strokes.size();
  const Options options;
  LabelledDrawing labelled;
  Solid solid;
  result.label_ms = result.total_ms = std::numeric_limits<double>::infinity();
  for (int run = 0; run < stage_runs; ++run) {
    Progress progress = result.stages.progress();
    Progress labelling = progress.step("label", 0.3);
    const double label_ms = cpu_ms([&] { labelled = label(drawing, options, labelling); });
    Progress inflating = progress.step("inflate", 0.7);
    const double inflate_ms = cpu_ms([&] { solid = inflate(labelled, drawing, options, inflating); });
    result.stages.end();
    result.label_ms = std::min(result.label_ms, label_ms);
    result.total_ms = std::min(result.total_ms, label_ms + inflate_ms);
  }
  for (const LabelledFigure& figure : labelled.figures) result.samples += figure.points.size();
  result.vertices = solid.mesh.vertex_count();
  result.triangulation_ms = triangulate_all(labelled);
  return result;
}

void print_stages(std::ostream& out, const std::vector<Measured>& all) {
  out << "CPU milliseconds per stage, the least of " << stage_runs << " runs.\n\n| stage |";
  for (const Measured& one : all) out << " " << one.name << " |";
  out << "\n|---|";
  for (std::size_t i = 0; i < all.size(); ++i) out << "---|";
  out << "\n" << std::fixed << std::setprecision(1);
  for (const std::string& stage : all.front().stages.order()) {
    out << "| " << stage << " |";
    for (const Measured& one : all) out << " " << one.stages.ms(stage) << " |";
    out << "\n";
  }
}

void print_totals(std::ostream& out, const std::vector<Measured>& all) {
  out << "\nPeer: one constrained Delaunay triangulation (CGAL) of the same contour samples.\n\n"
      << "| sketch | strokes | samples | mesh vertices | labelled figure ms | whole ms | triangulation ms | figure / "
         "triangulation | whole / triangulation |\n|---|---|---|---|---|---|---|---|---|\n";
  for (const Measured& one : all) {
    out << "| " << one.name << " | " << one.strokes << " | " << one.samples << " | " << one.vertices << " | "
        << one.label_ms << " | " << one.total_ms << " | " << std::setprecision(2) << one.triangulation_ms << " | "
        << std::setprecision(1) << one.label_ms / one.triangulation_ms << " | " << one.total_ms / one.triangulation_ms
        << " |\n";
  }
}

/// One numeric factorisation of each independent part's own system, collision rows included.
double depth_factorisation_ms(const LabelledFigure& figure, const silhouette::DepthSettings& settings) {
  Progress progress;
  const silhouette::Skeleton skeleton = chordal_axis(figure, settings.options.node_spacing, progress);
  const auto rows = silhouette::collision_rows(skeleton, figure, settings);
  double total = 0;
  for (const silhouette::DepthPart& part : depth_parts(skeleton, rows)) {
    total += factorisation_ms(depth_problem(skeleton, part, rows, settings));
  }
  return total;
}

void print_depth(std::ostream& out, const std::vector<test::NamedSketch>& sketches) {
  out << "\nThe depth solve. Peer: one numeric factorisation of its own system (all independent parts).\n\n"
      << "| sketch | nodes | rows | iterations | factorisations | solve ms | one factorisation ms | solve / one "
         "|\n|---|---|---|---|---|---|---|---|\n";
  const Options options;
  for (const test::NamedSketch& sketch : sketches) {
    Progress progress;
    const LabelledDrawing labelled = label(sketch.sketch.drawing, options, progress);
    for (const LabelledFigure& figure : labelled.figures) {
      silhouette::DepthSettings settings;
      settings.options = options.depth;
      const silhouette::Skeleton axis = chordal_axis(figure, options.depth.node_spacing, progress);
      silhouette::DepthResult result;
      const double solve = median_cpu_ms(runs, [&] {
        silhouette::Skeleton skeleton = axis;
        result = solve_depth(skeleton, figure, settings, progress);
      });
      const double one = depth_factorisation_ms(figure, settings);
      out << "| " << sketch.name << " | " << axis.nodes.size() << " | " << result.rows << " | " << result.iterations
          << " | " << result.factorisations << " | " << std::setprecision(2) << solve << " | " << one << " | "
          << std::setprecision(1) << solve / one << " |\n";
    }
  }
}

/// Keeps all stages, as the memo of a session does.
class KeepingCache final : public StageCache {
 public:
  std::shared_ptr<const void> get(std::string_view stage, std::string_view content,
                                  const std::function<Stage()>& make) override {
    const auto key = std::pair(std::string(stage), std::string(content));
    const auto known = kept_.find(key);
    return known != kept_.end() ? known->second.result : kept_.emplace(key, make()).first->second.result;
  }

 private:
  std::map<std::pair<std::string, std::string>, Stage> kept_;
};

/// Bends a stroke a little; its ends stay.
Drawing dragged(Drawing drawing, double distance) {
  std::vector<StrokeSample>& samples = drawing.strokes.front().samples;
  const auto last = static_cast<double>(samples.size() - 1);
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const double t = static_cast<double>(i) / last;
    samples[i].position.y() += distance * 16 * t * t * (1 - t) * (1 - t);
  }
  return drawing;
}

double solve_ms(const Drawing& drawing, const Options& options) {
  Progress progress;
  return cpu_ms([&] { inflate(label(drawing, options, progress), drawing, options, progress); });
}

/// Medians over places that a point is dragged to, each new to the cache.
void print_drag_of(std::ostream& out, const test::NamedSketch& sketch) {
  KeepingCache cache;
  Options cold;
  Options draft;
  draft.cache = &cache;
  draft.quality = silhouette::Quality::Draft;
  Options final = draft;
  final.quality = silhouette::Quality::Final;
  Options weight = final;
  weight.depth.weight_distance = 0.05;
  solve_ms(sketch.sketch.drawing, draft);
  solve_ms(sketch.sketch.drawing, final);
  std::vector<std::vector<double>> times(4);
  for (int place = 1; place <= runs; ++place) {
    const Drawing drawing = dragged(sketch.sketch.drawing, 0.7 * place);
    times[0].push_back(solve_ms(drawing, cold));
    times[1].push_back(solve_ms(drawing, draft));
    times[2].push_back(solve_ms(drawing, final));
    times[3].push_back(solve_ms(drawing, weight));
  }
  out << "| " << sketch.name << " | " << sketch.sketch.drawing.strokes.size();
  for (std::vector<double>& column : times) {
    std::sort(column.begin(), column.end());
    out << " | " << column[column.size() / 2];
  }
  out << " |\n";
}

test::Sketch beside(const test::Sketch& left, const test::Sketch& right) {
  test::Sketch both = left;
  for (Stroke stroke : test::translated(right, {1500, 0}).drawing.strokes) {
    stroke.id = "right " + stroke.id;
    both.drawing.strokes.push_back(std::move(stroke));
  }
  return both;
}

void print_drag(std::ostream& out) {
  out << "\nDrag: CPU milliseconds after a point was moved to a new place, medians. Cold: final quality, nothing "
         "kept.\n\n"
      << "| sketch | strokes | cold ms | draft ms | final ms | changed weight ms |\n|---|---|---|---|---|---|\n"
      << std::setprecision(1);
  print_drag_of(out, {"dog and duck", beside(test::dog_sketch(), test::duck_sketch())});
  print_drag_of(out, {"knot (3,4)", test::torus_knot_sketch(3, 4)});
  print_drag_of(out, {"chain of 6", test::chain_sketch(6)});
  print_drag_of(out, {"weave 4x4", test::weave_sketch()});
}

void print_hidden_ends(std::ostream& out) {
  out << "\nHidden ends all round a disc. Right: as many objects as were drawn.\n\n"
      << "| sketch | strokes | labelled ms | right |\n|---|---|---|---|\n"
      << std::setprecision(1);
  std::vector<test::NamedSketch> sketches;
  for (const int petals : {8, 16, 20, 40}) {
    const std::string name = "flower of " + std::to_string(petals);
    sketches.push_back({name + " slim petals", test::rosette_sketch(petals, 0.5, 1, 300, 0)});
    sketches.push_back({name + " petals side by side", test::rosette_sketch(petals, 0.9, 1, 300, 0)});
    sketches.push_back({name + " petals that overlap", test::rosette_sketch(petals, 1.5, 1, 300, 0)});
  }
  for (const int arms : {8, 16, 40}) {
    const std::string name = "octopus of " + std::to_string(arms);
    sketches.push_back({name + " straight arms", test::rosette_sketch(arms, 0.5, 0.5, 420, 0)});
    sketches.push_back({name + " bent arms", test::rosette_sketch(arms, 0.5, 0.5, 420, 30)});
  }
  for (const test::NamedSketch& sketch : sketches) {
    std::size_t objects = 0;
    const double ms = cpu_ms([&] {
      try {
        Progress progress;
        for (const LabelledFigure& figure : silhouette::label(sketch.sketch.drawing, {}, progress).figures) {
          objects += figure.objects.size();
        }
      } catch (const Error&) {
      }
    });
    const bool right = objects == static_cast<std::size_t>(sketch.sketch.truth.components);
    out << "| " << sketch.name << " | " << sketch.sketch.drawing.strokes.size() << " | " << ms << " | "
        << (right ? "yes" : "no") << " |\n";
  }
}

}  // namespace

void bench_silhouette(std::ostream& out) {
  const std::vector<test::NamedSketch> sketches = {{"trefoil", test::trefoil_sketch()},
                                                   {"dog", test::dog_sketch()},
                                                   {"Borromean rings", test::borromean_sketch()},
                                                   {"chain of 5", test::chain_sketch()},
                                                   {"weave 4x4", test::weave_sketch()}};
  std::vector<Measured> all;
  for (const test::NamedSketch& sketch : sketches) all.push_back(measure(sketch));
  print_stages(out, all);
  print_totals(out, all);
  print_depth(out, sketches);
  print_drag(out);
  print_hidden_ends(out);
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  out << "\nPeak memory of all of them: " << usage.ru_maxrss / 1024 << " MiB.\n";
}

}  // namespace croquis::bench
