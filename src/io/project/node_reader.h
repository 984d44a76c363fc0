// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <set>
#include <span>
#include <vector>

#include "croquis/document/document.h"
#include "io/project/damage_log.h"
#include "io/project/database.h"
#include "io/project/node_rows.h"
#include "io/project/schema.h"

namespace croquis {

/// The rows of all nodes that can be read, in the document's order, without their sources' values and their backdrops'
/// pictures. What can't be read is noted, and nodes are left out whose sources are of none of these types.
/// @throws Cancelled
std::vector<NodeRow> read_node_rows(const Database& database, std::span<const ValueType> types,
                                    const std::set<TableGroup>& tables, DamageLog& damage);

/// How findings call a node.
std::string title_of(const Node& node);
Subject node_subject(const Node& node);

/// Runs `use` for every row of a statement; what stops it is noted as damage.
/// @param what the rows are, in people's words
template <typename Use>
void each_row(const Database& database, const char* sql, const char* what, DamageLog& damage, const Use& use) {
  try {
    Statement statement(database, sql);
    while (statement.step()) use(statement);
  } catch (const DatabaseError&) {
    damage.lose(std::string("not all of its ") + what + " can be read");
  }
}

}  // namespace croquis
