// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// Everything that makes sketches, in one include.
#include "support/sketches/sketch.h"
#include "support/sketches/sketch_errors.h"
#include "support/sketches/sketch_figures.h"
#include "support/sketches/sketch_gallery.h"
#include "support/sketches/sketch_hand.h"
#include "support/sketches/sketch_layers.h"
#include "support/sketches/sketch_modifiers.h"
#include "support/sketches/sketch_svg.h"
#include "support/sketches/sketch_tubes.h"
