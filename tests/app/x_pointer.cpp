// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/x_pointer.h"

#include <array>
#include <cstdint>
#include <stdexcept>

#include <xcb/xcb.h>
#include <xcb/xcbext.h>

namespace croquis::test {
namespace {

// The one request that is needed of XTEST 2.2, whose own library need not be installed.
xcb_extension_t xtest = {"XTEST", 0};
constexpr std::uint8_t fake_input = 2;
constexpr std::uint8_t left_button = 1;

struct FakeInput {
  std::array<std::uint8_t, 4> header{};  // filled in by xcb
  std::uint8_t kind = 0;
  std::uint8_t detail = 0;
  std::uint16_t unused = 0;
  std::uint32_t after_ms = 0;
  std::uint32_t root = 0;
  std::array<std::uint32_t, 2> more_unused{};
  std::int16_t x = 0;
  std::int16_t y = 0;
  std::array<std::uint8_t, 7> still_unused{};
  std::uint8_t device = 0;
};
static_assert(sizeof(FakeInput) == 36);

}  // namespace

XPointer::XPointer() : connection_(xcb_connect(nullptr, nullptr)) {
  const xcb_query_extension_reply_t* found =
      xcb_connection_has_error(connection_) != 0 ? nullptr : xcb_get_extension_data(connection_, &xtest);
  if (found == nullptr || found->present == 0) throw std::runtime_error("the display has no XTEST");
  root_ = xcb_setup_roots_iterator(xcb_get_setup(connection_)).data->root;
}

XPointer::~XPointer() { xcb_disconnect(connection_); }

void XPointer::send(Kind kind, const QPoint& place, int after_ms) {
  FakeInput request;
  request.kind = static_cast<std::uint8_t>(kind);
  request.detail = kind == Kind::Motion ? 0 : left_button;
  request.after_ms = static_cast<std::uint32_t>(after_ms);
  request.root = root_;
  request.x = static_cast<std::int16_t>(place.x());
  request.y = static_cast<std::int16_t>(place.y());
  // xcb writes in front of what it is given.
  std::array<iovec, 4> parts{};
  parts[2] = {&request, sizeof(request)};
  const xcb_protocol_request_t protocol{2, &xtest, fake_input, 1};
  xcb_send_request(connection_, 0, parts.data() + 2, &protocol);
}

void XPointer::move(const QPoint& place) {
  send(Kind::Motion, place, 0);
  xcb_flush(connection_);
}

void XPointer::drag(const std::vector<QPoint>& places, int pace_ms) {
  send(Kind::Motion, places.front(), 0);
  send(Kind::Press, places.front(), pace_ms);
  for (std::size_t i = 1; i < places.size(); ++i) send(Kind::Motion, places[i], pace_ms);
  send(Kind::Release, places.back(), pace_ms);
  xcb_flush(connection_);
}

}  // namespace croquis::test
