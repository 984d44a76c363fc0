// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "app/views/view_pane.h"
#include "croquis/geometry/drawing.h"
#include "croquis/render/renderer.h"

namespace croquis::app {

/// How wide lines of sketches are, logical pixels.
inline constexpr double ink_width = 2.2;

/// The ink of a stroke under way, or null before its first sample.
/// @param pale for strokes that will lie behind others
render::LineItemPtr ink_item(const std::vector<StrokeSample>& ink, bool pale);

/// A view that is drawn on, as it was last drawn whole. While a stroke is under way only the rectangle of its newest
/// piece is drawn again: ink follows the pen without delay, however long a whole view takes.
class InkSheet {
 public:
  /// What was drawn. @param inked samples of the stroke under way that were drawn with it
  void keep(const render::Scene& scene, const render::RenderOptions& options, const ViewPane& pane, std::size_t inked);

  /// The view shows something else now.
  void drop() { drawn_.reset(); }

  /// Whether what was kept is what a pane still shows.
  bool fits(const ViewPane& pane) const;

  /// Draws the part of the ink that isn't there yet. Only after `keep`, with the renderer that drew it.
  /// @param whole the pane's place in the framebuffer
  void draw_new_ink(render::Renderer& renderer, const std::vector<StrokeSample>& ink, bool pale,
                    const render::PixelRect& whole);

  /// Samples of the ink that have been drawn.
  std::size_t inked() const { return inked_; }

 private:
  struct Drawn {
    render::Scene scene;
    render::RenderOptions options;
    ViewPane pane;
  };

  render::PixelRect part_of(const std::vector<StrokeSample>& ink, const render::PixelRect& whole) const;

  std::optional<Drawn> drawn_;
  std::size_t inked_ = 0;
};

}  // namespace croquis::app
