// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>

#include "croquis/attribute_surface/network_elements.h"
#include "croquis/base/finding.h"
#include "croquis/tools/recording/step.h"

namespace croquis {

/// What a step makes of a network.
struct NetworkEdit {
  AttributeNetwork network;
  std::string label;              ///< of the undo step: "Draw curve c3"; empty where nothing becomes of it
  std::optional<Findings> notes;  ///< worth knowing, of steps that can have any
};

/// What a step of surface_steps() does; nothing for one that changes no network.
/// @throws Error (E_INPUT …) for elements that aren't there, and values that can't be
std::optional<NetworkEdit> edited_by(const AttributeNetwork& network, const recorded::Step& step);

NetworkElements one_element(NetworkElement kind, const std::string& id);

}  // namespace croquis
