// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <functional>
#include <map>
#include <string>
#include <utility>

namespace croquis::app {

/// What `expect` looks at, by the names of the recordings' vocabulary. Each takes the node named, empty for the object
/// worked on, and throws Error (E_REPLAY) when there is nothing to count or measure.
struct Expectations {
  std::map<std::string, std::function<std::size_t(const std::string& node)>> counts;
  /// The smallest and the greatest.
  std::map<std::string, std::function<std::pair<double, double>(const std::string& node)>> ranges;

  /// Those of the other one count where both have a name.
  void add(Expectations other);
};

class MainWindow;

/// Those of the window and its tools: one for every name in recorded::all_steps().
Expectations expectations_of(MainWindow& window);

}  // namespace croquis::app
