// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "croquis/tools/recording/vocabulary.h"

/// Steps on holes of a scan, by the numbers that the operation's report gives them.
namespace croquis::recorded {

/// Holes were selected, or are to be filled or left open.
struct HoleChoice {
  std::vector<Index> holes;          ///< none: only for "select", which then selects nothing, and with `up_to`
  std::string action = "select";     ///< "select" (instead of others), "add", "remove", "toggle", "fill" or "leave"
  std::string node = {};             ///< the operation that fills them; empty for that of the object worked on
  std::optional<double> up_to = {};  ///< of "fill" instead of holes: all inner ones up to that width, no others

  static constexpr std::array verbs{"hole"};
  void describe(Fields& fields);
};
/// Patches are to be made in another way; what isn't there stays as it was.
struct HoleWay {
  std::vector<Index> holes = {};              ///< none: of all holes for which nothing else was said
  std::optional<std::string> fairness = {};   ///< "rbf", "smooth" or "flat"
  std::optional<std::string> kernel = {};     ///< as the operation names them
  std::optional<double> bulge = {};           ///< -1..1
  std::optional<std::int64_t> trim_rim = {};  ///< rings of faces
  std::string node = {};                      ///< as above

  static constexpr std::array verbs{"hole-way"};
  void describe(Fields& fields);
};
/// A place that a patch goes through was moved, made or taken away; see moved_through.
struct HolePoint {
  Index hole = 0;
  ModelPlace from = {};   ///< where it was; when the patch goes through no such place, a new one is made
  ModelPlace to = {};     ///< where it is now; none: it is taken away. One of both is there
  std::string node = {};  ///< as above

  static constexpr std::array verbs{"hole-point"};
  void describe(Fields& fields);
};

/// All of them, and the counts of holes and patches.
const Vocabulary& hole_steps();

}  // namespace croquis::recorded
