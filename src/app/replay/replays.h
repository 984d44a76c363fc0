// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <functional>
#include <map>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "app/studio/studio.h"
#include "croquis/tools/pointer/pointer_event.h"
#include "croquis/tools/recording/step.h"

namespace croquis::app {

/// What replays do and look at: the window's part, and that of each tool.
struct Replays {
  /// Does a recorded step. @return false: it is another tool's. @throws Error (E_REPLAY, E_INPUT …)
  using Play = std::function<bool(const recorded::Step& step)>;
  /// Of the node named, empty for the object worked on. @throws Error (E_REPLAY) when there is nothing to count
  using Count = std::function<std::size_t(const std::string& node)>;
  /// The smallest and the greatest. @throws Error (E_REPLAY) when there is nothing to measure
  using Range = std::function<std::pair<double, double>(const std::string& node)>;

  std::map<const recorded::StepKind*, std::vector<Play>> plays;  ///< tried in their order
  std::map<std::string, Count> counts;  ///< by the names of the recordings' vocabulary; tools replace the window's
  std::map<std::string, Range> ranges;

  /// Steps of that struct. @param does takes one, and may return whether it was its own
  template <recorded::StepValue T, class Does>
  void on(Does does) {
    plays[&recorded::step_kind<T>()].push_back([does = std::move(does)](const recorded::Step& step) {
      if constexpr (std::is_same_v<decltype(does(*step.as<T>())), bool>) {
        return does(*step.as<T>());
      } else {
        does(*step.as<T>());
        return true;
      }
    });
  }

  /// The same of several structs.
  template <recorded::StepValue... T, class Does>
  void on_each(const Does& does) {
    (on<T>(does), ...);
  }
};

class MainWindow;

/// Those of the window and its tools: something for every name in recorded::all_steps().
Replays replays_of(MainWindow& window);

// What the names in recordings stand for.

/// @throws Error (E_REPLAY)
[[noreturn]] void refuse_replay(const std::string& sentence);

Modifiers modifiers_of(const std::vector<std::string>& names);

/// The view of that name: "sketch" or none, "front", "perspective", "top", "side", "comparison".
/// @throws Error (E_REPLAY) for others
int view_of(const std::string& name);

/// The object of that name, or one of whose nodes has it; the active one when the name is empty.
/// @throws Error (E_REPLAY) when there is none, or it shows no mesh
const WorkObject& object_named(const Studio& studio, const std::string& name);

/// The node of that name or operation, a step of a chain too. @throws Error (E_REPLAY)
NodeId node_named(const Studio& studio, const std::string& name);

}  // namespace croquis::app
