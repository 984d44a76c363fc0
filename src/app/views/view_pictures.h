// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QTimer>
#include <array>
#include <cstddef>
#include <memory>
#include <optional>
#include <vector>

#include "app/views/view_pane.h"
#include "app/views/views.h"
#include "croquis/geometry/drawing.h"
#include "croquis/render/renderer.h"

namespace croquis::app {

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

/// All that the pixels of a view depend on.
struct ViewPicture {
  render::Scene scene;
  render::RenderOptions options;
  render::Camera camera;
  QRectF rect;
  bool fine = false;

  bool operator==(const ViewPicture&) const = default;
};

/// How the pixels of a view stand.
struct PaneState {
  bool drawn = false;                  ///< its pixels are still right: most events change one view alone
  bool fine = false;                   ///< drawn in full quality
  bool moving = false;                 ///< its camera is: large meshes are drawn with fewer triangles
  int drawn_count = 0;                 ///< how often it was drawn whole: not where it would have looked as before
  std::size_t triangles = 0;           ///< of surfaces, drawn last
  std::optional<ViewPicture> picture;  ///< that its pixels show, where it is whole
};

/// Draws views into their widget, as long as the widget's context is current: what has changed, and after a pause once
/// more, finer.
struct ViewPictures {
  explicit ViewPictures(Views& shown);

  PaneState& state(int view) { return states[static_cast<std::size_t>(view)]; }

  Views& views;
  std::unique_ptr<render::Renderer> renderer;  ///< null before there is a context, and where there can't be one
  std::array<PaneState, view_count> states;
  InkSheet sheet;
  int sheet_view = SketchView;  ///< that the sheet shows
  bool uploading = false;       ///< some view waits for the graphics card
  bool affordable = true;       ///< a fine frame is quick enough to go unnoticed
  std::size_t measured = 0;     ///< … as a coarse frame of that many triangles has shown
  bool measuring = false;       ///< the next frame is that one
  bool stale = false;           ///< what is out of date has been for longer: it is shown faded
  QTimer pause;                 ///< after it the views are drawn once more, finer
  QTimer patience;
  int frames = 0;  ///< how often something was drawn
};

/// @return whether the labels over the views have to be placed again
bool draw(ViewPictures& pictures);

/// Draws what is unfinished now instead of after a pause. @param fine in full quality
void settle(ViewPictures& pictures, bool fine);

/// Every item of what is shown has been made and sent to the graphics card.
bool settled(const ViewPictures& pictures);

}  // namespace croquis::app
