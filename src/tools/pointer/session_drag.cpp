// SPDX-License-Identifier: GPL-3.0-or-later
#include "croquis/tools/pointer/session_drag.h"

#include <utility>

namespace croquis {

void SessionDrag::begin(const std::string& label) {
  session_.begin_drag(label);
  begun_ = true;
  revision_ = session_.revision();
}

void SessionDrag::to(Document edited) {
  revision_ = session_.revision() + 1;  // what listeners see while they are notified
  session_.drag(std::move(edited));
  revision_ = session_.revision();
}

void SessionDrag::select(ComponentSelection components) {
  revision_ = session_.revision() + 1;
  session_.select_components(std::move(components));
  revision_ = session_.revision();
}

void SessionDrag::end() {
  if (std::exchange(begun_, false)) session_.end_drag();
}

void SessionDrag::cancel() {
  const bool owns_document = begun_ && !interrupted();
  begun_ = false;
  if (owns_document) session_.cancel_drag();
}

}  // namespace croquis
