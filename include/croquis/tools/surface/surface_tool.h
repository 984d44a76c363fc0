// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
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

/// The document with a network and the operation that it goes to.
Document add_network(const Document& document, AttributeNetwork network, const SurfaceToolOptions& options);

/// One step of a pen or mouse in a view. The frame sees the network's own space: a host puts the node's placement into
/// it.
struct SurfaceEvent {
  MeshEvent pointer;
  double pressure = 1;  ///< 0..1
};

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
};

/// The pen on an attribute network: draws its curves, moves what it has, fills loops with patches and pulls these.
///
/// Draw: a stroke becomes one curve, or one for each part between its corners. It begins and ends at nodes or on curves
/// that it comes near, which are split there. Where it begins on a mesh it lies on that; on a patch it becomes an inner
/// curve, or where both its ends lie on the patch's loop it divides the patch; between two nodes or curves it lies in
/// the plane through these that is most across the view. Select: a click picks (Shift adds or takes away); a drag moves
/// what is selected; handles, slopes and rings of what is selected come first; elsewhere it spans a box. Patch and
/// Point: see SurfaceMode. A drag of a point goes along the patch's normal, with Ctrl across the view. Every gesture is
/// one undo step, and a Cancel gives it up. With a symmetry plane, all edits are done on both sides.
/// The session outlives the tool. Everything on the session's thread.
class SurfaceTool {
 public:
  explicit SurfaceTool(Session& session, SurfaceToolOptions options = {});

  SurfaceMode mode() const { return mode_; }
  void set_mode(SurfaceMode mode);  ///< gives up a gesture under way

  /// What lies under rays; null: nothing does. A host sets it when results have come.
  void set_sight(std::shared_ptr<const SurfaceSight> sight) { sight_ = std::move(sight); }

  SurfacePlane plane() const { return plane_; }
  void set_plane(SurfacePlane plane) { plane_ = plane; }
  void set_chosen_plane(const SpacePlane& plane);                  ///< and draws on it
  void set_ground(const SpacePlane& ground) { ground_ = ground; }  ///< at first y = 0
  const std::optional<SymmetryPlane>& symmetry() const { return symmetry_; }

  // ---- Pointer
  Verdict handle(const SurfaceEvent& event);
  /// Whether a gesture is under way.
  bool active() const { return gesture_ != Gesture::None; }
  /// Pre-highlights, and finds what a stroke or click there would go to. @return whether the preview changed
  bool hover(const Vec2& pixel, const ViewFrame& frame);
  bool leave();
  const SurfacePreview& preview() const { return preview_; }
  /// What the last Commit did, for recordings.
  const std::optional<recorded::Step>& done() const { return done_; }
  /// Why the last command or gesture did nothing, and what is worth knowing of what it did.
  const Findings& notes() const { return notes_; }

  // ---- Commands; each is one undo step. Commit, or Continue where nothing changed.
  // @throws Error (E_INPUT …) for elements that aren't there, and values that can't be

  Verdict draw(const recorded::SurfaceStroke& stroke);
  Verdict move(const NetworkElements& elements, const Vec3& by, const std::string& into = {});
  Verdict move_handle(const ControlHandle& handle, const Vec3& by);
  Verdict fill_loop(const std::vector<std::string>& curves);  ///< findings of sort_loop become notes
  Verdict fill_selected();                                    ///< with the selected curves
  Verdict put_point(const NewPoint& point);
  Verdict set_points(const std::vector<std::string>& points, const PointSetting& setting);
  Verdict set_join(const std::vector<std::string>& curves, CurveJoin join);
  Verdict cycle_join();  ///< of the selected curves: all smooth, or where they are, all creases
  Verdict set_faces(const std::vector<std::string>& faces, const FaceSetting& setting);
  Verdict turn_faces(const std::vector<std::string>& faces);
  Verdict set_slope(const SlopeSide& side, const SlopeHandle& handle);
  Verdict remove_slope(const SlopeSide& side);
  Verdict set_inner(const std::string& curve, const InnerSetting& setting);
  Verdict add_inner(const std::string& face, const std::string& curve);
  Verdict remove_inner(const std::string& face, const std::string& curve);
  Verdict split_curve(const std::string& curve, double at);
  Verdict split_face(const std::string& face, const std::string& curve);
  Verdict merge_faces(const std::string& curve);
  Verdict remove(const NetworkElements& elements);
  Verdict delete_selected();
  Verdict mirror(const SymmetryPlane& plane);
  /// Edits on both sides from now on; recorded, but no undo step.
  Verdict set_symmetry(const std::optional<SymmetryPlane>& plane);
  /// Does a step of surface_steps(). @throws Error as the commands
  Verdict replay(const recorded::Step& step);

  // ---- The document
  /// The network worked on: the one set, else the document's first one; 0 when there is none.
  NodeId node() const;
  void set_node(NodeId node) { node_ = node; }
  std::shared_ptr<const AttributeNetwork> network() const;  ///< or null
  NodeId operation_node() const;                            ///< that it goes to; 0 for none

  // ---- What is selected. Parts of the session's selection are "node n1", "curve c1", "face f1", "point p1".
  NetworkElements selected() const;
  void select(const NetworkElements& elements);
  Verdict choose(const NetworkElements& elements);  ///< the same, recorded; Continue where nothing changed

  // ---- What can be dragged beside elements
  /// Handles of the selected curves (control_handles), without those at nodes.
  std::vector<ControlHandle> handles() const;
  /// Of each patch along the one selected curve.
  std::vector<SlopeTip> slopes() const;
  /// The ring of the one selected point; during a drag of it, as it is now. Empty for none.
  std::vector<Vec3> ring() const;

 private:
  enum class Gesture { None, Draw, Press, Box, Move, Handle, Slope, Ring, Pull };

  /// A network as a drag has changed it, and the step that does the same.
  struct Dragged {
    AttributeNetwork network;
    recorded::Step step;
    std::string label;
  };

  /// What a sample of a stroke lies over.
  struct Sample {
    Vec2 pixel = Vec2::Zero();
    std::optional<SurfaceHit> patch;
    std::optional<Vec3> mesh;  ///< nearer than the patch
  };

  Verdict begin(const SurfaceEvent& event);
  void go_on(const SurfaceEvent& event);
  Verdict finish();
  Verdict give_up();
  void end_gesture();

  // Draw
  void add_sample(const Vec2& pixel);
  void preview_stroke();
  std::optional<SurfaceSnap> snap_at(const ViewFrame& frame, const Vec2& pixel) const;
  std::string face_drawn_on() const;  ///< empty for none
  bool draws_on_mesh() const;
  SpacePlane plane_for(const std::optional<SurfaceSnap>& end) const;
  std::vector<Vec3> stroke_places(const std::optional<SurfaceSnap>& end) const;
  std::vector<Vec3> places_over(const std::string& face) const;
  Verdict finish_stroke();

  // Select, Patch, Point
  void press();
  void start_drag();
  void drag_to();
  Dragged dragged() const;
  Dragged moved() const;
  Dragged slope_dragged() const;
  Dragged ring_dragged() const;
  Dragged point_pulled() const;
  Vec3 way_across(const Vec3& place) const;
  Vec3 way_along(const Vec3& place, const Vec3& normal) const;
  std::optional<PickedPlace> node_to_join() const;
  Verdict finish_drag();
  Verdict finish_click();
  Verdict finish_box();
  std::optional<PickedPlace> pick(const ViewFrame& frame, const Vec2& pixel) const;
  bool ring_at(const ViewFrame& frame, const Vec2& pixel) const;
  std::optional<SlopeTip> slope_at(const ViewFrame& frame, const Vec2& pixel) const;
  std::optional<SurfaceHit> hit_at(const ViewFrame& frame, const Vec2& pixel) const;
  std::optional<LoopAround> loop_at(const ViewFrame& frame, const Vec2& pixel) const;
  Verdict click_in_loop();

  // The document
  Verdict commit(const std::string& label, AttributeNetwork network, recorded::Step step);
  AttributeNetwork on_both_sides(const AttributeNetwork& before, AttributeNetwork after) const;
  Document with_network(AttributeNetwork network) const;
  AttributeNetwork network_or_empty() const;

  Session& session_;
  SurfaceToolOptions options_;
  SurfaceMode mode_ = SurfaceMode::Draw;
  SurfacePlane plane_ = SurfacePlane::Ground;
  SpacePlane ground_;
  SpacePlane chosen_;
  std::optional<SymmetryPlane> symmetry_;
  NodeId node_ = 0;
  std::shared_ptr<const SurfaceSight> sight_;
  SurfacePreview preview_;
  std::optional<recorded::Step> done_;
  Findings notes_;

  Gesture gesture_ = Gesture::None;
  SurfaceEvent start_;                 ///< that began the gesture
  Vec2 last_ = Vec2::Zero();           ///< where the pointer is
  std::vector<Sample> samples_;        ///< Draw
  std::optional<SurfaceSnap> from_;    ///< Draw: what the stroke begins at
  std::optional<PickedPlace> picked_;  ///< under the press
  std::optional<SlopeTip> tip_;        ///< under the press
  std::optional<SurfaceHit> hit_;      ///< under the press
  bool on_ring_ = false;               ///< the press was on the ring of the selected point
  NetworkElements moving_;             ///< Move
  SessionDrag drag_;
  std::shared_ptr<const AttributeNetwork> original_;  ///< before the drag …
  std::optional<NetworkPartners> partners_;           ///< … and its symmetry
  std::optional<recorded::Step> dragged_;             ///< what the drag does by now
};

/// "part" of a selected item, and back: "curve c1".
std::string selected_part(NetworkElement kind, const std::string& id);

}  // namespace croquis
