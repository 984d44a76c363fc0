// SPDX-License-Identifier: GPL-3.0-or-later
#include <iostream>
#include <map>
#include <string>
#include <vector>

#include "bench/bench.h"

int main(int argc, char** argv) {
  using namespace croquis::bench;
  const std::map<std::string, void (*)(std::ostream&)> benches = {{"holes", bench_holes},
                                                                  {"implicit", bench_implicit},
                                                                  {"readers", bench_readers},
                                                                  {"silhouette", bench_silhouette},
                                                                  {"solver", bench_solver},
                                                                  {"subdivision", bench_subdivision}};
  std::vector<std::string> chosen(argv + 1, argv + argc);
  if (chosen.empty()) chosen = {"readers", "solver", "silhouette", "subdivision", "implicit", "holes"};
  for (const std::string& name : chosen) {
    const auto bench = benches.find(name);
    if (bench == benches.end()) {
      std::cerr << "There is no benchmark '" << name << "': use holes, implicit, readers, silhouette, solver or subdivision.\n";
      return 2;
    }
    std::cout << "# " << name << "\n\n";
    bench->second(std::cout);
    std::cout << std::endl;
  }
  return 0;
}
