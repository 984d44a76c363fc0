// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <functional>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "bench/scans/bench_holes.h"
#include "bench/scans/hole_case.h"
#include "bench/statistics.h"
#include "support/scans/virtual_scans.h"

namespace croquis::bench {
namespace {

using test::Sculpture;

constexpr std::size_t model_triangles = 30000;

struct Result {
  Accuracy accuracy;
  PatchShape shape;
  double cpu_ms = 0;
};

using Methods = std::vector<Method>;

/// What the methods made of one case; nothing for those that aren't installed.
struct Row {
  std::string name;
  std::size_t holes = 0;
  Methods methods;
  std::vector<std::optional<Result>> results;  // per method

  const std::optional<Result>& of(Method method) const {
    return results[static_cast<std::size_t>(std::find(methods.begin(), methods.end(), method) - methods.begin())];
  }
};

Row measured(const HoleCase& holes, const Methods& methods) {
  Row row{holes.name, holes.removed.size(), methods, {}};
  for (const Method method : methods) {
    const auto filled = fill(holes.mesh, method);
    row.results.emplace_back();
    if (filled) row.results.back() = {accuracy(holes, *filled), patch_shape(holes.mesh, *filled), filled->cpu_ms};
  }
  return row;
}

using Figure = std::function<double(const Result&)>;

double mean_of(const Result& r) { return r.accuracy.mean; }
double median_hole_of(const Result& r) { return r.accuracy.median_hole; }

void print_head(std::ostream& out, const std::string& first, const Methods& methods) {
  out << "| " << first << " |";
  for (const Method method : methods) out << ' ' << name_of(method) << " |";
  out << "\n|---|";
  for (std::size_t m = 0; m < methods.size(); ++m) out << "---|";
  out << '\n';
}

void print_table(std::ostream& out, const std::vector<Row>& rows, const std::string& title, const Figure& figure) {
  print_head(out, title, rows.front().methods);
  for (const Row& row : rows) {
    out << "| " << row.name << ", " << row.holes << " |";
    for (const auto& result : row.results) {
      if (result) {
        out << ' ' << figure(*result) << " |";
      } else {
        out << " not installed |";
      }
    }
    out << '\n';
  }
  out << '\n';
}

/// Ours over the best of some peers.
struct Target {
  Method ours;
  std::vector<Method> peers;
  double limit;
};

void print_ratio(std::ostream& out, const std::vector<Row>& rows, const Target& target, const Figure& figure) {
  std::vector<double> ratios;
  for (const Row& row : rows) {
    double best = std::numeric_limits<double>::infinity();
    for (const Method peer : target.peers) {
      if (row.of(peer)) best = std::min(best, figure(*row.of(peer)));
    }
    if (std::isfinite(best) && best > 0) ratios.push_back(figure(*row.of(target.ours)) / best);
  }
  if (ratios.empty()) {
    out << " not installed |";
    return;
  }
  const auto lost = std::count_if(ratios.begin(), ratios.end(), [](double ratio) { return ratio > 1; });
  out << ' ' << median(ratios) << " (" << lost << " of " << ratios.size() << " above 1) |";
}

void print_ratios(std::ostream& out, const std::vector<Row>& rows, const std::vector<Target>& targets) {
  out << "| median over models of | by mean hole | by median hole | target |\n|---|---|---|---|\n";
  for (const Target& target : targets) {
    out << "| " << name_of(target.ours) << " /";
    for (std::size_t i = 0; i < target.peers.size(); ++i)
      out << (i == 0 ? " " : " or ") << name_of(target.peers[i]) << (i + 1 == target.peers.size() ? " |" : "");
    print_ratio(out, rows, target, mean_of);
    print_ratio(out, rows, target, median_hole_of);
    out << " <= " << target.limit << " |\n";
  }
  out << '\n';
}

void print_shape(std::ostream& out, const std::vector<Row>& rows) {
  const auto over_rows = [&](const std::string& title, const Figure& figure, bool sum) {
    out << "| " << title << " |";
    for (std::size_t m = 0; m < rows.front().methods.size(); ++m) {
      std::vector<double> values;
      for (const Row& row : rows) {
        if (row.results[m]) values.push_back(figure(*row.results[m]));
      }
      double total = 0;
      for (const double value : values) total += value;
      if (values.empty()) {
        out << " not installed |";
      } else {
        out << ' ' << (sum ? total : median(values)) << " |";
      }
    }
    out << '\n';
  };
  print_head(out, "new faces, medians over models", rows.front().methods);
  over_rows(
      "mean inner edge / rim edge (0.7 to 1.4)", [](const Result& r) { return r.shape.edge_ratio; }, false);
  over_rows(
      "patches outside of that, %", [](const Result& r) { return 100 * r.shape.uneven_patches; }, false);
  over_rows(
      "angles below 10 degrees, % (< 1)", [](const Result& r) { return 100 * r.shape.small_angles; }, false);
  over_rows(
      "median of triangles' least angles (>= 35)", [](const Result& r) { return r.shape.median_min_angle; }, false);
  over_rows(
      "edges left open, sum (0)", [](const Result& r) { return static_cast<double>(r.shape.open_rims); }, true);
  over_rows(
      "self-intersections added, sum (0)",
      [](const Result& r) { return static_cast<double>(r.shape.new_intersections); }, true);
  over_rows(
      "processor time in ms, sum (MeshLab: its whole process)", [](const Result& r) { return r.cpu_ms; }, true);
  out << '\n';
}

/// Cases that are filled by the same methods, and what is wanted of them.
struct Family {
  std::string title;
  std::vector<HoleCase> cases;
  Methods methods;
  std::vector<Target> targets;
};

void report(std::ostream& out, const Family& family) {
  std::vector<Row> rows;
  for (const HoleCase& holes : family.cases) rows.push_back(measured(holes, family.methods));
  out << "### " << family.title << "\n\nDistance of removed surface to patches, 1e-4 of the diagonal.\n\n";
  print_table(out, rows, "model, holes: mean over holes", mean_of);
  print_table(out, rows, "model, holes: median hole", median_hole_of);
  print_ratios(out, rows, family.targets);
  print_shape(out, rows);
  out.flush();
}

std::vector<HoleCase> cases_of(std::span<const Sculpture> sculptures, const test::RaggedCuts& cuts, double noise = 0) {
  std::vector<HoleCase> cases;
  for (const Sculpture sculpture : sculptures) {
    PolyMesh complete = test::sculpt(sculpture, model_triangles);
    HoleCase holes = case_of(test::name_of(sculpture), test::ragged_cuts(complete, cuts));
    if (noise > 0) holes.mesh = test::with_noise(holes.mesh, 1, noise);
    cases.push_back(std::move(holes));
  }
  return cases;
}

const Methods cgal = {Method::CgalTangent, Method::CgalCurved};
const Methods usual = {Method::MeshLab, Method::CgalTangent, Method::CgalCurved,
                       Method::Smooth,  Method::Implicit,    Method::Sharp};

std::vector<Target> usual_targets() {
  return {{Method::Implicit, {Method::CgalTangent}, 0.6},
          {Method::Implicit, cgal, 0.7},
          {Method::Implicit, {Method::MeshLab}, 0.3}};
}

Family small_holes() {
  return {"Holes of radius 1 to 8 % of the diagonal", cases_of(test::all_sculptures, {}), usual, usual_targets()};
}

Family huge_holes() {
  test::RaggedCuts cuts;
  cuts.count = 3, cuts.low = 0.12, cuts.high = 0.2;
  return {
      "Huge holes: radius 12 to 20 %", cases_of(test::all_sculptures, cuts), usual, {{Method::Implicit, cgal, 0.9}}};
}

Family machined_holes() {
  constexpr std::array machined = {Sculpture::Bracket, Sculpture::Housing};
  test::RaggedCuts cuts;
  cuts.seed = 7, cuts.count = 20;
  return {"Machined pieces, 20 holes each",
          cases_of(machined, cuts),
          usual,
          {{Method::Sharp, cgal, 1}, {Method::Implicit, cgal, 1}}};
}

constexpr std::array rounded = {Sculpture::Beast, Sculpture::Head, Sculpture::Mug, Sculpture::Armour};

Family islands() {
  test::RaggedCuts cuts;
  cuts.count = 3, cuts.low = 0.06, cuts.high = 0.1, cuts.island = 0.4;
  return {"Holes with islands: radius 6 to 10 %", cases_of(rounded, cuts), usual, {{Method::Implicit, cgal, 0.9}}};
}

Family rough_scans() {
  Methods methods = usual;
  methods.back() = Method::Noisy;
  return {"Rough scans: noise of a tenth of an edge",
          cases_of(rounded, {}, 0.1),
          methods,
          {{Method::Noisy, cgal, 1}, {Method::Implicit, cgal, 1}}};
}

}  // namespace

void report_hole_accuracy(std::ostream& out) {
  for (const auto family : {small_holes, huge_holes, machined_holes, islands, rough_scans}) report(out, family());
}

void report_external_holes(std::ostream& out, const std::string& folder) {
  report(out, {"Scans of " + folder, cases_in(folder), usual, usual_targets()});
}

}  // namespace croquis::bench
