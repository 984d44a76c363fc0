// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <utility>

#include "croquis/base/limits.h"
#include "io/svg/svg_file.h"
#include "io/text.h"

namespace croquis {
namespace {

constexpr std::size_t most_uses = 100'000;  // a few nested uses can show billions of shapes
constexpr std::size_t elements_per_check = 256;

/// Elements that draw nothing by themselves.
bool is_definition(std::string_view name) {
  constexpr std::array<std::string_view, 19> names{"defs",   "clipPath", "symbol", "marker",         "pattern",
                                                   "mask",   "title",    "desc",   "metadata",       "style",
                                                   "script", "filter",   "cursor", "linearGradient", "radialGradient",
                                                   "set",    "view",     "font",   "foreignObject"};
  return std::ranges::find(names, name) != names.end() || name.starts_with("animate") ||
         name.find(':') != std::string_view::npos;
}

/// Whether an opacity is written as 0: "0", "0.0", "0%".
bool is_nothing(const std::string& opacity) {
  return opacity.find('0') != std::string::npos && opacity.find_first_not_of("0.% ") == std::string::npos;
}

/// "x y width height"; empty when it is not there, or not to be understood.
std::optional<Eigen::AlignedBox2d> view_box(const pugi::xml_node& node) {
  SvgScanner scanner(node.attribute("viewBox").value());
  const auto values = scanner.numbers<4>();
  if (!values || !are_usable_numbers(*values)) return std::nullopt;
  const auto [x, y, width, height] = *values;
  if (std::min(width, height) <= 0) return std::nullopt;
  return Eigen::AlignedBox2d(Vec2(x, y), Vec2(x, y) + Vec2(width, height));
}

/// What holds for an element and all that is in it.
struct Surroundings {
  Eigen::Affine2d map = Eigen::Affine2d::Identity();
  bool visible = true;
  int level = 0;
  Vec2 viewport = Vec2::Zero();  ///< see SvgLengths
  std::string prefix;            ///< of the names of what is shown by a `use`
};

/// Fits the viewBox of an svg element within the drawing, or of a symbol, into its place (SVG 1.1, 7.7 and 7.8).
/// @param lengths of the svg element itself, or of the `use` that shows the symbol and has placed it already
void fit_view_box(const pugi::xml_node& node, SvgLengths& lengths, bool is_placed, Surroundings& around) {
  const Vec2 origin = is_placed ? Vec2(Vec2::Zero()) : Vec2(lengths.at("x"), lengths.at("y"));
  const std::optional<Eigen::AlignedBox2d> box = view_box(node);
  const Vec2 natural = box ? Vec2(box->sizes()) : around.viewport;
  const Vec2 whole = around.viewport.minCoeff() > 0 ? around.viewport : natural;
  const Vec2 size(lengths.at("width", whole.x()), lengths.at("height", whole.y()));
  around.map.translate(origin);
  around.viewport = box ? Vec2(box->sizes()) : size;
  if (!box || !(size.minCoeff() > 0)) return;
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

/// One walk over the elements that are shown.
class Walk {
 public:
  Walk(SvgFile& file, const SvgVisitor& visitor, Progress& progress)
      : file_(file), visitor_(visitor), progress_(progress) {}

  void run() {
    visit(file_.root(), {});
    for (const auto& [name, entry] : ignored_) {
      const std::string advice = name == "text" ? ": turn text into paths to make it strokes" : ": only lines are read";
      warn_ignored(std::to_string(entry.first) + ' ' + in_quotes(name) +
                       (entry.first == 1 ? " element was" : " elements were") + " ignored" + advice,
                   entry.second);
    }
  }

 private:
  void warn_ignored(const std::string& message, std::int64_t line) {
    file_.add(make_warning(Category::Malformed, "W_IGNORED", message), line);
  }

  void visit(const pugi::xml_node& node, Surroundings around) {
    if (file_.limit_reached() || node.type() != pugi::node_element) return;
    if (++elements_ % elements_per_check == 0) progress_.check();
    const std::string_view name = svg_local_name(node);
    if (is_definition(name)) return;
    const bool shows_another = name == "use";
    if (!is_svg_group(name) && !is_svg_shape(name) && !shows_another) {
      auto& entry = ignored_[std::string(name)];
      if (entry.first++ == 0) entry.second = file_.line_of(node);
      return;
    }
    if (++around.level > deepest_nesting) {
      return file_.limit("The drawing is nested deeper than " + std::to_string(deepest_nesting) + " groups: ungroup it",
                         file_.line_of(node));
    }
    path_.push_back(node);
    if (enter(node, around)) {
      if (shows_another) {
        visit_use(node, std::move(around));
      } else if (is_svg_shape(name)) {
        read_shape(node, around);
      } else {
        if (name == "svg" && path_.size() == 1) {
          const Eigen::AlignedBox2d page = svg_page(node);
          if (!page.isEmpty()) around.viewport = page.sizes();
        } else if (name == "svg") {
          enter_viewport(node, node, around);
        }
        for (const pugi::xml_node& child : node.children()) visit(child, around);
      }
    }
    path_.pop_back();
  }

  /// Takes over the settings of an element for itself and its children. False when it is not to be shown.
  bool enter(const pugi::xml_node& node, Surroundings& around) {
    if (file_.property(node, "display") == "none" || is_nothing(file_.property(node, "opacity"))) return false;
    const std::string visibility = file_.property(node, "visibility");
    if (!visibility.empty() && visibility != "inherit") around.visible = visibility == "visible";
    // A transform in the style or in a class counts instead of the attribute (CSS Transforms 1, section 12).
    const std::string text = file_.property(node, "transform");
    const SvgTransform transform = parse_svg_transform(text);
    if (transform.error) return report(node, *transform.error, "transform"), false;
    if (!text.empty()) around.map = around.map * transform.map;
    if (is_svg_group(svg_local_name(node))) visitor_.enter(node);
    return true;
  }

  void enter_viewport(const pugi::xml_node& node, const pugi::xml_node& placed_by, Surroundings& around) {
    SvgLengths lengths(placed_by, around.viewport);
    fit_view_box(node, lengths, placed_by != node, around);
    if (lengths.error()) report(placed_by, *lengths.error(), "x, y, width or height");
  }

  /// Shows the element that a `use` names, at the place of the use (SVG 1.1, 5.6).
  void visit_use(const pugi::xml_node& node, Surroundings around) {
    const std::int64_t line = file_.line_of(node);
    std::string_view target = node.attribute("href").value();
    if (target.empty()) target = node.attribute("xlink:href").value();
    const pugi::xml_node used = target.starts_with('#') ? element_named(target.substr(1)) : pugi::xml_node();
    if (!used) {
      return warn_ignored("A use element was ignored, for the drawing has no element " + in_quotes(target), line);
    }
    if (std::find(path_.begin(), path_.end(), used) != path_.end()) {
      return file_.add(make_error(Category::Malformed, "E_SYNTAX",
                                  "The use element on line " + std::to_string(line) + " shows " + in_quotes(target) +
                                      ", which it is a part of itself"),
                       line);
    }
    if (++uses_ > most_uses) return file_.limit("The drawing shows elements by use more than 100,000 times", line);
    SvgLengths lengths(node, around.viewport);
    const Vec2 origin(lengths.at("x"), lengths.at("y"));
    if (lengths.error()) return report(node, *lengths.error(), "x or y");
    around.map.translate(origin);
    const std::string own = node.attribute("id").value();
    around.prefix = around.prefix.empty() || own.empty() ? around.prefix + own : around.prefix + "/" + own;
    if (svg_local_name(used) != "symbol") return visit(used, std::move(around));
    path_.push_back(used);
    if (enter(used, around)) {
      enter_viewport(used, node, around);
      for (const pugi::xml_node& child : used.children()) visit(child, around);
    }
    path_.pop_back();
  }

  pugi::xml_node element_named(std::string_view id) {
    if (by_id_.empty()) {
      by_id_.try_emplace("", pugi::xml_node());  // so that they are searched once
      std::vector<pugi::xml_node> waiting{file_.root()};
      while (!waiting.empty()) {
        const pugi::xml_node node = waiting.back();
        waiting.pop_back();
        by_id_.try_emplace(node.attribute("id").value(), node);
        for (const pugi::xml_node& child : node.children()) {
          if (child.type() == pugi::node_element) waiting.push_back(child);
        }
      }
    }
    const auto found = by_id_.find(id);
    return found == by_id_.end() ? pugi::xml_node() : found->second;
  }

  void read_shape(const pugi::xml_node& node, const Surroundings& around) {
    ++shape_count_;
    if (!around.visible) return;
    const std::string_view element = svg_local_name(node);
    SvgOutline outline = svg_shape(element, node, around.viewport);
    if (outline.error) {
      const bool points = element == "polyline" || element == "polygon";
      return report(node, *outline.error, element == "path" ? "d" : points ? "points" : "attributes");
    }
    const std::int64_t line = file_.line_of(node);
    visitor_.add(
        {node, file_.unique_name(name_of(node, around), line), line, std::move(outline.subpaths), around.map, path_});
  }

  /// The shape's own id; of one shown by a `use` that of the use, and its own where the use shows several.
  std::string name_of(const pugi::xml_node& node, const Surroundings& around) const {
    const std::string id = node.attribute("id").value();
    const std::string own = id.empty() ? "stroke-" + std::to_string(shape_count_) : id;
    if (around.prefix.empty()) return own;
    const bool alone = path_.size() > 1 && svg_local_name(path_[path_.size() - 2]) == "use";
    return alone ? around.prefix : around.prefix + "/" + own;
  }

  /// Notes an attribute that can't be read: of a shape, or of a group.
  void report(const pugi::xml_node& node, const SvgTextError& error, const char* attribute) {
    const std::int64_t line = file_.line_of(node);
    if (error.limit) return file_.limit("A path of the drawing has more than 4 million pieces: simplify it", line);
    const std::string id = node.attribute("id").value();
    const bool shape = is_svg_shape(svg_local_name(node));
    const std::string name = !id.empty() ? id : shape ? "stroke-" + std::to_string(shape_count_) : "";
    const std::string who = shape          ? "Stroke " + in_quotes(name)
                            : name.empty() ? "A group"
                                           : "The group " + in_quotes(name);
    file_.add(make_error(Category::Malformed, "E_SYNTAX",
                         who + " on line " + std::to_string(line) + ' ' + error.message + " (character " +
                             std::to_string(error.position + 1) + " of its " + attribute + ")"),
              line, shape ? name : std::string());
  }

  SvgFile& file_;
  const SvgVisitor& visitor_;
  Progress& progress_;
  std::vector<pugi::xml_node> path_;
  std::map<std::string, pugi::xml_node, std::less<>> by_id_;     ///< filled by the first `use`
  std::map<std::string, std::pair<int, std::int64_t>> ignored_;  ///< element name: how many, line of the first
  std::size_t shape_count_ = 0, elements_ = 0, uses_ = 0;
};

}  // namespace

void visit_svg(SvgFile& file, const SvgVisitor& visitor, Progress& progress) { Walk(file, visitor, progress).run(); }

/// The page's own scaling isn't applied: lengths of the drawing are those that its shapes have.
Eigen::AlignedBox2d svg_page(const pugi::xml_node& root) {
  if (const auto box = view_box(root)) return *box;
  SvgLengths lengths(root, Vec2::Zero());
  const Vec2 size(lengths.at("width"), lengths.at("height"));
  const bool known = !lengths.error() && size.minCoeff() > 0;
  return known ? Eigen::AlignedBox2d(Vec2(Vec2::Zero()), size) : Eigen::AlignedBox2d();
}

}  // namespace croquis
