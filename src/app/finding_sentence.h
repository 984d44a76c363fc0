// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

#include "croquis/base/finding.h"

namespace croquis::app {

/// What a finding says to people who see the place it is about: its sentence without coordinates.
QString sentence_in_view(const Finding& finding);

}  // namespace croquis::app
