// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <optional>
#include <string>
#include <vector>

#include "app/tools/surface/shown_surface.h"
#include "croquis/attribute_surface/loop_search.h"

namespace croquis::app {

/// How far a network is, in one sentence.
struct NetworkState {
  QString sentence;
  bool sound = false;        ///< all that is there could be made
  NetworkElements elements;  ///< that the sentence is about
};
NetworkState network_state(const AttributeNetwork& network, const ShownSurface& shown, const Findings& findings);

/// What the selected curves lack to be a loop.
struct LoopState {
  bool closed = false;
  std::optional<Vec3> gap;  ///< the middle of the only gap, in the network's own space
  QString sentence;         ///< what is missing; empty when it is closed
  Vec3 middle = Vec3::Zero();
};

/// @param curves selected. @return none where they aren't meant as a loop: fewer than two, or one that has a face
std::optional<LoopState> loop_state(const AttributeNetwork& network, const std::vector<std::string>& curves);

/// The elements of a network that a finding is about.
NetworkElements elements_in(const Finding& finding, const AttributeNetwork& network);

}  // namespace croquis::app
