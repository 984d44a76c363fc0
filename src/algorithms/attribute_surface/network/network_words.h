// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "croquis/base/finding.h"
#include "croquis/geometry/attribute_network.h"

/// How findings about a network spell what they are about.
namespace croquis {

std::string quoted(const std::string& id);

/// With four digits, for sentences.
std::string rounded_text(double number);

/// With units where the network has some.
std::string length_text(const AttributeNetwork& network, double length);

Subject subject_of(SubjectKind kind, const std::string& id);

}  // namespace croquis
