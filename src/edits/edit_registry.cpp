// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <utility>

#include "croquis/base/error.h"
#include "croquis/edits/edit.h"

namespace croquis {

void EditRegistry::add(std::unique_ptr<const Edit> edit) {
  if (find(edit->describe().id) != nullptr) {
    throw Error(make_error(Category::Internal, "E_INTERNAL", "Two edits are called '" + edit->describe().id + "'."));
  }
  edits_.push_back(std::move(edit));
}

const Edit* EditRegistry::find(std::string_view id) const {
  const auto found =
      std::find_if(edits_.begin(), edits_.end(), [&](const auto& edit) { return edit->describe().id == id; });
  return found == edits_.end() ? nullptr : found->get();
}

}  // namespace croquis
