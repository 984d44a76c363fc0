// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/svg/svg_walk.h"

#include <algorithm>

#include "croquis/base/error.h"
#include "io/svg/svg_elements.h"
#include "io/svg/svg_shapes.h"
#include "io/svg/svg_transform.h"
#include "io/text.h"

namespace croquis {
namespace {

constexpr int deepest_level = 256;                          // of nesting; drawing programs stay below 30
constexpr std::size_t most_copied = std::size_t{64} << 20;  // bytes of ids and data attributes, kept per subpath
constexpr std::size_t elements_per_check = 256;

}  // namespace

void SvgWalk::refuse(const char* code, const std::string& message, std::optional<std::int64_t> line) {
  findings_.file_error(Category::Malformed, code, message, line);
  throw_findings();
}

void SvgWalk::throw_findings() { throw Error(findings_.take()); }

pugi::xml_node SvgWalk::parse() {
  if (bytes_.find_first_not_of(" \t\r\n\f\v") == std::string_view::npos) {
    refuse("E_EMPTY", "The file is empty", std::nullopt);
  }
  const std::size_t zero = bytes_.find('\0');
  if (zero != std::string_view::npos) {
    refuse("E_SYNTAX", "The file is not text in UTF-8: it has a zero byte", lines_.line_at(zero));
  }
  text_.assign(bytes_);
  const auto outcome =
      document_.load_buffer_inplace(text_.data(), text_.size(), pugi::parse_default, pugi::encoding_utf8);
  if (!outcome) {
    refuse("E_SYNTAX", std::string("The file is not well-formed XML: ") + outcome.description(),
           lines_.line_at(static_cast<std::size_t>(std::max<std::ptrdiff_t>(outcome.offset, 0))));
  }
  const pugi::xml_node root = document_.document_element();
  if (svg_local_name(root) != "svg") {
    refuse("E_SYNTAX", "The file is not SVG: its outermost element is " + in_quotes(root.name()), line_of(root));
  }
  return root;
}

std::int64_t SvgWalk::line_of(const pugi::xml_node& node) {
  return lines_.line_at(static_cast<std::size_t>(std::max<std::ptrdiff_t>(node.offset_debug(), 0)));
}

void SvgWalk::limit(const std::string& message, std::int64_t line) {
  if (!limit_reached_) findings_.file_error(Category::Limit, "E_LIMIT", message, line);
  limit_reached_ = true;
}

void SvgWalk::visit(const pugi::xml_node& root, SvgVisitor& visitor) {
  visit(root, {}, visitor);
  warn_of_ignored();
}

void SvgWalk::visit(const pugi::xml_node& node, Surroundings around, SvgVisitor& visitor) {
  if (limit_reached_ || node.type() != pugi::node_element) return;
  if (++elements_ % elements_per_check == 0) progress_.check();
  const std::string_view name = svg_local_name(node);
  if (is_svg_definition(name)) return;
  if (!is_svg_group(name) && !is_svg_shape(name)) return ignore(node, name);
  if (!enter(node, around, visitor)) return;
  if (is_svg_shape(name)) return read_shape(node, name, around, visitor);
  if (++around.level > deepest_level) {
    return limit("The drawing is nested deeper than 256 groups: ungroup it", line_of(node));
  }
  if (name == "svg" && around.level > 1) enter_inner_svg(node, around);
  for (const pugi::xml_node& child : node.children()) visit(child, around, visitor);
}

void SvgWalk::ignore(const pugi::xml_node& node, std::string_view name) {
  auto& entry = ignored_[std::string(name)];
  if (entry.first++ == 0) entry.second = line_of(node);
}

/// Takes over the settings of an element for itself and its children. False when it is not to be shown.
bool SvgWalk::enter(const pugi::xml_node& node, Surroundings& around, SvgVisitor& visitor) {
  if (svg_property(node, "display") == "none") return false;
  const std::string visibility = svg_property(node, "visibility");
  if (!visibility.empty() && visibility != "inherit") around.visible = visibility == "visible";
  if (const pugi::xml_attribute attribute = node.attribute("transform")) {
    const SvgTransform transform = parse_svg_transform(attribute.value());
    if (transform.error) return report(node, *transform.error, "transform"), false;
    around.map = around.map * transform.map;
  }
  if (is_svg_group(svg_local_name(node))) visitor.enter(node);
  return true;
}

void SvgWalk::enter_inner_svg(const pugi::xml_node& node, Surroundings& around) {
  std::optional<SvgTextError> error;
  const SvgAttributes attributes = [&](const char* name) { return std::string_view(node.attribute(name).value()); };
  const Vec2 origin(svg_length(attributes, "x", 0, error), svg_length(attributes, "y", 0, error));
  if (error) report(node, *error, "x or y");
  around.map.translate(origin);
  if (node.attribute("viewBox")) {
    findings_.file_warning("W_IGNORED", "The viewBox of an svg element within the drawing was ignored", line_of(node));
  }
}

void SvgWalk::report(const pugi::xml_node& node, const SvgTextError& error, const char* attribute) {
  const std::int64_t line = line_of(node);
  if (error.limit) return limit("A path of the drawing has more than 4 million pieces: simplify it", line);
  const std::string id = node.attribute("id").value();
  const bool shape = is_svg_shape(svg_local_name(node));
  const std::string name = !id.empty() ? id : shape ? "stroke-" + std::to_string(shape_count_) : "";
  const std::string who = shape          ? "Stroke " + in_quotes(name)
                          : name.empty() ? "A group"
                                         : "The group " + in_quotes(name);
  const std::string message = who + " on line " + std::to_string(line) + ' ' + error.message + " (character " +
                              std::to_string(error.position + 1) + " of its " + attribute + ")";
  if (shape) {
    findings_.stroke_error(Category::Malformed, "E_SYNTAX", message, name, line);
  } else {
    findings_.file_error(Category::Malformed, "E_SYNTAX", message, line);
  }
}

void SvgWalk::read_shape(const pugi::xml_node& node, std::string_view element, const Surroundings& around,
                         SvgVisitor& visitor) {
  ++shape_count_;
  if (!around.visible) return;
  const SvgAttributes attributes = [&](const char* name) { return std::string_view(node.attribute(name).value()); };
  SvgOutline outline = svg_shape(element, attributes);
  if (outline.error) {
    const bool points = element == "polyline" || element == "polygon";
    return report(node, *outline.error, element == "path" ? "d" : points ? "points" : "attributes");
  }
  SvgShownShape shape;
  shape.node = node;
  shape.line = line_of(node);
  const std::string id = node.attribute("id").value();
  shape.id = unique_name(id.empty() ? "stroke-" + std::to_string(shape_count_) : id, shape.line);
  shape.subpaths = std::move(outline.subpaths);
  shape.map = around.map;
  visitor.add(std::move(shape));
}

std::string SvgWalk::unique_name(const std::string& wanted, std::int64_t line) {
  if (names_.insert(wanted).second) return wanted;
  std::string name;
  do {
    name = wanted + '-' + std::to_string(++copies_.try_emplace(wanted, 1).first->second);
  } while (!names_.insert(name).second);
  findings_.stroke_warning("W_DUPLICATE_ID",
                           "A second stroke named " + in_quotes(wanted) + " is called " + in_quotes(name) + " here",
                           name, line);
  return name;
}

bool SvgWalk::count_pieces(std::size_t pieces, std::size_t bytes, std::int64_t line) {
  copied_ += bytes;
  segments_ += pieces;
  if (copied_ > most_copied) limit("The strokes' names and data attributes exceed 64 MiB", line);
  if (segments_ > svg_most_segments) limit("The drawing has more than 4 million samples: simplify it", line);
  return !limit_reached_;
}

void SvgWalk::warn_of_ignored() {
  for (const auto& [name, entry] : ignored_) {
    const std::string advice = name == "use"    ? ": unlink the clones to make them strokes"
                               : name == "text" ? ": turn text into paths to make it strokes"
                                                : ": only lines are read";
    findings_.file_warning("W_IGNORED",
                           std::to_string(entry.first) + ' ' + in_quotes(name) +
                               (entry.first == 1 ? " element was" : " elements were") + " ignored" + advice,
                           entry.second);
  }
}

}  // namespace croquis
