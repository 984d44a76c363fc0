// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <optional>
#include <string>

#include "croquis/document/backdrop.h"
#include "croquis/session/session.h"
#include "croquis/tools/pointer/session_drag.h"
#include "croquis/tools/pointer/verdict.h"
#include "croquis/tools/recording/step.h"
#include "croquis/tools/strokes/sketch_event.h"

namespace croquis {

/// Changes the picture behind one drawing of a session: by the hand on the plane that is drawn on, and by numbers.
///
/// A drag that begins at a corner of the picture scales it about the opposite corner, any other one moves it. Every
/// gesture and every command is one undo step. The session outlives the editor. Everything on the session's thread.
class BackdropEditor {
 public:
  /// @param corner_pixels how far from a corner the pointer may be, of the view
  explicit BackdropEditor(Session& session, double corner_pixels = 14)
      : session_(session), corner_pixels_(corner_pixels), drag_(session) {}

  void set_node(NodeId drawing) { node_ = drawing; }
  NodeId node() const { return node_; }
  std::shared_ptr<const Backdrop> backdrop() const;  ///< or null

  Verdict handle(const SketchEvent& event);
  bool active() const { return gesture_ != Gesture::None; }

  // Commands; Continue where there is no picture or nothing changed.
  // @throws Error (E_INPUT) for numbers that are out of range

  Verdict set(const std::string& label, const Backdrop& backdrop);
  Verdict fit();  ///< to the sheet or the strokes
  Verdict remove();

  /// Many values of one step, as of a slider: `change` until `finish`. @throws as above
  void change(const std::string& label, const Backdrop& backdrop);
  Verdict finish();
  Verdict give_up();

  /// What the last Commit did, for recordings.
  const std::optional<recorded::Step>& done() const { return done_; }

 private:
  enum class Gesture { None, Move, Scale, Change };

  void begin(const SketchEvent& event);
  void go_on(const SketchEvent& event);
  void drag_to(const Backdrop& backdrop);
  void require_valid(const Backdrop& backdrop) const;

  Session& session_;
  double corner_pixels_;
  NodeId node_ = 0;
  Gesture gesture_ = Gesture::None;
  SessionDrag drag_;
  std::shared_ptr<const Backdrop> before_;  ///< the gesture
  Vec2 from_ = Vec2::Zero();                ///< where it began
  Vec2 fixed_ = Vec2::Zero();               ///< Scale: the corner that stays
  std::optional<recorded::Step> done_;
};

}  // namespace croquis
