// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>

#include "croquis/base/finding.h"

namespace croquis {

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

}  // namespace croquis
