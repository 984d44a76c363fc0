// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace croquis::test {

/// Sanitizers keep a shadow of all memory: what is allocated can't be counted, and limits of address space don't work.
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
inline constexpr bool is_sanitized = true;
#else
inline constexpr bool is_sanitized = false;
#endif

/// Programs begin and run more slowly under sanitizers.
inline constexpr int slowness = is_sanitized ? 10 : 1;

}  // namespace croquis::test
