// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>

#include "croquis/render/color.h"
#include "croquis/render/line_item.h"

namespace croquis::render {

enum class Shading {
  Clay,  ///< key light from the upper left, sky and ground, soft rim; the lights turn with the camera
  Flat,  ///< the colours as they are
  Zebra  ///< reflection lines: the surface mirrors a room of black and white stripes. Where a surface only meets
         ///< another they break off, where it goes on without a crease they have a corner, where its curvature goes on,
         ///< too, none
};

enum class GridKind { None, Dots, Lines };

/// Squared paper behind parallel views, through the model's origin; perspective views have none. It gets coarser and
/// finer by steps of five while one zooms, every fifth line a little stronger.
struct GridOptions {
  GridKind kind = GridKind::None;
  double spacing = 1;                ///< model units, > 0: the grid's step is this times a power of five
  Color color = {92, 110, 140, 70};  ///< alpha is the strength of the strong lines

  bool operator==(const GridOptions&) const = default;
};

/// Short axes x, y, z in the lower left corner that turn with the camera; letters and dashes distinguish them, too.
struct AxisCrossOptions {
  bool shown = false;
  double size = 34;  ///< length of an axis in pixels
  /// Unit directions of x, y and z in the model: of an object that stands upright in it, its own.
  std::array<glm::dvec3, 3> axes = {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
  /// Red, green, blue; people who are blind to red and green see three colors, too.
  std::array<Color, 3> colors = {{{196, 40, 36, 255}, {30, 140, 70, 255}, {44, 92, 200, 255}}};
  std::array<DashPattern, 3> dashes = {{{}, {7, 3, 0, 0}, {2.5F, 2.5F, 0, 0}}};

  bool operator==(const AxisCrossOptions&) const = default;
};

/// How emphasised items look.
struct EmphasisOptions {
  Color selected = {255, 128, 16, 200};  ///< alpha is the strength
  Color hovered = {40, 140, 255, 150};
  double surface_tint = 0.45;  ///< times the strength for surfaces, in [0, 1]
  double glow = 2.5;           ///< pixels that lines and marks grow on either side, in the colour of the emphasis
  Color outline = {255, 128, 16, 255};       ///< of surfaces, beside them …
  Color outline_casing = {30, 20, 12, 255};  ///< … and the thin border of that line: one of both differs from anything
  double outline_width = 2.4;                ///< pixels, in (0, 16]
  double casing_width = 1.3;                 ///< pixels, in [0, 16]: of lines and outlines that have a border
  double faded = 0.45;                       ///< what is left of stale items' strength, in [0, 1]

  bool operator==(const EmphasisOptions&) const = default;
};

/// The look of a picture. Widths and lengths are in pixels of the finished picture, times `pixel_ratio`.
struct RenderOptions {
  Color background_top = {250, 250, 251, 255};     ///< a vertical gradient from here …
  Color background_bottom = {214, 218, 224, 255};  ///< … to here
  GridOptions grid;
  AxisCrossOptions axis_cross;
  EmphasisOptions emphasis;
  Shading shading = Shading::Clay;
  int zebra_stripes = 12;      ///< dark stripes from straight above to straight below, in [2, 200]
  bool occlusion = true;       ///< with Clay: darkens hollows and where parts come close
  bool contours = true;        ///< lines where the surface turns away from the eye, at creases and where patches meet
  double contour_width = 1.5;  ///< in [0.5, 8]
  Color contour_color = {40, 36, 42, 235};  ///< alpha is the strength
  bool wire = false;                        ///< the polygons' edges (not the triangles drawn for them); on filled faces
                                            ///< they fade below eight pixels of length, to nothing at one and a half
  double wire_width = 0.8;                  ///< in [0.1, 8]
  Color wire_color = {44, 50, 62, 150};     ///< alpha is the strength
  double line_width = 2;                    ///< of meshes' polylines, in [0.1, 32]
  int supersampling = 3;  ///< samples per pixel and axis, 1..4; lowered where the driver allows no texture that large
  /// Bytes of large items that one drawing may send to the graphics card; 0: all at once. A mesh that is not there yet
  /// shows its box, then its triangles as they come. Items below a megabyte and updated ones go whole at once.
  std::size_t upload_budget = 0;
  /// Draws large meshes with fewer triangles (`MeshItem::reduced`): for while the camera moves.
  bool reduced = false;
  double pixel_ratio = 1;  ///< device pixels per pixel of the lengths given here and in items, in [0.25, 8]

  /// For while something moves: one sample per pixel and no occlusion; lines and marks stay smooth.
  static RenderOptions interactive();

  /// For the sketch view: plain paper with a faint grid.
  static RenderOptions paper();

  bool operator==(const RenderOptions&) const = default;
};

}  // namespace croquis::render
