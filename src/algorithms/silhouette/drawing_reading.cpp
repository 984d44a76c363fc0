// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/silhouette/drawing_reading.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <limits>
#include <map>
#include <utility>

#include "algorithms/silhouette/figure/labelling.h"
#include "algorithms/silhouette/reading/reading_costs.h"
#include "algorithms/silhouette/reading/reading_program.h"
#include "algorithms/silhouette/sampling/planar_walk.h"
#include "algorithms/silhouette/stage.h"
#include "algorithms/silhouette/strokes/clean_line.h"
#include "algorithms/silhouette/strokes/drawing_findings.h"
#include "algorithms/silhouette/strokes/visible_crossings.h"
#include "croquis/base/error.h"
#include "croquis/base/text.h"
#include "croquis/silhouette/labelled_figure.h"

namespace croquis::silhouette {
namespace {

/// Marks the overlaps of objects whose outlines cross in full view.
void mark_whole_outlines(LabelledDrawing& labelled) {
  for (LabelledFigure& figure : labelled.figures) {
    for (FigureOverlap& overlap : figure.overlaps) {
      const auto bounds = [&](Index object, Index stroke) {
        return std::ranges::count(figure.objects[object].strokes, stroke) > 0;
      };
      overlap.whole_outlines = std::ranges::any_of(labelled.crossings, [&](const CrossingInView& pair) {
        return pair.whole && bounds(overlap.upper, pair.front) && bounds(overlap.lower, pair.behind);
      });
    }
  }
}

// So many readings are tried before all but what lines enclose is given up.
constexpr int most_readings = 8;
// And so many connections of the same strokes before their kinds must change.
constexpr int most_connections = 3;

void append(Findings from, Findings& to) { std::move(from.begin(), from.end(), std::back_inserter(to)); }

Finding crosses_itself(const Drawing& drawing, const CleanLine& line, const Vec2& place) {
  return make_warning(Category::Geometry, "W_CROSS",
                      in_quotes(drawing, line.strokes.front()) +
                          " crosses itself: its two sides are read as lying beside one another there",
                      {stroke_subject(drawing, line.strokes.front(), place), crossing_subject(drawing, place)});
}

double size_of_stroke(const Drawing& drawing, Index stroke) {
  Points points;
  for (const StrokeSample& sample : drawing.strokes[stroke].samples) points.push_back(sample.position);
  return size_of(points, drawing.strokes[stroke].closed);
}

/// Everything that doesn't depend on the reading.
struct Material {
  const Drawing& drawing;
  const Options& options;
  SampledDrawing sampled;
  Connections connections;
  Envelope envelope;
  std::vector<PinnedEnds> pins = {};
};

/// The size that half of the length doesn't exceed.
double middle_size(std::vector<std::pair<double, double>> sizes_and_lengths) {
  std::ranges::sort(sizes_and_lengths);
  double whole = 0, below = 0;
  for (const auto& [size, part] : sizes_and_lengths) whole += part;
  for (const auto& [size, part] : sizes_and_lengths) {
    below += part;
    if (2 * below >= whole) return size;
  }
  return 0;
}

/// How large the things on a sheet are. They are small only where strokes and what they enclose are: rings of a chain
/// are, however long it is; tufts along a body aren't.
double typical_size(const Material& material) {
  constexpr double size_of_width = 1.2;  // of a disc of the same width as a region, 2 area / length
  std::vector<std::pair<double, double>> strokes, regions;
  for (const SampledStroke& stroke : material.sampled.strokes) strokes.emplace_back(stroke.size, stroke.length);
  for (const EnclosedRegion& region : material.envelope.regions) {
    const double own = length(region.outline, true);
    regions.emplace_back(size_of_width * 2 * region.area / own, own);
  }
  return std::max(middle_size(std::move(strokes)), middle_size(std::move(regions)));
}

/// The same of things that are sampled as tubes should be: several places across each, but only so many along all.
double typical_size(const std::vector<CentreLine>& tubes) {
  constexpr double size_of_radius = 5;
  constexpr double most_sizes = 80;
  double radius = std::numeric_limits<double>::infinity(), along = 0;
  for (const CentreLine& tube : tubes) {
    const auto [thin, thick] = std::ranges::minmax(tube.radius);
    radius = std::min(radius, std::sqrt(thin * thick));
    along += length(tube.points, tube.closed);
  }
  return std::max(size_of_radius * radius, along / most_sizes);
}

/// The strokes and what they enclose. Where tolerances go by size, a sheet of many small things is sampled once more.
void sample(Material& material) {
  const StrokeOptions& options = material.options.strokes;
  material.sampled = sample_strokes(material.drawing, options);
  material.envelope = enclosed_regions(material.sampled.strokes);
  if (options.reach_share <= 0 && material.sampled.tubes.empty()) return;
  double typical = std::numeric_limits<double>::infinity();
  if (options.reach_share > 0 && !material.sampled.strokes.empty()) typical = typical_size(material);
  if (!material.sampled.tubes.empty()) typical = std::min(typical, typical_size(material.sampled.tubes));
  if (typical >= least_typical_size * material.sampled.scale.unit) return;
  SampledDrawing finer = sample_strokes(material.drawing, options, typical);
  if (finer.scale.unit >= material.sampled.scale.unit) return;
  material.sampled = std::move(finer);
  material.envelope = enclosed_regions(material.sampled.strokes);
}

/// Fur and hatching cross themselves again and again.
bool is_scribble(const Material& material, Index stroke) {
  constexpr int least_crossings = 6;
  const StrokeKind given = material.sampled.strokes[stroke].given_kind;
  if (given == StrokeKind::Detail || given == StrokeKind::Scribble) return given == StrokeKind::Scribble;
  const auto with_itself = material.connections.crossings.find({stroke, stroke});
  return with_itself != material.connections.crossings.end() && with_itself->second >= least_crossings;
}

/// Closed outlines within others.
void add_nested(const Drawing& drawing, LabelledDrawing& labelled) {
  constexpr double blob_share = 0.2;  // of the size of what it lies on
  for (const LabelledFigure& figure : labelled.figures) {
    for (const NestedOutline& nested : figure.nested) {
      const bool small = size_of_stroke(drawing, nested.stroke) < blob_share * size_of_stroke(drawing, nested.around);
      const StrokeKind given = stroke_kind(drawing.strokes[nested.stroke]).value_or(StrokeKind::Visible);
      const bool blob = given == StrokeKind::Blob || (small && given != StrokeKind::Part);
      const StrokeKind part = blob ? StrokeKind::Blob : StrokeKind::Part;
      labelled.kinds[nested.stroke] = nested.hole ? StrokeKind::Hole : part;
    }
  }
}

/// What was found of every stroke of the drawing.
std::vector<StrokeKind> kinds_of(const Material& material, const Reading& reading) {
  std::vector<StrokeKind> kinds(material.drawing.strokes.size(), StrokeKind::Ignored);
  for (const SampledStroke& hidden : material.sampled.hidden) kinds[hidden.stroke] = StrokeKind::Hidden;
  for (const CentreLine& tube : material.sampled.tubes) kinds[tube.stroke] = StrokeKind::Tube;
  for (Index s = 0; s < reading.kinds.size(); ++s) {
    StrokeKind& kind = kinds[material.sampled.strokes[s].stroke];
    switch (reading.kinds[s]) {
      case LineKind::Contour:
      case LineKind::Region: kind = StrokeKind::Contour; break;
      case LineKind::Detail: kind = is_scribble(material, s) ? StrokeKind::Scribble : StrokeKind::Detail; break;
      case LineKind::Tube: kind = StrokeKind::Tube; break;
      case LineKind::Ignored: kind = StrokeKind::Ignored; break;
    }
  }
  return kinds;
}

/// What is drawn is seen: a line that all of what was drawn later covers is no contour.
Findings covered_lines(const Drawing& drawing, const LabelledDrawing& labelled) {
  Findings findings;
  for (const LabelledFigure& figure : labelled.figures) {
    for (Index c = 0; c < figure.contours.size(); ++c) {
      const auto is_seen = [c](const FigureArc& arc) { return arc.contour == c && arc.visible; };
      if (std::ranges::any_of(figure.arcs, is_seen)) continue;
      const Index stroke = figure.contours[c].strokes.front();
      findings.push_back(
          no_solid("all of " + in_quotes(drawing, stroke) + " would be covered", {stroke_subject(drawing, stroke)}));
    }
  }
  return findings;
}

bool is_on_surface(const LabelledDrawing& labelled, const Vec2& place) {
  return std::ranges::any_of(labelled.figures, [&](const LabelledFigure& figure) {
    const Index triangle = PlanarWalk(figure.points, figure.triangulation).locate(place);
    return triangle != no_index && figure.layers[triangle] > 0;
  });
}

/// Strokes too short to be lines are eyes and freckles where there is a surface.
void add_dots(const Material& material, LabelledDrawing& labelled) {
  for (const Index s : material.sampled.dots) {
    const Stroke& stroke = material.drawing.strokes[s];
    const StrokeKind given = stroke_kind(stroke).value_or(StrokeKind::Visible);
    const bool may_be_detail = given == StrokeKind::Visible || given == StrokeKind::Detail || given == StrokeKind::Blob;
    if (may_be_detail && stroke.samples.size() > 1 && is_on_surface(labelled, stroke.samples.front().position)) {
      labelled.kinds[s] = StrokeKind::Detail;
    } else {
      labelled.findings.push_back(too_short(material.drawing, s));
    }
  }
}

void mark_limbs(const Drawing& drawing, LabelledDrawing& labelled) {
  const auto is_limb = [&](Index stroke) {
    return labelled.kinds[stroke] == StrokeKind::Tube && !is_centre_line(drawing.strokes[stroke]);
  };
  for (LabelledFigure& figure : labelled.figures) {
    for (FigureObject& object : figure.objects) {
      object.tube = std::ranges::all_of(object.strokes, is_limb);
    }
  }
}

/// What was joined in full view, and what all of the reading costs.
void add_connections_and_cost(const Material& material, const Reading& reading, LabelledDrawing& labelled) {
  const auto stroke_end_of = [&](Index end) {
    return StrokeEnd{material.sampled.strokes[material.connections.ends[end].stroke].stroke,
                     material.connections.ends[end].at_start};
  };
  for (const Index join : reading.joins) {
    EndPair& pair = labelled.joined.emplace_back();
    pair = {stroke_end_of(material.connections.joins[join].a), stroke_end_of(material.connections.joins[join].b)};
    std::ranges::sort(pair);
  }
  labelled.cost = reading.cost;
  for (const LabelledFigure& figure : labelled.figures) {
    for (const FigureCompletion& completion : figure.completions) labelled.cost += costs::hidden * completion.cost;
  }
}

LabelledDrawing label_reading(const Material& material, const Reading& reading, const Progress& progress) {
  const Drawing& drawing = material.drawing;
  DrawingScale scale = material.sampled.scale;
  const StrokeOptions& options = material.options.strokes;
  ContourLines contours = contour_lines(drawing, material.sampled, material.connections, material.envelope, reading,
                                        material.sampled.smoothing_passes, progress);
  std::vector<CleanLine>& lines = contours.lines;
  Findings findings = material.sampled.findings;
  append(std::move(contours.findings), findings);
  if (scale.reach_share > 0) scale.jitter = jitter_of(lines, scale.step);
  for (CleanLine& line : lines) {
    for (const Vec2& place : uncross(line, scale)) findings.push_back(crosses_itself(drawing, line, place));
  }
  meet_bars(lines, scale);
  for (CleanLine& line : tube_outlines(material.sampled, reading, lines, material.envelope.diagonal))
    lines.push_back(std::move(line));
  if (material.options.attach_suggested) lead_into_neighbours(lines, scale);
  std::ranges::move(outlines_of_tubes(material.sampled.tubes, scale), std::back_inserter(lines));
  const bool tubes_only = options.crossings != Crossings::Front;
  VisibleCrossings order = order_visible_crossings(drawing, lines, scale, tubes_only, progress);
  meet_bars(lines, scale);  // bars may have moved
  Junctions junctions = find_junctions(drawing, lines, material.sampled.hidden, order, scale, progress);
  TubePassings passings = find_passings(drawing, material.sampled.tubes, lines, scale);
  std::ranges::move(passings.findings, std::back_inserter(junctions.findings));
  order.passings = std::move(passings.all);
  bring_into_general_position(lines, scale.step);

  const FigureContext context{drawing, material.options, scale, lines, junctions, order, material.pins};
  LabelledDrawing result = label_parts(context, progress.silent());
  result.crossings = std::move(order.pairs);
  for (const TubePassing& passing : order.passings) result.tube_crossings.push_back(passing.crossing);
  result.kinds = kinds_of(material, reading);
  add_connections_and_cost(material, reading, result);
  add_dots(material, result);
  mark_limbs(drawing, result);
  add_nested(drawing, result);
  mark_whole_outlines(result);
  append(std::move(order.findings), findings);
  for (LineFinding& found : junctions.findings) findings.push_back(std::move(found.finding));
  append(std::move(result.findings), findings);
  append(covered_lines(drawing, result), findings);
  const std::vector<PinnedEnds> lost = pins_lost(material.pins, result);
  if (!lost.empty()) findings.push_back(pins_not_kept(drawing, lost));
  for (const LabelledFigure& figure : result.figures) append(nested_findings(drawing, figure), findings);
  result.findings = std::move(findings);
  return result;
}

/// What an error is about.
struct Fault {
  std::vector<Index> strokes;    ///< positions among the sampled ones; none stands for all
  std::optional<Vec2> crossing;  ///< where lines cross or touch
};

std::vector<Fault> faults_of(const Material& material, const Findings& findings) {
  std::vector<Fault> faults;
  for (const Finding& finding : findings) {
    if (finding.severity != Severity::Error) continue;
    Fault& fault = faults.emplace_back();
    for (Index s = 0; s < material.sampled.strokes.size(); ++s) {
      const std::string& id = material.drawing.strokes[material.sampled.strokes[s].stroke].id;
      const auto subject = std::ranges::find_if(
          finding.subjects, [&](const Subject& named) { return named.kind == SubjectKind::Stroke && named.id == id; });
      if (subject == finding.subjects.end()) continue;
      fault.strokes.push_back(s);
      if (finding.code == "E_CROSS" && subject->at.size() == 2) fault.crossing = Vec2(subject->at[0], -subject->at[1]);
    }
  }
  if (faults.empty()) faults.emplace_back();
  return faults;
}

/// Strokes taken for details of which much lies beside everything: there would be nothing of them.
std::vector<Index> lost_details(const Material& material, const Reading& reading, const LabelledDrawing& labelled) {
  constexpr int places = 12;
  constexpr int most_lost = 5;
  std::vector<Index> lost;
  for (Index s = 0; s < reading.kinds.size(); ++s) {
    const SampledStroke& stroke = material.sampled.strokes[s];
    const bool is_line = stroke.given_kind == StrokeKind::Visible && !is_scribble(material, s);
    if (reading.kinds[s] != LineKind::Detail || !is_line) continue;
    int off = 0;
    for (int k = 0; k < places; ++k) {
      const double parameter = (k + 0.5) / places * static_cast<double>(stroke.points.size() - 1);
      off += is_on_surface(labelled, point_at(stroke.points, parameter)) ? 0 : 1;
    }
    if (off > most_lost) lost.push_back(s);
  }
  return lost;
}

/// Whether two closed strokes cross: that has no other meaning.
bool outlines_cross(const Material& material, const LabelledDrawing& labelled) {
  return std::ranges::any_of(labelled.findings, [&](const Finding& finding) {
    return finding.code == "E_CROSS" && std::ranges::all_of(finding.subjects, [&](const Subject& subject) {
             const auto stroke = std::ranges::find(material.drawing.strokes, subject.id, &Stroke::id);
             return subject.kind != SubjectKind::Stroke || (stroke != material.drawing.strokes.end() && stroke->closed);
           });
  });
}

/// One warning for each stroke that is ignored.
Findings left_out(const Material& material, const Reading& reading) {
  Findings findings;
  for (Index s = 0; s < reading.kinds.size(); ++s) {
    if (reading.kinds[s] != LineKind::Ignored || material.sampled.strokes[s].given_kind == StrokeKind::Ignored)
      continue;
    const Index stroke = material.sampled.strokes[s].stroke;
    std::vector<Subject> subjects{stroke_subject(material.drawing, stroke)};
    std::string sentence = in_quotes(material.drawing, stroke) + " is no line of a solid and was left out";
    const Index first = material.connections.doubled[s];
    if (first != no_index) {
      const Index other = material.sampled.strokes[first].stroke;
      subjects.push_back(stroke_subject(material.drawing, other));
      sentence = in_quotes(material.drawing, stroke) + " was drawn over " + in_quotes(material.drawing, other) +
                 ": they are read as one line";
    }
    const char* code = first == no_index ? "W_LEFT_OUT" : "W_DOUBLE";
    findings.push_back(make_warning(Category::Geometry, code, sentence, std::move(subjects)));
  }
  return findings;
}

/// What to say where no reading is left.
LabelledDrawing nothing_read(const Material& material, const ReadingProgram& program) {
  LabelledDrawing nothing;
  nothing.findings = material.sampled.findings;
  add_dots(material, nothing);
  const auto is_ignored = [](const SampledStroke& stroke) { return stroke.given_kind == StrokeKind::Ignored; };
  const std::vector<SampledStroke>& strokes = material.sampled.strokes;
  if (!strokes.empty() && std::ranges::all_of(strokes, is_ignored)) {
    nothing.findings.push_back(make_error(Category::Geometry, "E_NO_OUTLINE",
                                          "All lines of the drawing are set to be ignored: give the outline of "
                                          "something another kind"));
    return nothing;
  }
  for (const Index s : program.contradictions()) {
    if (is_ignored(material.sampled.strokes[s])) continue;
    const Index stroke = material.sampled.strokes[s].stroke;
    nothing.findings.push_back(make_error(Category::Geometry, "E_KIND",
                                          in_quotes(material.drawing, stroke) + " can't be a " +
                                              to_string(material.sampled.strokes[s].given_kind) +
                                              ": let its ends meet something, or give it another kind",
                                          {stroke_subject(material.drawing, stroke)}));
  }
  if (has_errors(nothing.findings)) return nothing;
  if (!material.pins.empty()) {
    nothing.findings.push_back(pins_not_kept(material.drawing, material.pins));
    return nothing;
  }
  nothing.findings.push_back(make_error(Category::Geometry, "E_NO_OUTLINE",
                                        "The drawing's lines enclose nothing: draw the outline of something"));
  return nothing;
}

/// Ends that are pinned but aren't found stay so: the reading is compared with the pins at its end.
void apply_pins(const Material& material, ReadingProgram& program) {
  for (const auto& [pair, joined] : material.pins) {
    std::vector<Index> found;
    for (Index e = 0; e < material.connections.ends.size(); ++e) {
      const LineEnd& end = material.connections.ends[e];
      const StrokeEnd own{material.sampled.strokes[end.stroke].stroke, end.at_start};
      if (std::ranges::count(pair, own) > 0) found.push_back(e);
    }
    if (found.size() == pair.size()) program.pin(found.front(), found.back(), joined);
  }
}

/// Finds the best reading of a drawing that can be labelled: what its strokes are, which of their ends meet, what they
/// pass behind, and what lies over what.
///
/// Readings are tried from the cheapest on (reading_program.h); one whose contours can't be labelled is excluded with
/// what its errors name. After some, only what the lines enclose is taken, with all lines in it as details: that can
/// always be labelled. Bounds are counts.
/// @param cheapest only the first one is tried
/// @throws Error when nothing can be labelled
LabelledDrawing read_drawing(const Drawing& drawing, const Options& options, const std::vector<PinnedEnds>& pins,
                             Progress& progress, bool cheapest = false) {
  Material material{drawing, options, {}, {}, {}, pins};
  sample(material);
  if (material.sampled.strokes.empty()) {  // only tubes
    LabelledDrawing labelled = label_reading(material, {}, progress);
    if (labelled.figures.empty()) throw Error(labelled.findings);
    return labelled;
  }
  material.connections = find_connections(material.sampled.strokes, material.sampled.scale, progress);
  progress.report(0.2);
  ReadingProgram program(material.sampled.strokes, material.connections, material.envelope);
  apply_pins(material, program);
  std::optional<LabelledDrawing> first, with_losses;
  std::map<std::vector<Index>, int> failed;
  for (int tried = 0; tried < most_readings + 2; ++tried) {
    progress.check();
    if (tried == most_readings) program.allow_regions_only();
    if (tried == most_readings + 1) program.forbid(LineKind::Tube);
    const std::optional<Reading> reading = program.best();
    if (!reading && cheapest) throw Error(nothing_read(material, program).findings);
    if (!reading) continue;
    LabelledDrawing labelled = label_reading(material, *reading, progress);
    append(left_out(material, *reading), labelled.findings);
    if (!has_errors(labelled.findings) && !labelled.figures.empty()) {
      const std::vector<Index> lost = lost_details(material, *reading, labelled);
      if (lost.empty()) return labelled;
      if (cheapest) throw Error(pins_not_kept(drawing, material.pins));
      for (const Index s : lost) program.forbid_loss(s);
      if (!with_losses) with_losses = std::move(labelled);
      continue;
    }
    if (cheapest) throw Error(labelled.findings);
    for (const auto& [strokes, crossing] : faults_of(material, labelled.findings)) {
      if (crossing && program.exclude_crossing(*reading, strokes.front(), strokes.back(), *crossing)) continue;
      // What fails again and again isn't saved by other connections.
      program.exclude(*reading, strokes, ++failed[strokes] <= most_connections);
    }
    if (!first && has_errors(labelled.findings)) first = std::move(labelled);
    if (first && options.strokes.crossings == Crossings::Refuse && outlines_cross(material, *first)) break;
  }
  LabelledDrawing result = with_losses ? *std::move(with_losses)
                           : first     ? *std::move(first)
                                       : nothing_read(material, program);
  if (result.figures.empty()) throw Error(result.findings);
  const std::vector<PinnedEnds> lost = pins_lost(material.pins, result);
  if (!lost.empty()) throw Error(pins_not_kept(drawing, lost));
  return result;
}

/// Pins that can't be kept any more, since strokes have changed, are named and left out.
LabelledDrawing read_with_pins(const Drawing& drawing, const Options& options, Progress& progress) {
  const std::vector<PinnedEnds> pins = pinned_ends(drawing);
  try {
    return read_drawing(drawing, options, pins, progress);
  } catch (const Error&) {
    if (pins.empty()) throw;
  }
  LabelledDrawing without = read_drawing(drawing, options, {}, progress);
  without.findings.push_back(pins_not_kept(drawing, pins));
  without.findings.back().code = "W_PIN";
  without.findings.back().severity = Severity::Warning;
  return without;
}

}  // namespace

LabelledDrawing label_cheapest(const Drawing& drawing, const Options& options, Progress& progress) {
  return read_drawing(drawing, options, pinned_ends(drawing), progress, true);
}

LabelledDrawing label(const Drawing& drawing, const Options& options, Progress& progress) {
  StageKey key;
  if (options.cache != nullptr) {
    add_drawing(drawing, key);
    key.add(options.strokes).add(options.completion).add(options.attach_suggested).add(options.swaps);
  }
  const auto labelled = cached<LabelledDrawing>(
      options.cache, "silhouette labels", key,
      [&] {
        LabelledDrawing read = read_with_pins(drawing, options, progress);
        if (options.swaps.empty()) return read;
        return read_with_pins(swap_overlaps(drawing, read, options.swaps), options, progress);
      },
      [](const LabelledDrawing& result) { return bytes_of(result); });
  progress.report(1);
  return *labelled;
}

}  // namespace croquis::silhouette
