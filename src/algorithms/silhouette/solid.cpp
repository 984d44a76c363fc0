// SPDX-License-Identifier: GPL-3.0-or-later
#include "croquis/silhouette/solid.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <iterator>
#include <limits>
#include <optional>
#include <string>
#include <tuple>
#include <utility>

#include "algorithms/silhouette/cage/figure_cage.h"
#include "algorithms/silhouette/cage/whole_cage.h"
#include "algorithms/silhouette/figure_solid.h"
#include "algorithms/silhouette/solid_lines.h"
#include "algorithms/silhouette/strokes/drawing_findings.h"
#include "algorithms/silhouette/surface/mirror_halves.h"
#include "croquis/base/error.h"
#include "croquis/base/text.h"
#include "croquis/geometry/polyline.h"
#include "croquis/silhouette/cage.h"
#include "croquis/silhouette/stroke_data.h"

namespace croquis::silhouette {
namespace {

std::vector<Vec2> sample_places(const Stroke& stroke) {
  std::vector<Vec2> points;
  for (const StrokeSample& sample : stroke.samples) {
    if (points.empty() || sample.position != points.back()) points.push_back(sample.position);
  }
  return points;
}

/// A limb without its body isn't what was drawn: a solid of a smaller share of the drawing is none.
constexpr double least_use = 0.5;

/// How much of a drawing a solid is made of. Lines that are drawn as hidden aren't counted.
struct DrawnUse {
  double share = 1;                 ///< by length
  double meant = 1;                 ///< the same without the lines that are set to be ignored, which nobody misses
  bool has_largest_outline = true;  ///< no stroke that is left out encloses more than any outline of the solid
  Index left_out = no_index;        ///< that stroke, else the longest one
};

/// @param largest_area that an outline of the solid encloses
DrawnUse use_of(const Drawing& drawing, const Solid& solid, double largest_area) {
  constexpr double open_share = 0.5;  // of its length: an outline's ends are no farther apart
  std::vector<bool> used(drawing.strokes.size(), false);
  for (const SolidObject& object : solid.objects) {
    for (const Index stroke : object.strokes) used[stroke] = true;
  }
  for (const SurfaceLine& line : solid.lines) used[line.stroke] = true;
  double whole = 0, ignored = 0, used_length = 0, longest = 0, most_area = largest_area;
  Index largest = no_index, longest_left = no_index;
  for (Index s = 0; s < drawing.strokes.size(); ++s) {
    const Stroke& stroke = drawing.strokes[s];
    if (stroke_kind(stroke) == StrokeKind::Hidden) continue;
    const std::vector<Vec2> points = sample_places(stroke);
    const double own = length(points, stroke.closed), area = std::abs(signed_area(points));
    whole += own;
    if (stroke_kind(stroke) == StrokeKind::Ignored) {
      ignored += own;
      continue;
    }
    const bool encloses = stroke.closed || (points.back() - points.front()).norm() < open_share * own;
    if (!used[s] && encloses && area > most_area) std::tie(largest, most_area) = std::pair(s, area);
    if (used[s]) used_length += own;
    if (!used[s] && own > longest) std::tie(longest_left, longest) = std::pair(s, own);
  }
  const bool has_largest = largest == no_index;
  const auto share_of = [&](double length) { return length > 0 ? used_length / length : 1; };
  return {share_of(whole), share_of(whole - ignored), has_largest, has_largest ? longest_left : largest};
}

Finding left_out_error(const Drawing& drawing, const DrawnUse& use) {
  const auto percent = static_cast<int>(100 * use.meant);
  return make_error(Category::Geometry, "E_LEFT_OUT",
                    "The solid would use only " + std::to_string(percent) + " % of what is drawn and lack " +
                        in_quotes(drawing, use.left_out) +
                        ", the largest line that is left out: close that line, lead its ends to the lines that they "
                        "pass behind, or delete it",
                    {stroke_subject(drawing, use.left_out)});
}

void add_findings(const Findings& from, Findings& to) { to.insert(to.end(), from.begin(), from.end()); }

void add_lines(const LabelledDrawing& labelled, const Drawing& drawing, Solid& solid) {
  constexpr double shown_within = 15;  // u: a line that near to a contour is that contour
  if (labelled.figures.empty()) return;
  std::vector<DrawnLine> details, contours;
  double step = 0, unit = 0;
  for (const LabelledFigure& figure : labelled.figures) {
    step = std::max(step, figure.step);
    unit = std::max(unit, figure.unit);
  }
  for (Index s = 0; s < labelled.kinds.size(); ++s) {
    const Stroke& stroke = drawing.strokes[s];
    DrawnLine line{s, sample_places(stroke), stroke.closed};
    if (labelled.kinds[s] == StrokeKind::Detail || labelled.kinds[s] == StrokeKind::Scribble) {
      details.push_back(std::move(line));
    } else if (labelled.kinds[s] == StrokeKind::Contour) {
      contours.push_back(std::move(line));
    }
  }
  std::ranges::move(inner_pieces(contours, labelled.figures, shown_within * unit), std::back_inserter(details));
  solid.lines = surface_lines(details, solid.mesh, step);
}

void add_attachments(const LabelledFigure& figure, const Attachments& attachments, Solid& solid) {
  for (const auto& [pair, how] : attachments.held) {
    SolidAttachment& made = solid.attached.emplace_back();
    made.a = figure.objects[pair.first].name;
    made.b = figure.objects[pair.second].name;
    made.hold = how.hold;
    if (how.hold == Hold::Joined) std::tie(made.kappa, made.blend) = std::pair(how.kappa, how.blend);
    const auto place = std::ranges::find(figure.overlaps, pair, [](const FigureOverlap& overlap) {
      return ObjectPair(std::minmax(overlap.upper, overlap.lower));
    });
    if (place != figure.overlaps.end()) made.at = place->at;
  }
}

void add_shell(const LabelledFigure& figure, const DepthSettings& settings, const Shell& shell, Solid& solid) {
  AttributeChannel& channel = *solid.mesh.channel("object", Domain::Face);
  SolidShell made{{}, shell.euler};
  std::vector<std::int32_t> number(figure.objects.size(), 0);
  for (const Index o : shell.objects) {
    const FigureObject& object = figure.objects[o];
    // A copy on the far side belongs to the object that it is a copy of.
    const auto known = std::ranges::find(channel.labels, object.name);
    number[o] = static_cast<std::int32_t>(known - channel.labels.begin());
    if (known != channel.labels.end()) {
      made.objects.push_back(static_cast<Index>(number[o]));
      continue;
    }
    channel.labels.push_back(object.name);
    made.objects.push_back(static_cast<Index>(solid.objects.size()));
    // Counted and found to be this, see topology_fault.
    solid.objects.push_back(
        {object.name, object.strokes, object.euler_region, 2 * object.euler_region, settings.thickness_of(o)});
  }
  auto& values = std::get<std::vector<std::int32_t>>(channel.data);
  for (Index f = 0; f < shell.mesh.face_count(); ++f) values.push_back(number[shell.object_of(f)]);
  append_triangles(shell.mesh, solid.mesh);
  solid.shells.push_back(std::move(made));
}

void add_diagnostics(const SolidDiagnostics& part, SolidDiagnostics& total) {
  total.skeleton_vertices += part.skeleton_vertices;
  total.collision_constraints += part.collision_constraints;
  total.scale = std::max(total.scale, part.scale);
  total.minimum_gap = std::min(total.minimum_gap, part.minimum_gap);
  total.solver_iterations = std::max(total.solver_iterations, part.solver_iterations);
  total.solver_residual = std::max(total.solver_residual, part.solver_residual);
  total.depth_ratio = std::max(total.depth_ratio, part.depth_ratio);
}

/// What is known of a solid while its figures are added.
struct SolidSoFar {
  Solid solid;
  double rings = 0;  ///< of the cage, if that is wanted
  QuadCage cage = {};
  double largest_area = 0;  ///< that an outline of it encloses
  Overlap overlap;
  Overlap cage_overlap;
};

/// The cages of a figure's sound objects, and of their copies on the far side.
void add_cage(const LabelledFigure& figure, const FigureSolid& part, SolidSoFar& made, Progress& progress) {
  const FigureCage cage = figure_cage(figure, *part.sheets, made.rings, progress);
  const AttributeChannel& objects = *made.solid.mesh.channel("object", Domain::Face);
  std::vector<std::int32_t> number(figure.objects.size(), -1);
  for (const Shell& shell : part.shells) {
    for (const Index o : shell.objects) {
      const auto known = std::ranges::find(objects.labels, figure.objects[o].name);
      number[o] = static_cast<std::int32_t>(known - objects.labels.begin());
    }
  }
  append_cage(cage, number, part.mirrored, made.cage);
  made.cage_overlap.both += cage.overlap.both;
  made.cage_overlap.either += cage.overlap.either;
}

void add_figure(const LabelledFigure& figure, const DepthSettings& settings, const FigureSolid& part,
                SolidSoFar& made) {
  for (const Shell& shell : part.shells) {
    add_shell(figure, settings, shell, made.solid);
    for (const Index object : shell.objects) {
      for (const Index c : figure.objects[object].contours) {
        made.largest_area = std::max(made.largest_area, std::abs(signed_area(figure.raw_contours[c])));
      }
    }
  }
  add_attachments(figure, part.held, made.solid);
  made.overlap.both += part.overlap.both;
  made.overlap.either += part.overlap.either;
  add_findings(part.findings, made.solid.findings);
  add_diagnostics(part.diagnostics, made.solid.diagnostics);
  append_skeleton(part.skeleton, made.solid.skeleton);
}

/// One bad figure doesn't stop the others: its errors are kept.
void try_figure(const LabelledFigure& figure, const Drawing& drawing, const FigureSettings& settings, SolidSoFar& made,
                Progress& progress) {
  try {
    const std::shared_ptr<const FigureSolid> part = make_figure_solid(figure, drawing, settings, progress);
    add_figure(figure, settings.depth, *part, made);
    if (made.rings > 0) add_cage(figure, *part, made, progress);
  } catch (const Error& error) {
    for (Finding finding : error.findings()) {
      if (finding.subjects.empty()) {
        for (const FigureObject& object : figure.objects) {
          std::ranges::move(object_subjects(object, drawing), std::back_inserter(finding.subjects));
        }
      }
      made.solid.findings.push_back(std::move(finding));
    }
  }
}

void finish_cage(SolidSoFar& made) {
  made.cage.mesh.channels.front().labels = made.solid.mesh.channel("object", Domain::Face)->labels;
  made.cage.mirror = make_symmetric(made.cage.mesh);
  if (made.cage_overlap.either > 0) made.cage.silhouette_iou = made.cage_overlap.ratio();
}

/// @throws Error where the solid is none of the drawing
void require_use(const LabelledDrawing& labelled, const Drawing& drawing, const DrawnUse& use, Solid& solid) {
  if (!solid.objects.empty() && use.meant >= least_use && use.has_largest_outline) return;
  Findings findings = labelled.findings;
  add_findings(solid.findings, findings);
  if (!solid.objects.empty()) {
    findings.insert(findings.begin(), left_out_error(drawing, use));
  } else if (!has_errors(findings)) {
    findings.push_back(
        make_error(Category::Geometry, "E_EMPTY", "The drawing has no closed outline: draw at least one"));
  }
  throw Error(std::move(findings));
}

/// The text that a stroke has under a key; empty for none.
std::string said(const Stroke& stroke, const char* key) {
  const auto found = stroke.data.find(key);
  return found == stroke.data.end() ? std::string() : found->second;
}

/// The line on both sides of which all outlines are the same; none where that isn't so.
std::optional<double> common_mirror(const Drawing& drawing, const Solid& solid) {
  std::string words;
  for (const SolidObject& object : solid.objects) {
    for (const Index stroke : object.strokes) {
      const std::string own = said(drawing.strokes[stroke], mirror_key);
      if (own.empty() || (!words.empty() && own != words)) return std::nullopt;
      words = own;
    }
  }
  double axis = 0;
  return croquis::read_number(words, axis) ? std::optional(axis) : std::nullopt;
}

/// Per object the one that its mirror image belongs to: itself where its strokes have no twins.
std::vector<std::int32_t> mirror_images(const Drawing& drawing, const Solid& solid) {
  std::vector<std::int32_t> images(solid.objects.size());
  for (std::size_t o = 0; o < images.size(); ++o) {
    images[o] = static_cast<std::int32_t>(o);
    const std::string twin = said(drawing.strokes[solid.objects[o].strokes.front()], twin_key);
    for (std::size_t other = 0; other < images.size(); ++other) {
      const auto is_twin = [&](Index stroke) { return drawing.strokes[stroke].id == twin; };
      if (std::ranges::any_of(solid.objects[other].strokes, is_twin)) images[o] = static_cast<std::int32_t>(other);
    }
  }
  return images;
}

/// Makes both halves of a symmetric drawing's solid the same, to the last digit.
void make_symmetric(const Drawing& drawing, Solid& solid, Progress& progress) {
  const std::optional<double> axis = common_mirror(drawing, solid);
  if (!axis) return;
  if (auto mesh = with_mirrored_half(solid.mesh, *axis, mirror_images(drawing, solid), progress)) {
    solid.mesh = std::move(*mesh);
  } else {
    solid.findings.push_back(make_warning(
        Category::Geometry, "W_MIRROR",
        "The solid is symmetric but for small differences: at the symmetry line its halves can't be joined; move parts "
        "that touch the line away from it, or onto it"));
  }
}

using Rgb = std::array<std::uint8_t, 3>;

/// "#0088ff"; nothing for any other text.
std::optional<Rgb> color_of(const std::string& text) {
  Rgb color{};
  if (text.size() != 7 || text.front() != '#') return std::nullopt;
  for (std::size_t i = 0; i < 3; ++i) {
    const char* digits = text.data() + 1 + 2 * i;
    const auto [end, error] = std::from_chars(digits, digits + 2, color[i], 16);
    if (error != std::errc() || end != digits + 2) return std::nullopt;
  }
  return color;
}

/// Of the group that names the object, or of the first of its strokes that has one.
std::optional<Rgb> drawn_color(const Drawing& drawing, const SolidObject& object) {
  const auto fill_of = [](const std::map<std::string, std::string>& data) {
    const auto found = data.find(fill_key);
    return found == data.end() ? std::nullopt : color_of(found->second);
  };
  const auto group = drawing.object_data.find(object.name);
  std::optional<Rgb> color = group == drawing.object_data.end() ? std::nullopt : fill_of(group->second);
  for (const Index stroke : object.strokes) {
    if (!color) color = fill_of(drawing.strokes[stroke].data);
  }
  return color;
}

/// Colours of parts, where any has one.
void color_parts(const Drawing& drawing, Solid& solid) {
  std::vector<std::optional<Rgb>> colors;
  for (const SolidObject& object : solid.objects) colors.push_back(drawn_color(drawing, object));
  if (std::ranges::none_of(colors, [](const auto& color) { return color.has_value(); })) return;
  for (const SolidShell& shell : solid.shells) {
    const auto first = std::ranges::find_if(shell.objects, [&](Index object) { return colors[object].has_value(); });
    if (first == shell.objects.end()) continue;
    for (const Index object : shell.objects) {
      if (!colors[object]) colors[object] = colors[*first];
    }
  }
  constexpr std::uint8_t grey = 200;
  std::vector<std::uint8_t> values(3 * solid.mesh.positions.size(), grey);
  const auto& objects = std::get<std::vector<std::int32_t>>(solid.mesh.channel("object", Domain::Face)->data);
  for (Index face = 0; face < solid.mesh.face_count(); ++face) {
    const auto& color = colors[static_cast<std::size_t>(objects[face])];
    if (!color) continue;
    for (const Index vertex : solid.mesh.face(face))
      std::copy(color->begin(), color->end(), values.begin() + 3 * vertex);
  }
  solid.mesh.channels.push_back({"color", Domain::Vertex, 3, std::move(values), {}});
}

void inflate_all(const LabelledDrawing& labelled, const Drawing& drawing, const Options& options, SolidSoFar& made,
                 Progress& progress) {
  Solid& solid = made.solid;
  const std::vector<FigureSettings> settings = figure_settings(labelled, drawing, options, solid.findings);
  constexpr double carving_share = 0.2;
  const double inflating_share = options.details.shape == DetailShape::Line ? 1 : 1 - carving_share;
  double total = 0, unit = 0;
  for (const LabelledFigure& figure : labelled.figures) {
    total += static_cast<double>(figure.points.size());
    unit = std::max(unit, figure.unit);
  }
  solid.diagnostics.minimum_gap = std::numeric_limits<double>::infinity();
  solid.mesh.channels.push_back({"object", Domain::Face, 1, std::vector<std::int32_t>{}, {}});
  for (std::size_t f = 0; f < labelled.figures.size(); ++f) {
    const LabelledFigure& figure = labelled.figures[f];
    Progress part = progress.step("inflate part", inflating_share * static_cast<double>(figure.points.size()) / total);
    try_figure(figure, drawing, settings[f], made, part);
  }
  add_lines(labelled, drawing, solid);
  const DrawnUse use = use_of(drawing, solid, made.largest_area);
  require_use(labelled, drawing, use, solid);
  solid.used = use.share;
  if (options.details.shape != DetailShape::Line) {
    Progress carving = progress.step("carve details", carving_share);
    carve_lines(drawing, options.details, unit, solid, carving);
  }
  if (options.quality == Quality::Final) make_symmetric(drawing, solid, progress);
  color_parts(drawing, solid);
  const bool measured = made.overlap.either > 0;
  solid.diagnostics.silhouette_iou = measured ? made.overlap.ratio() : std::numeric_limits<double>::quiet_NaN();
  if (made.rings > 0) finish_cage(made);
  progress.report(1);
}

}  // namespace

Solid inflate(const LabelledDrawing& labelled, const Drawing& drawing, const Options& options, Progress& progress) {
  SolidSoFar made;
  inflate_all(labelled, drawing, options, made, progress);
  return std::move(made.solid);
}

CagedSolid inflate_with_cage(const LabelledDrawing& labelled, const Drawing& drawing, const Options& options,
                             double rings, Progress& progress) {
  SolidSoFar made;
  made.rings = rings;
  inflate_all(labelled, drawing, options, made, progress);
  return {std::move(made.solid), std::move(made.cage)};
}

}  // namespace croquis::silhouette
