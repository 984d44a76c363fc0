// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>

#include "croquis/base/progress.h"
#include "io/project/database.h"

/// Large values in a project database, found by what is in them: the same contents are stored once.
namespace croquis {

/// XXH3 with 128 bits and seed 0, as its 16 canonical (big-endian) bytes.
std::string blob_hash(std::string_view bytes);

/// Stores the bytes in chunks, unless they are there already.
/// @throws DatabaseError, Cancelled
void store_blob(const Database& database, std::string_view hash, std::string_view bytes, const Progress& progress);

/// The bytes of that hash. Takes no more memory than the file has bytes, whatever lengths it claims.
/// @throws BadBytes when they are missing, incomplete or others
/// @throws DatabaseError, Cancelled
std::string load_blob(const Database& database, std::string_view hash, const Progress& progress);

/// Removes those that no source and no backdrop uses any more.
void remove_unused_blobs(Database& database);

}  // namespace croquis
