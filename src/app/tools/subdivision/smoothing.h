// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "app/studio/studio.h"

/// The subdivision of the active object, as keys and menus change it: an operation between its cage and what is seen,
/// so nothing is lost. Everything but what keys 1 to 3 show is one step of the history.
namespace croquis::app {

/// Shows the cage, both, or the smooth surface; for all but the cage the object gets the operation if it has none.
void show_smooth(Studio& studio, ChainView view);

/// Of the active object; -1 where it isn't subdivided.
int shown_level(const Studio& studio);

/// One level finer or coarser, within what the operation allows.
void change_level(Studio& studio, int by);

/// Gives the operation's parameter another value. @return whether there is such an operation
bool set_smoothing(Studio& studio, const std::string& parameter, const ParameterValue& value);

/// What is computed, a level or a scan with filled holes, becomes a mesh of its own, with its tags and patches; the old
/// object is hidden.
/// @throws Error (E_EMPTY) when nothing computed is seen, or it isn't finished
void freeze_level(Studio& studio);

enum class KeptShape { Faces, Outline };

/// Makes the active object's selected faces stay as they are on every level, or only their outline, by tags and pins;
/// bent faces are cut into triangles first. One step of the history.
/// @return what had to be done to the faces
/// @throws Error (E_EMPTY) when no faces are selected
Findings keep_selected_faces(Studio& studio, KeptShape kept);

}  // namespace croquis::app
