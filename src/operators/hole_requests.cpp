// SPDX-License-Identifier: GPL-3.0-or-later
#include "croquis/operators/hole_requests.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <string_view>
#include <utility>

#include "croquis/base/error.h"
#include "croquis/base/index_list.h"
#include "croquis/base/limits.h"
#include "croquis/base/text.h"
#include "operators/fill_settings.h"

namespace croquis {
namespace {

using hole_filling::Fairness;
using hole_filling::Selection;
using implicit::Kernel;

constexpr std::string_view blanks = " \t\r\n";
constexpr std::string_view separators_of_ids = ",+ \t\r\n";

std::string_view trimmed(std::string_view text) {
  const std::size_t first = text.find_first_not_of(blanks);
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(blanks) - first + 1);
}

/// The pieces between separators, without blanks around them; those without anything are left out.
std::vector<std::string_view> split(std::string_view text, std::string_view separators) {
  std::vector<std::string_view> pieces;
  for (const std::string_view part : text_parts(text, separators)) {
    if (const std::string_view piece = trimmed(part); !piece.empty()) pieces.push_back(piece);
  }
  return pieces;
}

bool read_bulge(std::string_view word, HoleRequest& request) {
  const auto bulge = usable_number(word);
  if (!bulge || std::abs(*bulge) > 1) return false;
  request.bulge = *bulge;
  return true;
}

bool read_trim(std::string_view word, HoleRequest& request) {
  if (word.size() != 1 || word[0] < '0' || word[0] > '3') return false;
  request.trim_rim = word[0] - '0';
  return true;
}

bool read_kernel(std::string_view word, HoleRequest& request) {
  request.kernel = kernel_named(word);
  return request.kernel.has_value();
}

bool read_through(const std::vector<std::string_view>& words, HoleRequest& request) {
  Vec3 place;
  for (std::size_t i = 0; i < 3; ++i) {
    const auto coordinate = usable_number(words[i + 1]);
    if (!coordinate) return false;
    place[static_cast<Eigen::Index>(i)] = *coordinate;
  }
  request.through.push_back(place);
  return true;
}

bool read_word(std::string_view word, HoleRequest& request) {
  if (word == "bridge") return request.bridge = true;
  if (word == "fill" || word == "leave") {
    request.fill = word == "fill";
    return true;
  }
  const auto fairness = fairness_named(word);
  if (fairness) request.fairness = fairness;
  return fairness.has_value();
}

bool read_part(std::string_view part, HoleRequest& request) {
  const std::vector<std::string_view> words = split(part, blanks);
  if (words.size() == 1) return read_word(words[0], request);
  if (words.size() == 4) return words[0] == "through" && read_through(words, request);
  if (words.size() != 2) return false;
  if (words[0] == "bulge") return read_bulge(words[1], request);
  if (words[0] == "trim") return read_trim(words[1], request);
  return words[0] == "kernel" && read_kernel(words[1], request);
}

Finding refusal(std::string_view part, const std::string& instead) {
  return make_error(Category::Usage, "E_PARAMETER", "'" + std::string(part) + "' is no value for holes: " + instead,
                    {{SubjectKind::Parameter, "holes", {}, {}, {}}});
}

HoleRequest read_request(std::string_view text, Findings& findings) {
  HoleRequest request;
  const std::size_t colon = text.find(':');
  for (const std::string_view word : split(text.substr(0, colon), separators_of_ids)) {
    if (!append_indices(word, request.holes))
      findings.push_back(
          refusal(word, "requests begin with the numbers of holes, counted from 0, such as '0,3-5: fill'."));
  }
  const auto parts = split(colon == std::string_view::npos ? std::string_view() : text.substr(colon + 1), ",");
  for (const std::string_view part : parts) {
    if (!read_part(part, request))
      findings.push_back(refusal(part,
                                 "a hole can be given fill, leave, bridge, rbf, smooth, flat, kernel NAME, bulge "
                                 "-1..1, trim 0..3 or through X Y Z."));
  }
  if (parts.empty() || split(text.substr(0, colon), separators_of_ids).empty())
    findings.push_back(refusal(text, "it takes holes and what is wanted of them, such as '3: leave; 5-7: flat'."));
  if (request.bridge && std::set<Index>(request.holes.begin(), request.holes.end()).size() < 2)
    findings.push_back(refusal(text, "a bridge joins two holes or more, such as '2+9: bridge'."));
  return request;
}

std::vector<std::string> parts_of(const HoleRequest& request) {
  std::vector<std::string> parts;
  if (request.fill) parts.emplace_back(*request.fill ? "fill" : "leave");
  if (request.bridge) parts.emplace_back("bridge");
  if (request.fairness) parts.emplace_back(name_of(*request.fairness));
  if (request.kernel) parts.push_back("kernel " + std::string(name_of(*request.kernel)));
  if (request.bulge) parts.push_back("bulge " + number_text(*request.bulge));
  if (request.trim_rim) parts.push_back("trim " + std::to_string(*request.trim_rim));
  for (const Vec3& place : request.through)
    parts.push_back("through " + number_text(place.x()) + ' ' + number_text(place.y()) + ' ' + number_text(place.z()));
  return parts;
}

ParameterValue value_of(const std::vector<HoleRequest>& requests) {
  std::string words = to_text(requests);
  if (words.empty()) return words;
  return ParsedText(std::move(words), requests);
}

}  // namespace

std::string_view name_of(Fairness fairness) {
  return fairness_names[static_cast<std::size_t>(std::ranges::find(fairnesses, fairness) - fairnesses.begin())];
}

std::string_view name_of(Kernel kernel) { return kernel_names[static_cast<std::size_t>(kernel)]; }

std::optional<Fairness> fairness_named(std::string_view name) {
  const auto found = std::ranges::find(fairness_names, name);
  if (found == fairness_names.end()) return std::nullopt;
  return fairnesses[static_cast<std::size_t>(found - fairness_names.begin())];
}

std::optional<Kernel> kernel_named(std::string_view name) {
  const auto found = std::ranges::find(kernel_names, name);
  if (found == kernel_names.end()) return std::nullopt;
  return static_cast<Kernel>(found - kernel_names.begin());
}

std::vector<HoleRequest> requests_in(const ParameterValue& value) {
  const auto* written = std::get_if<ParsedText>(&value);
  const auto* requests = written == nullptr ? nullptr : written->value<std::vector<HoleRequest>>();
  return requests == nullptr ? parse_hole_requests(to_text(value)) : *requests;
}

std::vector<Index> parse_hole_ids(const std::string& text) {
  const auto refused = [](std::string_view word) {
    return refused_value("only", word, "the numbers of holes, counted from 0, such as 0,3-5");
  };
  std::vector<Index> ids;
  Findings findings;
  for (const std::string_view word : text_parts(text, ",; ")) {
    if (!append_indices(word, ids)) findings.push_back(refused(word));
  }
  if (ids.empty() && findings.empty() && !text.empty()) findings.push_back(refused(text));
  if (!findings.empty()) throw Error(std::move(findings));
  std::sort(ids.begin(), ids.end());
  ids.erase(std::unique(ids.begin(), ids.end()), ids.end());
  return ids;
}

std::vector<HoleRequest> parse_hole_requests(const std::string& text) {
  std::vector<HoleRequest> requests;
  Findings findings;
  for (const std::string_view piece : split(text, ";")) requests.push_back(read_request(piece, findings));
  if (!findings.empty()) throw Error(std::move(findings));
  return requests;
}

std::string to_text(std::span<const HoleRequest> requests) {
  std::string text;
  for (const HoleRequest& request : requests) {
    const std::vector<std::string> parts = parts_of(request);
    if (request.holes.empty() || parts.empty()) continue;
    if (!text.empty()) text += "; ";
    text += index_list_text(request.holes, request.bridge ? '+' : ',') + ": " + parts.front();
    for (std::size_t i = 1; i < parts.size(); ++i) text += ", " + parts[i];
  }
  return text;
}

Selection parse_selection(std::string_view name) {
  const auto found = std::ranges::find(selection_names, name);
  return found == selection_names.end() ? Selection::Inner : static_cast<Selection>(found - selection_names.begin());
}

FillChoice read_fill_choice(const ParameterValues& parameters) {
  FillChoice choice;
  choice.select = parse_selection(text_of(parameters, "select"));
  choice.only = parse_hole_ids(text_of(parameters, "only"));
  choice.requests = requests_in(parameters.at("holes"));
  return choice;
}

ParameterValues to_parameters(const FillChoice& choice) {
  return {{"select", std::string(selection_names[static_cast<std::size_t>(choice.select)])},
          {"only", index_list_text(choice.only, ',')},
          {"holes", value_of(choice.requests)}};
}

}  // namespace croquis
