// SPDX-License-Identifier: GPL-3.0-or-later
#include "croquis/subdivision/rules.h"

namespace croquis::subdivision {

Rules Rules::of(Preset preset) {
  if (preset == Preset::Refined) return {};
  return {Weights::Average, Profile::Plain, ChainEnds::Retract, BoundaryCorners::Corner};
}

}  // namespace croquis::subdivision
