// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

#include "app/studio/studio.h"

namespace croquis::app {

/// "About 9 s and 1.1 GB": what remeshing a scan costs with the parameters of a `fill` operation, before it begins.
QString estimate_sentence(const Studio& studio, const Node& node, const PolyMesh& scan);

}  // namespace croquis::app
