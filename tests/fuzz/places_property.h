// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>

/// What must hold for any bytes that are read as places of a surface: shared by the fuzzer and the tests.
namespace croquis::test {

/// Reading either throws an Error with findings, or gives places that come back the same through their file.
/// @return what did not hold; empty when all did
std::string broken_surface_places(std::string_view bytes);

}  // namespace croquis::test
