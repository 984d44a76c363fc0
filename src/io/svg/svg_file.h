// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include <Eigen/Geometry>
#include <pugixml.hpp>

#include "croquis/base/finding.h"
#include "croquis/base/progress.h"
#include "io/svg/svg_shapes.h"

namespace croquis {

/// "svg:path" and "path" are the same; other prefixes stay, so that they match nothing.
std::string_view svg_local_name(const pugi::xml_node& node);

bool is_svg_group(std::string_view name);

/// One SVG file: its elements, its style sheets, the names of its strokes, and all that can be wrong with it.
class SvgFile {
 public:
  /// Parses the file.
  /// @param bytes outlive this
  /// @throws Error E_EMPTY, E_SYNTAX
  SvgFile(std::string_view bytes, const std::string& file_name);

  pugi::xml_node root() const { return document_.document_element(); }
  std::int64_t line_of(const pugi::xml_node& node) { return line_at(node.offset_debug()); }

  /// A property of an element: its style attribute, then what style sheets say of its id, its classes and its name,
  /// then its own attribute; empty when it has none.
  std::string property(const pugi::xml_node& node, std::string_view name) const;

  /// The same of the element or of the nearest one around it in the file that has it.
  std::string inherited_property(pugi::xml_node node, std::string_view name) const;

  /// The name itself when it is free, else the name with the next free number, and a warning.
  std::string unique_name(const std::string& wanted, std::int64_t line);

  /// To be called for each subpath that is kept: no more pieces and bytes than fit. False when they don't.
  bool count_pieces(std::size_t pieces, std::size_t bytes, std::int64_t line);

  /// Notes once that a limit is reached: the rest of the file isn't read.
  void limit(const std::string& message, std::int64_t line);
  bool limit_reached() const { return limit_reached_; }

  /// Notes a finding, which is about a stroke or, without one, about the file. At most a hundred of a code are kept.
  void add(Finding finding, std::optional<std::int64_t> line, const std::string& stroke = {});

  /// What is wrong with the file as a whole, at once. @throws Error
  [[noreturn]] void refuse(const char* code, const std::string& message, std::optional<std::int64_t> line);

  /// @throws Error with all findings so far when one of them is an error
  void stop_on_errors();

  /// All findings so far; of codes that are too frequent the number of the others.
  Findings take();

 private:
  std::int64_t line_at(std::ptrdiff_t position);
  void read_sheets(const pugi::xml_node& parent, int level);

  std::string_view bytes_;
  std::string file_;
  std::string text_;  ///< the copy that pugixml takes apart
  pugi::xml_document document_;
  std::map<std::string, std::string, std::less<>> declarations_;  ///< of style sheets, by selector
  std::ptrdiff_t counted_to_ = 0;                                 ///< the place whose line is known, and that line:
  std::int64_t line_ = 1;                                         ///< places come in rising order
  Findings findings_;
  std::map<std::string, std::size_t> counts_;  ///< of findings by code
  std::set<std::string> names_;
  std::map<std::string, int> copies_;  ///< of names that several strokes have
  std::size_t copied_ = 0, segments_ = 0;
  bool limit_reached_ = false;
};

/// A shape that is to be shown, with its outline in its own coordinates.
struct SvgShownShape {
  pugi::xml_node node;
  std::string id;  ///< of its own or "stroke-N" for the N-th shape; no other one's
  std::int64_t line = 0;
  std::vector<SvgSubpath> subpaths;
  Eigen::Affine2d map = Eigen::Affine2d::Identity();  ///< of the shape and all groups around it
  const std::vector<pugi::xml_node>& path;  ///< what is around it, the outermost first, then it itself; what a `use`
                                            ///< shows is within that use
};

/// What is made of the elements.
struct SvgVisitor {
  std::function<void(const pugi::xml_node& group)> enter;  ///< a group that is to be shown, before what is in it
  std::function<void(SvgShownShape shape)> add;
};

/// Shows all shapes to the visitor, in the order of the file. What is wrong goes into the file's findings.
/// @throws Cancelled
void visit_svg(SvgFile& file, const SvgVisitor& visitor, Progress& progress);

/// E_NO_STROKES
Finding no_svg_strokes();

/// The part of the plane that the file's page shows; empty when it doesn't say.
Eigen::AlignedBox2d svg_page(const pugi::xml_node& root);

}  // namespace croquis
