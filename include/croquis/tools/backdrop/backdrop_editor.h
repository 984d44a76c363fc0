// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <optional>
#include <string>

#include "croquis/document/backdrop.h"
#include "croquis/document/document.h"
#include "croquis/session/session.h"
#include "croquis/tools/pointer/pointer_event.h"
#include "croquis/tools/pointer/session_drag.h"
#include "croquis/tools/recording/step.h"
#include "croquis/tools/strokes/sketch_event.h"

namespace croquis {

/// A rectangle on the plane that is drawn on, x right, y UP.
struct BackdropArea {
  Vec2 low = Vec2::Zero();
  Vec2 high = Vec2::Zero();
};

/// What a picture behind that drawing is fitted into: the sheet of one in perspective, the strokes of a sketch, or the
/// place where a first stroke would be drawn.
BackdropArea backdrop_area(const Node& drawing);

/// The picture in the middle of the area, as large as fits.
Backdrop fitted(std::shared_ptr<const PictureFile> picture, const BackdropArea& area);

/// The area that it covers.
BackdropArea area_of(const Backdrop& backdrop);

/// The size of a sheet for that picture, px: its own, made smaller where its longer side has more than `longest`.
Vec2 sheet_for(const PictureFile& picture, double longest = 4096);

/// The document with that picture behind a drawing, or without one. @pre the node is there
Document with_backdrop(const Document& document, NodeId drawing, std::optional<Backdrop> backdrop);

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
