// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <functional>
#include <iostream>
#include <string>
#include <utility>
#include <vector>

#include "bench/bench.h"

namespace {

using Words = std::vector<std::string>;

struct Benchmark {
  std::string name;
  std::function<void(std::ostream&, const Words&)> run;
  bool takes_words = false;  ///< that stand behind its name
  bool is_usual = false;     ///< runs when none is named
};

const std::vector<Benchmark>& benches() {
  using namespace croquis::bench;
  const auto plain = [](void (*bench)(std::ostream&)) {
    return [bench](std::ostream& out, const Words&) { bench(out); };
  };
  static const std::vector<Benchmark> all = {{"readers", plain(bench_readers), false, true},
                                             {"solver", plain(bench_solver), false, true},
                                             {"silhouette", plain(bench_silhouette), false, true},
                                             {"silhouette-hand", bench_silhouette_hand, true, true},
                                             {"subdivision", plain(bench_subdivision), false, true},
                                             {"perspective", plain(bench_perspective), false, true},
                                             {"surface", plain(bench_surface), false, true},
                                             {"implicit", plain(bench_implicit), false, true},
                                             {"holes", bench_holes, true, true},
                                             {"remesh", plain(bench_remesh), false, true},
                                             {"holes-wild", bench_holes_wild, true},
                                             {"remesh-wild", bench_remesh_wild, true},
                                             {"strangers", bench_strangers, true}};
  return all;
}

/// One benchmark, and the words behind its name.
using Choice = std::pair<const Benchmark*, Words>;

/// Words that are no benchmark's name belong to the one before them that takes words. @return whether all words mean
/// something
bool read_choices(const Words& words, std::vector<Choice>& choices) {
  for (const std::string& word : words) {
    const auto bench = std::ranges::find(benches(), word, &Benchmark::name);
    if (bench != benches().end()) {
      choices.push_back({&*bench, {}});
    } else if (!choices.empty() && choices.back().first->takes_words) {
      choices.back().second.push_back(word);
    } else {
      std::cerr << "There is no benchmark '" << word << "'; there are:";
      for (const Benchmark& known : benches()) std::cerr << ' ' << known.name;
      std::cerr << '\n';
      return false;
    }
  }
  return true;
}

}  // namespace

int main(int argc, char** argv) {
  std::vector<Choice> choices;
  if (!read_choices({argv + 1, argv + argc}, choices)) return 2;
  if (choices.empty()) {
    for (const Benchmark& bench : benches())
      if (bench.is_usual) choices.push_back({&bench, {}});
  }
  try {
    for (const auto& [bench, words] : choices) {
      std::cout << "# " << bench->name << "\n\n";
      bench->run(std::cout, words);
      std::cout << std::endl;
    }
  } catch (const std::exception& error) {
    std::cerr << error.what() << '\n';
    return 1;
  }
  return 0;
}
