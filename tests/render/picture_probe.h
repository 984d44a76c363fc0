// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <vector>

#include "croquis/render/picture.h"

namespace croquis::test {

/// Runs the test with a renderer in a context without a screen; warns and returns where none can be had.
void with_renderer(const std::function<void(render::Renderer&)>& test);

/// A pixel, x from the left and y from the top.
render::Color pixel(const render::RenderedPicture& picture, int x, int y);

int brightness(const render::Color& color);  ///< 0..255

/// Number of pixels for which the condition holds.
int count_pixels(const render::RenderedPicture& picture, const std::function<bool(const render::Color&)>& condition);

/// Plain colours on white, no lines: what is where can be read off exactly.
render::RenderOptions flat_options();

/// A parallel view in which a model unit is a pixel and the origin is the picture's lower left corner.
render::Camera pixel_camera(const render::PictureSize& size);

/// The picture of a scene in that view, plain colours on white.
render::RenderedPicture pixel_picture(render::Renderer& renderer, const render::Scene& scene,
                                      const render::PictureSize& size, double pixel_ratio = 1);

/// A single drawing, whatever it shows, into a framebuffer of its own.
render::RenderedPicture draw_once(render::Renderer& renderer, const render::Scene& scene, const render::Camera& camera,
                                  const render::RenderOptions& options, const render::PictureSize& size);

/// Number of pixels of exactly that colour.
int count_color(const render::RenderedPicture& picture, const render::Color& color);

/// How dark a pixel is: 0 white … 1 black.
double ink(const render::RenderedPicture& picture, int x, int y);
double ink_of_column(const render::RenderedPicture& picture, int x);  ///< sum of a column's ink, pixels of black
double ink_of_all(const render::RenderedPicture& picture);            ///< sum of all ink, pixels of black

/// The faces' colours by a channel, three values 0..255 per face.
void color_faces(PolyMesh& mesh, const std::vector<std::array<std::uint8_t, 3>>& colors);

/// The picture of one mesh from a named view, framed with the usual margin.
render::RenderedPicture picture_of(render::Renderer& renderer, const PolyMesh& mesh, render::NamedView view,
                                   const render::RenderOptions& options, const render::PictureSize& size);

}  // namespace croquis::test
