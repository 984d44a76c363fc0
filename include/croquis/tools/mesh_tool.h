// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <future>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "croquis/mesh_editing/mesh_edit.h"
#include "croquis/mesh_editing/mesh_selection.h"
#include "croquis/mesh_editing/tag_edit.h"
#include "croquis/session/session.h"
#include "croquis/tools/manipulator.h"
#include "croquis/tools/mesh_event.h"
#include "croquis/tools/mesh_pick.h"
#include "croquis/tools/pen.h"
#include "croquis/tools/recording.h"
#include "croquis/tools/sketch_tool.h"

namespace croquis {

/// What clicks and boxes pick. In Object mode they are left to the window: only the manipulator answers.
enum class MeshMode { Object, Vertex, Edge, Face };

/// What a drag does. Sharpen: from a selected edge, or with Shift from anywhere, sideways changes the sharpness of the
/// selected edges.
enum class MeshHandles { Select, Move, Rotate, Scale, Sharpen };

struct MeshToolOptions {
  MeshPickOptions pick;
  double drag_pixels = 4;  ///< a press that moves less is a click
  double double_click_seconds = 0.4;
  double pixels_per_level = 60;  ///< sideways drag for one level of sharpness
  double manipulator_pixels = 80;
  ManipulatorSnap snap = {0, 15, 0.1};  ///< while Ctrl is held at the beginning of a drag of the manipulator
};

/// What to draw over the views besides the selection (Session::components).
struct MeshPreview {
  std::optional<PickBox> box;               ///< pixels of the view the gesture began in
  std::optional<PickedElement> hovered;     ///< of the mode's kind
  std::optional<double> hovered_sharpness;  ///< of a hovered edge with a tag
  ManipulatorHandle hovered_handle = ManipulatorHandle::None;
  ManipulatorHandle active_handle = ManipulatorHandle::None;
  std::optional<LoopCutPreview> cut;        ///< while the loop cut is armed: where it would go
  std::optional<double> sharpness_change;   ///< Sharpen: levels so far
  std::optional<ManipulatorMotion> motion;  ///< what the drag has done, for the help line
};

/// Works on one mesh of a session as Maya does: picks components, moves them, tags edges, cuts.
///
/// Clicks: plain replaces, Shift toggles, Ctrl removes, Ctrl+Shift adds; boxes the same. Double click: of an edge its
/// loop, of a face or vertex all that is connected. Shift+double click goes on from the last picked element: along the
/// loop or ring of edges, the row of faces, the shortest path between vertices; else it adds what a double click picks.
/// Every change is one undo step. Selections come back with undo. The session outlives the tool. One thread.
///
/// What a gesture costs: a drag event copies the mesh and moves the picked vertices, nothing else; neighbourhoods are
/// only made again when the connectivity changed, the picking tree is refitted when the next pick asks.
class MeshTool {
 public:
  explicit MeshTool(Session& session, MeshToolOptions options = {});
  ~MeshTool();

  // ---- What it works on
  void set_node(NodeId node);  ///< a source node with a mesh; another one than before empties hover and gestures
  NodeId node() const { return node_; }
  std::shared_ptr<const PolyMesh> mesh() const;  ///< null when the node holds none
  /// Whether neighbourhoods and picking tree are ready. Those of big meshes are made beside: hovering shows nothing
  /// meanwhile, everything else that needs them waits.
  bool ready() { return at_hand() != nullptr; }
  std::shared_ptr<const MeshTopology> topology();  ///< of mesh(), or null
  MeshPicker* picker();                            ///< of mesh(), or null
  const std::vector<double>& edge_sharpness();     ///< #E, of mesh()'s tags

  MeshMode mode() const { return mode_; }
  void set_mode(MeshMode mode);  ///< F8 … F11; another kind empties no selection: it is kept for its mode
  /// Turns the selection into another kind and changes the mode (Ctrl+F9 … F11).
  Verdict convert_to(MeshMode mode, ConvertRule rule = ConvertRule::Touching);
  MeshHandles handles() const { return handles_; }
  void set_handles(MeshHandles handles);
  void set_pick_through(bool through) { options_.pick.through = through; }

  // ---- Pointer
  Verdict handle(const MeshEvent& event);
  /// After a Begin in Object mode off the manipulator it isn't: the gesture is the window's, to pick objects with.
  bool active() const { return gesture_ != Gesture::None; }
  /// Pre-highlights. @return whether the preview changed
  bool hover(const Vec2& pixel, const ViewFrame& frame);
  bool leave();
  const MeshPreview& preview() const { return preview_; }
  /// At the middle of what is selected; nothing when there is nothing to move.
  std::optional<Manipulator> manipulator();
  ManipulatorPicture manipulator_picture(const ViewFrame& frame);

  /// The next click cuts the hovered edge's ring, where it was hovered; every mode. Escape or another mode disarms.
  void arm_loop_cut(bool armed);
  bool loop_cut_armed() const { return loop_cut_armed_; }

  /// What the last Commit did, for recordings.
  const std::optional<recorded::Step>& done() const { return done_; }
  /// What the last edit lost or refused (warnings).
  const Findings& notes() const { return notes_; }

  // ---- Selection. Continue when nothing changed
  enum class How { Replace, Add, Remove, Toggle, Loop, Ring, Path, Connected, Chain, All };
  /// Loop, Ring, Connected and Chain start at each element; Path joins the first to the last;
  /// All needs none.
  Verdict pick(ComponentKind kind, Elements elements, How how = How::Replace);
  Verdict select_all();
  Verdict select_none();
  Verdict invert_selection();
  Verdict grow_selection();
  Verdict shrink_selection();
  Verdict select_loop();  ///< of all selected edges
  Verdict select_ring();
  Verdict select_connected();
  Verdict select_chain();  ///< whole chains of tagged edges
  Verdict select_boundary();
  Verdict select_tagged();
  Verdict select_between();  ///< the shortest path between two selected vertices or edges
  Verdict select_sharper_than(double degrees);

  // ---- Edits, each one undo step. Continue when there was nothing to do
  Verdict move_selected(const Vec3& by);
  Verdict rotate_selected(const Vec3& axis, double degrees, std::optional<Vec3> pivot = std::nullopt);
  Verdict scale_selected(const Vec3& factors, std::optional<Vec3> pivot = std::nullopt);
  Verdict delete_selected();  ///< faces go; edges and vertices dissolve
  Verdict extrude(const Vec3& by);
  Verdict extrude_along_normal(double distance);
  Verdict cut_loop(Index edge, double at);
  Verdict tag(double sharpness);  ///< selected edges (of faces: their edges); 0 untags
  Verdict untag() { return tag(0); }
  Verdict change_sharpness(double by);
  Verdict tag_edges(const Elements& edges, double sharpness);
  Verdict tag_sharper_than(double degrees, double sharpness = infinite_sharpness);
  std::size_t count_sharper_than(double degrees);  ///< what that would tag, for a live preview
  Verdict tag_boundary(double sharpness = infinite_sharpness);
  Verdict pin(bool pinned);  ///< selected vertices (of edges and faces: their vertices)
  Verdict make_set(const std::string& name, double sharpness = infinite_sharpness);
  Verdict rename_set(const std::string& name, const std::string& new_name);
  Verdict set_set_sharpness(const std::string& name, double sharpness);
  Verdict select_set(const std::string& name);  ///< its edges, or its pins when it has none
  Verdict merge_sets(const std::string& into, const std::string& from);
  Verdict remove_set(const std::string& name, bool untag);
  Verdict set_tags(MeshTags tags, const std::string& label);  ///< any other change of tags

  // ---- Replays. @throws Error (E_INPUT) when the step doesn't fit the mesh
  Verdict replay(const recorded::Pick& step);
  Verdict replay(const recorded::Move& step);
  Verdict replay(const recorded::Rotate& step);
  Verdict replay(const recorded::Scale& step);
  Verdict replay(const recorded::Tag& step);
  Verdict replay(const recorded::Pin& step);
  Verdict replay(const recorded::TagSet& step);
  Verdict replay(const recorded::Extrude& step);
  Verdict replay(const recorded::LoopCut& step);

 private:
  enum class Gesture { None, Press, Box, Handle, Sharpen };
  struct Cache;  ///< what is derived from the mesh

  // Gestures
  Verdict begin(const MeshEvent& event);
  void go_on(const MeshEvent& event);
  Verdict finish(const MeshEvent& event);
  Verdict give_up();
  void end_gesture();
  bool interrupted() const;
  void press(const MeshEvent& event);
  void start_drag();
  void drag_handle(const Vec2& pixel);
  void drag_sharpness(const Vec2& pixel);
  Verdict finish_handle();
  Verdict finish_sharpness();
  Verdict finish_box();
  Verdict click();
  Verdict click_again(Index element);
  Verdict cut_hovered(const MeshEvent& event);
  std::optional<recorded::Step> recorded_motion(const ManipulatorMotion& motion, const Vec3& pivot) const;

  // Selection
  ComponentKind kind() const;
  const Elements& selected() const;
  const Elements& selected_vertices();  ///< of all kinds, and in Object mode of the whole mesh
  Elements selected_edges();
  Elements expanded(ComponentKind kind, Index element, How how);
  Elements path(ComponentKind kind, Index from, Index to);
  Elements face_path(Index from, Index to);
  Verdict choose(ComponentKind kind, Elements elements, std::optional<recorded::Step> step = std::nullopt);
  Verdict choose_if_any(ComponentKind kind, Elements elements);
  Vec3 middle();

  // Edits
  Cache* fresh();    ///< null without a mesh
  Cache* at_hand();  ///< also null while it is being made
  std::string node_name() const;
  std::string counted(const std::string& verb, ComponentKind kind, std::size_t count) const;
  Document with_mesh(PolyMesh mesh) const;
  Verdict commit(const std::string& label, MeshEdit edit, ComponentSelection then);
  Verdict commit_tags(const std::string& label, MeshTags tags, std::optional<recorded::Step> step);
  Verdict transform(const std::string& verb, const Eigen::Affine3d& map, recorded::Step step);

  Session& session_;
  MeshToolOptions options_;
  NodeId node_ = 0;
  MeshMode mode_ = MeshMode::Object;
  MeshHandles handles_ = MeshHandles::Select;
  bool loop_cut_armed_ = false;
  MeshPreview preview_;
  std::optional<recorded::Step> done_;
  Findings notes_;
  std::unique_ptr<Cache> cache_;
  std::future<std::unique_ptr<Cache>> coming_;                     ///< the cache of a big mesh
  std::array<std::shared_ptr<const ComponentSelection>, 3> kept_;  ///< of the modes that are off

  Gesture gesture_ = Gesture::None;
  MeshEvent start_;                           ///< that began the gesture
  Vec2 last_ = Vec2::Zero();                  ///< where the pointer is
  bool may_sharpen_ = false;                  ///< the press was meant for the sharpness if it moves
  std::optional<ManipulatorDrag> drag_;       ///< of a handle
  std::shared_ptr<const PolyMesh> original_;  ///< before the drag
  Elements dragged_;                          ///< vertices, or edges of Sharpen
  std::uint64_t drag_revision_ = 0;           ///< of the session after the drag's last change
  bool dragging_ = false;                     ///< the session's drag has begun

  std::optional<MeshEvent> last_click_;
  Index anchor_ = no_index, anchor_before_ = no_index;  ///< last clicked element, and the one before that
};

}  // namespace croquis
