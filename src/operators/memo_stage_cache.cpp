// SPDX-License-Identifier: GPL-3.0-or-later
#include "operators/memo_stage_cache.h"

namespace croquis {

std::shared_ptr<const void> MemoStageCache::get(std::string_view stage, std::string_view content,
                                                const std::function<Stage()>& make) {
  ContentHasher hasher;
  hasher.add(stage);
  hasher.add(content);
  const auto kept = memo_->get<Stage>(hasher.digest(), make, [](const Stage& made) { return made.bytes; });
  return kept->result;
}

}  // namespace croquis
