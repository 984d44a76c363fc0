// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "croquis/tools/holes/hole_pins.h"
#include "croquis/tools/holes/hole_steps.h"
#include "croquis/tools/pointer/mesh_event.h"
#include "croquis/tools/pointer/pointer_event.h"
#include "croquis/tools/recording/step.h"

namespace croquis {

/// A patch in view: any place of it can be pulled.
struct HolePatchView {
  Index hole = no_index;
  std::vector<Vec3> positions;
  std::vector<std::array<Index, 3>> triangles;  ///< into positions
};

/// A place that a patch goes through; it can be moved.
struct PatchHandle {
  Index hole = no_index;
  Vec3 place = Vec3::Zero();
  Vec3 normal = Vec3::UnitZ();  ///< of the patch there, length 1
};

struct HoleToolOptions {
  HolePinOptions pins;
  double rim_pixels = 7;     ///< how far the pointer may be from a rim …
  double handle_pixels = 9;  ///< … from a handle …
  double pin_slack = 2;      ///< … and from the edge of a pin
  double drag_pixels = 4;    ///< a press that moves less is a click
  double double_click_seconds = 0.4;
};

/// What the pointer is over, the first of these that is within reach.
enum class HolePart { None, Handle, Pin, Rim, Patch, Opening };

struct HoleHover {
  HolePart part = HolePart::None;
  std::vector<Index> holes;   ///< of a pin that stands for several: all of them
  std::size_t handle = 0;     ///< of a Handle: its number in handles()
  std::optional<Vec3> place;  ///< Handle: its place; Patch: where a drag would take hold
  bool operator==(const HoleHover&) const = default;
};

/// A place of a patch being dragged.
struct PatchPull {
  Index hole = no_index;
  std::optional<std::size_t> handle;  ///< its number in handles() when the drag began; none: a new one is made
  Vec3 from = Vec3::Zero();
  Vec3 to = Vec3::Zero();
  Vec3 normal = Vec3::UnitZ();
  bool along_normal = false;

  recorded::HolePoint as_step() const { return {hole, from, to, {}}; }
};

/// What to draw besides rims, pins and the selection.
struct HolePreview {
  std::optional<PickBox> box;  ///< pixels of the view the gesture began in
  HoleHover hovered;
  std::optional<PatchPull> pull;  ///< while a handle or patch is dragged; show the patch as it would be at `to`
};

class HoleScene;
struct HoleGesture;

/// Works on the holes of one scan: picks them by pin, rim, patch, opening or box, chooses which to fill, pulls patches.
///
/// Clicks: plain replaces the selection, Shift toggles, Ctrl removes, Ctrl+Shift adds; boxes the same, for holes whose
/// place is in the box and not hidden. A plain click on nothing selects none. Double click: fill this one; leave it
/// open when it is filled (of several on one pin: fill, unless all are). Drag of a handle, or of any place of a patch:
/// in the plane across the view; with Shift along the patch's normal. Ctrl+click takes a handle away.
///
/// Plain data in and out: it changes nothing but its own selection, and returns in done() what a window has to do. An
/// event in a view that was looked at before costs O(what lies near), in a new one O(points of all rims). One thread.
class HoleTool {
 public:
  explicit HoleTool(HoleToolOptions options = {});
  ~HoleTool();
  HoleTool(HoleTool&&) noexcept;
  HoleTool& operator=(HoleTool&&) noexcept;

  // ---- What it works on
  /// Gives up what is under way; holes that are still there (by id) stay selected.
  void set_rims(std::vector<HoleRim> rims);
  const std::vector<HoleRim>& rims() const;
  const HoleRim* rim(Index hole) const;  ///< or null
  void set_filled(std::vector<Index> holes);
  bool is_filled(Index hole) const { return std::ranges::binary_search(filled_, hole); }
  /// These may change while a drag is under way: the drag goes on.
  void set_patches(std::vector<HolePatchView> patches);
  void set_handles(std::vector<PatchHandle> handles);
  const std::vector<PatchHandle>& handles() const;
  /// Asked for pins' holes, handles and places of patches; none: everything is seen. Call it again when the model or
  /// what hides it has changed.
  void set_sight(HoleSight sight);

  // ---- Pointer
  Verdict handle(const MeshEvent& event);  ///< Commit: see done(). Cancel (Escape) gives up
  bool active() const { return gesture_ != nullptr; }
  /// @return whether the preview changed
  bool hover(const Vec2& pixel, const ViewFrame& frame);
  bool leave();
  const HolePreview& preview() const { return preview_; }
  /// What the last Commit was: HoleChoice (selections have been made already) or HolePoint.
  const std::optional<recorded::Step>& done() const { return done_; }

  /// Every hole's place on screen; kept until the view, rims or sight change.
  const std::vector<HolePin>& pins(const ViewFrame& frame);

  /// Does a step of hole_steps() but a HoleWay, as a gesture would.
  /// @throws Error (E_INPUT) naming each hole that isn't there
  Verdict take(const recorded::Step& step);

  // ---- Selection, sorted
  const std::vector<Index>& selected() const { return selected_; }
  bool is_selected(Index hole) const { return std::ranges::binary_search(selected_, hole); }
  Verdict select(std::vector<Index> holes);  ///< from a list; those that aren't there are left out

 private:
  void go_on(const MeshEvent& event);
  Verdict finish();
  Verdict give_up();
  Verdict choose(std::vector<Index> holes, const std::string& action);
  Verdict commit(recorded::Step step);

  HoleToolOptions options_;
  std::unique_ptr<HoleScene> scene_;
  std::vector<Index> filled_, selected_;  ///< sorted
  HolePreview preview_;
  std::optional<recorded::Step> done_;
  std::unique_ptr<HoleGesture> gesture_;  ///< null: none is under way
  std::optional<MeshEvent> last_click_;
};

/// The places a patch goes through, after that step: of equally near ones the first.
/// @param reach how near `from` has to be to a place to mean it, model units
std::vector<Vec3> moved_through(std::vector<Vec3> through, const recorded::HolePoint& step, double reach = 0);

}  // namespace croquis
