// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/svg/svg_file.h"

#include <algorithm>
#include <array>

#include "croquis/base/error.h"
#include "croquis/base/limits.h"
#include "io/text.h"

namespace croquis {
namespace {

constexpr std::size_t most_of_a_code = 100;
constexpr std::size_t most_copied = std::size_t{64} << 20;  // bytes of ids and data attributes, kept per subpath
constexpr int deepest_sheet = 4;                            // levels of groups around a style sheet

/// Cuts off the text before the next separator, and the separator.
std::string_view cut(std::string_view& text, char separator) {
  const std::string_view part = text.substr(0, text.find(separator));
  text.remove_prefix(std::min(text.size(), part.size() + 1));
  return part;
}

/// On one line.
std::string without_comments(std::string_view text) {
  std::string result;
  while (!text.empty()) {
    const std::size_t begin = std::min(text.find("/*"), text.size());
    result.append(text.substr(0, begin));
    text.remove_prefix(begin);
    const std::size_t end = text.find("*/", std::min<std::size_t>(2, text.size()));
    text.remove_prefix(end == std::string_view::npos ? text.size() : end + 2);
  }
  std::ranges::replace(result, '\n', ' ');
  return result;
}

/// The value of a property in a list of declarations ("a: b; c: d"), the last one; empty when it is not there.
std::string_view declared(std::string_view declarations, std::string_view property) {
  std::string_view value;
  while (!declarations.empty()) {
    std::string_view declaration = cut(declarations, ';');
    if (declaration.find(':') == std::string_view::npos) continue;
    if (trimmed(cut(declaration, ':')) == property) value = trimmed(declaration);
  }
  return value;
}

}  // namespace

std::string_view svg_local_name(const pugi::xml_node& node) {
  std::string_view name = node.name();
  if (name.starts_with("svg:")) name.remove_prefix(4);
  return name;
}

bool is_svg_group(std::string_view name) { return name == "g" || name == "a" || name == "svg" || name == "switch"; }

Finding no_svg_strokes() {
  return make_error(Category::Malformed, "E_NO_STROKES",
                    "The drawing has no visible path, line or other shape: there is nothing to make a solid of");
}

SvgFile::SvgFile(std::string_view bytes, const std::string& file_name) : bytes_(bytes), file_(file_name) {
  if (bytes.find_first_not_of(" \t\r\n\f\v") == std::string_view::npos) {
    refuse("E_EMPTY", "The file is empty", std::nullopt);
  }
  const std::size_t zero = bytes.find('\0');
  if (zero != std::string_view::npos) {
    refuse("E_SYNTAX", "The file is not text in UTF-8: it has a zero byte", line_at(static_cast<std::ptrdiff_t>(zero)));
  }
  text_.assign(bytes);
  const auto outcome =
      document_.load_buffer_inplace(text_.data(), text_.size(), pugi::parse_default, pugi::encoding_utf8);
  if (!outcome) {
    const std::int64_t line = line_at(outcome.offset);
    refuse("E_SYNTAX", "The file is not well-formed XML on line " + std::to_string(line) + ": " + outcome.description(),
           line);
  }
  if (svg_local_name(root()) != "svg") {
    refuse("E_SYNTAX", "The file is not SVG: its outermost element is " + in_quotes(root().name()), line_of(root()));
  }
  read_sheets(root(), 0);
}

std::int64_t SvgFile::line_at(std::ptrdiff_t position) {
  position = std::clamp<std::ptrdiff_t>(position, 0, std::ssize(bytes_));
  if (position < counted_to_) {
    counted_to_ = 0;
    line_ = 1;
  }
  line_ += std::count(bytes_.begin() + counted_to_, bytes_.begin() + position, '\n');
  counted_to_ = position;
  return line_;
}

/// Rules whose selector is a class, an id or an element's name alone (".a, #b, path { stroke: red }"), of all `style`
/// elements among definitions or in few groups, where drawing programs put them.
void SvgFile::read_sheets(const pugi::xml_node& parent, int level) {
  for (const pugi::xml_node& child : parent.children()) {
    const std::string_view name = svg_local_name(child);
    const std::string sheet = name == "style" ? without_comments(child.text().get()) : std::string();
    for (std::string_view text = sheet; !text.empty();) {
      std::string_view selectors = cut(text, '{');
      const std::string_view rule = cut(text, '}');
      while (!selectors.empty()) {
        const std::string_view selector = trimmed(cut(selectors, ','));
        const bool simple = selector.find_first_of(" .#>+~:[*@", 1) == std::string_view::npos;
        if (selector.empty() || !simple || selector.front() == '@') continue;
        declarations_[std::string(selector)].append(rule).append(";");
      }
    }
    if (level < deepest_sheet && (name == "defs" || name == "switch" || name == "g")) read_sheets(child, level + 1);
  }
}

std::string SvgFile::property(const pugi::xml_node& node, std::string_view name) const {
  const auto of_rule = [&](const std::string& selector) {
    const auto found = declarations_.find(selector);
    return found == declarations_.end() ? std::string_view() : declared(found->second, name);
  };
  std::string_view value = declared(node.attribute("style").value(), name);
  if (value.empty() && !declarations_.empty()) {
    value = of_rule("#" + std::string(node.attribute("id").value()));
    for (std::string_view classes = node.attribute("class").value(); value.empty() && !classes.empty();)
      value = of_rule("." + std::string(trimmed(cut(classes, ' '))));
    if (value.empty()) value = of_rule(std::string(svg_local_name(node)));
  }
  return std::string(value.empty() ? trimmed(node.attribute(std::string(name).c_str()).value()) : value);
}

std::string SvgFile::inherited_property(pugi::xml_node node, std::string_view name) const {
  for (; node; node = node.parent()) {
    std::string value = property(node, name);
    if (!value.empty() && value != "inherit") return value;
  }
  return {};
}

std::string SvgFile::unique_name(const std::string& wanted, std::int64_t line) {
  if (names_.insert(wanted).second) return wanted;
  std::string name;
  do {
    name = wanted + '-' + std::to_string(++copies_.try_emplace(wanted, 1).first->second);
  } while (!names_.insert(name).second);
  add(make_warning(Category::Malformed, "W_DUPLICATE_ID",
                   "A second stroke named " + in_quotes(wanted) + " is called " + in_quotes(name) + " here"),
      line, name);
  return name;
}

bool SvgFile::count_pieces(std::size_t pieces, std::size_t bytes, std::int64_t line) {
  copied_ += bytes;
  segments_ += pieces;
  if (copied_ > most_copied) limit("The strokes' names and data attributes exceed 64 MiB", line);
  if (segments_ > most_curve_pieces) limit("The drawing has more than 4 million samples: simplify it", line);
  return !limit_reached_;
}

void SvgFile::limit(const std::string& message, std::int64_t line) {
  if (!limit_reached_) add(make_error(Category::Limit, "E_LIMIT", message), line);
  limit_reached_ = true;
}

void SvgFile::add(Finding finding, std::optional<std::int64_t> line, const std::string& stroke) {
  if (++counts_[finding.code] > most_of_a_code) return;
  finding.subjects = {stroke.empty() ? Subject{SubjectKind::File, file_, file_, line, {}}
                                     : Subject{SubjectKind::Stroke, stroke, file_, line, {}}};
  findings_.push_back(std::move(finding));
}

void SvgFile::refuse(const char* code, const std::string& message, std::optional<std::int64_t> line) {
  add(make_error(Category::Malformed, code, message), line);
  throw Error(take());
}

void SvgFile::stop_on_errors() {
  if (has_errors(findings_)) throw Error(take());
}

Findings SvgFile::take() {
  for (const auto& [code, count] : counts_) {
    if (count <= most_of_a_code) continue;
    Finding rest = *std::ranges::find(findings_, code, &Finding::code);
    rest.message = std::to_string(count - most_of_a_code) + " more findings of the kind " + code + " are not listed";
    rest.subjects = {{SubjectKind::File, file_, file_, std::nullopt, {}}};
    findings_.push_back(std::move(rest));
  }
  counts_.clear();
  return std::move(findings_);
}

}  // namespace croquis
