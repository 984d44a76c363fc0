// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
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

/// ln x for positive normal x, without branches so that loops over it vectorise.
///
/// x = 2^e m with m in [sqrt(1/2), sqrt 2); ln m = 2 artanh s = 2 (s + s^3/3 + s^5/5 ...), s = (m - 1)/(m + 1). With
/// s^2 <= 0.0295 the first term left out is below 2^-56 of the sum.
inline double log_of_normal(double x) {
  constexpr std::uint64_t root_half = 0x3fe6a09e667f3bcdU;  // bits of sqrt(1/2)
  const std::uint64_t bits = std::bit_cast<std::uint64_t>(x) - root_half;
  // The exponent as a double without an integer conversion, which older instruction sets can't vectorise: its biased
  // bits go into the mantissa of 2^52.
  const double biased = std::bit_cast<double>((((bits + (std::uint64_t{1024} << 52)) >> 52)) | 0x4330000000000000U);
  const double e = biased - (0x1p52 + 1024);
  const double m = std::bit_cast<double>((bits & 0x000fffffffffffffU) + root_half);
  const double s = (m - 1) / (m + 1);
  const double z = s * s;
  double sum = 1.0 / 19;
  for (const double divisor : {17.0, 15.0, 13.0, 11.0, 9.0, 7.0, 5.0, 3.0}) sum = sum * z + 1 / divisor;
  const double tail = 2 * s * z * sum;
  constexpr double high = 0x1.62e42fefa38p-1;  // ln 2 in two parts: e * high is exact
  constexpr double low = 0x1.ef35793c7673p-45;
  return e * high + (2 * s + (tail + e * low));
}

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
