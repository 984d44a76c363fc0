// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/hole_filling/patching/site_memory.h"

namespace croquis::hole_filling {

SiteMemory* SiteMemory::of(const HoleSite& site) {
  SiteMemory* memory = site.memory;
  if (memory != nullptr && memory->blocked_ != site.polygon.blocked) {
    const std::optional<double> crease_cosine = memory->crease_cosine;
    *memory = {};
    memory->crease_cosine = crease_cosine;
    memory->blocked_ = site.polygon.blocked;
  }
  return memory;
}

std::optional<HolePatch> made_once(const HoleSite& site, const std::string& method,
                                   const std::function<std::optional<HolePatch>()>& make) {
  SiteMemory* memory = SiteMemory::of(site);
  if (memory == nullptr) return make();
  const auto known = memory->patches.find(method);
  return known != memory->patches.end() ? known->second : memory->patches[method] = make();
}

std::optional<RimField> fitted_once(const HoleSite& site, const ImplicitOptions& options, const RimFitOptions& how) {
  SiteMemory* memory = SiteMemory::of(site);
  if (memory == nullptr || !how.guides.empty()) return fit_rims(site, options, how);
  const bool is_full = how.every_normal || !continues_curvature(site, options);  // few normals count by r^5 alone
  const SiteMemory::Smoothness smoothness = {how.stiffness, how.other_sheets, is_full};
  const auto known = memory->fields.find(smoothness);
  return known != memory->fields.end() ? known->second : memory->fields[smoothness] = fit_rims(site, options, how);
}

}  // namespace croquis::hole_filling
