// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "croquis/attribute_surface/face_edit.h"
#include "croquis/attribute_surface/loop_search.h"
#include "croquis/attribute_surface/network_mirror.h"
#include "croquis/session/session.h"
#include "croquis/tools/pointer/mesh_event.h"
#include "croquis/tools/pointer/pointer_event.h"
#include "croquis/tools/pointer/session_drag.h"
#include "croquis/tools/recording/step.h"
#include "croquis/tools/surface/network_pick.h"
#include "croquis/tools/surface/surface_sight.h"
#include "croquis/tools/surface/surface_steps.h"

namespace croquis {

/// Draw: the pen draws curves. Select: picks and drags. Patch: a click in a loop makes a patch. Point: a press on a
/// patch puts a point attribute there, a drag pulls it.
enum class SurfaceMode { Draw, Select, Patch, Point };

/// Where strokes lie that begin on nothing: on the ground, or across the view where that is seen too flat; or always
/// across the view; or on the plane chosen.
enum class SurfacePlane { Ground, View, Chosen };

struct SurfaceToolOptions {
  std::string name = "Surface";       ///< of the network
  std::string operation = "surface";  ///< made together with the network …
  int version = 1;                    ///< … of this version …
  std::string port = "network";       ///< … its input that the network goes to
  double snap_pixels = 12;            ///< an end this near to a node or a curve goes to it
  double pick_pixels = 9;             ///< how far the pointer may miss
  double drag_pixels = 4;             ///< a press that moves less is a click
};

/// What a host sets of the tool.
struct SurfaceSettings {
  SurfacePlane plane = SurfacePlane::Ground;
  SpacePlane ground;
  SpacePlane chosen;                          ///< that strokes lie on with SurfacePlane::Chosen
  std::shared_ptr<const SurfaceSight> sight;  ///< what lies under rays, once results have come; null: nothing does
  NodeId node = 0;                            ///< the network worked on; where there is none: the document's first one
};

/// The document with a network and the operation that it goes to.
Document add_network(const Document& document, AttributeNetwork network, const SurfaceToolOptions& options);

/// What an end would go to, or the pointer is over.
struct SurfaceSnap {
  recorded::CurveEnd end;  ///< a node or a place of a curve; neither: the stroke's own start, which it would close at
  Vec3 place = Vec3::Zero();
};

/// A handle of the slope of a patch along a selected curve.
struct SlopeTip {
  SlopeSide side;   ///< the slope that a drag sets: the patch's own, or the one for all patches where that is set
  double at = 0.5;  ///< fraction of the curve's arc length
  SlopeFrame frame;
  double magnitude = 1;
  bool automatic = true;    ///< no slope is set there
  Vec3 tip = Vec3::Zero();  ///< end of the handle, which begins at the frame's point
};

/// What to draw over the views while a gesture is under way or the pointer hovers. Places are of the network's space;
/// networks that change during a drag are in the session's document.
struct SurfacePreview {
  std::vector<Vec3> ink;               ///< Draw: where the stroke lies so far
  std::optional<SpacePlane> plane;     ///< Draw: that it lies on; none on a mesh or a patch
  std::string face;                    ///< Draw: the patch that the stroke lies on
  std::optional<SurfaceSnap> snap;     ///< what the end would go to
  std::optional<PickBox> box;          ///< Select: px of the view the gesture began in
  std::optional<PickedPlace> hovered;  ///< what a press would take
  std::optional<SurfaceHit> hit;       ///< the patch under the pointer, where nothing else is
  std::optional<LoopAround> loop;      ///< Patch: that a click would fill
  std::optional<double> radius;        ///< Point, Select: of the point whose ring is dragged
  std::optional<Vec3> moved;           ///< Select: how far what is dragged has come
};

struct SurfaceGesture;

/// The pen on an attribute network: draws its curves, moves what it has, fills loops with patches and pulls these.
///
/// Draw: a stroke becomes one curve, or one for each part between its corners. It begins and ends at nodes or on curves
/// that it comes near, which are split there. Where it begins on a mesh it lies on that; on a patch it becomes an inner
/// curve, or where both its ends lie on the patch's loop it divides the patch; between two nodes or curves it lies in
/// the plane through these that is most across the view. Select: a click picks (Shift adds or takes away); a drag moves
/// what is selected; handles, slopes and rings of what is selected come first; elsewhere it spans a box. Patch and
/// Point: see SurfaceMode. A drag of a point goes along the patch's normal, with Ctrl across the view. Every gesture is
/// one undo step, and a Cancel gives it up. With a symmetry plane, all edits are done on both sides.
/// Frames of events see the network's own space: a host puts the node's placement into them.
/// The session outlives the tool. Everything on the session's thread.
class SurfaceTool {
 public:
  explicit SurfaceTool(Session& session, SurfaceToolOptions options = {});
  ~SurfaceTool();
  SurfaceTool(const SurfaceTool&) = delete;
  SurfaceTool& operator=(const SurfaceTool&) = delete;

  SurfaceMode mode() const { return mode_; }
  void set_mode(SurfaceMode mode);  ///< gives up a gesture under way
  SurfaceSettings& settings() { return settings_; }
  const SurfaceSettings& settings() const { return settings_; }
  const std::optional<SymmetryPlane>& symmetry() const { return symmetry_; }

  // ---- Pointer
  Verdict handle(const MeshEvent& event);
  /// Whether a gesture is under way.
  bool active() const { return gesture_ != nullptr; }
  /// Pre-highlights, and finds what a stroke or click there would go to. @return whether the preview changed
  bool hover(const Vec2& pixel, const ViewFrame& frame);
  bool leave();
  const SurfacePreview& preview() const { return preview_; }

  /// Does a step of surface_steps(): one undo step, but for those that select or set the symmetry.
  /// @return Commit; Continue where nothing changed; Revert where nothing could be made of it
  /// @throws Error (E_INPUT …) for elements that aren't there, and values that can't be
  Verdict take(const recorded::Step& step);
  /// What the last Commit did, for recordings.
  const std::optional<recorded::Step>& done() const { return done_; }
  /// Why the last step or gesture did nothing, and what is worth knowing of what it did.
  const Findings& notes() const { return notes_; }

  // ---- The document
  NodeId node() const;                                      ///< the network worked on; 0 when there is none
  std::shared_ptr<const AttributeNetwork> network() const;  ///< or null
  NodeId operation_node() const;                            ///< that it goes to; 0 for none

  // ---- What is selected. Parts of the session's selection are "node n1", "curve c1", "face f1", "point p1".
  NetworkElements selected() const;
  void select(const NetworkElements& elements);  ///< recorded with a SurfaceChoice instead

 private:
  void go_on(const MeshEvent& event);
  Verdict finish();
  Verdict give_up();
  void drag();
  Document with_network(AttributeNetwork network) const;

  Session& session_;
  SurfaceToolOptions options_;
  SurfaceSettings settings_;
  SurfaceMode mode_ = SurfaceMode::Draw;
  std::optional<SymmetryPlane> symmetry_;
  SurfacePreview preview_;
  std::optional<recorded::Step> done_;
  Findings notes_;
  std::unique_ptr<SurfaceGesture> gesture_;  ///< null: none is under way
  SessionDrag drag_;
};

// ---- What can be dragged beside elements

/// Handles of the selected curves (control_handles), without those at nodes.
std::vector<ControlHandle> handles_of(const SurfaceTool& tool);
/// Of each patch along the one selected curve.
std::vector<SlopeTip> slopes_of(const SurfaceTool& tool);
/// The ring of the one selected point; during a drag of it, as it is now. Empty for none.
std::vector<Vec3> ring_of(const SurfaceTool& tool);

/// Makes curves smooth, or where all of them are, creases.
recorded::SurfaceJoin other_join(const AttributeNetwork& network, const std::vector<std::string>& curves);

/// "part" of a selected item, and back: "curve c1".
std::string selected_part(NetworkElement kind, const std::string& id);

}  // namespace croquis
