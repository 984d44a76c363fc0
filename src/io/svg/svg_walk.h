// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <Eigen/Geometry>
#include <pugixml.hpp>

#include "croquis/base/finding.h"
#include "croquis/base/progress.h"
#include "io/svg/svg_shapes.h"

/// A file's elements, and all that can be wrong with them.
namespace croquis {

/// "svg:path" and "path" are the same; other prefixes stay, so that they match nothing.
std::string_view svg_local_name(const pugi::xml_node& node);

bool is_svg_group(std::string_view name);

/// Elements that draw nothing by themselves.
bool is_svg_definition(std::string_view name);

/// The value of a property in a list of declarations ("a: b; c: d"), the last one; empty when it is not there.
std::string_view svg_declared(std::string_view declarations, std::string_view property);

/// A property as an attribute or, stronger, in the style attribute.
std::string svg_property(const pugi::xml_node& node, std::string_view name);

/// Declarations of a file's style sheets: rules whose selector is a class, an id or an element's name alone
/// (".a, #b, path { stroke: red }").
class SvgClasses {
 public:
  /// All `style` elements below the root that stand among definitions or in few groups.
  void read(const pugi::xml_node& root);

  /// A property of an element: its style attribute, then what sheets say of its id, its classes and its name, then its
  /// own attribute; empty when it has none.
  std::string property(const pugi::xml_node& node, std::string_view name) const;

  /// The same of the element or of the nearest element around it that has one.
  std::string inherited(pugi::xml_node node, std::string_view name) const;

 private:
  void read(const pugi::xml_node& root, int level);
  void read_sheet(std::string_view text);

  std::string_view of_rule(std::string_view selector, std::string_view name) const;

  std::map<std::string, std::string, std::less<>> declarations_;  ///< by selector
};

/// Findings about one drawing: at most a hundred of a code, then only the number of the others.
class SvgFindings {
 public:
  explicit SvgFindings(std::string file) : file_(std::move(file)) {}

  void file_error(Category category, const char* code, const std::string& message,
                  std::optional<std::int64_t> line = std::nullopt);
  void stroke_error(Category category, const char* code, const std::string& message, const std::string& stroke,
                    std::int64_t line);
  void stroke_warning(const char* code, const std::string& message, const std::string& stroke, std::int64_t line);
  void stroke_note(const char* code, const std::string& message, const std::string& stroke, std::int64_t line);
  void file_warning(const char* code, const std::string& message, std::int64_t line);

  /// @throws Error with all findings so far when one of them is an error
  void stop_on_errors();
  Findings take();

 private:
  void add(Finding finding);

  std::string file_;
  Findings findings_;
  std::map<std::string, std::size_t> counts_;
};

/// Line of a place in a text, in constant time on average for places that come in rising order.
class LineCounter {
 public:
  explicit LineCounter(std::string_view text) : text_(text) {}

  std::int64_t line_at(std::size_t position);  ///< 1-based

 private:
  std::string_view text_;
  std::size_t position_ = 0;
  std::int64_t line_ = 1;
};

/// A shape that is to be shown, with its outline in its own coordinates.
struct SvgShownShape {
  pugi::xml_node node;
  std::string id;  ///< of its own or "stroke-N" for the N-th shape; no other one's
  std::int64_t line = 0;
  std::vector<SvgSubpath> subpaths;
  Eigen::Affine2d map = Eigen::Affine2d::Identity();  ///< of the shape and all groups around it
};

/// What is made of the elements.
class SvgVisitor {
 public:
  virtual ~SvgVisitor() = default;
  virtual void enter(const pugi::xml_node& group) = 0;  ///< a group that is to be shown, before what is in it
  virtual void add(SvgShownShape shape) = 0;
};

/// One reading of one file: XML, groups, transforms, visibility, names, and all that can be wrong with them.
class SvgWalk {
 public:
  SvgWalk(std::string_view bytes, const std::string& file, Progress& progress)
      : bytes_(bytes), lines_(bytes), findings_(file), progress_(progress) {}

  /// Parses the file. @throws Error
  pugi::xml_node parse();

  /// Shows all shapes to the visitor, in the order of the file. What is wrong goes into the findings.
  void visit(const pugi::xml_node& root, SvgVisitor& visitor);

  /// The elements around the one that is being shown, the outermost first, it itself last. What a `use` shows is within
  /// that use.
  const std::vector<pugi::xml_node>& path() const { return path_; }

  /// A property of an element from its style, its classes or its own attribute; empty when it has none.
  std::string property(const pugi::xml_node& node, std::string_view name) const {
    return classes_.property(node, name);
  }

  /// The same of the element being shown or of the nearest one around it that has one.
  std::string inherited_property(std::string_view name) const;

  /// The part of the plane that the file's page shows; empty when it doesn't say.
  const Eigen::AlignedBox2d& page() const { return page_; }

  /// To be called for each subpath that is kept: no more pieces and bytes than fit. False when they don't.
  bool count_pieces(std::size_t pieces, std::size_t bytes, std::int64_t line);

  /// The name itself when it is free, else the name with the next free number, and a warning.
  std::string unique_name(const std::string& wanted, std::int64_t line);

  void limit(const std::string& message, std::int64_t line);
  [[noreturn]] void throw_findings();

  /// What is wrong with the file as a whole, at once. @throws Error
  [[noreturn]] void refuse(const char* code, const std::string& message, std::optional<std::int64_t> line);

  std::int64_t line_of(const pugi::xml_node& node);
  SvgFindings& findings() { return findings_; }
  bool limit_reached() const { return limit_reached_; }

  /// An attribute that can't be read: of a shape, or of a group.
  void report(const pugi::xml_node& node, const SvgTextError& error, const char* attribute);

 private:
  struct Surroundings {
    Eigen::Affine2d map = Eigen::Affine2d::Identity();
    bool visible = true;
    int level = 0;
    SvgViewport viewport;
    std::string prefix;  ///< of the names of what is shown by a `use`
  };

  void visit(const pugi::xml_node& node, Surroundings around, SvgVisitor& visitor);
  void ignore(const pugi::xml_node& node, std::string_view name);
  bool enter(const pugi::xml_node& node, Surroundings& around, SvgVisitor& visitor);
  bool transform(const pugi::xml_node& node, Surroundings& around);
  void enter_page(const pugi::xml_node& root, Surroundings& around);
  void enter_viewport(const pugi::xml_node& node, const pugi::xml_node& placed_by, Surroundings& around);
  void visit_children(const pugi::xml_node& node, Surroundings around, SvgVisitor& visitor);
  void visit_use(const pugi::xml_node& node, Surroundings around, SvgVisitor& visitor);
  pugi::xml_node element_named(std::string_view id);
  std::string name_of(const pugi::xml_node& node, const Surroundings& around) const;
  void read_shape(const pugi::xml_node& node, std::string_view element, const Surroundings& around,
                  SvgVisitor& visitor);
  void warn_of_ignored();

  std::string_view bytes_;
  std::string text_;  ///< the copy that pugixml takes apart
  pugi::xml_document document_;
  LineCounter lines_;
  SvgFindings findings_;
  Progress& progress_;
  SvgClasses classes_;
  std::vector<pugi::xml_node> path_;
  Eigen::AlignedBox2d page_;
  std::map<std::string, pugi::xml_node, std::less<>> by_id_;  ///< filled by the first `use`
  bool ids_known_ = false;
  std::set<std::string> names_;
  std::map<std::string, int> copies_;
  std::map<std::string, std::pair<int, std::int64_t>> ignored_;  ///< element name: how many, line of the first
  std::size_t shape_count_ = 0;
  std::size_t elements_ = 0;
  std::size_t uses_ = 0;
  std::size_t copied_ = 0;
  std::size_t segments_ = 0;
  bool limit_reached_ = false;
};

}  // namespace croquis
