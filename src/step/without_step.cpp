// SPDX-License-Identifier: GPL-3.0-or-later
#include "croquis/base/error.h"
#include "step/step_file.h"

/// Stands for write_step.cpp in builds without OpenCASCADE.
namespace croquis {

std::string why_no_step() {
  return "This program was built without OpenCASCADE, which writes STEP files: install the Debian package "
         "libocct-data-exchange-dev (scripts/setup step), then build Croquis again.";
}

StepFile write_step(const Brep&, const StepOptions&, Progress&) {
  throw Error(make_error(Category::Usage, "E_NO_STEP", why_no_step()));
}

}  // namespace croquis
