// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <functional>
#include <map>
#include <string>
#include <utility>

namespace croquis::app {

class MainWindow;

/// What `expect` looks at, by the names of the recordings' vocabulary. Each takes the node named, empty for the object
/// worked on, and throws Error (E_REPLAY) when there is nothing to count or measure.
struct Expectations {
  std::map<std::string, std::function<std::size_t(MainWindow&, const std::string& node)>> counts;
  /// The smallest and the greatest.
  std::map<std::string, std::function<std::pair<double, double>(MainWindow&, const std::string& node)>> ranges;
};

/// Those of this window: one for every name in recorded::all_steps().
const Expectations& expectations();

}  // namespace croquis::app
