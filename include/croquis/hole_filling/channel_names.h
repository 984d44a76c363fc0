// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace croquis::hole_filling {

/// Channels that filled and remeshed models carry.
inline constexpr const char* patch_channel = "patch_id";
inline constexpr const char* confidence_channel = "confidence";

}  // namespace croquis::hole_filling
