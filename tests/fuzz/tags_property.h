// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>

/// What must hold for any bytes that are read as JSON and as tags: shared by the fuzzer and the tests.
namespace croquis::test {

/// Reading either throws an Error with findings, or gives a report whose JSON reads back as the same JSON; where that
/// is read as tags, they come back the same.
/// @return what did not hold; empty when all did
std::string broken_tags(std::string_view bytes);

}  // namespace croquis::test
