// SPDX-License-Identifier: GPL-3.0-or-later
#include "croquis/tools/all_steps.h"

#include "croquis/tools/backdrop/backdrop_steps.h"
#include "croquis/tools/holes/hole_steps.h"
#include "croquis/tools/measure/measure_steps.h"
#include "croquis/tools/mesh/mesh_steps.h"
#include "croquis/tools/perspective/perspective_steps.h"
#include "croquis/tools/recording/general_steps.h"
#include "croquis/tools/silhouette/sketch_steps.h"
#include "croquis/tools/surface/surface_steps.h"

namespace croquis::recorded {

const Vocabulary& all_steps() {
  static const Vocabulary vocabulary = [] {
    Vocabulary made;
    made.add(general_steps());
    made.add(sketch_steps());
    made.add(mesh_steps());
    made.add(hole_steps());
    made.add(measure_steps());
    made.add(perspective_steps());
    made.add(backdrop_steps());
    made.add(surface_steps());
    return made;
  }();
  return vocabulary;
}

}  // namespace croquis::recorded
