// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "croquis/document/document.h"

namespace croquis {

/// A name as people would write it: "Hex bolt" for "hex_bolt", the stem of a file. Others are as they are.
std::string readable_name(const std::string& name);

/// A name that no node has yet: the wanted one, or with a number behind.
std::string free_name(const Document& document, const std::string& wanted);

}  // namespace croquis
