// SPDX-License-Identifier: GPL-3.0-or-later
#include "croquis/io/svg_drawing.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <utility>

#include <pugixml.hpp>

#include "croquis/base/error.h"
#include "io/svg/svg_findings.h"
#include "io/svg/svg_flattening.h"
#include "io/svg/svg_scanner.h"
#include "io/svg/svg_shapes.h"
#include "io/svg/svg_transform.h"
#include "io/text.h"

namespace croquis {
namespace {

constexpr int deepest_level = 256;                          // of nesting; drawing programs stay below 30
constexpr std::size_t most_copied = std::size_t{64} << 20;  // bytes of ids and data attributes, kept per subpath
constexpr std::size_t elements_per_check = 256;

/// What an element inherits from those around it.
struct Surroundings {
  Eigen::Affine2d map = Eigen::Affine2d::Identity();
  std::string object;
  bool visible = true;
  int level = 0;
};

/// "svg:path" and "path" are the same; other prefixes stay, so that they match nothing.
std::string_view local_name(const pugi::xml_node& node) {
  std::string_view name = node.name();
  if (name.substr(0, 4) == "svg:") name.remove_prefix(4);
  return name;
}

template <std::size_t N>
bool is_one_of(std::string_view name, const std::array<std::string_view, N>& names) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

bool is_group(std::string_view name) {
  return is_one_of(name, std::array<std::string_view, 4>{"g", "a", "svg", "switch"});
}

/// Elements that draw nothing by themselves.
bool is_definition(std::string_view name) {
  constexpr std::array<std::string_view, 18> names{
      "defs",  "clipPath", "symbol", "marker", "pattern",        "mask",           "title", "desc", "metadata",
      "style", "script",   "filter", "cursor", "linearGradient", "radialGradient", "set",   "view", "font"};
  return is_one_of(name, names) || name.substr(0, 7) == "animate" || name.find(':') != std::string_view::npos;
}

/// A property as an attribute or, stronger, in the style attribute.
std::string property(const pugi::xml_node& node, std::string_view name) {
  std::string value(trimmed(node.attribute(std::string(name).c_str()).value()));
  std::string_view style = node.attribute("style").value();
  while (!style.empty()) {
    const std::string_view declaration = style.substr(0, style.find(';'));
    style.remove_prefix(std::min(style.size(), declaration.size() + 1));
    const std::size_t colon = declaration.find(':');
    if (colon == std::string_view::npos || trimmed(declaration.substr(0, colon)) != name) continue;
    value = trimmed(declaration.substr(colon + 1));
  }
  return value;
}

std::map<std::string, std::string> data_attributes(const pugi::xml_node& node) {
  std::map<std::string, std::string> data;
  for (const pugi::xml_attribute& attribute : node.attributes()) {
    const std::string_view name = attribute.name();
    if (name.substr(0, 5) == "data-" && name != "data-object") data.emplace(name.substr(5), attribute.value());
  }
  return data;
}

/// One reading of one file.
class SvgReader {
 public:
  SvgReader(std::string_view bytes, const std::string& file, Progress& progress)
      : bytes_(bytes), lines_(bytes), findings_(file), progress_(progress) {
    result_.drawing.file = file;
  }

  DrawingReadResult read() {
    const pugi::xml_node root = parse();
    read_plane(root);
    visit(root, {});
    warn_of_ignored();
    if (shapes_.empty() && !limit_reached_) {
      findings_.file_error(Category::Malformed, "E_NO_STROKES",
                           "The drawing has no visible path, line or other shape: there is nothing to make a solid of");
    }
    findings_.stop_on_errors();
    flatten();
    result_.warnings = findings_.take();
    return std::move(result_);
  }

 private:
  [[noreturn]] void refuse(const char* code, const std::string& message, std::optional<std::int64_t> line) {
    findings_.file_error(Category::Malformed, code, message, line);
    throw_findings();
  }

  [[noreturn]] void throw_findings() { throw Error(findings_.take()); }

  pugi::xml_node parse() {
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
    if (local_name(root) != "svg") {
      refuse("E_SYNTAX", "The file is not SVG: its outermost element is " + in_quotes(root.name()), line_of(root));
    }
    return root;
  }

  void read_plane(const pugi::xml_node& root) {
    const pugi::xml_attribute attribute = root.attribute("data-plane");
    if (!attribute) return;
    SvgScanner scanner(attribute.value());
    DrawingPlane plane;
    bool complete = true;
    for (Vec3* vector : {&plane.origin, &plane.u, &plane.v}) {
      for (double& value : *vector) {
        scanner.skip_separators();
        const std::optional<double> number = scanner.number();
        complete = complete && number;
        value = number.value_or(0);
      }
    }
    scanner.skip_blanks();
    if (!complete || !scanner.at_end() || !plane.is_orthonormal()) {
      refuse(
          "E_SYNTAX",
          "The drawing's data-plane is no plane: it takes nine numbers, an origin and two directions of length 1 at a "
          "right angle",
          line_of(root));
    }
    result_.drawing.plane = plane;
  }

  std::int64_t line_of(const pugi::xml_node& node) {
    return lines_.line_at(static_cast<std::size_t>(std::max<std::ptrdiff_t>(node.offset_debug(), 0)));
  }

  void limit(const std::string& message, std::int64_t line) {
    if (!limit_reached_) findings_.file_error(Category::Limit, "E_LIMIT", message, line);
    limit_reached_ = true;
  }

  void visit(const pugi::xml_node& node, Surroundings around) {
    if (limit_reached_ || node.type() != pugi::node_element) return;
    if (++elements_ % elements_per_check == 0) progress_.check();
    const std::string_view name = local_name(node);
    if (is_definition(name)) return;
    if (!is_group(name) && !is_svg_shape(name)) return ignore(node, name);
    if (!enter(node, around)) return;
    if (is_svg_shape(name)) return read_shape(node, name, around);
    if (++around.level > deepest_level) {
      return limit("The drawing is nested deeper than 256 groups: ungroup it", line_of(node));
    }
    if (name == "svg" && around.level > 1) enter_inner_svg(node, around);
    for (const pugi::xml_node& child : node.children()) visit(child, around);
  }

  void ignore(const pugi::xml_node& node, std::string_view name) {
    auto& entry = ignored_[std::string(name)];
    if (entry.first++ == 0) entry.second = line_of(node);
  }

  /// Takes over the settings of an element for itself and its children. False when it is not to be shown.
  bool enter(const pugi::xml_node& node, Surroundings& around) {
    if (property(node, "display") == "none") return false;
    const std::string visibility = property(node, "visibility");
    if (!visibility.empty() && visibility != "inherit") around.visible = visibility == "visible";
    if (const pugi::xml_attribute attribute = node.attribute("transform")) {
      const SvgTransform transform = parse_svg_transform(attribute.value());
      if (transform.error) return report(node, *transform.error, "transform"), false;
      around.map = around.map * transform.map;
    }
    enter_object(node, around);
    return true;
  }

  void enter_object(const pugi::xml_node& node, Surroundings& around) {
    const pugi::xml_attribute object = node.attribute("data-object");
    if (!object || *object.value() == '\0') return;
    around.object = object.value();
    if (is_group(local_name(node))) result_.drawing.object_data[around.object].merge(data_attributes(node));
  }

  void enter_inner_svg(const pugi::xml_node& node, Surroundings& around) {
    std::optional<SvgTextError> error;
    const SvgAttributes attributes = [&](const char* name) { return std::string_view(node.attribute(name).value()); };
    const Vec2 origin(svg_length(attributes, "x", 0, error), svg_length(attributes, "y", 0, error));
    if (error) report(node, *error, "x or y");
    around.map.translate(origin);
    if (node.attribute("viewBox")) {
      findings_.file_warning("W_IGNORED", "The viewBox of an svg element within the drawing was ignored",
                             line_of(node));
    }
  }

  /// An attribute that can't be read: of a shape, or of a group.
  void report(const pugi::xml_node& node, const SvgTextError& error, const char* attribute) {
    const std::int64_t line = line_of(node);
    if (error.limit) return limit("A path of the drawing has more than 4 million pieces: simplify it", line);
    const std::string id = node.attribute("id").value();
    const bool shape = is_svg_shape(local_name(node));
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

  void read_shape(const pugi::xml_node& node, std::string_view element, const Surroundings& around) {
    ++shape_count_;
    if (!around.visible) return;
    const SvgAttributes attributes = [&](const char* name) { return std::string_view(node.attribute(name).value()); };
    SvgOutline outline = svg_shape(element, attributes);
    if (outline.error) {
      const bool points = element == "polyline" || element == "polygon";
      return report(node, *outline.error, element == "path" ? "d" : points ? "points" : "attributes");
    }
    Stroke stroke;
    stroke.line = line_of(node);
    stroke.object = around.object;
    stroke.data = data_attributes(node);
    const std::string id = node.attribute("id").value();
    const std::string base = unique_name(id.empty() ? "stroke-" + std::to_string(shape_count_) : id, *stroke.line);
    std::size_t number = 0;
    for (SvgSubpath& subpath : outline.subpaths) {
      if (subpath.segments.empty() && !subpath.closed) continue;  // a moveto alone draws nothing
      ++number;
      stroke.id = number == 1 ? base : unique_name(base + '/' + std::to_string(number), *stroke.line);
      if (!add(stroke, std::move(subpath), around.map)) return;
    }
  }

  /// The name itself when it is free, else the name with the next free number, and a warning.
  std::string unique_name(const std::string& wanted, std::int64_t line) {
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

  /// False when the rest of the element must not be read.
  bool add(const Stroke& stroke, SvgSubpath subpath, const Eigen::Affine2d& map) {
    if (subpath.segments.empty()) {
      findings_.stroke_warning("W_TINY", "Stroke " + in_quotes(stroke.id) + " is a single point and was ignored",
                               stroke.id, *stroke.line);
      return true;
    }
    transform(subpath, Eigen::Affine2d(Eigen::Scaling(1.0, -1.0)) * map);
    if (!is_finite(subpath)) {
      findings_.stroke_error(Category::Malformed, "E_NOT_FINITE",
                             "Stroke " + in_quotes(stroke.id) + " on line " + std::to_string(*stroke.line) +
                                 " has a coordinate that is not a finite number",
                             stroke.id, *stroke.line);
      return true;
    }
    copied_ += stroke.id.size() + stroke.object.size();
    for (const auto& [name, value] : stroke.data) copied_ += name.size() + value.size();
    segments_ += subpath.segments.size();
    if (copied_ > most_copied) limit("The strokes' names and data attributes exceed 64 MiB", *stroke.line);
    if (segments_ > svg_most_segments) limit("The drawing has more than 4 million samples: simplify it", *stroke.line);
    if (limit_reached_) return false;
    shapes_.push_back({stroke, std::move(subpath)});
    return true;
  }

  void warn_of_ignored() {
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

  void flatten() {
    FlatteningLimits limits;
    for (const SvgShape& shape : shapes_) extend(limits.bounds, shape.outline);
    limits.tolerance = svg_flattening_tolerance * limits.bounds.diagonal().norm();
    for (SvgShape& shape : shapes_) {
      progress_.check();
      if (!flatten_into(shape.stroke, shape.outline, limits)) {
        limit("The drawing has more than 4 million samples: simplify it", *shape.stroke.line);
        throw_findings();
      }
      result_.drawing.strokes.push_back(std::move(shape.stroke));
    }
  }

  struct SvgShape {
    Stroke stroke;  ///< without samples yet
    SvgSubpath outline;
  };

  std::string_view bytes_;
  std::string text_;  ///< the copy that pugixml takes apart
  pugi::xml_document document_;
  LineCounter lines_;
  SvgFindings findings_;
  Progress& progress_;
  DrawingReadResult result_;
  std::vector<SvgShape> shapes_;
  std::set<std::string> names_;
  std::map<std::string, int> copies_;
  std::map<std::string, std::pair<int, std::int64_t>> ignored_;  ///< element name: how many, line of the first
  std::size_t shape_count_ = 0;
  std::size_t elements_ = 0;
  std::size_t copied_ = 0;
  std::size_t segments_ = 0;
  bool limit_reached_ = false;
};

}  // namespace

DrawingReadResult read_svg_drawing(std::string_view bytes, const std::string& file_name, Progress& progress) {
  return SvgReader(bytes, file_name, progress).read();
}

}  // namespace croquis
