// SPDX-License-Identifier: GPL-3.0-or-later
#include "fuzz/places_property.h"

#include "croquis/base/error.h"
#include "croquis/io/json.h"
#include "croquis/io/surface_places_file.h"

namespace croquis::test {

std::string broken_surface_places(std::string_view bytes) {
  try {
    const SurfacePlacesReadResult read = read_surface_places(read_json(bytes, "fuzzed"));
    if (read.warnings.size() > 200) return "too many warnings";
    const std::string written = write_json(report_of(read.places));
    if (written.find("\xef\xbf\xbd") != std::string::npos) return "";  // bytes that are no UTF-8 don't come back
    const SurfacePlacesReadResult again = read_surface_places(read_json(written, "fuzzed"));
    if (!again.warnings.empty()) return "the written places have unknown members";
    return again.places == read.places ? "" : "the written places read back differently";
  } catch (const Error& error) {
    if (!has_errors(error.findings())) return "an error without errors";
    for (const Finding& finding : error.findings()) {
      if (finding.code.empty() || finding.message.empty()) return "a finding without a name";
      if (finding.category != Category::Malformed) return "a finding of another kind";
    }
    return error.findings().size() > 200 ? "too many findings" : "";
  }
}

}  // namespace croquis::test
