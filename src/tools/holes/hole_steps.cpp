// SPDX-License-Identifier: GPL-3.0-or-later
#include "croquis/tools/holes/hole_steps.h"

#include <cmath>

namespace croquis::recorded {

void HoleChoice::describe(Fields& fields) {
  static const Words actions = {"select", "add", "remove", "toggle", "fill", "leave"};
  const bool by_width = fields.reads() ? fields.has("up-to") : up_to.has_value();
  if (by_width) {
    fields.required("action", action, Words{"fill"});
    fields.required("up-to", up_to);
    fields.require(*up_to > 0, "\"up-to\" must be greater than 0");
  } else {
    if (fields.reads() && fields.has("hole")) {
      fields.required("hole", holes.emplace_back());
    } else {
      fields.required("holes", holes);
    }
    fields.given("action", action, actions);
    fields.require(!holes.empty() || action == "select", "\"holes\" must name a hole for \"" + action + "\"");
  }
  fields.seldom("node", node);
}

void HoleWay::describe(Fields& fields) {
  fields.given("holes", holes);
  fields.seldom("fairness", fairness, Words{"auto", "rbf", "smooth", "flat"});
  fields.seldom("kernel", kernel);
  fields.seldom("bulge", bulge);
  fields.seldom("trim-rim", trim_rim);
  fields.require(!bulge || std::abs(*bulge) <= 1, "\"bulge\" must be from -1 to 1");
  fields.require(fairness || kernel || bulge || trim_rim,
                 "\"fairness\", \"kernel\", \"bulge\" or \"trim-rim\" is missing");
  fields.seldom("node", node);
}

void HolePoint::describe(Fields& fields) {
  fields.required("hole", hole);
  fields.seldom("from", from);
  fields.seldom("to", to);
  fields.seldom("node", node);
  fields.require(from || to, "\"from\", \"to\" or both are missing");
}

const Vocabulary& hole_steps() {
  static const Vocabulary vocabulary = vocabulary_of<HoleChoice, HoleWay, HolePoint>({"holes", "patches"});
  return vocabulary;
}

}  // namespace croquis::recorded
