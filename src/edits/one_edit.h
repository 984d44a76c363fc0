// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <limits>
#include <memory>

#include "croquis/edits/edit.h"

/// One function for each edit; all_edits.cpp lists them.
namespace croquis {

inline constexpr double unlimited_value = std::numeric_limits<double>::infinity();

std::unique_ptr<const Edit> make_move_edit();
std::unique_ptr<const Edit> make_rotate_edit();
std::unique_ptr<const Edit> make_scale_edit();
std::unique_ptr<const Edit> make_extrude_edit();
std::unique_ptr<const Edit> make_inset_edit();
std::unique_ptr<const Edit> make_loop_cut_edit();
std::unique_ptr<const Edit> make_dissolve_edit();
std::unique_ptr<const Edit> make_delete_edit();
std::unique_ptr<const Edit> make_sharpness_edit();
std::unique_ptr<const Edit> make_pin_edit();

}  // namespace croquis
