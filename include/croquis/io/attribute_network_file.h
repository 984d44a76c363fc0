// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>

#include "croquis/base/finding.h"
#include "croquis/geometry/attribute_network.h"

/// Attribute networks as JSON in the format croquis-abs/1:
///
///     {"format": "croquis-abs/1", "name": TEXT, "units": TEXT, "tolerance": NUMBER,
///      "nodes": [{"id": TEXT, "p": [X, Y, Z]}],
///      "curves": [{"id": TEXT, "from": NODE, "to": NODE, "ctrl": [[X, Y, Z] …], "join": "crease" or "smooth"}],
///      "faces": [{"id": TEXT, "loop": ["+CURVE", "-CURVE" …], "mode": "smooth", "position" or "paper",
///                 "fullness": NUMBER, "domain": "chordlength" or "uniform",
///                 "inner": [{"curve": CURVE, "profile": "smooth" or "sharp", "radius": NUMBER}]}],
///      "points": [{"id": TEXT, "face": FACE, "p": [X, Y, Z], "fan": [CORNER, A, B], "radius": NUMBER,
///                  "profile": "smooth" or "cone", "normal": [X, Y, Z]}],
///      "slopes": [{"curve": CURVE, "face": FACE, "at": [S …], "normal": [[X, Y, Z] …], "magnitude": NUMBER}]}
///
/// All but `format`, ids, loops, places and what a slope is about may be absent; "-" before a curve's id: it is walked
/// along backwards.
namespace croquis {

/// The file: numbers read back exactly, members with their default are left out where nothing is lost.
std::string write_attribute_network(const AttributeNetwork& network);

struct AttributeNetworkReadResult {
  AttributeNetwork network;
  Findings warnings;  ///< W_IGNORED, for each name of a member that the format doesn't have
};

/// Reads a file that may come from anybody.
/// @param file_name for findings
/// @throws Error Malformed, all findings together (at most 100), each naming its element (such as curve "c3"):
///         E_EMPTY and E_SYNTAX for what isn't of this format, E_NOT_FINITE, E_DUP_ID, E_DUP_CURVE, E_NO_NODE,
///         E_NO_CURVE, E_NO_FACE as croquis::validate has them
AttributeNetworkReadResult read_attribute_network(std::string_view bytes, const std::string& file_name);

}  // namespace croquis
