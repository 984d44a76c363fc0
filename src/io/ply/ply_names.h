// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <string_view>

namespace croquis {

/// PLY's names for the parts of a channel; the first row of a channel is what the writer uses.
struct PlyPartNames {
  std::string_view channel;
  int width;
  std::array<std::string_view, 4> parts;
};

/// Longer rows stand before their beginnings, so that the first match is the right one.
inline constexpr std::array ply_part_names = {
    PlyPartNames{"normal", 3, {"nx", "ny", "nz"}},
    PlyPartNames{"normal", 3, {"normal_x", "normal_y", "normal_z"}},
    PlyPartNames{"color", 4, {"red", "green", "blue", "alpha"}},
    PlyPartNames{"color", 3, {"red", "green", "blue"}},
    PlyPartNames{"color", 4, {"r", "g", "b", "a"}},
    PlyPartNames{"color", 3, {"r", "g", "b"}},
    PlyPartNames{"color", 3, {"diffuse_red", "diffuse_green", "diffuse_blue"}},
    PlyPartNames{"uv", 2, {"s", "t"}},
    PlyPartNames{"uv", 2, {"u", "v"}},
    PlyPartNames{"uv", 2, {"texture_u", "texture_v"}}};

}  // namespace croquis
