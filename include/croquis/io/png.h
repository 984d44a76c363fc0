// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
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

/// How a PNG file's pixels lie: the orientation that its Exif data give, 1..8; 1, as they are, where they give none.
/// Any bytes.
int png_orientation(std::string_view bytes);

/// The picture of a PNG file that may come from anybody, upright as its Exif data say.
/// @param file_name for findings
/// @throws Error E_PICTURE_FILE (Malformed) when it is damaged; E_LIMIT above most_picture_pixels (limits.h)
Picture decode_png(std::string_view bytes, const std::string& file_name);

}  // namespace croquis
