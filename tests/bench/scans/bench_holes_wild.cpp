// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <iomanip>
#include <map>
#include <ostream>
#include <set>
#include <string>
#include <vector>

#include "bench/bench.h"
#include "bench/scans/scan_choice.h"
#include "bench/scans/wild_holes.h"
#include "bench/statistics.h"

namespace croquis::bench {
namespace {

using test::HoleKind;

constexpr double negligible = 0.01;  // 1e-4 diagonals: errors of patches in one plane are rounding
constexpr std::size_t listed = 12;   // of the worst holes
constexpr std::array cgal = {Filler::Tangent, Filler::Curved};

using Holes = std::vector<const HoleRecord*>;
/// Groups by name, in an order of their own.
using Groups = std::vector<std::pair<std::string, Holes>>;

bool is_compared(const HoleRecord& hole) {
  return !hole.is_left && hole.of(Filler::Ours).is_closed && hole.of(Filler::Tangent).is_closed &&
         hole.of(Filler::Curved).is_closed;
}

double better_peer(const HoleRecord& hole) {
  double best = std::numeric_limits<double>::infinity();
  for (const Filler peer : cgal) {
    if (hole.of(peer).is_closed) best = std::min(best, hole.of(peer).error);
  }
  return best;
}

/// By how much ours is farther off than the better of CGAL's; infinite where only CGAL's closes it.
double excess(const HoleRecord& hole) {
  const double best = better_peer(hole);
  if (hole.is_left || !std::isfinite(best)) return -std::numeric_limits<double>::infinity();
  return hole.of(Filler::Ours).is_closed ? hole.of(Filler::Ours).error - best : std::numeric_limits<double>::infinity();
}

std::vector<double> errors_of(const Holes& holes, Filler filler) {
  std::vector<double> errors;
  for (const HoleRecord* hole : holes) {
    if (hole->of(filler).is_closed) errors.push_back(std::max(hole->of(filler).error, negligible));
  }
  return errors;
}

std::string scan_of(const HoleRecord& hole) {
  return std::string(name_of(hole.scan)) + (hole.has_seams ? " with seams" : "");
}

/// Openings and gaps may be borders: what lies beyond is known here, but nobody has to guess it.
bool is_hole(const HoleRecord& hole) { return hole.kind != HoleKind::Opening && hole.kind != HoleKind::Gap; }

/// @param label nothing for holes that are left out
Groups grouped(const std::vector<ScanRecord>& scans, const std::function<std::string(const HoleRecord&)>& label) {
  Groups groups;
  Holes all;
  for (const ScanRecord& scan : scans) {
    for (const HoleRecord& hole : scan.holes) {
      const std::string name = label(hole);
      if (name.empty()) continue;
      auto group = std::ranges::find(groups, name, &Groups::value_type::first);
      if (group == groups.end()) group = groups.insert(group, {name, {}});
      group->second.push_back(&hole);
      all.push_back(&hole);
    }
  }
  groups.emplace_back("all", all);
  return groups;
}

void print_counts(std::ostream& out, const Groups& groups) {
  out << "| | holes | left as OUTER | closed of the others: ours | CGAL C1 | CGAL C2 | MeshLab |\n"
         "|---|---|---|---|---|---|---|\n";
  for (const auto& [name, holes] : groups) {
    const auto left = std::ranges::count_if(holes, [](const HoleRecord* hole) { return hole->is_left; });
    out << "| " << name << " | " << holes.size() << " | " << left << " |";
    for (const Filler filler : all_fillers) {
      out << ' ' << std::ranges::count_if(holes, [&](const HoleRecord* hole) {
        return !hole->is_left && hole->of(filler).is_closed;
      }) << " |";
    }
    out << '\n';
  }
  out << '\n';
}

/// Sums over the scans of one kind. By Filler.
struct Soundness {
  std::size_t scans = 0, triangles = 0, open_edges = 0, refused = 0, changed = 0;
  std::array<std::ptrdiff_t, 4> intersections{}, edges_left{};
  std::array<double, 4> seconds{};

  void add(const ScanRecord& scan) {
    ++scans;
    triangles += scan.triangles, open_edges += scan.open_edges;
    refused += scan.edges_left[3] < 0, changed += !scan.is_kept;
    for (std::size_t i = 0; i < 4; ++i) {
      if (scan.edges_left[i] < 0) continue;
      intersections[i] += scan.new_intersections[i], edges_left[i] += scan.edges_left[i];
      seconds[i] += 1e-3 * scan.cpu_ms[i];
    }
  }
};

template <typename Values>
void print_row(std::ostream& out, const Values& values) {
  for (const auto value : values) out << value << " | ";
}

void print_soundness(std::ostream& out, const std::vector<ScanRecord>& scans) {
  out << "| | scans | triangles, edges of one face | pairs of faces that intersect, beyond the scan's: ours | CGAL C1 "
         "| "
         "CGAL C2 | MeshLab | edges of one face left: ours | CGAL C1 | CGAL C2 | MeshLab | s for all holes: ours | "
         "CGAL "
         "C1 | CGAL C2 | MeshLab, whole process | scans that MeshLab refuses or changes | that ours changes "
         "|\n|---|---|---|---|---|---|---|---|---|---|---|---|---|---|---|---|---|\n";
  std::map<test::ScanKind, Soundness> by_kind;
  for (const ScanRecord& scan : scans) by_kind[scan.kind].add(scan);
  for (const auto& [kind, sum] : by_kind) {
    out << "| " << name_of(kind) << " | " << sum.scans << " | " << sum.triangles << ", " << sum.open_edges << " | ";
    print_row(out, sum.intersections);
    print_row(out, sum.edges_left);
    print_row(out, sum.seconds);
    out << sum.refused << " | " << sum.changed << " |\n";
  }
  out << '\n';
}

/// Ours over the better of CGAL's, by a figure of the errors.
double ratio_of(const Holes& holes, const std::function<double(const std::vector<double>&)>& figure) {
  const double peer = std::min(figure(errors_of(holes, Filler::Tangent)), figure(errors_of(holes, Filler::Curved)));
  return figure(errors_of(holes, Filler::Ours)) / peer;
}

/// The median over scans of the ratios.
double ratio_over_scans(const Holes& holes, const std::function<double(const std::vector<double>&)>& figure) {
  std::map<std::pair<test::ScanKind, std::uint64_t>, Holes> scans;
  for (const HoleRecord* hole : holes) scans[{hole->scan, hole->seed}].push_back(hole);
  std::vector<double> ratios;
  for (const auto& [scan, own] : scans) ratios.push_back(ratio_of(own, figure));
  return median(ratios);
}

void print_errors(std::ostream& out, const Groups& groups) {
  out << "| | holes that all three close | mean: ours | CGAL C1 | CGAL C2 | MeshLab | median: ours | CGAL C1 | CGAL C2 "
         "| MeshLab | ours / better CGAL over scans: by mean hole | by median hole | over all these holes: by mean | "
         "by "
         "median | single holes worse, of those CGAL closes, % |\n"
         "|---|---|---|---|---|---|---|---|---|---|---|---|---|---|---|\n";
  for (const auto& [name, all] : groups) {
    Holes holes;
    double judged = 0, worse = 0;
    for (const HoleRecord* hole : all) {
      if (is_compared(*hole)) holes.push_back(hole);
      if (std::isinf(excess(*hole)) && excess(*hole) < 0) continue;
      ++judged;
      worse += excess(*hole) > negligible;
    }
    if (holes.empty()) continue;
    out << "| " << name << " | " << holes.size() << " |";
    for (const Filler filler : all_fillers) out << ' ' << mean(errors_of(holes, filler)) << " |";
    for (const Filler filler : all_fillers) out << ' ' << median(errors_of(holes, filler)) << " |";
    out << ' ' << ratio_over_scans(holes, mean) << " | " << ratio_over_scans(holes, median) << " | "
        << ratio_of(holes, mean) << " | " << ratio_of(holes, median) << " | " << 100 * worse / judged << " |\n";
  }
  out << '\n';
}

void print_confidence(std::ostream& out, const Groups& groups) {
  out << "| | holes | rank correlation of confidence and -error (wanted 0.7) | and -error / diameter of the hole |\n"
         "|---|---|---|---|\n";
  for (const auto& [name, holes] : groups) {
    std::vector<double> confidence, error, relative;
    for (const HoleRecord* hole : holes) {
      const FilledHole& made = hole->is_left ? hole->asked : hole->of(Filler::Ours);
      if (!made.is_closed || !std::isfinite(hole->confidence)) continue;
      confidence.push_back(hole->confidence);
      error.push_back(-made.error);
      relative.push_back(-made.error / hole->diameter);
    }
    out << "| " << name << " | " << confidence.size() << " | " << rank_correlation(confidence, error) << " | "
        << rank_correlation(confidence, relative) << " |\n";
  }
  out << '\n';
}

/// Holes that the default options leave, each asked for by its number.
void print_asked(std::ostream& out, const Groups& groups) {
  out << "| left as OUTER, then asked for | holes | closed: ours | CGAL C1 | CGAL C2 | closed by all: holes | median "
         "error: ours | CGAL C1 | CGAL C2 | median confidence |\n|---|---|---|---|---|---|---|---|---|---|\n";
  for (const auto& [name, all] : groups) {
    std::size_t left = 0, ours = 0;
    std::array<std::size_t, 2> peers{};
    std::array<std::vector<double>, 3> errors;
    std::vector<double> confidence;
    for (const HoleRecord* hole : all) {
      if (!hole->is_left || !hole->has_own_rim) continue;
      ++left, ours += hole->asked.is_closed;
      for (std::size_t i = 0; i < 2; ++i) peers[i] += hole->of(cgal[i]).is_closed;
      if (!hole->asked.is_closed || !hole->of(cgal[0]).is_closed || !hole->of(cgal[1]).is_closed) continue;
      errors[0].push_back(hole->asked.error);
      for (std::size_t i = 0; i < 2; ++i) errors[i + 1].push_back(hole->of(cgal[i]).error);
      confidence.push_back(hole->confidence);
    }
    if (left == 0) continue;
    out << "| " << name << " | " << left << " | " << ours << " | " << peers[0] << " | " << peers[1] << " | "
        << confidence.size() << " | " << median(errors[0]) << " | " << median(errors[1]) << " | " << median(errors[2])
        << " | " << median(confidence) << " |\n";
  }
  out << '\n';
}

void print_times(std::ostream& out, const Groups& groups) {
  out << "| processor time per hole | holes | ms: median | 95 % | worst | CGAL C1: median | 95 % | worst | sum / CGAL "
         "C1's | single holes: median of ratios | 95 % |\n|---|---|---|---|---|---|---|---|---|---|---|\n";
  for (const auto& [name, all] : groups) {
    std::vector<double> ours, peer, ratios;
    for (const HoleRecord* hole : all) {
      const double own = hole->of(Filler::Ours).cpu_ms, other = hole->of(Filler::Tangent).cpu_ms;
      if (!std::isfinite(own) || !std::isfinite(other) || other <= 0) continue;
      ours.push_back(own), peer.push_back(other), ratios.push_back(own / other);
    }
    if (ours.empty()) continue;
    out << "| " << name << " | " << ours.size() << " |";
    for (const auto& times : {ours, peer})
      out << ' ' << median(times) << " | " << quantile(times, 0.95) << " | " << quantile(times, 1) << " |";
    out << ' ' << mean(ours) / mean(peer) << " | " << median(ratios) << " | " << quantile(ratios, 0.95) << " |\n";
  }
  out << '\n';
}

/// What each method is good for: those that no hole needs may go.
void print_methods(std::ostream& out, const Holes& all) {
  std::map<std::string, Holes> by_method;
  for (const HoleRecord* hole : all) by_method[hole->method.empty() ? " none" : hole->method].push_back(hole);
  out << "| method taken, asked for by number included | holes | median error: ours | better of CGAL's | holes that "
         "CGAL doesn't close |\n|---|---|---|---|---|\n";
  for (const auto& [method, holes] : by_method) {
    std::vector<double> ours, peer;
    for (const HoleRecord* hole : holes) {
      const FilledHole& made = hole->is_left ? hole->asked : hole->of(Filler::Ours);
      if (made.is_closed) ours.push_back(made.error);
      if (std::isfinite(better_peer(*hole))) peer.push_back(better_peer(*hole));
    }
    out << '|' << method << " | " << holes.size() << " | " << median(ours) << " | " << median(peer) << " | "
        << holes.size() - peer.size() << " |\n";
  }
  out << '\n';
}

void print_error(std::ostream& out, const FilledHole& made) {
  if (made.is_closed) {
    out << ' ' << made.error << " |";
  } else {
    out << " open |";
  }
}

void print_list(std::ostream& out, const std::string& title, Holes holes,
                const std::function<double(const HoleRecord&)>& badness) {
  std::erase_if(holes, [&](const HoleRecord* hole) { return !(badness(*hole) > negligible); });
  std::stable_sort(holes.begin(), holes.end(),
                   [&](const HoleRecord* a, const HoleRecord* b) { return badness(*a) > badness(*b); });
  if (holes.size() > listed) holes.resize(listed);
  out << "| " << title << " | kind | rim edges | diameter / diagonal | ours | CGAL C1 | CGAL C2 | MeshLab | method | "
      << "confidence | ms |\n|---|---|---|---|---|---|---|---|---|---|---|\n";
  for (const HoleRecord* hole : holes) {
    out << "| " << scan_of(*hole) << ' ' << hole->seed << ", " << hole->number << " | " << name_of(hole->kind) << " | "
        << hole->rim_edges << " | " << hole->diameter << " |";
    for (const Filler filler : all_fillers)
      print_error(out, filler == Filler::Ours && hole->is_left ? hole->asked : hole->of(filler));
    out << hole->method << " | " << hole->confidence << " | "
        << (hole->is_left ? hole->asked.cpu_ms : hole->of(Filler::Ours).cpu_ms) << " |\n";
  }
  out << '\n';
}

void print_worst(std::ostream& out, const Holes& all) {
  print_list(out, "not closed, where CGAL closes", all, [](const HoleRecord& hole) {
    return std::isinf(excess(hole)) && excess(hole) > 0 ? static_cast<double>(hole.rim_edges) : 0;
  });
  print_list(out, "farther off than CGAL", all,
             [](const HoleRecord& hole) { return std::isfinite(excess(hole)) ? excess(hole) : 0; });
  print_list(out, "confidence above 0.5, largest error", all, [](const HoleRecord& hole) {
    const FilledHole& made = hole.is_left ? hole.asked : hole.of(Filler::Ours);
    return made.is_closed && hole.confidence > 0.5 ? made.error : 0;
  });
  print_list(out, "slowest", all, [](const HoleRecord& hole) {
    const double ms = hole.is_left ? hole.asked.cpu_ms : hole.of(Filler::Ours).cpu_ms;
    return std::isfinite(ms) ? ms : 0;
  });
}

}  // namespace

void bench_holes_wild(std::ostream& out, const std::vector<std::string>& words) {
  const ScanChoice choice = scan_choice(words);
  std::vector<ScanRecord> scans;
  for (const test::ScanKind kind : choice.kinds) {
    for (std::uint64_t seed = choice.first; seed < choice.first + choice.count; ++seed)
      scans.push_back(fill_known_scan(kind, seed, choice.folder));
  }
  out << std::setprecision(3) << "Known scans of seeds " << choice.first << " to " << choice.first + choice.count - 1
      << (choice.first < 5000 ? ", on which rules are tuned" : "")
      << ". Ours by the default options; CGAL's and MeshLab's fill all rims. Errors: mean distance of the surface that "
         "is missing to the patch, 1e-4 of the diagonal.\n\n";
  const Groups by_scan = grouped(scans, scan_of);
  const Groups inner = grouped(scans, [](const HoleRecord& hole) { return is_hole(hole) ? scan_of(hole) : ""; });
  const Groups by_hole = grouped(scans, [](const HoleRecord& hole) { return std::string(name_of(hole.kind)); });
  print_soundness(out, scans);
  out << "Of scans: openings and gaps left out.\n\n";
  print_counts(out, inner);
  print_errors(out, inner);
  out << "Of holes by kind:\n\n";
  print_counts(out, by_hole);
  print_errors(out, by_hole);
  print_asked(out, by_hole);
  print_confidence(out, by_scan);
  print_times(out, by_hole);
  print_times(out, by_scan);
  print_methods(out, by_scan.back().second);
  print_worst(out, by_scan.back().second);
}

}  // namespace croquis::bench
