// SPDX-License-Identifier: GPL-3.0-or-later
#include "edits/one_edit.h"

namespace croquis {

const EditRegistry& all_edits() {
  static const EditRegistry registry = [] {
    EditRegistry made;
    made.add(make_move_edit());
    made.add(make_rotate_edit());
    made.add(make_scale_edit());
    made.add(make_extrude_edit());
    made.add(make_inset_edit());
    made.add(make_loop_cut_edit());
    made.add(make_dissolve_edit());
    made.add(make_delete_edit());
    made.add(make_sharpness_edit());
    made.add(make_pin_edit());
    return made;
  }();
  return registry;
}

}  // namespace croquis
