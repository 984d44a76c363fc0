// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "croquis/io/project_file.h"
#include "support/random.h"

/// Projects with everything in them that a document can hold, and how they differ.
namespace croquis::test {

PolyMesh random_mesh(Random& random);
Drawing random_drawing(Random& random);
Report random_report(Random& random);
Camera random_camera(Random& random);
PerspectiveDrawing random_perspective_drawing(Random& random);
CurveNetwork random_network(Random& random);
Brep random_brep(Random& random);  ///< valid, its curves and patches anywhere
AttributeNetwork random_attribute_network(Random& random);

/// Sources and operations with parameters and links; texts of any bytes, numbers of any bits. Ids have gaps.
Document random_document(Random& random, std::uint32_t nodes);

/// Any bytes, rarely many.
std::string random_text(Random& random);

/// The first node with a difference in anything that a project keeps; empty when there is none.
std::string difference(const Document& a, const Document& b);

}  // namespace croquis::test
