// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "croquis/geometry/poly_mesh.h"
#include "croquis/subdivision/rules.h"
#include "support/random.h"

namespace croquis::test {

/// Tags on some, all or no edges, with sharpness of all kinds, and pins.
/// @param all_infinite without finite sharpness
void add_random_tags(PolyMesh& mesh, Random& random, bool all_infinite);

/// A preset, or switches set one by one.
subdivision::Rules random_rules(Random& random);

/// The same faces in another order, each beginning at another corner; vertices and tags stay.
PolyMesh with_faces_shuffled(const PolyMesh& mesh, Random& random);

}  // namespace croquis::test
