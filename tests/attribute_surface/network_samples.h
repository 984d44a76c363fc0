// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "croquis/geometry/attribute_network.h"

namespace croquis::test {

/// A sheet of columns × rows bent four-sided faces with cubic curves, smooth between them. Node "n<i>_<j>", curves
/// "u<i>_<j>" along x and "v<i>_<j>" along y, faces "f<i>_<j>", each from its lower left node. Cells are 1 × 1.
AttributeNetwork bent_sheet(int columns, int rows);

/// The sheet with a point on every face, and slopes and an inner curve on the first one.
AttributeNetwork rich_sheet(int columns, int rows);

/// A box of 12 straight curves without faces, corners 0..1; curve "x<y><z>" goes along x.
AttributeNetwork wire_box();

/// The whole content as text: equal networks have equal texts.
std::string text_of(const AttributeNetwork& network);

}  // namespace croquis::test
