// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <string_view>

namespace croquis {

/// Keeps the results of stages from one run to the next, so that a changed weight or a dragged point makes only what
/// depends on it again. Hosts implement it over their own memory; results are the same with any cache and without.
class StageCache {
 public:
  struct Stage {
    std::shared_ptr<const void> result;
    std::size_t bytes = 0;  ///< about what it takes
  };

  virtual ~StageCache() = default;

  /// The result of that stage made from that content, or what make returns. What make throws is passed on.
  /// @param stage   names the stage and the type of its result
  /// @param content all that the result depends on, byte by byte
  virtual std::shared_ptr<const void> get(std::string_view stage, std::string_view content,
                                          const std::function<Stage()>& make) = 0;
};

}  // namespace croquis
