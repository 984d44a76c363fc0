// SPDX-License-Identifier: GPL-3.0-or-later
#include <catch2/catch.hpp>

#include "operators/inflate_operation.h"
#include "support/check_operation.h"
#include "support/sketch_errors.h"
#include "support/sketch_gallery.h"

namespace croquis {
namespace {

Values inputs_of(const Drawing& drawing) { return {{"drawing", std::make_shared<const Drawing>(drawing)}}; }

TEST_CASE("inflating is a function of drawing and parameters") {
  test::check_operation(InflateOperation(), inputs_of(test::snake_sketch().drawing), {{"resolution", 10.0}});
  test::check_operation(InflateOperation(), inputs_of(test::circle_sketch().drawing),
                        {{"resolution", 10.0}, {"preset", std::string("tablet")}});
}

TEST_CASE("inflating refuses a drawing with the same findings every time") {
  test::check_operation(InflateOperation(), inputs_of(test::error_sketch("E_TWO_SIDED").drawing), {});
}

}  // namespace
}  // namespace croquis
