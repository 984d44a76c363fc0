// SPDX-License-Identifier: GPL-3.0-or-later
#include "operators/fill_settings.h"

#include <algorithm>
#include <limits>
#include <optional>
#include <string>
#include <utility>

#include "croquis/base/error.h"
#include "croquis/base/text.h"
#include "croquis/operators/hole_wishes.h"

namespace croquis {
namespace {

using hole_filling::Fairness;
using hole_filling::FillOptions;
using hole_filling::HoleRequest;
using hole_filling::Precision;
using hole_filling::Preset;
using implicit::Kernel;
using remeshing::RemeshOptions;

constexpr double unlimited = std::numeric_limits<double>::infinity();

/// Which holes, and what of them.
std::vector<ParameterDescription> hole_parameters() {
  return {
      choice_parameter(
          "mode", {"patch", "remesh"},
          "patch closes holes and changes nothing else; remesh makes all of it of new triangles, from one function.")
          .titled("Method", {"patches", "a new mesh"}),
      choice_parameter(
          "select", {selection_names.begin(), selection_names.end()},
          "inner fills all holes that don't look like the border of an open surface; none only those that holes "
          "names.")
          .titled("Fill", {"inner holes", "all holes", "all but the largest", "none"}),
      list_parameter("only", "Numbers of the holes to fill instead, as the list shows them: 0,3-5.")
          .at(ParameterPlace::Nowhere),
      number_parameter("max-diameter", 0, 0, unlimited, "model units", "Wider holes stay open; 0 for no limit.")
          .titled("Widest hole"),
      number_parameter("weld", hole_filling::usual_weld_tolerance, 0, 0.01, "× diagonal",
                       "Vertices of rims so near to each other count as one, if the edges there are longer; the scan "
                       "keeps them as they are. 0: only those at one place.")
          .titled("Join edges within"),
      list_parameter(
          "holes",
          "Wishes for single holes: '3: leave; 5-7: flat, bulge 0.4; 4: through 1 2 3; 2+9: bridge'. Words: fill, "
          "leave, bridge, rbf, smooth, flat, kernel NAME, bulge -1..1, trim 0..3, through X Y Z.")
          .at(ParameterPlace::Nowhere)};
}

ParameterDescription fill_preset_choice() {
  ParameterDescription preset =
      choice_parameter(
          "preset", {"auto", "standard", "paper", "sharp", "noisy"},
          "What is scanned: auto continues creases that run into a hole, standard rounds them; sharp for machined "
          "parts, where creases go on in holes of any size, noisy for rough scans; paper for comparison with Yoo 2005.")
          .titled("The scan is", {"usual", "smooth", "as published in 2005", "a machined part", "rough"});
  preset.presets["paper"] = {{"kernel", std::string("thin-plate")},
                             {"overlap", remeshing::remesh_preset(Preset::Paper).overlap}};
  preset.presets["sharp"] = {{"cell", remeshing::remesh_preset(Preset::Sharp).cell}};
  return preset;
}

std::vector<ParameterDescription> patch_parameters() {
  return {
      choice_parameter("fairness", {"auto", "rbf", "smooth", "flat"},
                       "rbf continues the surface around by functions fitted to it, smooth its tangents; flat adds no "
                       "vertices and has the least area; auto is flat where an open surface ends, and rbf elsewhere.")
          .titled("Patches", {"best for each hole", "continue the surface", "smooth", "flat"}),
      choice_parameter(
          "kernel", {kernel_names.begin(), kernel_names.end()},
          "The functions of rbf: hermite takes normals along, the others points beside the surface; thin-plate "
          "with the preset paper.")
          .titled("Function", {"with normals", "triharmonic", "biharmonic", "thin plate"})
          .at(ParameterPlace::Expert),
      fill_preset_choice(),
      number_parameter("bulge", 0, -1, 1, "", "Turns the surface at the rims outwards, or inwards below 0.")
          .titled("Bulge"),
      integer_parameter("trim-rim", 0, 0, 3, "rings of faces",
                        "Removes so much of the scan along the rims that are filled, where scans are worst.")
          .titled("Trim edge")};
}

std::vector<ParameterDescription> remesh_parameters() {
  return {
      number_parameter("overlap", 0.25, 0, 1, "× domain",
                       "remesh: how much larger domains are than their boxes; 0.1 with the preset paper.")
          .titled("New mesh: overlap")
          .at(ParameterPlace::Expert),
      text_parameter("points-per-domain", "30:300", "remesh: least and most points of a domain, MIN:MAX.")
          .at(ParameterPlace::Nowhere),
      integer_parameter("smoothing", 2, 0, 20, "rounds",
                        "remesh: how often the triangles are evened out on the surface.")
          .titled("New mesh: evened out"),
      integer_parameter("refine", 0, 0, 4, "times", "remesh: how often every triangle is cut in four.")
          .titled("New mesh: each triangle cut in four"),
      number_parameter("cell", 1, 0.1, 10, "× mean edge",
                       "remesh: edge of the cubes; small ones keep more detail and take more memory. 0.5 with the "
                       "preset sharp.")
          .titled("New mesh: edges"),
      number_parameter("adaptive", 0, 0, 1, "× cell",
                       "remesh: fewer faces where the surface is flat: they are merged as long as the surface stays "
                       "this near to what it was. 0: none are; 0.1 is usual.")
          .titled("New mesh: fewer faces where flat")};
}

/// How much memory the result may take, and what is kept in it.
std::vector<ParameterDescription> result_parameters() {
  return {
      number_parameter("memory-limit", 0, 0, unlimited, "MiB",
                       "A mesh that would take more is refused before anything is allocated; 0 for no limit.")
          .titled("Most memory")
          .at(ParameterPlace::Expert),
      choice_parameter("precision", {"double", "single"},
                       "How coordinates will be stored, by which patches are judged; files of single numbers set it.")
          .at(ParameterPlace::Nowhere),
      flag_parameter(
          "patch-ids", true,
          "Mark each face with the number of its patch, -1 for the scan's own, and each vertex with a confidence; "
          "files other than PLY can't hold them.")
          .titled("Mark patches")
          .at(ParameterPlace::Expert),
      flag_parameter("list", false, "Only list the holes and which of them would be filled; write nothing.")};
}

Fairness fairness_of(std::string_view name) {
  if (name == "smooth") return Fairness::Tangent;
  return name == "flat" ? Fairness::Flat : Fairness::Implicit;
}

Kernel kernel_of(std::string_view name) {
  constexpr std::array<Kernel, 4> kernels = {Kernel::Hermite, Kernel::Triharmonic, Kernel::Biharmonic,
                                             Kernel::ThinPlate};
  return kernels[static_cast<std::size_t>(std::find(kernel_names.begin(), kernel_names.end(), name) -
                                          kernel_names.begin())];
}

Preset preset_of(const std::string& name) {
  if (name == "paper") return Preset::Paper;
  if (name == "sharp") return Preset::Sharp;
  if (name == "noisy") return Preset::Noisy;
  return name == "standard" ? Preset::Standard : Preset::Auto;
}

HoleRequest request_of(const HoleWish& wish) {
  HoleRequest request;
  request.holes = wish.holes;
  std::sort(request.holes.begin(), request.holes.end());
  request.holes.erase(std::unique(request.holes.begin(), request.holes.end()), request.holes.end());
  request.bridge = wish.bridge;
  request.fill = wish.fill;
  if (!wish.fairness.empty()) request.fairness = fairness_of(wish.fairness);
  if (!wish.kernel.empty()) request.kernel = kernel_of(wish.kernel);
  request.bulge = wish.bulge;
  if (wish.trim_rim) request.trim_rim = static_cast<int>(*wish.trim_rim);
  request.through = wish.through;
  return request;
}

void read_shape(const ParameterValues& parameters, FillOptions& options) {
  options.fairness = fairness_of(text_of(parameters, "fairness"));
  options.flat_caps = text_of(parameters, "fairness") == "auto";
  options.preset = preset_of(text_of(parameters, "preset"));
  options.implicit.kernel = kernel_of(text_of(parameters, "kernel"));
  options.bulge = number_of(parameters, "bulge");
  options.trim_rim = static_cast<int>(integer_of(parameters, "trim-rim"));
}

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
    throw Error(make_error(Category::Usage, "E_PARAMETER",
                           "'" + range +
                               "' is no value for points-per-domain: it takes the least and the most points, "
                               "4 to 2000, such as 30:300.",
                           {{SubjectKind::Parameter, "points-per-domain", {}, {}, {}}}));
  options.min_points = *low;
  options.max_points = *high;
}

RemeshOptions mode_options(const ParameterValues& parameters, bool remesh) {
  RemeshOptions options = remesh ? remeshing::remesh_preset(preset_of(text_of(parameters, "preset"))) : RemeshOptions();
  options.overlap = number_of(parameters, "overlap");
  read_point_range(text_of(parameters, "points-per-domain"), options);
  options.smoothing = static_cast<int>(integer_of(parameters, "smoothing"));
  options.refine = static_cast<int>(integer_of(parameters, "refine"));
  options.cell = number_of(parameters, "cell");
  options.adaptive = number_of(parameters, "adaptive");
  constexpr double mebibyte = 1024 * 1024;
  options.memory_limit = static_cast<std::size_t>(std::min(number_of(parameters, "memory-limit") * mebibyte, 1e18));
  return options;
}

/// What only one of the modes looks at.
constexpr std::array<const char*, 6> remesh_alone = {"overlap", "points-per-domain", "smoothing", "refine",
                                                     "cell",    "adaptive"};
constexpr std::array<const char*, 2> patch_alone = {"bulge", "trim-rim"};

Findings unused_parameters(const ParameterValues& parameters, bool remesh) {
  std::string names;
  std::vector<Subject> subjects;
  const ParameterValues plain = complete(fill_parameters(), {{"preset", parameters.at("preset")}});
  const auto look_at = [&](const char* name) {
    if (parameters.at(name) == plain.at(name)) return;  // without an effect in either mode
    names += (names.empty() ? "" : ", ") + std::string(name);
    subjects.push_back({SubjectKind::Parameter, name, {}, {}, {}});
  };
  if (remesh)
    std::ranges::for_each(patch_alone, look_at);
  else
    std::ranges::for_each(remesh_alone, look_at);
  if (subjects.empty()) return {};
  const std::string mode = remesh ? "remesh" : "patch";
  return {make_warning(Category::Usage, "W_PARAMETER_UNUSED", "Not looked at in mode " + mode + ": " + names + ".",
                       std::move(subjects))};
}

}  // namespace

std::vector<ParameterDescription> fill_parameters() {
  std::vector<ParameterDescription> all;
  for (const auto& group : {hole_parameters(), patch_parameters(), remesh_parameters(), result_parameters()})
    all.insert(all.end(), group.begin(), group.end());
  return all;
}

FillSettings read_fill_settings(const ParameterValues& parameters) {
  FillSettings settings;
  settings.remesh = text_of(parameters, "mode") == "remesh";
  settings.options = mode_options(parameters, settings.remesh);
  FillOptions& options = settings.options.fill;
  FillChoice choice = read_fill_choice(parameters);
  options.selection = choice.select;
  options.only = std::move(choice.only);
  if (const double limit = number_of(parameters, "max-diameter"); limit > 0) options.max_diameter = limit;
  for (const HoleWish& wish : choice.wishes) options.requests.push_back(request_of(wish));
  options.analysis.weld_tolerance = number_of(parameters, "weld");
  read_shape(parameters, options);
  if (settings.remesh)
    options.flat_caps = true;  // fairness is of patches
  else
    options.memory_limit = settings.options.memory_limit;
  if (text_of(parameters, "precision") == "single") options.precision = Precision::Single;
  options.mark_patches = flag_of(parameters, "patch-ids");
  settings.list_only = flag_of(parameters, "list");
  if (!settings.list_only) settings.warnings = unused_parameters(parameters, settings.remesh);
  return settings;
}

}  // namespace croquis
