// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include <glm/glm.hpp>

namespace croquis::render {

/// Larger pictures are made smaller before they become items: every graphics card can hold this one.
inline constexpr int max_picture_item_side = 4096;

/// A picture at one size. Colours are multiplied by their alpha.
struct PictureLevel {
  int width = 1;                   ///< pixels
  int height = 1;                  ///< pixels
  std::vector<std::uint8_t> rgba;  ///< 4 * width * height, top row first
};

/// A photo or a scan made ready for display: never changed once made, shared between scenes and views. Where and how
/// strongly it is shown stands in the scene, so that moving it sends nothing to the graphics card.
struct PictureItem {
  std::vector<PictureLevel> levels;  ///< the picture, then each half as large as the one before, down to a pixel
};

using PictureItemPtr = std::shared_ptr<const PictureItem>;

/// Makes a picture ready.
/// @param rgba 4 * width * height bytes, top row first, colours not multiplied by alpha
/// @throws Error (E_PICTURE_SIZE, usage) for sides outside 1..max_picture_item_side or another number of bytes
/// O(pixels).
PictureItemPtr make_picture_item(std::span<const std::uint8_t> rgba, int width, int height);

/// A picture in a scene: a parallelogram behind all that is drawn.
struct ShownPicture {
  PictureItemPtr item;                       ///< null ones are left out
  glm::dvec3 corner = glm::dvec3(0);         ///< model coordinates, of its lower left corner
  glm::dvec3 right = glm::dvec3(1, 0, 0);    ///< along its lower border, to the other end
  glm::dvec3 upwards = glm::dvec3(0, 1, 0);  ///< along its left border, to the other end
  double opacity = 1;                        ///< 0..1

  bool operator==(const ShownPicture&) const = default;
};

}  // namespace croquis::render
