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

/// A pen or mouse stroke; what it does depends on the tool's mode, as in the window.
struct StrokeDrawn {
  std::string view = "sketch";
  std::vector<StrokeSample> points;  ///< at least one; tilt isn't recorded
  std::string device = "mouse";      ///< "mouse", "pen" or "eraser"
  double scale = 0;                  ///< units per pixel of the view drawn in; 0 for the replaying view's own
};
/// Instead of a place in a view: a place of the model, seen in the view named.
using ModelPlace = std::optional<Vec3>;

/// An anchor of a stroke, or without one the whole stroke, was dragged.
struct Drag {
  std::string stroke;
  std::optional<std::size_t> anchor;  ///< 0-based
  Vec2 by = Vec2::Zero();
};
/// The pointer was dragged between two places of the model as a view shows them: a manipulator's handle, a sharpness.
struct ModelDrag {
  std::string view = "perspective";
  Vec3 from = Vec3::Zero();
  Vec3 to = Vec3::Zero();
  std::vector<std::string> modifiers;
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
  ModelPlace place = {};               ///< instead of `at`
  int clicks = 1;                      ///< 2: a double click
};
struct Box {
  std::string view = "sketch";
  Vec2 from = Vec2::Zero();
  Vec2 to = Vec2::Zero();
  std::vector<std::string> modifiers;
  ModelPlace from_place = {};  ///< both places or none; instead of `from` …
  ModelPlace to_place = {};    ///< … and `to`
};
struct Navigate {
  std::string view = "perspective";
  std::string motion;      ///< "tumble", "track" or "dolly"
  Vec2 by = Vec2::Zero();  ///< pixels of a view 1000 pixels high, y down; of a dolly only x and y's sum matters
};

// ---- Meshes: by the name of the source node, elements by their numbers (edges: MeshTopology's)

struct Pick {
  std::string node;
  std::string kind = "edge";  ///< "vertex", "edge" or "face"
  std::vector<Index> elements;
  std::string how =
      "replace";  ///< "replace", "add", "remove", "toggle", "loop", "ring", "path", "connected", "chain", "all"
};
/// What is selected was moved, turned or scaled.
struct Move {
  std::string node;
  Vec3 by = Vec3::Zero();
};
struct Rotate {
  std::string node;
  Vec3 axis = Vec3::UnitZ();  ///< not zero
  double degrees = 0;
  ModelPlace pivot = {};  ///< without it the middle of what is selected
};
struct Scale {
  std::string node;
  Vec3 factors = {1, 1, 1};
  ModelPlace pivot = {};
};
/// Edges got a sharpness, or theirs changed.
struct Tag {
  std::string node;
  std::string edges = "selected";   ///< "selected", "boundary", "tagged" or "sharper-than"
  double degrees = 0;               ///< of "sharper-than"
  std::optional<double> sharpness;  ///< this or …
  std::optional<double> change;     ///< … that; of the selected edges
};
struct Pin {
  std::string node;
  bool pinned = true;
};
/// A named set of tags.
struct TagSet {
  std::string node;
  std::string how = "make";  ///< "make", "rename", "sharpness", "select", "merge", "remove" or "untag"
  std::string name;
  std::string other;                ///< rename: the new name; merge: the set that is taken in
  std::optional<double> sharpness;  ///< make, sharpness
};
struct Extrude {
  std::string node;
  Vec3 by = Vec3::Zero();
};
struct LoopCut {
  std::string node;
  Index edge = 0;
  double at = 0.5;
};

/// Faces were selected by the names of their sets.
struct FaceSetChoice {
  std::string node;                ///< the object's name
  std::vector<std::string> names;  ///< "patches", "patch of hole 3" …
};

// ---- Holes of a scan, by the numbers that the operation's report gives them

/// Holes were selected, or are to be filled or left open.
struct HoleChoice {
  std::vector<Index> holes;          ///< none: only for "select", which then selects nothing, and with `up_to`
  std::string action = "select";     ///< "select" (instead of others), "add", "remove", "toggle", "fill" or "leave"
  std::string node = {};             ///< the operation that fills them; empty for that of the object worked on
  std::optional<double> up_to = {};  ///< of "fill" instead of holes: all inner ones up to that width, no others
};
/// Patches are to be made in another way; what isn't there stays as it was.
struct HoleWay {
  std::vector<Index> holes;                   ///< none: of all holes for which nothing else was said
  std::optional<std::string> fairness = {};   ///< "rbf", "smooth" or "flat"
  std::optional<std::string> kernel = {};     ///< as the operation names them
  std::optional<double> bulge = {};           ///< -1..1
  std::optional<std::int64_t> trim_rim = {};  ///< rings of faces
  std::string node = {};                      ///< as above
};
/// A place that a patch goes through was moved, made or taken away; see moved_through.
struct HolePoint {
  Index hole = 0;
  ModelPlace from = {};   ///< where it was; when the patch goes through no such place, a new one is made
  ModelPlace to = {};     ///< where it is now; none: it is taken away. One of both is there
  std::string node = {};  ///< as above
};

/// Fails the replay when it isn't so.
struct Expect {
  /// "objects", "findings", "strokes", "faces", "vertices", "edges", "sharp-edges", "selected" or "dihedral"
  std::string what;
  std::int64_t count = 0;
  std::optional<double> value = {};  ///< of "dihedral" instead of a count: degrees, of every edge of the shown chains …
  std::optional<double> to = {};  ///< … or the greatest of them, if `value` is to be the smallest; both within 1e-3
  std::string node = {};          ///< whose result is counted; empty for the object worked on
};

using Step = std::variant<StrokeDrawn, Drag, Action, Set, Wait, Screenshot, File, Click, Box, Navigate, Expect,
                          ModelDrag, Pick, Move, Rotate, Scale, Tag, Pin, TagSet, Extrude, LoopCut, FaceSetChoice,
                          HoleChoice, HoleWay, HolePoint>;

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
