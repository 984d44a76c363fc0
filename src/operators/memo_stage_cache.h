// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "croquis/base/stage_cache.h"
#include "croquis/document/memo.h"

namespace croquis {

/// Keeps the stages of silhouettes in the memo of an evaluation.
class MemoStageCache final : public StageCache {
 public:
  /// @param memo must outlive the cache when it is used
  explicit MemoStageCache(Memo* memo) : memo_(memo) {}

  std::shared_ptr<const void> get(std::string_view stage, std::string_view content,
                                  const std::function<Stage()>& make) override;

 private:
  Memo* memo_;
};

}  // namespace croquis
