// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/svg/svg_walk.h"

#include <algorithm>
#include <array>

#include "croquis/base/error.h"
#include "croquis/base/limits.h"
#include "io/svg/svg_shapes.h"
#include "io/text.h"

namespace croquis {
namespace {

constexpr std::size_t most_copied = std::size_t{64} << 20;  // bytes of ids and data attributes, kept per subpath
constexpr std::size_t most_uses = 100'000;                  // a few nested uses can show billions of shapes
constexpr std::size_t elements_per_check = 256;

/// Whether an opacity is written as 0: "0", "0.0", "0%".
bool is_nothing(const std::string& opacity) {
  return opacity.find('0') != std::string::npos && opacity.find_first_not_of("0.% ") == std::string::npos;
}

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
  classes_.read(root);
  visit(root, {}, visitor);
  warn_of_ignored();
}

void SvgWalk::visit(const pugi::xml_node& node, Surroundings around, SvgVisitor& visitor) {
  if (limit_reached_ || node.type() != pugi::node_element) return;
  if (++elements_ % elements_per_check == 0) progress_.check();
  const std::string_view name = svg_local_name(node);
  if (is_svg_definition(name)) return;
  const bool shows_another = name == "use";
  if (!is_svg_group(name) && !is_svg_shape(name) && !shows_another) return ignore(node, name);
  if (++around.level > deepest_nesting) {
    return limit("The drawing is nested deeper than " + std::to_string(deepest_nesting) + " groups: ungroup it",
                 line_of(node));
  }
  path_.push_back(node);
  if (enter(node, around, visitor)) {
    if (shows_another) {
      visit_use(node, std::move(around), visitor);
    } else if (is_svg_shape(name)) {
      read_shape(node, name, around, visitor);
    } else {
      if (name == "svg" && path_.size() == 1) enter_page(node, around);
      if (name == "svg" && path_.size() > 1) enter_viewport(node, node, around);
      visit_children(node, std::move(around), visitor);
    }
  }
  path_.pop_back();
}

void SvgWalk::visit_children(const pugi::xml_node& node, Surroundings around, SvgVisitor& visitor) {
  for (const pugi::xml_node& child : node.children()) visit(child, around, visitor);
}

/// Shows the element that a `use` names, at the place of the use (SVG 1.1, 5.6).
void SvgWalk::visit_use(const pugi::xml_node& node, Surroundings around, SvgVisitor& visitor) {
  std::string_view target = node.attribute("href").value();
  if (target.empty()) target = node.attribute("xlink:href").value();
  const pugi::xml_node used = target.starts_with('#') ? element_named(target.substr(1)) : pugi::xml_node();
  if (!used) {
    findings_.file_warning(
        "W_IGNORED", "A use element was ignored, for the drawing has no element " + in_quotes(target), line_of(node));
    return;
  }
  if (std::find(path_.begin(), path_.end(), used) != path_.end()) {
    return findings_.file_error(Category::Malformed, "E_SYNTAX",
                                "The use element on line " + std::to_string(line_of(node)) + " shows " +
                                    in_quotes(target) + ", which it is a part of itself",
                                line_of(node));
  }
  if (++uses_ > most_uses) return limit("The drawing shows elements by use more than 100,000 times", line_of(node));
  const SvgAttributes attributes = [&](const char* name) { return std::string_view(node.attribute(name).value()); };
  SvgLengths lengths(attributes, around.viewport);
  const Vec2 origin(lengths.at("x"), lengths.at("y"));
  if (lengths.error()) return report(node, *lengths.error(), "x or y");
  around.map.translate(origin);
  const std::string own = node.attribute("id").value();
  around.prefix = around.prefix.empty() || own.empty() ? around.prefix + own : around.prefix + "/" + own;
  if (svg_local_name(used) != "symbol") return visit(used, std::move(around), visitor);
  path_.push_back(used);
  if (enter(used, around, visitor)) {
    enter_viewport(used, node, around);
    visit_children(used, std::move(around), visitor);
  }
  path_.pop_back();
}

pugi::xml_node SvgWalk::element_named(std::string_view id) {
  if (!ids_known_) {
    ids_known_ = true;
    std::vector<pugi::xml_node> waiting{document_.document_element()};
    while (!waiting.empty()) {
      const pugi::xml_node node = waiting.back();
      waiting.pop_back();
      const std::string_view name = node.attribute("id").value();
      if (!name.empty()) by_id_.try_emplace(std::string(name), node);
      for (const pugi::xml_node& child : node.children()) {
        if (child.type() == pugi::node_element) waiting.push_back(child);
      }
    }
  }
  const auto found = by_id_.find(id);
  return found == by_id_.end() ? pugi::xml_node() : found->second;
}

std::string SvgWalk::inherited_property(std::string_view name) const {
  for (auto node = path_.rbegin(); node != path_.rend(); ++node) {
    std::string value = property(*node, name);
    if (!value.empty() && value != "inherit") return value;
  }
  return {};
}

void SvgWalk::ignore(const pugi::xml_node& node, std::string_view name) {
  auto& entry = ignored_[std::string(name)];
  if (entry.first++ == 0) entry.second = line_of(node);
}

/// Takes over the settings of an element for itself and its children. False when it is not to be shown.
bool SvgWalk::enter(const pugi::xml_node& node, Surroundings& around, SvgVisitor& visitor) {
  if (property(node, "display") == "none" || is_nothing(property(node, "opacity"))) return false;
  const std::string visibility = property(node, "visibility");
  if (!visibility.empty() && visibility != "inherit") around.visible = visibility == "visible";
  if (!transform(node, around)) return false;
  if (is_svg_group(svg_local_name(node))) visitor.enter(node);
  return true;
}

/// A transform in the style or in a class counts instead of the attribute (CSS Transforms 1, section 12).
bool SvgWalk::transform(const pugi::xml_node& node, Surroundings& around) {
  const std::string text = property(node, "transform");
  if (text.empty()) return true;
  const SvgTransform transform = parse_svg_transform(text);
  if (transform.error) return report(node, *transform.error, "transform"), false;
  around.map = around.map * transform.map;
  return true;
}

namespace {

/// "x y width height"; empty when it is not there, or not to be understood.
std::optional<Eigen::AlignedBox2d> view_box(const pugi::xml_node& node) {
  SvgScanner scanner(node.attribute("viewBox").value());
  std::array<double, 4> values{};
  for (double& value : values) {
    scanner.skip_separators();
    const std::optional<double> number = scanner.number();
    if (!number || !is_usable_number(*number)) return std::nullopt;
    value = *number;
  }
  const Vec2 low(values[0], values[1]);
  const Vec2 size(values[2], values[3]);
  if (size.minCoeff() <= 0) return std::nullopt;
  return Eigen::AlignedBox2d(low, low + size);
}

}  // namespace

/// The page's own scaling isn't applied: lengths of the drawing are those that its shapes have.
void SvgWalk::enter_page(const pugi::xml_node& root, Surroundings& around) {
  if (const auto box = view_box(root)) {
    page_ = *box;
  } else {
    const SvgAttributes attributes = [&](const char* name) { return std::string_view(root.attribute(name).value()); };
    SvgLengths lengths(attributes, {});
    const Vec2 size(lengths.at("width"), lengths.at("height"));
    if (!lengths.error() && size.minCoeff() > 0) page_ = Eigen::AlignedBox2d(Vec2(Vec2::Zero()), size);
  }
  if (!page_.isEmpty()) around.viewport.size = page_.sizes();
}

/// An svg element within the drawing, or a symbol: its viewBox is fitted into its place (SVG 1.1, 7.7 and 7.8).
/// @param placed_by the svg element itself, or the `use` that shows the symbol
void SvgWalk::enter_viewport(const pugi::xml_node& node, const pugi::xml_node& placed_by, Surroundings& around) {
  const bool own_place = placed_by == node;
  const SvgAttributes attributes = [&](const char* name) {
    return std::string_view(placed_by.attribute(name).value());
  };
  SvgLengths lengths(attributes, around.viewport);
  const Vec2 origin = own_place ? Vec2(lengths.at("x"), lengths.at("y")) : Vec2(Vec2::Zero());
  const std::optional<Eigen::AlignedBox2d> box = view_box(node);
  const Vec2 natural = box ? Vec2(box->sizes()) : around.viewport.size;
  const Vec2 whole = around.viewport.size.minCoeff() > 0 ? around.viewport.size : natural;
  const Vec2 size(lengths.at("width", whole.x()), lengths.at("height", whole.y()));
  if (lengths.error()) report(placed_by, *lengths.error(), "x, y, width or height");
  around.map.translate(origin);
  if (!box) {
    around.viewport.size = size;
    return;
  }
  around.viewport.size = box->sizes();
  if (!(size.minCoeff() > 0)) return;
  const Vec2 factors = size.cwiseQuotient(natural);
  const std::string_view aspect = trimmed(node.attribute("preserveAspectRatio").value());
  if (aspect == "none") {
    around.map.scale(factors);
  } else {
    const double factor = aspect.find("slice") == std::string_view::npos ? factors.minCoeff() : factors.maxCoeff();
    const Vec2 spare = size - factor * natural;
    const auto share = [&](std::string_view low, std::string_view high) {
      if (aspect.find(low) != std::string_view::npos) return 0.0;
      return aspect.find(high) != std::string_view::npos ? 1.0 : 0.5;
    };
    around.map.translate(Vec2(share("xMin", "xMax") * spare.x(), share("YMin", "YMax") * spare.y()));
    around.map.scale(factor);
  }
  around.map.translate(Vec2(-box->min()));
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
  SvgOutline outline = svg_shape(element, attributes, around.viewport);
  if (outline.error) {
    const bool points = element == "polyline" || element == "polygon";
    return report(node, *outline.error, element == "path" ? "d" : points ? "points" : "attributes");
  }
  SvgShownShape shape;
  shape.node = node;
  shape.line = line_of(node);
  shape.id = unique_name(name_of(node, around), shape.line);
  shape.subpaths = std::move(outline.subpaths);
  shape.map = around.map;
  visitor.add(std::move(shape));
}

/// The shape's own id; of one shown by a `use` that of the use, and its own where the use shows several.
std::string SvgWalk::name_of(const pugi::xml_node& node, const Surroundings& around) const {
  const std::string id = node.attribute("id").value();
  const std::string own = id.empty() ? "stroke-" + std::to_string(shape_count_) : id;
  if (around.prefix.empty()) return own;
  const bool alone = path_.size() > 1 && svg_local_name(path_[path_.size() - 2]) == "use";
  return alone ? around.prefix : around.prefix + "/" + own;
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
  if (segments_ > most_curve_pieces) limit("The drawing has more than 4 million samples: simplify it", line);
  return !limit_reached_;
}

void SvgWalk::warn_of_ignored() {
  for (const auto& [name, entry] : ignored_) {
    const std::string advice = name == "text" ? ": turn text into paths to make it strokes" : ": only lines are read";
    findings_.file_warning("W_IGNORED",
                           std::to_string(entry.first) + ' ' + in_quotes(name) +
                               (entry.first == 1 ? " element was" : " elements were") + " ignored" + advice,
                           entry.second);
  }
}

}  // namespace croquis
