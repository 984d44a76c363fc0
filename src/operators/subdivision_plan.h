// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <tuple>
#include <variant>

#include "croquis/base/members.h"
#include "croquis/base/progress.h"
#include "croquis/document/content_hash.h"
#include "croquis/document/memo.h"
#include "croquis/operators/subdivide_result.h"
#include "croquis/subdivision/cage.h"
#include "croquis/subdivision/doo_sabin.h"
#include "croquis/subdivision/uniform_schemes.h"

namespace croquis {

/// What decides, with the cage, how it is refined.
struct PlanSettings {
  SubdivisionScheme scheme = SubdivisionScheme::DooSabin;
  subdivision::Rules rules;
  int levels = 2;
};
constexpr auto members(const PlanSettings& settings) {
  return std::tie(settings.scheme, settings.rules, settings.levels);
}
static_assert(lists_every_member<PlanSettings>);

/// What doesn't depend on positions, of any scheme.
using SubdivisionPlan = std::variant<subdivision::DooSabinPlan, subdivision::UniformPlan>;

/// Of all that a plan of the cage depends on: connectivity, tags, scheme, rules and levels; positions aren't among it.
ContentHash plan_hash(const subdivision::Cage& cage, const PlanSettings& settings);

/// The plan of that hash, kept by the memo (may be null): dragging points of the cage doesn't make it again.
std::shared_ptr<const SubdivisionPlan> plan_of(const subdivision::Cage& cage, const PlanSettings& settings,
                                               const ContentHash& hash, Memo* memo, Progress& progress);

int level_count(const SubdivisionPlan& plan);
const subdivision::Level& level_of(const SubdivisionPlan& plan, int k);
const Findings& warnings_of(const SubdivisionPlan& plan);
void compute_positions(const SubdivisionPlan& plan, const subdivision::Cage& cage,
                       subdivision::PositionBuffers& buffers, int threads);

}  // namespace croquis
