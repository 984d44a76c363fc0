// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <iterator>

#include "io/tracing/tracing.h"

namespace croquis::tracing {
namespace {

/// Whether the mask is as connected without the pixel as with it (Yokoi's number is 1), which isn't the end of a line.
bool can_go(const Mask& mask, const Pixel& pixel) {
  std::array<int, 8> set;
  int count = 0;
  for (int d = 0; d < 8; ++d) {
    const Pixel p = neighbour(pixel, d);
    set[static_cast<std::size_t>(d)] = mask.at_or_empty(p.x, p.y);
    count += set[static_cast<std::size_t>(d)];
  }
  if (count < 2) return false;
  int connected = 0;
  for (std::size_t d = 0; d < 8; d += 2) {
    if (set[d] == 0 && (set[d + 1] != 0 || set[(d + 2) % 8] != 0)) ++connected;
  }
  return connected == 1;
}

/// Removes from each side in turn what lies on the border there: all at once, lines of two pixels would be eaten up
/// from their ends. @return whether anything went
bool remove_borders(Mask& mask, const std::vector<Pixel>& pixels) {
  bool has_changed = false;
  for (const int side : {6, 2, 4, 0}) {
    std::vector<Pixel> border;
    std::ranges::copy_if(pixels, std::back_inserter(border), [&](const Pixel& pixel) {
      const Pixel beside = neighbour(pixel, side);
      return mask.at(pixel.x, pixel.y) != 0 && mask.at_or_empty(beside.x, beside.y) == 0;
    });
    for (const Pixel& pixel : border) {
      if (!can_go(mask, pixel)) continue;
      mask.at(pixel.x, pixel.y) = 0;
      has_changed = true;
    }
  }
  return has_changed;
}

}  // namespace

PixelGrid<int> distances_to_outside(const Mask& mask) {
  PixelGrid<int> distances(mask.width, mask.height);
  const auto pass = [&](int x, int y, std::size_t first) {
    int& nearest = distances.at(x, y);
    if (mask.at(x, y) == 0) return;
    if (first == 4) nearest = pixel_step * (mask.width + mask.height);
    for (std::size_t d = first; d < first + 4; ++d) {
      const Pixel p = neighbour({x, y}, static_cast<int>(d));
      nearest = std::min(nearest, distances.at_or_empty(p.x, p.y) + pixel_step + static_cast<int>(d % 2));
    }
  };
  for (int y = 0; y < mask.height; ++y) {
    for (int x = 0; x < mask.width; ++x) pass(x, y, 4);
  }
  for (int y = mask.height - 1; y >= 0; --y) {
    for (int x = mask.width - 1; x >= 0; --x) pass(x, y, 0);
  }
  return distances;
}

Mask thinned(const Mask& mask, const PixelGrid<int>& distances) {
  std::vector<std::vector<Pixel>> layers;
  for (int y = 0; y < mask.height; ++y) {
    for (int x = 0; x < mask.width; ++x) {
      const auto layer = static_cast<std::size_t>(distances.at(x, y));
      if (layer == 0) continue;
      if (layer >= layers.size()) layers.resize(layer + 1);
      layers[layer].push_back({x, y});
    }
  }
  Mask result = mask;
  for (const std::vector<Pixel>& layer : layers) {
    // What goes may let others of its layer go.
    while (remove_borders(result, layer)) {
    }
  }
  return result;
}

}  // namespace croquis::tracing
