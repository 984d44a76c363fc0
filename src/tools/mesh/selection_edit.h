// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <utility>

#include "croquis/edits/edit_line.h"

namespace croquis {

/// An edit of these elements.
inline EditLine edit_of(std::string edit, ComponentKind kind, Elements elements, ParameterValues parameters = {}) {
  EditLine line;
  line.edit = std::move(edit);
  line.target.kind = kind;
  line.target.elements = std::move(elements);
  line.parameters = std::move(parameters);
  return line;
}

}  // namespace croquis
