// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>

/// What must hold for any bytes that are read as attribute networks: shared by the fuzzer and the tests.
namespace croquis::test {

/// Reading either throws an Error with findings, or gives a valid network that comes back the same through its file.
/// @return what did not hold; empty when all did
std::string broken_attribute_network(std::string_view bytes);

}  // namespace croquis::test
