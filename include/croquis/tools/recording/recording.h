// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "croquis/tools/recording/vocabulary.h"

/// What a user did, as lines of JSON that a window replays (docs/replays.md): places are sketch coordinates, views and
/// actions have names, so a recording outlives every change of the window's layout.
///
/// The vocabulary is open: a step is a small struct of its tool, with its reader and writer beside it.
namespace croquis::recorded {

struct Line {
  Step step;
  std::int64_t number = 0;  ///< 1-based, in its file
};

/// Reads a recording; empty lines and lines that begin with # are passed over.
/// @param name of the file, for findings
/// @throws Error with an E_REPLAY finding for every line that can't be understood
std::vector<Line> parse(std::string_view text, const std::string& name, const Vocabulary& vocabulary);

/// One line without its end; parse gives the same step back. Numbers are written so that they read back exactly.
std::string to_line(const Step& step);

/// Hands over each step's line, with its end, as the user works.
class Recorder {
 public:
  explicit Recorder(std::function<void(const std::string& line)> sink) : sink_(std::move(sink)) {}
  void add(const Step& step) { sink_(to_line(step) + '\n'); }

 private:
  std::function<void(const std::string& line)> sink_;
};

}  // namespace croquis::recorded
