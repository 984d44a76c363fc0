// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// Everything that makes sketches, in one include.
#include "support/sketch.h"
#include "support/sketch_errors.h"
#include "support/sketch_gallery.h"
#include "support/sketch_layers.h"
#include "support/sketch_modifiers.h"
#include "support/sketch_svg.h"
#include "support/sketch_tubes.h"
