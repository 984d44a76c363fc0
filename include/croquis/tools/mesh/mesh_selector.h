// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "croquis/mesh_editing/mesh_selection.h"
#include "croquis/tools/mesh/editable_mesh.h"
#include "croquis/tools/mesh/mesh_steps.h"
#include "croquis/tools/pointer/pointer_event.h"

namespace croquis {

/// What clicks and boxes pick. In Object mode they are left to the window.
enum class MeshMode { Object, Vertex, Edge, Face };

/// What becomes of the selection. Loop, Ring, Connected and Chain start at each element; Path joins the first to the
/// last; All needs none.
enum class PickHow { Replace, Add, Remove, Toggle, Loop, Ring, Path, Connected, Chain, All };

/// By its name in recordings: "replace", "loop" …; Replace for any other.
PickHow pick_how(const std::string& name);

/// What the selection becomes by a command. Loop and Ring are of all selected edges, Chain are whole chains of tagged
/// edges, Between is the shortest path between two selected vertices or edges.
enum class Reselect { Invert, Grow, Shrink, Loop, Ring, Connected, Chain, Boundary, Tagged, Between };

/// The mode in which elements of a kind are picked.
MeshMode mode_of(ComponentKind kind);

/// Which elements of a mesh are selected, and how they come to be. Selections come back with undo.
/// Commands give Continue when nothing changed.
class MeshSelector {
 public:
  /// @param source, log outlive this
  /// @param mode_set   called when a mode is chosen, before it counts; true: another one than before
  MeshSelector(EditableMesh& editable, CommandLog& log, std::function<void(bool changes)> mode_set)
      : editable_(editable), log_(log), mode_set_(std::move(mode_set)) {}

  // ---- Modes
  MeshMode mode() const { return mode_; }
  void set_mode(MeshMode mode);  ///< F8 … F11; another kind empties no selection: it is kept for its mode
  /// Turns the selection into another kind and changes the mode (Ctrl+F9 … F11).
  Verdict convert_to(MeshMode mode, ConvertRule rule = ConvertRule::Touching);

  // ---- What is selected
  ComponentKind kind() const;  ///< of the mode; Edge in Object mode
  const Elements& selected() const;
  const Elements& selected_vertices();  ///< of all kinds, and in Object mode of the whole mesh
  Elements selected_edges();
  Vec3 middle();  ///< of the box around selected_vertices(); needs a mesh
  /// "Move 3 vertices", in Object mode "Move bolt".
  std::string counted(const std::string& verb, ComponentKind kind, std::size_t count) const;

  // ---- Commands
  Verdict pick(ComponentKind kind, Elements elements, PickHow how = PickHow::Replace);
  /// Selects these. @param step what is recorded; none: a Pick of them
  Verdict choose(ComponentKind kind, Elements elements, std::optional<recorded::Step> step = std::nullopt);
  Verdict select_all();
  Verdict select_none();
  Verdict reselect(Reselect how);

  // ---- Parts of a mesh that has been prepared
  Elements expanded(ComponentKind kind, Index element, PickHow how);
  Elements path(ComponentKind kind, Index from, Index to);

 private:
  Elements found_by(ComponentKind kind, Elements elements, PickHow how);
  Elements face_path(Index from, Index to);
  Verdict choose_if_any(ComponentKind kind, Elements elements);
  void forget_other_connectivity();

  EditableMesh& editable_;
  CommandLog& log_;
  std::function<void(bool)> mode_set_;
  MeshMode mode_ = MeshMode::Object;
  std::array<std::shared_ptr<const ComponentSelection>, 3> kept_;  ///< of the modes that are off …
  std::uint64_t kept_connectivity_ = 0;                            ///< … and the connectivity they are for

  Elements vertices_;                                      ///< selected_vertices() …
  std::shared_ptr<const ComponentSelection> vertices_of_;  ///< … of this selection …
  bool all_vertices_ = false;                              ///< … or of the whole mesh …
  std::uint64_t vertices_connectivity_ = 0;                ///< … with this connectivity
};

}  // namespace croquis
