// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace croquis {

/// A picture in memory: 8 bits per channel, not premultiplied.
struct Picture {
  int width = 0;                   ///< pixels
  int height = 0;                  ///< pixels
  std::vector<std::uint8_t> rgba;  ///< 4 × width × height, top row first
};

/// The bytes of a PNG file of the picture. The same picture gives the same bytes.
/// @throws Error (E_PICTURE, internal) when the sizes contradict each other or the picture is empty
std::string encode_png(const Picture& picture);

}  // namespace croquis
