// SPDX-License-Identifier: GPL-3.0-or-later
#include "bench/scans/bench_holes.h"

#include <iomanip>
#include <map>
#include <stdexcept>

#include "bench/bench.h"

namespace croquis::bench {

void bench_holes(std::ostream& out, const std::vector<std::string>& sections) {
  using Section = void (*)(std::ostream&);
  const std::map<std::string, Section> known = {{"accuracy", report_hole_accuracy},
                                                {"growth", report_hole_growth},
                                                {"rims", report_long_rims},
                                                {"speed", report_hole_speed}};
  out << std::setprecision(3) << "Processor time on one thread, where nothing else is said.\n";
  const std::vector<std::string> all = {"accuracy", "growth", "rims", "speed"};
  const std::vector<std::string>& chosen = sections.empty() ? all : sections;
  for (std::size_t i = 0; i < chosen.size(); ++i) {
    out << "\n## " << chosen[i] << "\n\n";
    if (known.contains(chosen[i])) {
      known.at(chosen[i])(out);
    } else if (chosen[i] == "external" && i + 1 < chosen.size()) {
      report_external_holes(out, chosen[++i]);
    } else {
      throw std::invalid_argument("Sections of holes: accuracy, growth, rims, speed, external FOLDER.");
    }
  }
}

}  // namespace croquis::bench
