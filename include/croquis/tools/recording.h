// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "croquis/base/parameter.h"
#include "croquis/geometry/drawing.h"

/// What a user did, as lines of JSON that a window replays (docs/replays.md): places are sketch coordinates, views and
/// actions have names, so a recording outlives every change of the window's layout.
namespace croquis::recorded {

/// A pen or mouse stroke; what it does depends on the tool's mode, as under the hand.
struct StrokeDrawn {
  std::string view = "sketch";
  std::vector<StrokeSample> points;  ///< at least one; tilt isn't recorded
  std::string device = "mouse";      ///< "mouse", "pen" or "eraser"
  double scale = 0;                  ///< units per pixel of the view drawn in; 0 for the replaying view's own
};
/// An anchor of a stroke, or without one the whole stroke, was dragged.
struct Drag {
  std::string stroke;
  std::optional<std::size_t> anchor;  ///< 0-based
  Vec2 by = Vec2::Zero();
};
/// A named action of the window ("undo", "draw", "frame-all").
struct Action {
  std::string name;
};
struct Set {
  std::string node;  ///< its name
  std::string parameter;
  ParameterValue value;
};
/// Waits until something is finished.
struct Wait {
  std::string what = "solid";
};
struct Screenshot {
  std::string file;
};
struct File {
  std::string verb;  ///< "save", "open" or "export"
  std::string file;
};
struct Click {
  std::string view = "sketch";
  Vec2 at = Vec2::Zero();
  std::vector<std::string> modifiers;  ///< of "shift", "ctrl", "alt", "super"
};
struct Box {
  std::string view = "sketch";
  Vec2 from = Vec2::Zero();
  Vec2 to = Vec2::Zero();
  std::vector<std::string> modifiers;
};
struct Navigate {
  std::string view = "perspective";
  std::string motion;      ///< "tumble", "track" or "dolly"
  Vec2 by = Vec2::Zero();  ///< pixels of a view 1000 pixels high, y down; of a dolly only x and y's sum matters
};
/// Fails the replay when it isn't so.
struct Expect {
  std::string what;  ///< "objects", "findings" or "strokes"
  std::int64_t count = 0;
};

using Step = std::variant<StrokeDrawn, Drag, Action, Set, Wait, Screenshot, File, Click, Box, Navigate, Expect>;

struct Line {
  Step step;
  std::int64_t number = 0;  ///< 1-based, in its file
};

/// Reads a recording; empty lines and lines that begin with # are passed over.
/// @param name of the file, for findings
/// @throws Error with an E_REPLAY finding for every line that can't be understood
std::vector<Line> parse(std::string_view text, const std::string& name);

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
