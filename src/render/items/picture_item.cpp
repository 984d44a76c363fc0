// SPDX-License-Identifier: GPL-3.0-or-later
#include "croquis/render/picture_item.h"

#include <algorithm>
#include <string>

#include "croquis/base/error.h"

namespace croquis::render {
namespace {

void require_picture(std::size_t bytes, int width, int height) {
  const auto fits = [](int side) { return side >= 1 && side <= max_picture_item_side; };
  const bool sides_fit = fits(width) && fits(height);
  if (sides_fit && bytes == std::size_t{4} * static_cast<std::size_t>(width) * static_cast<std::size_t>(height)) return;
  throw Error(make_error(Category::Usage, "E_PICTURE_SIZE",
                         "A picture of " + std::to_string(width) + " x " + std::to_string(height) + " pixels and " +
                             std::to_string(bytes) + " bytes can't be shown; give 4 bytes per pixel and sides up to " +
                             std::to_string(max_picture_item_side) + ".",
                         {}));
}

PictureLevel first_level(std::span<const std::uint8_t> rgba, int width, int height) {
  PictureLevel level{width, height, {}};
  level.rgba.resize(rgba.size());
  for (std::size_t i = 0; i < rgba.size(); i += 4) {
    const unsigned alpha = rgba[i + 3];
    for (std::size_t k = 0; k < 3; ++k)
      level.rgba[i + k] = static_cast<std::uint8_t>((rgba[i + k] * alpha + 127) / 255);
    level.rgba[i + 3] = static_cast<std::uint8_t>(alpha);
  }
  return level;
}

/// The mean of each four pixels; the last row and column count once more where their number is odd.
PictureLevel half_of(const PictureLevel& from) {
  PictureLevel half{std::max(1, from.width / 2), std::max(1, from.height / 2), {}};
  half.rgba.resize(std::size_t{4} * static_cast<std::size_t>(half.width) * static_cast<std::size_t>(half.height));
  std::uint8_t* to = half.rgba.data();
  const auto row = [&](int y) {
    return from.rgba.data() + std::size_t{4} * static_cast<std::size_t>(std::min(y, from.height - 1)) *
                                  static_cast<std::size_t>(from.width);
  };
  for (int y = 0; y < half.height; ++y) {
    const std::uint8_t* upper = row(2 * y);
    const std::uint8_t* lower = row(2 * y + 1);
    for (int x = 0; x < half.width; ++x) {
      const int left = 4 * std::min(2 * x, from.width - 1), right = 4 * std::min(2 * x + 1, from.width - 1);
      for (int k = 0; k < 4; ++k) {
        const int sum = upper[left + k] + upper[right + k] + lower[left + k] + lower[right + k];
        *to++ = static_cast<std::uint8_t>((sum + 2) / 4);
      }
    }
  }
  return half;
}

}  // namespace

PictureItemPtr make_picture_item(std::span<const std::uint8_t> rgba, int width, int height) {
  require_picture(rgba.size(), width, height);
  auto item = std::make_shared<PictureItem>();
  item->levels.push_back(first_level(rgba, width, height));
  while (item->levels.back().width > 1 || item->levels.back().height > 1)
    item->levels.push_back(half_of(item->levels.back()));
  return item;
}

}  // namespace croquis::render
