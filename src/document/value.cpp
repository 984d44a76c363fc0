// SPDX-License-Identifier: GPL-3.0-or-later
#include "croquis/document/value.h"

namespace croquis {

const char* to_string(ValueType type) {
  switch (type) {
    case ValueType::Mesh: return "mesh";
    case ValueType::Drawing: return "drawing";
    case ValueType::Report: return "report";
  }
  return "value";
}

}  // namespace croquis
