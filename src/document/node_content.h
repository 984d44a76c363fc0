// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "croquis/base/parameter.h"
#include "croquis/document/content_hash.h"

namespace croquis {

/// Names, types and values of all of them.
void add_content(ContentHasher& hasher, const ParameterValues& parameters);

void add_content(ContentHasher& hasher, const Affine3& transform);

}  // namespace croquis
