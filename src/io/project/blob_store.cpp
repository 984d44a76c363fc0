// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/project/blob_store.h"

#include <algorithm>

#include <xxhash.h>

#include "croquis/document/byte_stream.h"
#include "io/project/schema.h"

namespace croquis {
namespace {

constexpr auto chunk_size = static_cast<std::size_t>(max_chunk_bytes);

bool is_stored(const Database& database, std::string_view hash) {
  return Statement(database, "SELECT 1 FROM blobs WHERE hash=?").bind_blob(0, hash).step();
}

std::int64_t stored_length(const Database& database, std::string_view hash) {
  Statement statement(database, "SELECT length FROM blobs WHERE hash=?");
  if (!statement.bind_blob(0, hash).step()) throw BadBytes("they are missing");
  return statement.integer(0);
}

}  // namespace

std::string blob_hash(std::string_view bytes) {
  XXH128_canonical_t canonical;
  XXH128_canonicalFromHash(&canonical, XXH3_128bits(bytes.data(), bytes.size()));
  return {reinterpret_cast<const char*>(canonical.digest), sizeof(canonical.digest)};
}

void store_blob(const Database& database, std::string_view hash, std::string_view bytes, const Progress& progress) {
  if (is_stored(database, hash)) return;
  run_statement(database, "INSERT INTO blobs(hash, length) VALUES(?, ?)", Bytes{hash},
                static_cast<std::int64_t>(bytes.size()));
  Statement insert(database, "INSERT INTO chunks(hash, number, bytes) VALUES(?, ?, ?)");
  for (std::size_t begin = 0; begin < bytes.size(); begin += chunk_size) {
    progress.check();
    const auto number = static_cast<std::int64_t>(begin / chunk_size);
    insert.bind_blob(0, hash).bind(1, number).bind_blob(2, bytes.substr(begin, chunk_size)).run();
  }
}

std::string load_blob(const Database& database, std::string_view hash, const Progress& progress) {
  const std::int64_t length = stored_length(database, hash);
  Statement chunks(database, "SELECT number, bytes FROM chunks WHERE hash=? ORDER BY number");
  chunks.bind_blob(0, hash);
  std::string bytes;
  for (std::int64_t number = 0; chunks.step(); ++number) {
    progress.check();
    if (chunks.integer(0) != number || !chunks.is_blob(1)) throw BadBytes("a part of them is missing");
    bytes.append(chunks.blob(1));
  }
  if (static_cast<std::int64_t>(bytes.size()) != length) throw BadBytes("a part of them is missing");
  if (blob_hash(bytes) != hash) throw BadBytes("they have changed since they were saved");
  return bytes;
}

void remove_unused_blobs(Database& database) {
  std::string used = "(SELECT hash FROM sources";
  if (has_tables(database, TableGroup::Backdrops)) used += " UNION SELECT hash FROM backdrops";
  if (has_tables(database, TableGroup::Results)) used += " UNION SELECT hash FROM kept_results";
  if (has_tables(database, TableGroup::Past))
    used += " UNION SELECT source FROM past_nodes UNION SELECT picture FROM past_nodes";
  used += ")";
  for (const char* table : {"chunks", "blobs"})
    database.execute(std::string("DELETE FROM ") + table + " WHERE hash NOT IN " + used);
}

}  // namespace croquis
