// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/replay/step_players.h"

#include "app/replay/replay_lookup.h"
#include "app/replay/replay_player.h"
#include "app/views/viewport.h"
#include "app/window/main_window.h"
#include "croquis/tools/silhouette/sketch_steps.h"

namespace croquis::app {
namespace {

// ---- Sketches

void play_stroke(MainWindow& window, const recorded::StrokeDrawn& step) {
  if (window.shows_start_page()) window.start_sketch();
  window.viewport().sketch().replay_gesture(step.points, step.device == "eraser", {}, step.scale);
}

void play_drag(MainWindow& window, const recorded::Drag& step) {
  window.viewport().tool().drag(step.stroke, step.anchor, step.by);
}

// ---- Meshes

void play_model_drag(MainWindow& window, const recorded::ModelDrag& step) {
  window.viewport().mesh().replay(view_of(step.view), step.from, step.to, modifiers_of(step.modifiers), 1);
}

template <typename MeshStep>
void play_on_mesh(MainWindow& window, const MeshStep& step) {
  Studio& studio = window.studio();
  if (!step.node.empty()) studio.set_active(object_named(studio, step.node).node);
  MeshInteraction& mesh = window.viewport().mesh();
  mesh.follow();
  mesh.tool().replay(step);
  mesh.follow();
}

void play_pick(MainWindow& window, const recorded::Pick& step) {
  const MeshMode mode = step.kind == "vertex" ? MeshMode::Vertex
                        : step.kind == "face" ? MeshMode::Face
                                              : MeshMode::Edge;
  MeshInteraction& mesh = window.viewport().mesh();
  if (mesh.tool().selection().mode() != mode) mesh.set_mode(mode);
  play_on_mesh(window, step);
}

void play_edit(MainWindow& window, const recorded::EditStep& step) {
  MeshInteraction& mesh = window.viewport().mesh();
  const MeshMode before = mesh.tool().selection().mode();
  play_on_mesh(window, step);
  const MeshMode after = mesh.tool().selection().mode();
  if (after != before) mesh.set_mode(after);  // the window's buttons follow
}

void play_face_sets(MainWindow& window, const recorded::FaceSetChoice& step) {
  wait_until_settled(window);
  window.select_face_sets(object_named(window.studio(), step.node).node, step.names);
}

// ---- Holes

template <typename HoleStep>
void play_on_holes(MainWindow& window, const HoleStep& step) {
  if (!step.node.empty()) window.studio().set_active(object_named(window.studio(), step.node).node);
  HoleInteraction& holes = window.viewport().holes();
  if (!holes.active()) refuse_replay("No holes are being worked on: the action \"holes\" opens them");
  wait_until_settled(window);  // their numbers are known once they have been found
  holes.replay(step);
}

template <typename T>
void add_player(StepPlayers& players, void (*play)(MainWindow&, const T&)) {
  players[&T::step_kind()] = [play](MainWindow& window, const recorded::Step& step) { play(window, *step.as<T>()); };
}

StepPlayers make_step_players() {
  StepPlayers made;
  add_player(made, play_stroke);
  add_player(made, play_drag);
  add_player(made, play_model_drag);
  add_player(made, play_pick);
  add_player(made, play_edit);
  add_player(made, play_on_mesh<recorded::Move>);
  add_player(made, play_on_mesh<recorded::Rotate>);
  add_player(made, play_on_mesh<recorded::Scale>);
  add_player(made, play_on_mesh<recorded::Tag>);
  add_player(made, play_on_mesh<recorded::Pin>);
  add_player(made, play_on_mesh<recorded::TagSet>);
  add_player(made, play_on_mesh<recorded::Extrude>);
  add_player(made, play_on_mesh<recorded::LoopCut>);
  add_player(made, play_face_sets);
  add_player(made, play_on_holes<recorded::HoleChoice>);
  add_player(made, play_on_holes<recorded::HoleWay>);
  add_player(made, play_on_holes<recorded::HolePoint>);
  return made;
}

}  // namespace

const StepPlayers& step_players() {
  static const StepPlayers made = make_step_players();
  return made;
}

}  // namespace croquis::app
