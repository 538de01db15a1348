// The tables of a store, and how older ones become the present ones. docs/how-to/clusters-and-stores.md describes them
// to people.
#pragma once

#include <span>
#include <string>

#include "labmouse/lab/store/database.hpp"

namespace labmouse {

/// What makes of a store of version i one of version i + 1; of version 0, which is an empty file, one of version 1.
/// What stands here is never changed: stores out there were made by it.
std::span<const char* const> migrations();

/// The version of stores that this program writes.
inline int schema_version(std::span<const char* const> steps = migrations()) { return static_cast<int>(steps.size()); }

/// Opens a store, in its present version: one that is to be written is brought there, all or nothing. The database has
/// an error where there is no store, or one that this program cannot read, or one with tables, views or triggers that
/// labmouse has not made.
Database open_store(const std::string& path, Database::Access access,
                    std::span<const char* const> steps = migrations());

/// The same after a quick look at all pages of the file, but not at what its indices say: for what adds to a store or
/// takes from it. It takes 0.8 s of processor time for 1,000,000 contests.
Database open_checked_store(const std::string& path, Database::Access access);

/// Opens a store to read what it holds, after a look at the file as a whole: a damaged page may pass for one without
/// rows, and a store with it for one that holds less. It takes 0.2 s of processor time for 170,000 contests.
Database open_whole_store(const std::string& path);

/// An error of a store as a line for the user; empty where there is none.
std::string error_line(const std::string& path, const std::string& error);

}  // namespace labmouse
