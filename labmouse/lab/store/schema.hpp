// The tables of a store, and the migration of older stores. See docs/how-to/clusters-and-stores.md.
#pragma once

#include <span>
#include <string>

#include "labmouse/lab/store/database.hpp"

namespace labmouse {

/// SQL that turns a store of version i into version i + 1; version 0 is an empty file. Never change an entry: existing
/// stores were made by it.
std::span<const char* const> migrations();

/// The version of stores that this program writes.
inline int schema_version(std::span<const char* const> steps = migrations()) { return static_cast<int>(steps.size()); }

/// Opens a store and migrates it to the current version if it will be written, completely or not at all. The database
/// has an error for a missing store, for an unknown version, and for tables, views or triggers that labmouse did not
/// make.
Database open_store(const std::string& path, Database::Access access,
                    std::span<const char* const> steps = migrations());

/// The same after a check of all pages, but not of the content of the indices (SQLite's quick_check). For programs that
/// add to a store or delete from it. Takes 0.8 s of processor time for 1,000,000 contests.
Database open_checked_store(const std::string& path, Database::Access access);

/// Opens a store for reading after a check of the whole file (integrity_check): a damaged page may look like an empty
/// one and hide contests. Takes 0.2 s of processor time for 170,000 contests.
Database open_whole_store(const std::string& path);

/// An error of a store as a line for the user; empty where there is none.
std::string error_line(const std::string& path, const std::string& error);

}  // namespace labmouse
