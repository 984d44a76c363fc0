// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>

#include "croquis/base/finding.h"
#include "croquis/document/document.h"
#include "croquis/document/value.h"

/// About how much memory contents take: what byte caps count by. Allocators' own overhead is left out.
namespace croquis {

std::size_t byte_size(const Value& value);
std::size_t byte_size(const Values& values);
std::size_t byte_size(const Findings& findings);

/// Without its source's value and its backdrop's picture, which nodes may share.
std::size_t byte_size(const Node& node);

}  // namespace croquis
