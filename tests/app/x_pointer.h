// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QPoint>
#include <vector>

struct xcb_connection_t;

namespace croquis::test {

/// The pointer of the X server itself (XTEST): its events come to the window as a mouse's do, through the server and
/// Qt's queue, and the server keeps their pace whatever the window is doing.
class XPointer {
 public:
  /// Of the display named in the environment. @throws std::runtime_error
  XPointer();
  ~XPointer();
  XPointer(const XPointer&) = delete;
  XPointer& operator=(const XPointer&) = delete;

  void move(const QPoint& place);

  /// The left button goes down at the first place, the pointer to all others, the button up. Returns at once.
  /// @param places  pixels of the screen, neighbours different
  /// @param pace_ms between two events, by the server's clock
  void drag(const std::vector<QPoint>& places, int pace_ms);

 private:
  enum class Kind : unsigned char { Press = 4, Release = 5, Motion = 6 };
  void send(Kind kind, const QPoint& place, int after_ms);

  xcb_connection_t* connection_;
  unsigned root_ = 0;
};

}  // namespace croquis::test
