// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstring>

/// Arithmetic on eight doubles at once, in plain C++ operators.
///
/// The compiler maps it to whatever registers there are. Every lane is computed as a double on its own and nothing is
/// contracted (-ffp-contract=off), so that all machines give the same bits.
namespace croquis::implicit {

inline constexpr std::size_t lane_count = 8;
using Lanes = double __attribute__((vector_size(lane_count * sizeof(double))));

inline void load(Lanes& lanes, const double* values) { std::memcpy(&lanes, values, sizeof(Lanes)); }
inline void store(const Lanes& lanes, double* values) { std::memcpy(values, &lanes, sizeof(Lanes)); }

/// The sum over the lanes, always in the same order.
inline double sum(const Lanes& v) { return ((v[0] + v[4]) + (v[2] + v[6])) + ((v[1] + v[5]) + (v[3] + v[7])); }

inline std::size_t whole_lanes(std::size_t count) { return (count + lane_count - 1) / lane_count * lane_count; }

}  // namespace croquis::implicit

/// Compiles a function for several instruction sets; the machine's best one is taken when the program starts. Not with
/// sanitizers, whose start-up code runs later than that choice.
#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__) && !defined(__SANITIZE_ADDRESS__) && \
    !defined(__SANITIZE_THREAD__)
#define CROQUIS_FOR_EVERY_MACHINE __attribute__((target_clones("avx512f", "avx2", "default")))
#else
#define CROQUIS_FOR_EVERY_MACHINE
#endif

/// For the parts of such a function: compiled into it, for its instruction set.
#define CROQUIS_PART inline __attribute__((always_inline))
