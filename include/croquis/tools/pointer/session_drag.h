// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>

#include "croquis/session/session.h"

namespace croquis {

/// The drag of a session that a tool's gesture makes: many changes of the document, one step of the history.
///
/// Whatever else changes the session meanwhile interrupts it, and owns the document from then on. The tool's own
/// changes don't, not even for those who are notified of them. The session outlives it. Everything on its thread.
class SessionDrag {
 public:
  explicit SessionDrag(Session& session) : session_(session) {}

  void begin(const std::string& label);  ///< of the step
  void to(Document edited);
  void select(ComponentSelection components);  ///< in the document dragged to

  bool begun() const { return begun_; }  ///< and neither ended nor cancelled
  bool interrupted() const { return begun_ && session_.revision() != revision_; }

  void end();
  void cancel();  ///< goes back to the beginning; leaves the session alone when it was interrupted

 private:
  Session& session_;
  bool begun_ = false;
  std::uint64_t revision_ = 0;  ///< of the session after the last change
};

}  // namespace croquis
