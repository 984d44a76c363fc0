// SPDX-License-Identifier: GPL-3.0-or-later
#include "operators/fill_settings.h"

#include <algorithm>
#include <limits>
#include <optional>
#include <string>
#include <utility>

#include "croquis/base/error.h"
#include "croquis/base/text.h"
#include "croquis/operators/hole_requests.h"

namespace croquis {
namespace {

using hole_filling::FillOptions;
using remeshing::RemeshOptions;

constexpr double unlimited = std::numeric_limits<double>::infinity();

std::optional<std::size_t> count_in(std::string_view word) {
  std::size_t count = 0;
  return read_number(word, count) ? std::optional(count) : std::nullopt;
}

/// "30:300".
void read_point_range(const std::string& range, RemeshOptions& options) {
  constexpr std::size_t fewest = 4, most = 2000;
  const std::size_t colon = std::min(range.find(':'), range.size());
  const auto low = count_in(std::string_view(range).substr(0, colon));
  const auto high = colon < range.size() ? count_in(std::string_view(range).substr(colon + 1)) : std::nullopt;
  if (!low || !high || *low < fewest || *high < *low || *high > most)
    throw Error(refused_value("points-per-domain", range, "the least and the most points, 4 to 2000, such as 30:300"));
  options.min_points = *low;
  options.max_points = *high;
}

template <std::size_t size>
std::vector<std::string> words(const std::array<std::string_view, size>& names) {
  return {names.begin(), names.end()};
}

/// Which holes, and what of them.
void list_hole_parameters(FillSettings& settings, ParameterList& list) {
  FillOptions& fill = settings.options.fill;
  list.choice(
          "mode", settings.remesh, {"patch", "remesh"},
          "patch closes holes and changes nothing else; remesh makes all of it of new triangles, from one function.")
      .titled("Method", {"patches", "a new mesh"});
  list.choice("select", fill.selection, words(selection_names),
              "inner fills all holes that don't look like the border of an open surface; none only those that holes "
              "names.")
      .titled("Fill", {"inner holes", "all holes", "all but the largest", "none"});
  list.list("only", "Numbers of the holes to fill instead, as the list shows them: 0,3-5.",
            [&](const std::string& ids) { fill.only = parse_hole_ids(ids); })
      .at(ParameterPlace::Nowhere);
  list.number("max-diameter", settings.max_diameter, unlimited, {"model units", ParameterLength::Model},
              "Wider holes stay open; 0 for no limit.")
      .titled("Widest hole")
      .or_else("no limit");
  list.number("weld", fill.analysis.weld_tolerance, 0, 0.01, {"× diagonal", ParameterLength::Input},
              "Vertices of rims so near to each other count as one, if the edges there are longer; the scan keeps them "
              "as they are. 0: only those at one place.")
      .titled("Join edges within", {"strict", "loose"});
  list.add(list_parameter("holes",
                          "Requests for single holes: '3: leave; 5-7: flat, bulge 0.4; 4: through 1 2 3; 2+9: bridge'. "
                          "Words: fill, leave, bridge, rbf, smooth, flat, kernel NAME, bulge -1..1, trim 0..3, through "
                          "X Y Z."),
           [&](const ParameterValue& given) { fill.requests = requests_in(given); })
      .at(ParameterPlace::Nowhere);
}

void list_patch_parameters(FillSettings& settings, ParameterList& list) {
  FillOptions& fill = settings.options.fill;
  list.choice_of("fairness", 0, {"auto", "rbf", "smooth", "flat"},
                 "rbf continues the surface around by functions fitted to it, smooth its tangents; flat adds no "
                 "vertices and has the least area; auto is flat where an open surface ends, and rbf elsewhere.",
                 [&](std::size_t chosen) {
                   fill.flat_caps = chosen == 0;
                   fill.fairness = fairnesses[chosen == 0 ? 0 : chosen - 1];
                 })
      .titled("Patches", {"best for each hole", "continue the surface", "smooth", "flat"});
  list.choice("kernel", fill.implicit.kernel, words(kernel_names),
              "The functions of rbf: hermite takes normals along, the others points beside the surface; thin-plate "
              "with the preset paper.")
      .titled("Function", {"with normals", "triharmonic", "biharmonic", "thin plate"})
      .at(ParameterPlace::Expert);
  list.choice_of(
          "preset", 0, {"auto", "standard", "paper", "sharp", "noisy"},
          "What is scanned: auto continues creases that run into a hole, standard rounds them; sharp for machined "
          "parts, where creases go on in holes of any size, noisy for rough scans; paper for comparison with Yoo 2005.",
          [&](std::size_t preset) {
            settings.options = remeshing::remesh_preset(static_cast<hole_filling::Preset>(preset));
          })
      .titled("The scan is", {"usual", "smooth", "as published in 2005", "a machined part", "rough"})
      .sets_others();
  list.number("bulge", fill.bulge, -1, 1, "", "Turns the surface at the rims outwards, or inwards below 0.")
      .titled("Bulge", {"inwards", "outwards"});
  list.integer("trim-rim", fill.trim_rim, 0, 3, "rings of faces",
               "Removes so much of the scan along the rims that are filled, where scans are worst.")
      .titled("Trim edge");
}

void list_remesh_parameters(RemeshOptions& options, ParameterList& list) {
  list.number("overlap", options.overlap, 0, 1, {"× domain", ParameterLength::Inner},
              "remesh: how much larger domains are than their boxes; 0.1 with the preset paper.")
      .titled("New mesh: overlap")
      .at(ParameterPlace::Expert);
  list.text("points-per-domain", "30:300", "remesh: least and most points of a domain, MIN:MAX.",
            [&](const std::string& range) { read_point_range(range, options); })
      .at(ParameterPlace::Nowhere);
  list.integer("smoothing", options.smoothing, 0, 20, "rounds",
               "remesh: how often the triangles are evened out on the surface.")
      .titled("New mesh: evened out");
  list.integer("refine", options.refine, 0, 4, "times", "remesh: how often every triangle is cut in four.")
      .titled("New mesh: each triangle cut in four");
  list.number("cell", options.cell, 0.1, 10, {"× mean edge", ParameterLength::Inner},
              "remesh: edge of the cubes; small ones keep more detail and take more memory. 0.5 with the preset sharp.")
      .titled("New mesh: edges", {"fine", "coarse"});
  list.number(
          "adaptive", options.adaptive, 0, 1, "× cell",
          "remesh: fewer faces where the surface is flat: they are merged as long as the surface stays this near to "
          "what it was. 0: none are; 0.1 is usual.")
      .titled("New mesh: fewer faces where flat", {"many", "few"})
      .or_else("off");
}

/// How much memory the result may take, and what is kept in it.
void list_result_parameters(FillSettings& settings, ParameterList& list) {
  FillOptions& fill = settings.options.fill;
  list.number("memory-limit", settings.memory_limit, unlimited, "MiB",
              "A mesh that would take more is refused before anything is allocated; 0 for no limit.")
      .titled("Most memory")
      .or_else("no limit")
      .at(ParameterPlace::Expert);
  list.choice("precision", fill.precision, {"double", "single"},
              "How coordinates will be stored, by which patches are judged; files of single numbers set it.")
      .at(ParameterPlace::Nowhere);
  list.flag("patch-ids", fill.mark_patches,
            "Mark each face with the number of its patch, -1 for the scan's own, and each vertex with a confidence; "
            "files other than PLY can't hold them.")
      .titled("Mark patches")
      .at(ParameterPlace::Expert);
  list.flag("list", settings.list_only, "Only list the holes and which of them would be filled; write nothing.");
}

}  // namespace

void list_fill_parameters(FillSettings& settings, ParameterList& list) {
  list_hole_parameters(settings, list);
  list_patch_parameters(settings, list);
  list_remesh_parameters(settings.options, list);
  list_result_parameters(settings, list);
}

FillSettings read_fill_settings(const ParameterValues& parameters) {
  auto settings = settings_of(list_fill_parameters, parameters);
  FillOptions& fill = settings.options.fill;
  if (settings.max_diameter) fill.max_diameter = *settings.max_diameter;
  constexpr double mebibyte = 1024 * 1024;
  const auto limit = static_cast<std::size_t>(std::min(settings.memory_limit.value_or(0) * mebibyte, 1e18));
  if (settings.remesh) {
    settings.options.memory_limit = limit;
    fill.flat_caps = true;  // fairness is of patches
  } else {
    fill.memory_limit = limit;
    const implicit::Kernel kernel = fill.implicit.kernel;
    fill.implicit = {};  // patches follow how rough the surface around them is by themselves
    fill.implicit.kernel = kernel;
  }
  return settings;
}

Findings unused_parameters(const ParameterValues& parameters) {
  const bool remesh = text_of(parameters, "mode") == "remesh";
  const std::vector<const char*> looked_at_by_the_other =
      remesh ? std::vector{"bulge", "trim-rim"}
             : std::vector{"overlap", "points-per-domain", "smoothing", "refine", "cell", "adaptive"};
  const ParameterValues plain = complete(parameters_of(list_fill_parameters), {{"preset", parameters.at("preset")}});
  std::string names;
  std::vector<Subject> subjects;
  for (const char* name : looked_at_by_the_other) {
    if (parameters.at(name) == plain.at(name)) continue;  // without an effect in either mode
    names += (names.empty() ? "" : ", ") + std::string(name);
    subjects.push_back({SubjectKind::Parameter, name, {}, {}, {}});
  }
  if (subjects.empty()) return {};
  return {make_warning(Category::Usage, "W_PARAMETER_UNUSED",
                       "Not looked at in mode " + std::string(remesh ? "remesh" : "patch") + ": " + names + ".",
                       std::move(subjects))};
}

}  // namespace croquis
