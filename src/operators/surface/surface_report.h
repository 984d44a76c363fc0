// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "croquis/base/report.h"
#include "croquis/geometry/attribute_network.h"
#include "croquis/operators/surface_result.h"

namespace croquis {

/// The `details` of the report.
Report to_report(const AttributeNetwork& network, const SurfaceResult& result);

}  // namespace croquis
