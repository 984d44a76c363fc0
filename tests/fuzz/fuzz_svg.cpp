// SPDX-License-Identifier: GPL-3.0-or-later
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string_view>

#include "croquis/base/error.h"
#include "croquis/io/svg_drawing.h"

/// Any bytes are either refused with an error or give strokes of finite samples.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  croquis::Progress progress;
  try {
    const auto result = croquis::read_svg_drawing({reinterpret_cast<const char*>(data), size}, "fuzz.svg", progress);
    if (result.drawing.strokes.empty()) std::abort();
    for (const croquis::Stroke& stroke : result.drawing.strokes) {
      if (stroke.samples.empty() || stroke.id.empty()) std::abort();
      for (const croquis::StrokeSample& sample : stroke.samples) {
        if (!sample.position.allFinite()) std::abort();
      }
    }
  } catch (const croquis::Error& error) {
    if (!croquis::has_errors(error.findings())) std::abort();
  }
  return 0;
}
