// SPDX-License-Identifier: GPL-3.0-or-later
#include <functional>
#include <iostream>
#include <map>
#include <string>
#include <vector>

#include "bench/bench.h"

namespace {

using Bench = std::function<void(std::ostream&, const std::vector<std::string>&)>;

/// A benchmark that takes no words of its own.
Bench plain(void (*bench)(std::ostream&)) {
  return [bench](std::ostream& out, const std::vector<std::string>&) { bench(out); };
}

const std::map<std::string, Bench>& benches() {
  using namespace croquis::bench;
  static const std::map<std::string, Bench> all = {{"holes", bench_holes},
                                                   {"holes-wild", bench_holes_wild},
                                                   {"implicit", plain(bench_implicit)},
                                                   {"perspective", plain(bench_perspective)},
                                                   {"readers", plain(bench_readers)},
                                                   {"remesh", plain(bench_remesh)},
                                                   {"remesh-adaptive", bench_remesh_adaptive},
                                                   {"remesh-wild", bench_remesh_wild},
                                                   {"silhouette", plain(bench_silhouette)},
                                                   {"silhouette-depth", plain(bench_silhouette_depth)},
                                                   {"silhouette-finish", plain(bench_silhouette_finish)},
                                                   {"silhouette-hand", bench_silhouette_hand},
                                                   {"solver", plain(bench_solver)},
                                                   {"strangers", bench_strangers},
                                                   {"subdivision", plain(bench_subdivision)},
                                                   {"surface", plain(bench_surface)}};
  return all;
}

/// One benchmark, and the words behind its name.
using Choice = std::pair<std::string, std::vector<std::string>>;

bool takes_words(const std::string& bench) {
  return bench == "holes" || bench == "holes-wild" || bench == "remesh-adaptive" || bench == "remesh-wild" ||
         bench == "silhouette-hand" || bench == "strangers";
}

/// Words that are no benchmark's name belong to the one before them that takes words. @return whether all words mean
/// something
bool read_choices(const std::vector<std::string>& words, std::vector<Choice>& choices) {
  for (const std::string& word : words) {
    if (benches().contains(word)) {
      choices.push_back({word, {}});
    } else if (!choices.empty() && takes_words(choices.back().first)) {
      choices.back().second.push_back(word);
    } else {
      std::cerr << "There is no benchmark '" << word
                << "': use holes, holes-wild, implicit, perspective, readers, remesh, remesh-adaptive, remesh-wild, "
                   "silhouette, "
                   "silhouette-depth, silhouette-finish, silhouette-hand, solver, strangers, subdivision or surface.\n";
      return false;
    }
  }
  return true;
}

}  // namespace

int main(int argc, char** argv) {
  std::vector<std::string> words(argv + 1, argv + argc);
  if (words.empty())
    words = {"readers",     "solver",  "silhouette", "silhouette-hand", "subdivision",
             "perspective", "surface", "implicit",   "holes",           "remesh"};
  std::vector<Choice> choices;
  if (!read_choices(words, choices)) return 2;
  try {
    for (const auto& [name, sections] : choices) {
      std::cout << "# " << name << "\n\n";
      benches().at(name)(std::cout, sections);
      std::cout << std::endl;
    }
  } catch (const std::exception& error) {
    std::cerr << error.what() << '\n';
    return 1;
  }
  return 0;
}
