// SPDX-License-Identifier: GPL-3.0-or-later
#include "croquis/operators/attach_text.h"

#include <algorithm>
#include <optional>
#include <ranges>
#include <string_view>
#include <utility>

#include "croquis/base/error.h"
#include "croquis/base/limits.h"
#include "croquis/base/parameter.h"
#include "croquis/base/text.h"

namespace croquis {
namespace {

using silhouette::AttachedPair;
using silhouette::Hold;

constexpr std::string_view all_suggested = "auto";
constexpr std::string_view apart = "apart";
constexpr std::string_view resting = "rest";
constexpr std::string_view joined = "join";

std::string_view trimmed(std::string_view text) {
  while (!text.empty() && text.front() == ' ') text.remove_prefix(1);
  while (!text.empty() && text.back() == ' ') text.remove_suffix(1);
  return text;
}

/// What stands after '='. False for what is no hold.
bool read_hold(std::string_view text, AttachedPair& pair) {
  if (text == apart || text == resting) {
    pair.hold = text == apart ? Hold::Apart : Hold::Resting;
    return true;
  }
  const std::size_t colon = text.rfind(':');
  if (colon != std::string_view::npos) {
    const auto blend = usable_number(trimmed(text.substr(colon + 1)));
    if (!blend) return false;
    pair.blend = *blend;
    text = trimmed(text.substr(0, colon));
  }
  const auto kappa = usable_number(text);
  pair.kappa = kappa.value_or(pair.kappa);
  return text == joined || kappa;
}

std::optional<AttachedPair> read_pair(std::string_view entry) {
  AttachedPair pair;
  const std::size_t equals = entry.rfind('=');
  if (equals != std::string_view::npos) {
    if (!read_hold(trimmed(entry.substr(equals + 1)), pair)) return std::nullopt;
    entry = entry.substr(0, equals);
  }
  const std::size_t comma = entry.find(',');
  if (comma == std::string_view::npos || entry.find(',', comma + 1) != std::string_view::npos) return std::nullopt;
  pair.a = trimmed(entry.substr(0, comma));
  pair.b = trimmed(entry.substr(comma + 1));
  if (pair.a.empty() || pair.b.empty()) return std::nullopt;
  return pair;
}

std::string to_text(const AttachedPair& pair) {
  const AttachedPair standard;
  std::string text = pair.a + "," + pair.b;
  if (pair.hold != Hold::Joined) return text + "=" + std::string(pair.hold == Hold::Apart ? apart : resting);
  const bool plain = pair.kappa == standard.kappa;
  if (!plain || pair.blend != standard.blend)
    text += "=" + (plain ? std::string(joined) : croquis::to_text(pair.kappa));
  if (pair.blend != standard.blend) text += ":" + croquis::to_text(pair.blend);
  return text;
}

}  // namespace

AttachText read_attach_text(const std::string& text) {
  AttachText attach;
  Findings findings;
  for (const std::string_view part : text_parts(text, ";")) {
    const std::string_view entry = trimmed(part);
    if (entry.empty()) continue;
    if (entry == all_suggested) {
      attach.suggested = true;
    } else if (std::optional<AttachedPair> pair = read_pair(entry)) {
      attach.pairs.push_back(*std::move(pair));
    } else {
      findings.push_back(
          refused_value("attach", entry, "auto, or two names as A,B or A,B=0.55, A,B=rest or A,B=apart"));
    }
  }
  if (!findings.empty()) throw Error(std::move(findings));
  return attach;
}

std::string to_text(const AttachText& attach) {
  std::string text(attach.suggested ? all_suggested : std::string_view());
  for (const AttachedPair& pair : attach.pairs) text += (text.empty() ? "" : ";") + to_text(pair);
  return text;
}

const AttachedPair* find_pair(const AttachText& attach, const std::string& a, const std::string& b) {
  const auto found = std::ranges::find_if(attach.pairs.rbegin(), attach.pairs.rend(), [&](const AttachedPair& pair) {
    return (pair.a == a && pair.b == b) || (pair.a == b && pair.b == a);
  });
  return found == attach.pairs.rend() ? nullptr : &*found;
}

}  // namespace croquis
