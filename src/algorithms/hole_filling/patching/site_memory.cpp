// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/hole_filling/patching/site_memory.h"

namespace croquis::hole_filling {

SiteMemory* SiteMemory::of(const HoleSite& site) {
  SiteMemory* memory = site.memory;
  if (memory != nullptr && memory->blocked_ != site.polygon.blocked) {
    *memory = {};
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

}  // namespace croquis::hole_filling
