// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "croquis/geometry/drawing.h"

/// Drawings nobody thought about: shapes thrown over one another, drawn by a steady or a shaky hand. Many of them mean
/// nothing, and are to be refused; what becomes solid has to be sound.
namespace croquis::test {

enum class Scrawl {
  Blobs,     ///< lobed shapes of all sizes over one another
  Slivers,   ///< copies shifted by a hair, and specks on rims: thin crescents stay in sight
  Sticks,    ///< long and short ones, whose widths differ by up to twenty times
  Chain,     ///< linked rings
  Tube,      ///< a closed tube that runs across itself
  Scribbles  ///< wandering lines, closed or not, that cross as they like
};

const std::vector<Scrawl>& scrawl_families();
std::string to_string(Scrawl family);

struct ScrawledDrawing {
  Drawing drawing;
  bool shaky = false;  ///< wants the preset for tablets
};

ScrawledDrawing random_scrawl(Scrawl family, std::uint64_t seed);

}  // namespace croquis::test
