// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <utility>

#include "croquis/base/stage_cache.h"

namespace croquis::test {

/// Ends the run when a stage is asked for and has its key; stages before it are made.
class KeyRecorder final : public StageCache {
 public:
  struct Reached {
    std::string key;
  };

  explicit KeyRecorder(std::string stage) : stage_(std::move(stage)) {}

  std::shared_ptr<const void> get(std::string_view stage, std::string_view content,
                                  const std::function<Stage()>& make) override {
    if (stage == stage_) throw Reached{std::string(content)};
    return make().result;
  }

 private:
  std::string stage_;
};

/// The key under which the run asks for the stage; empty when it doesn't.
/// @param run is given a StageCache*
template <typename Run>
std::string stage_key(const std::string& stage, Run&& run) {
  KeyRecorder recorder(stage);
  try {
    run(static_cast<StageCache*>(&recorder));
  } catch (const KeyRecorder::Reached& reached) {
    return reached.key;
  }
  return "";
}

}  // namespace croquis::test
