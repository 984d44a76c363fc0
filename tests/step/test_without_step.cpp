// SPDX-License-Identifier: GPL-3.0-or-later
#include <catch2/catch.hpp>

#include "croquis/base/error.h"
#include "step/step_file.h"

using namespace croquis;

TEST_CASE("without OpenCASCADE, writing STEP says what to install (other tests of STEP are left out)") {
  Progress progress;
  try {
    write_step({}, {}, progress);
    FAIL("nothing was thrown");
  } catch (const Error& error) {
    CHECK(error.findings()[0].code == "E_NO_STEP");
    CHECK(error.findings()[0].category == Category::Usage);
    CHECK(error.findings()[0].message.find("libocct-data-exchange-dev") != std::string::npos);
  }
}
