// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <utility>

#include "io/tracing/tracing.h"

namespace croquis::tracing {
namespace {

using Brightness = PixelGrid<float>;

// Light and dark sides of the ground differ less; darker places are no paper, and their texture is no drawing.
constexpr float darkest_ground = 0.35F;    // × that of the light part of the picture
constexpr float noise_factor = 6;          // × the usual deviation: what is darker isn't grain of the paper
constexpr float least_darkness = 0.06F;    // of ink on paper without any grain
constexpr float sure_ink = 0.5F;           // × the usual ink: what is darker begins a line …
constexpr float faint_ink = 0.35F;         // … which goes on where it is darker than this
constexpr float faint_grain = 0.8F;        // the same of grain
constexpr std::size_t largest_speck = 20;  // pixels

/// Where one pixel of a row goes when the row is scaled down: to one place, and the rest to the next one.
struct Share {
  int place = 0;
  float first = 1;
};

std::vector<Share> shares(int from, int to) {
  std::vector<Share> result;
  const double scale = static_cast<double>(to) / from;
  for (int i = 0; i < from; ++i) {
    const double begin = i * scale, end = (i + 1) * scale;
    const int place = std::min(static_cast<int>(begin), to - 1);
    const bool splits = place + 1 < to && end > place + 1;
    result.push_back({place, static_cast<float>(splits ? (place + 1 - begin) / (end - begin) : 1)});
  }
  return result;
}

struct Coat {
  Brightness light;  ///< premultiplied by
  Brightness cover;  ///< 0 where the picture is transparent
};

/// Means over the area that each new pixel covers.
Coat scaled_down(const Picture& picture, int longest_side, Progress& progress) {
  const double scale = std::min(1.0, static_cast<double>(longest_side) / std::max(picture.width, picture.height));
  const int width = std::max(1, static_cast<int>(std::lround(picture.width * scale)));
  const int height = std::max(1, static_cast<int>(std::lround(picture.height * scale)));
  Coat coat{{width, height}, {width, height}};
  const auto columns = shares(picture.width, width), rows = shares(picture.height, height);
  const auto area = static_cast<float>(static_cast<double>(picture.width) / width * picture.height / height);
  std::vector<float> light(static_cast<std::size_t>(width) + 1), cover(light.size());
  const std::uint8_t* pixel = picture.rgba.data();
  for (int y = 0; y < picture.height; ++y) {
    std::ranges::fill(light, 0.0F);
    std::ranges::fill(cover, 0.0F);
    for (const auto& [place, first] : columns) {
      const float alpha = static_cast<float>(pixel[3]) / 255;
      const float value = alpha * static_cast<float>(pixel[0] + pixel[1] + pixel[2]) / 765;
      const auto at = static_cast<std::size_t>(place);
      light[at] += first * value;
      light[at + 1] += (1 - first) * value;
      cover[at] += first * alpha;
      cover[at + 1] += (1 - first) * alpha;
      pixel += 4;
    }
    const Share row = rows[static_cast<std::size_t>(y)];
    for (const bool next : {false, true}) {
      const float part = (next ? 1 - row.first : row.first) / area;
      if (part == 0) continue;
      for (int x = 0; x < width; ++x) {
        coat.light.at(x, row.place + next) += part * light[static_cast<std::size_t>(x)];
        coat.cover.at(x, row.place + next) += part * cover[static_cast<std::size_t>(x)];
      }
    }
    progress.check();
  }
  return coat;
}

/// The picture on ground that its lines stand out from: what borders on transparent places shows whether they are dark.
Brightness on_ground(Coat coat) {
  double border = 0, light = 0;
  for (int y = 0; y < coat.cover.height; ++y) {
    for (int x = 1; x < coat.cover.width; ++x) {
      const float left = coat.cover.at(x - 1, y), right = coat.cover.at(x, y);
      const int nearer = left > right ? x - 1 : x;
      const double step = std::abs(left - right);
      border += step * coat.cover.at(nearer, y);
      light += step * coat.light.at(nearer, y);
    }
  }
  const float ground = light > border / 2 ? 0 : 1;
  for (std::size_t i = 0; i < coat.light.values.size(); ++i)
    coat.light.values[i] += ground * (1 - coat.cover.values[i]);
  return std::move(coat.light);
}

/// Rows become columns.
template <typename T>
PixelGrid<T> transposed(const PixelGrid<T>& grid) {
  PixelGrid<T> result(grid.height, grid.width);
  for (int y = 0; y < grid.height; ++y) {
    for (int x = 0; x < grid.width; ++x) result.at(y, x) = grid.at(x, y);
  }
  return result;
}

/// Applies a filter of rows to rows and then to columns.
template <typename Filter>
Brightness filtered(const Brightness& grid, const Filter& filter) {
  return transposed(filter(transposed(filter(grid))));
}

/// Means of 1, 2 and 1 pixels against single noisy ones.
Brightness softened(const Brightness& grid) {
  return filtered(grid, [](const Brightness& rows) {
    Brightness result = rows;
    for (int y = 0; y < rows.height; ++y) {
      for (int x = 0; x < rows.width; ++x) {
        const float sides = rows.at(std::max(x - 1, 0), y) + rows.at(std::min(x + 1, rows.width - 1), y);
        result.at(x, y) = rows.at(x, y) / 2 + sides / 4;
      }
    }
    return result;
  });
}

/// The mean over 2 × radius + 1 pixels of each row.
Brightness row_means(const Brightness& rows, int radius) {
  Brightness result = rows;
  std::vector<double> sums(static_cast<std::size_t>(rows.width) + 1);
  for (int y = 0; y < rows.height; ++y) {
    for (int x = 0; x < rows.width; ++x)
      sums[static_cast<std::size_t>(x) + 1] = sums[static_cast<std::size_t>(x)] + rows.at(x, y);
    for (int x = 0; x < rows.width; ++x) {
      const int low = std::max(x - radius, 0), high = std::min(x + radius + 1, rows.width);
      result.at(x, y) = static_cast<float>(
          (sums[static_cast<std::size_t>(high)] - sums[static_cast<std::size_t>(low)]) / (high - low));
    }
  }
  return result;
}

/// Whether what differs much from its surroundings is lighter than they are: lines take less room than their ground.
bool has_light_lines(const Brightness& grid) {
  const int radius = std::max(2, std::max(grid.width, grid.height) / 50);
  const Brightness mean = filtered(grid, [radius](const Brightness& rows) { return row_means(rows, radius); });
  double skew = 0;
  for (std::size_t i = 0; i < grid.values.size(); ++i) skew += std::pow(grid.values[i] - mean.values[i], 3);
  return skew > 0;
}

/// The largest value within `radius` pixels along each row: running maxima from both ends of blocks as long as the
/// window (van Herk 1992).
Brightness row_maxima(const Brightness& rows, int radius) {
  const int window = 2 * radius + 1;
  Brightness result = rows;
  std::vector<float> ahead(static_cast<std::size_t>(rows.width)), back(ahead.size());
  for (int y = 0; y < rows.height; ++y) {
    for (int x = 0; x < rows.width; ++x) {
      const auto i = static_cast<std::size_t>(x), j = static_cast<std::size_t>(rows.width - 1 - x);
      ahead[i] = x % window == 0 ? rows.at(x, y) : std::max(ahead[i - 1], rows.at(x, y));
      const int mirrored = rows.width - 1 - x;
      const bool ends = x == 0 || mirrored % window == window - 1;
      back[j] = ends ? rows.at(mirrored, y) : std::max(back[j + 1], rows.at(mirrored, y));
    }
    for (int x = 0; x < rows.width; ++x) {
      const int low = std::max(x - radius, 0), high = std::min(x + radius, rows.width - 1);
      const float from_low = back[static_cast<std::size_t>(low)], to_high = ahead[static_cast<std::size_t>(high)];
      // Windows that the border cuts may lie within a block, of which either reaches too far.
      const bool within = low / window == high / window;
      result.at(x, y) = !within ? std::max(from_low, to_high) : low % window == 0 ? to_high : from_low;
    }
  }
  return result;
}

void negate(Brightness& grid) {
  for (float& value : grid.values) value = -value;
}

/// The grid without what is darker than its surroundings and narrower than a square of 2 × radius + 1 pixels
/// (morphological closing). Beyond the border it is dark, so that narrow strips of a dark desk stay as they are.
Brightness ground_of(const Brightness& grid, int radius) {
  Brightness wide(grid.width + 2 * radius, grid.height + 2 * radius);
  for (int y = 0; y < grid.height; ++y) std::copy_n(&grid.at(0, y), grid.width, &wide.at(radius, y + radius));
  const auto maxima = [radius](const Brightness& rows) { return row_maxima(rows, radius); };
  wide = filtered(wide, maxima);
  negate(wide);
  wide = filtered(wide, maxima);
  negate(wide);
  Brightness ground(grid.width, grid.height);
  for (int y = 0; y < grid.height; ++y) std::copy_n(&wide.at(radius, y + radius), grid.width, &ground.at(0, y));
  return ground;
}

/// The value that a part of all is below. @param part 0..1
float quantile(std::vector<float> values, double part) {
  const auto place = values.begin() + static_cast<std::ptrdiff_t>(part * static_cast<double>(values.size() - 1));
  std::ranges::nth_element(values, place);
  return *place;
}

/// Connected pixels of `possible` that have one of `sure` among them, without specks.
Mask connected_to(const Mask& sure, const Mask& possible) {
  Mask mask(sure.width, sure.height);
  std::vector<Pixel> pixels, specks;
  const auto take = [&](const Pixel& p, const Mask& allowed) {
    if (allowed.at_or_empty(p.x, p.y) == 0 || mask.at(p.x, p.y) != 0) return;
    mask.at(p.x, p.y) = 1;
    pixels.push_back(p);
  };
  for (int y = 0; y < sure.height; ++y) {
    for (int x = 0; x < sure.width; ++x) {
      pixels.clear();
      take({x, y}, sure);
      for (std::size_t i = 0; i < pixels.size(); ++i) {
        const Pixel p = pixels[i];
        for (int d = 0; d < 8; ++d) take(neighbour(p, d), possible);
      }
      if (pixels.size() < largest_speck) specks.insert(specks.end(), pixels.begin(), pixels.end());
    }
  }
  for (const Pixel& p : specks) mask.at(p.x, p.y) = 0;
  return mask;
}

/// How much darker than the ground a pixel may be by the grain of the paper. Most pixels are paper: half of them
/// deviate less than the median does.
float grain_of(const Brightness& depth) {
  const float usual = quantile(depth.values, 0.5);
  std::vector<float> deviations = depth.values;
  for (float& value : deviations) value = std::abs(value - usual);
  return usual + noise_factor * quantile(std::move(deviations), 0.5);
}

/// The darkness of what was drawn, among values of all that is darker than grain: that of the dark ones of two classes
/// (Otsu 1979), since the lines of squared paper may take more room than those drawn on it.
float usual_ink(const std::vector<float>& values) {
  constexpr std::size_t bins = 64;
  std::array<double, bins> counts{};
  const auto bin_of = [](float value) { return std::min(static_cast<std::size_t>(value * bins), bins - 1); };
  double sum = 0;
  for (const float value : values) {
    ++counts[bin_of(value)];
    sum += static_cast<double>(bin_of(value));
  }
  const auto all = static_cast<double>(values.size());
  double below = 0, sum_below = 0, greatest = -1;
  std::size_t first_dark = 0;
  for (std::size_t bin = 0; bin + 1 < bins; ++bin) {
    below += counts[bin];
    sum_below += static_cast<double>(bin) * counts[bin];
    if (below == 0 || below == all) continue;
    const double between = std::pow(sum_below / below - (sum - sum_below) / (all - below), 2) * below * (all - below);
    if (between > greatest) first_dark = bin + 1;
    greatest = std::max(greatest, between);
  }
  std::vector<float> dark;
  std::ranges::copy_if(values, std::back_inserter(dark), [&](float value) { return bin_of(value) >= first_dark; });
  return dark.empty() ? 1 : quantile(std::move(dark), 0.5);
}

}  // namespace

Ink find_ink(const Picture& picture, const TraceOptions& options, Progress& progress) {
  Brightness light = softened(on_ground(scaled_down(picture, options.longest_side, progress)));
  if (has_light_lines(light)) {
    for (float& value : light.values) value = 1 - value;
  }
  const int radius = std::max(2, static_cast<int>(options.widest_line * std::max(light.width, light.height) / 2));
  const Brightness ground = ground_of(light, radius);
  progress.check();
  const float darkest = darkest_ground * quantile(ground.values, 0.9);
  Brightness depth = ground;
  Ink ink;
  ink.darkness = light;
  for (std::size_t i = 0; i < light.values.size(); ++i) {
    depth.values[i] -= light.values[i];
    ink.darkness.values[i] = depth.values[i] / std::max({ground.values[i], darkest, 1e-3F});
  }
  const float grain = grain_of(depth);
  const auto darker_than = [&](float part_of_grain, float least) {
    Mask mask(light.width, light.height);
    for (std::size_t i = 0; i < light.values.size(); ++i)
      mask.values[i] = depth.values[i] > part_of_grain * grain && ink.darkness.values[i] > least ? 1 : 0;
    return mask;
  };
  std::vector<float> dark;
  const Mask candidates = darker_than(1, least_darkness);
  for (std::size_t i = 0; i < light.values.size(); ++i) {
    if (candidates.values[i] != 0) dark.push_back(ink.darkness.values[i]);
  }
  const float usual = usual_ink(dark);
  progress.check();
  ink.mask = connected_to(darker_than(1, sure_ink * usual), darker_than(faint_grain, faint_ink * usual));
  return ink;
}

}  // namespace croquis::tracing
