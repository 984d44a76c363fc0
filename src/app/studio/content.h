// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <string>

#include "app/studio/studio.h"
#include "croquis/geometry/camera.h"

/// How what files and galleries hold comes into a studio.
namespace croquis::app {

/// The parameters that a new step of an operation starts with; those not named have the operation's own defaults.
ParameterValues first_parameters(const Studio& studio, const std::string& operation);

/// Replaces the document by one drawing and the solid made of it; forgets the history.
void start_with(Studio& studio, Drawing drawing);  ///< of exact lines; its parts are held as it suggests
void start_with(Studio& studio, PerspectiveDrawing drawing, const std::string& name = {});
void start_with(Studio& studio, AttributeNetwork network, const std::string& name = {});

/// Replaces the document by a value with one step after it; forgets the history.
void start_with(Studio& studio, const std::string& name, Value value, const std::string& operation);

/// Puts a picture behind the drawing that is shown; a sheet without strokes becomes as large as the picture. Where no
/// drawing is shown, one begins: a sketch where one was about to be drawn, else a drawing in perspective.
void add_picture(Studio& studio, std::shared_ptr<const PictureFile> picture);

/// Adds a drawing of a picture's lines with the solid made of it; it takes the place of a sketch without strokes.
void add_traced(Studio& studio, std::shared_ptr<const Drawing> drawing);

/// States the camera of the sheet that is shown: its field of view and principal point. Without a sheet, an empty
/// one of the camera's picture begins.
void state_camera(Studio& studio, const Camera& camera);

}  // namespace croquis::app
