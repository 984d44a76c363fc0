// SPDX-License-Identifier: GPL-3.0-or-later
#include <numbers>
#include <span>
#include <utility>
#include <vector>

#include <Eigen/Geometry>

#include "croquis/document/byte_size.h"
#include "croquis/io/mesh_tags_file.h"
#include "croquis/subdivision/level_mesh.h"
#include "croquis/subdivision/limit.h"
#include "croquis/subdivision/shape_keeping.h"
#include "operators/operations.h"
#include "operators/subdivide_report.h"
#include "operators/subdivide_tags.h"
#include "operators/subdivision_plan.h"

namespace croquis {
namespace {

using namespace subdivision;

struct SubdivideSettings {
  PlanSettings plan;
  double sharp_angle = 0;                ///< radians; 0 tags nothing
  double keep_kinks = std::numbers::pi;  ///< radians; chains keep corners where they turn by more
  bool limit = false;                    ///< vertices are moved to where they end
  bool provenance = false;               ///< the result lists what its elements come from
};

/// Rules of which presets have values of their own.
void list_rules(Rules& rules, ParameterList& list) {
  list.choice_of("preset", 0, {"refined", "paper"},
                 "refined for round faces and smooth ends of chains, paper for Lee, Joo, Hong 2002; doo-sabin only.",
                 [&](std::size_t preset) { rules = Rules::of(static_cast<Preset>(preset)); })
      .titled("Quality", {"refined", "as published in 2002"})
      .sets_others();
  const auto rule = [&](const char* name, auto& value, const std::vector<std::string>& words, const char* sentence,
                        const char* title, std::vector<std::string> titles) {
    titles.emplace_back("as the quality");
    list.choice(name, value, words, sentence).or_preset().titled(title, titles).at(ParameterPlace::Expert);
  };
  rule("weights", rules.weights, {"classical", "average"}, "How the corners of a face weigh in its new points.",
       "Corners of faces", {"classical", "all the same"});
  rule("profile", rules.profile, {"clamped", "plain"},
       "Rows of faces beside a chain: clamped halves them at each level, plain keeps three quarters.",
       "Beside sharp edges", {"half as wide", "three quarters as wide"});
  rule("chain-ends", rules.chain_ends, {"smooth", "retract", "pin"},
       "Where a chain of sharp edges ends in a surface: it runs out, draws back, or stays.", "Ends of sharp edges",
       {"run out", "draw back", "stay"});
  rule("boundary-corners", rules.boundary_corners, {"corner", "smooth"},
       "Boundary vertices with a single face stay, or are rounded with the boundary.", "Corners of borders",
       {"stay", "rounded"});
}

void list_subdivide_parameters(SubdivideSettings& settings, ParameterList& list) {
  constexpr int most_levels = 10;
  list.choice("scheme", settings.plan.scheme, {"doo-sabin", "catmull-clark", "loop"},
              "Rules of refinement; loop cuts polygons into triangles first.")
      .titled("Smoothing", {"Soft (Doo-Sabin)", "Standard (Catmull-Clark)", "Triangles (Loop)"});
  list_rules(settings.plan.rules, list);
  list.integer("levels", settings.plan.levels, 0, most_levels, "",
               "How often the cage is refined; each level has about four times the faces.")
      .titled("Level");
  list.angle("sharp-angle", settings.sharp_angle, 0, 180,
             "Edges without a tag become sharp where faces meet at more than this; 0 for none.")
      .titled("Sharp over")
      .or_else("off");
  list.angle("keep-kinks", settings.keep_kinks, 0, 180,
             "Chains that turn by more than this at a vertex of the cage keep a corner there; 180 for none.")
      .titled("Corners above", {"sharp", "round"})
      .or_else("off")
      .at(ParameterPlace::Expert);
  list.flag("limit", settings.limit, "Move the vertices to where they would end after endless refinement.")
      .titled("On the final surface")
      .at(ParameterPlace::Expert);
  list.flag("provenance", settings.provenance,
            "Attach to faces and vertices which element of the cage they come from; doo-sabin only.")
      .at(ParameterPlace::Nowhere);
}

void append(Findings& all, const Findings& more) { all.insert(all.end(), more.begin(), more.end()); }

/// The cage with all the tags that count.
PolyMesh fully_tagged_cage(const Values& inputs, const SubdivideSettings& settings, Findings& warnings) {
  PolyMesh mesh = *tagged_cage(inputs, warnings);
  if (settings.sharp_angle > 0) mesh.tags = with_sharp_angles(mesh, settings.sharp_angle, settings.plan.rules);
  if (settings.keep_kinks < std::numbers::pi) mesh = pin_kinks(mesh, settings.keep_kinks);
  return mesh;
}

/// Channels of earlier refinements, and normals: they are computed again.
bool is_computed(const AttributeChannel& channel) {
  return channel.name == settled_channel || channel.name == "normal" || channel.name.starts_with("cage_");
}

/// What the cage has besides faces and tags doesn't go on into finer levels.
void warn_of_losses(const PolyMesh& mesh, Findings& warnings) {
  std::string names;
  for (const AttributeChannel& channel : mesh.channels) {
    if (is_computed(channel)) continue;
    names += (names.empty() ? "'" : ", '") + channel.name + "'";
  }
  if (mesh.line_count() > 0) names += std::string(names.empty() ? "" : ", ") + "polylines";
  if (names.empty()) return;
  warnings.push_back(make_warning(Category::Geometry, "W_CHANNELS",
                                  "Subdivision carries shape and tags alone; left out: " + names + "."));
}

/// How far the chords of drawn curves may lie from them, × the cage's extent: less than a pixel on any screen.
constexpr double curve_tolerance = 1e-5;

/// The diagonal of the bounding box; 1 for a single point.
double extent(const std::vector<Vec3>& positions) {
  Eigen::AlignedBox3d box;
  for (const Vec3& position : positions) box.extend(position);
  const double diagonal = positions.empty() ? 0 : box.diagonal().norm();
  return diagonal > 0 ? diagonal : 1;
}

/// All steps from a cage to a mesh.
class Subdivision {
 public:
  Subdivision(Cage cage, const SubdivideSettings& settings, Context& context)
      : cage_(std::move(cage)), settings_(settings), context_(context) {
    // The limit of a level is read off the next one.
    if (reads_next_level()) ++settings_.plan.levels;
    hash_ = plan_hash(cage_, settings_.plan);
  }

  void compute(Progress& progress) {
    Progress planning = progress.step("plan", 0.6);
    plan_ = plan_of(cage_, settings_.plan, hash_, context_.memo, planning);
    compute_positions(*plan_, cage_, buffers_, context_.threads);
    progress.report(0.8);
    connect_mesh();
    if (settings_.limit) move_to_limit(progress);
  }

  const SubdivisionPlan& plan() const { return *plan_; }
  int last() const { return reads_next_level() ? settings_.plan.levels - 1 : settings_.plan.levels; }
  const Level& level() const { return level_of(*plan_, last()); }
  std::span<const Vec3> positions() const { return buffers_.levels[static_cast<std::size_t>(last())]; }

  ContinuityReport continuity(Progress& progress) const {
    return std::visit([&](const auto& plan) { return continuity_report(plan, buffers_, progress); }, *plan_);
  }

  std::vector<std::vector<CageEdge>> origins_of(std::span<const EdgeChain> chains) const {
    return chain_origins(*plan_, last(), chains, cage_);
  }

  const MeshTags& tags() const { return mesh_.tags; }

  /// The result. Takes the last level's positions along: large arrays that are new cost more than what is in them.
  PolyMesh take_mesh() {
    if (!settings_.limit) mesh_.positions = std::move(buffers_.levels[static_cast<std::size_t>(last())]);
    return std::move(mesh_);
  }

  /// The limit curves of all chains.
  PolyMesh curves() const {
    const auto* doo_sabin = std::get_if<DooSabinPlan>(plan_.get());
    const auto curves = doo_sabin != nullptr ? limit_curves(*doo_sabin, buffers_, settings_.plan.rules)
                                             : limit_curves(std::get<UniformPlan>(*plan_), buffers_);
    return curve_lines(curves, curve_tolerance * extent(cage_.positions));
  }

 private:
  bool reads_next_level() const { return settings_.limit && settings_.plan.scheme == SubdivisionScheme::DooSabin; }

  /// All of the mesh but its positions, which the memo keeps while points are dragged.
  void connect_mesh();
  PolyMesh unplaced_mesh() const;

  void move_to_limit(Progress& progress);

  Cage cage_;
  SubdivideSettings settings_;
  Context& context_;
  ContentHash hash_;
  std::shared_ptr<const SubdivisionPlan> plan_;
  PositionBuffers buffers_;
  PolyMesh mesh_;
};

PolyMesh Subdivision::unplaced_mesh() const {
  const auto level_mesh = [this](const auto& plan) {
    const bool with_provenance = settings_.provenance && last() > 0;
    return with_provenance ? to_mesh(plan, last(), positions()) : to_mesh(plan.level(last()), positions());
  };
  PolyMesh mesh = std::visit(level_mesh, *plan_);
  std::vector<Vec3>().swap(mesh.positions);
  return mesh;
}

void Subdivision::connect_mesh() {
  if (context_.memo == nullptr) {
    mesh_ = unplaced_mesh();
    return;
  }
  ContentHasher hasher;
  hasher.add("subdivide/mesh/1");
  hasher.add(hash_);
  hasher.add(last());
  hasher.add(settings_.provenance);
  const auto bytes = [](const PolyMesh& mesh) { return byte_size(std::make_shared<const PolyMesh>(mesh)); };
  mesh_ = *context_.memo->get<PolyMesh>(
      hasher.digest(), [this] { return unplaced_mesh(); }, bytes);
}

void Subdivision::move_to_limit(Progress& progress) {
  Progress step = progress.step("limit", 0.2);
  ContentHasher hasher;
  hasher.add("subdivide/limit/1");
  hasher.add(hash_);
  const auto make = [&] { return std::visit([&](const auto& plan) { return LimitPlan(plan, last(), step); }, *plan_); };
  const std::size_t bytes = 16 * sizeof(double) * positions().size();
  const auto limit = memoized<LimitPlan>(context_.memo, hasher.digest(), make, [&](const LimitPlan&) { return bytes; });
  LimitSurface surface;
  limit->evaluate(buffers_, surface, context_.threads);
  mesh_.positions = std::move(surface.points);
  std::vector<double> normals;
  normals.reserve(3 * surface.corner_normals.size());
  for (const Vec3& normal : surface.corner_normals) normals.insert(normals.end(), normal.begin(), normal.end());
  mesh_.channels.push_back({"normal", Domain::Corner, 3, std::move(normals), {}});
}

/// Of the chains nothing in drafts: only the mesh counts while something is dragged.
SubdivideResult result_of_subdividing(const Subdivision& subdivision, const SubdivideSettings& settings,
                                      Quality quality, Progress& progress) {
  SubdivideResult result;
  result.scheme = settings.plan.scheme;
  result.levels = level_counts(subdivision.plan(), subdivision.last());
  if (quality == Quality::Draft) return result;
  const Level& level = subdivision.level();
  const std::vector<EdgeChain> chains = edge_chains(level);
  result.chains = sharp_chains(level, chains, subdivision.positions(), subdivision.origins_of(chains));
  const ContinuityReport continuity = subdivision.continuity(progress);
  result.continuity = continuity_angles(continuity, subdivision.last());
  result.verdict = continuity.sentence;
  result.judged = true;
  return result;
}

OperationResult compute_subdivide(const Values& inputs, SubdivideSettings settings, Context& context) {
  OperationResult result;
  Progress checking = context.progress.step("check", 0.1);
  const PolyMesh mesh = fully_tagged_cage(inputs, settings, result.warnings);
  const bool doo_sabin = settings.plan.scheme == SubdivisionScheme::DooSabin;
  CageResult made = make_cage(mesh, settings.plan.rules, doo_sabin ? CageUse::DooSabin : CageUse::UniformSchemes);
  append(result.warnings, made.warnings);
  warn_of_losses(mesh, result.warnings);
  checking.report(1);

  Progress refining = context.progress.step("refine", 0.8);
  Subdivision subdivision(std::move(made.cage), settings, context);
  subdivision.compute(refining);
  append(result.warnings, warnings_of(subdivision.plan()));

  Progress judging = context.progress.step("judge", 0.1);
  SubdivideResult details = result_of_subdividing(subdivision, settings, context.quality, judging);
  result.outputs["details"] = std::make_shared<const Report>(to_report(details));
  result.details = std::move(details);
  result.outputs["chains"] = std::make_shared<const PolyMesh>(subdivision.curves());
  result.outputs["tags-out"] = std::make_shared<const Report>(report_of(subdivision.tags()));
  result.outputs["mesh"] = std::make_shared<const PolyMesh>(subdivision.take_mesh());
  context.progress.report(1);
  return result;
}

}  // namespace

std::unique_ptr<const Operation> subdivide_operation() {
  return operation_of(
      {"subdivide",
       1,
       "Subdivide",
       "Refines a cage of polygons into a smooth mesh; tagged edges stay sharp, in chains that are curves.",
       {{"cage", ValueType::Mesh, "Polygons of any number of corners, closed or open, with their tags."}, tags_input()},
       {{"mesh", ValueType::Mesh, "The last level, with the tags that are left."},
        {"chains", ValueType::Mesh, "The curves to which the chains of sharp edges tend, as polylines."},
        {"tags-out", ValueType::Report, "The tags that are left (croquis-tags-1)."},
        {"details", ValueType::Report, "Counts of every level, chains, and how smooth the levels are."}}},
      list_subdivide_parameters, compute_subdivide);
}

}  // namespace croquis
