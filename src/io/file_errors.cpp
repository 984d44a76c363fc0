// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/file_errors.h"

#include <cerrno>
#include <cstring>

#include "croquis/base/error.h"

namespace croquis {

std::string reading_reason(int error) {
  switch (error) {
    case ENOENT: return "there is no such file";
    case EACCES: return "you have no permission to read it";
    case EISDIR: return "it is a folder";
    case ENOTDIR: return "a part of its path is not a folder";
    default: return std::strerror(error);
  }
}

std::string writing_reason(int error) {
  switch (error) {
    case ENOENT: return "its folder does not exist";
    case ENOTDIR: return "a part of its path is not a folder";
    case EISDIR: return "it is a folder";
    case EACCES: return "you have no permission to write there";
    case ENOSPC: return "the disk is full";
    default: return std::strerror(error);
  }
}

void fail_reading(const std::string& path, const std::string& reason) {
  throw Error(make_error(Category::Malformed, "E_FILE_OPEN", "The file '" + path + "' can't be read: " + reason + ".",
                         {{SubjectKind::File, path, path, std::nullopt, {}}}));
}

void fail_writing(const std::string& path, const std::string& reason) {
  throw Error(make_error(Category::Io, "E_WRITE", "The file '" + path + "' can't be written: " + reason + ".",
                         {{SubjectKind::File, path, path, std::nullopt, {}}}));
}

}  // namespace croquis
