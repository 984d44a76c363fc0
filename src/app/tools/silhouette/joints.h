// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "croquis/document/evaluation.h"
#include "croquis/geometry/vector.h"

namespace croquis::app {

/// A limb and a body that may be attached.
struct Joint {
  std::string a;  ///< names of objects
  std::string b;
  Vec2 at = Vec2::Zero();  ///< sketch units
  bool attached = false;
};

/// What the solid suggests, with whether the operation's parameter holds it already. @param attach its text
std::vector<Joint> suggested_joints(const Evaluation& evaluation, const std::string& attach);

/// The parameter's text with the pair added, or taken out when it is there.
std::string toggled_joint(const std::string& attach, const Joint& joint);

}  // namespace croquis::app
