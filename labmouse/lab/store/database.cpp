#include "labmouse/lab/store/database.hpp"

#include <fmt/format.h>
#include <sqlite3.h>

#include <cassert>
#include <cerrno>
#include <chrono>
#include <filesystem>
#include <string_view>
#include <thread>

#include "labmouse/lab/system/calls.hpp"
#include "labmouse/lab/system/file_problems.hpp"

namespace labmouse {
namespace {

/// How long to wait for another program's lock, in milliseconds.
constexpr int patience_ms = 60'000;

/// The primary code of an extended SQLite code.
int primary(int code) { return code & 0xff; }

std::string with_cause(const std::string& text, int error_number) {
  return error_number == 0 ? text : fmt::format("{}: {}", text, cause_of(error_number));
}

/// SQLite's error in words for a user.
std::string words_of(int code, int error_number, bool writes, const char* message) {
  const std::string what = writes ? "cannot be written" : "cannot be read";
  switch (primary(code)) {
    case SQLITE_FULL:
      return with_cause(what, ENOSPC);
    case SQLITE_READONLY:
      return with_cause(what, error_number == 0 ? EACCES : error_number);
    case SQLITE_PERM:
    case SQLITE_CANTOPEN:
      return with_cause("cannot be opened", error_number);
    case SQLITE_IOERR:
      return with_cause(what, error_number);
    case SQLITE_NOTADB:
      return "is no store: it is not a database of SQLite";
    case SQLITE_CORRUPT:
      return "is damaged; `sqlite3 FILE .recover` saves what can still be read";
    case SQLITE_BUSY:
    case SQLITE_LOCKED:
      return "is locked by another program, and has been for a minute";
    default:
      return fmt::format("{}: {}", what, message);
  }
}

/// The error number that explains why a file cannot be written or created. SQLite's own number may be from its second
/// try, which opens the file only for reading.
int why_unwritable(const std::string& path, int error_number) {
  namespace fs = std::filesystem;
  std::error_code unknown;
  const fs::path parent = fs::path(path).parent_path(), folder = parent.empty() ? fs::path(".") : parent;
  if (!fs::is_directory(folder, unknown)) return error_number;
  int reason = fs::exists(path, unknown) ? writable_error(path) : 0;
  if (reason == 0) reason = writable_error(folder.string());
  return reason != 0 ? reason : error_number;
}

/// A path as a URI for SQLite that opens the file read-only and creates no files beside it.
std::string unchanging_address(const std::string& path) {
  std::string address = "file:";
  for (const char letter : std::filesystem::absolute(path).string())
    address +=
        letter == '%' || letter == '?' || letter == '#' ? fmt::format("%{:02x}", letter) : std::string(1, letter);
  return address + "?immutable=1";
}

/// A file may come from somebody else, so its schema must not run code that changes other things than its rows, and no
/// statement may write to the schema table.
void distrust(sqlite3* database) {
  sqlite3_db_config(database, SQLITE_DBCONFIG_TRUSTED_SCHEMA, 0, nullptr);
  sqlite3_db_config(database, SQLITE_DBCONFIG_DEFENSIVE, 1, nullptr);
  sqlite3_db_config(database, SQLITE_DBCONFIG_ENABLE_TRIGGER, 0, nullptr);
}

}  // namespace

void Database::Close::operator()(sqlite3* database) const { sqlite3_close_v2(database); }
void Statement::Finish::operator()(sqlite3_stmt* statement) const { sqlite3_finalize(statement); }

Database::Database(const std::string& path, Access access) : path_(path), writes_(access != Access::read) {
  // A reader opens the file for writing too, where it may: then the last connection can remove the files beside it.
  int flags = SQLITE_OPEN_NOMUTEX | SQLITE_OPEN_EXRESCODE | SQLITE_OPEN_READWRITE;
  if (access == Access::create || access == Access::scratch) flags |= SQLITE_OPEN_CREATE;
  const auto open = [&](const std::string& name, int more) {
    sqlite3* opened = nullptr;
    const int code = sqlite3_open_v2(name.c_str(), &opened, flags | more, nullptr);
    database_.reset(opened);
    if (code == SQLITE_OK) distrust(opened);
    if (code == SQLITE_OK) sqlite3_busy_timeout(opened, patience_ms);
    return code == SQLITE_OK ? sqlite3_exec(opened, "SELECT count(*) FROM sqlite_master", nullptr, nullptr, nullptr)
                             : code;
  };
  int code = open(path, 0);
  // SQLite cannot create its files beside the database in a read-only folder. Without a -wal file nobody is writing, so
  // the database can be opened as immutable.
  std::error_code unknown;
  if (!writes_ && (primary(code) == SQLITE_CANTOPEN || primary(code) == SQLITE_READONLY) &&
      std::filesystem::exists(path, unknown) && !std::filesystem::exists(path + "-wal", unknown))
    code = open(unchanging_address(path), SQLITE_OPEN_URI);
  if (check(code) && writes_ && sqlite3_db_readonly(database_.get(), "main") == 1)
    fail(words_of(SQLITE_READONLY, why_unwritable(path, EACCES), true, ""));
}

void Database::fail(const std::string& error) {
  if (error_.empty()) error_ = error;
}

bool Database::check(int code) {
  if (code == SQLITE_OK || code == SQLITE_ROW || code == SQLITE_DONE) return good();
  int error_number = database_ ? sqlite3_system_errno(database_.get()) : 0;
  if (writes_ && (primary(code) == SQLITE_CANTOPEN || primary(code) == SQLITE_READONLY))
    error_number = why_unwritable(path_, error_number);
  fail(words_of(code, error_number, writes_, database_ ? sqlite3_errmsg(database_.get()) : sqlite3_errstr(code)));
  return false;
}

void Database::run(const std::string& sql) {
  if (good()) check(sqlite3_exec(database_.get(), sql.c_str(), nullptr, nullptr, nullptr));
}

void Database::run_patiently(const std::string& sql) {
  const auto end = std::chrono::steady_clock::now() + std::chrono::milliseconds(patience_ms);
  int code = SQLITE_BUSY;
  while (good() && primary(code) == SQLITE_BUSY) {
    code = sqlite3_exec(database_.get(), sql.c_str(), nullptr, nullptr, nullptr);
    if (primary(code) != SQLITE_BUSY || std::chrono::steady_clock::now() > end)
      check(code);
    else
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
}

Statement Database::prepare(std::string_view sql) {
  sqlite3_stmt* statement = nullptr;
  if (good())
    check(sqlite3_prepare_v3(database_.get(), sql.data(), static_cast<int>(sql.size()), SQLITE_PREPARE_PERSISTENT,
                             &statement, nullptr));
  return {*this, statement};
}

std::int64_t Database::number(std::string_view sql) {
  Statement statement = prepare(sql);
  return statement.next() ? statement.whole(0) : 0;
}

std::int64_t Database::changes() const { return sqlite3_changes64(database_.get()); }
std::int64_t Database::last_row() const { return sqlite3_last_insert_rowid(database_.get()); }

void Database::roll_back() {
  if (database_ && sqlite3_get_autocommit(database_.get()) == 0)
    sqlite3_exec(database_.get(), "ROLLBACK", nullptr, nullptr, nullptr);
}

Statement& Statement::bind(int place, std::int64_t value) {
  if (statement_ && database_->good()) database_->check(sqlite3_bind_int64(statement_.get(), place, value));
  return *this;
}

Statement& Statement::bind(int place, std::string_view value) {
  // An empty view may have a null pointer, which SQLite would store as NULL.
  if (statement_ && database_->good())
    database_->check(sqlite3_bind_text64(statement_.get(), place, value.empty() ? "" : value.data(), value.size(),
                                         SQLITE_TRANSIENT, SQLITE_UTF8));
  return *this;
}

Statement& Statement::bind(int place, const std::optional<double>& value) {
  if (statement_ && database_->good())
    database_->check(value ? sqlite3_bind_double(statement_.get(), place, *value)
                           : sqlite3_bind_null(statement_.get(), place));
  return *this;
}

Statement& Statement::bind(int place, const Statement& row, int column) {
  if (statement_ && row.statement_ && database_->good())
    database_->check(sqlite3_bind_value(statement_.get(), place, sqlite3_column_value(row.statement_.get(), column)));
  return *this;
}

bool Statement::next() {
  if (!statement_ || !database_->good()) return false;
  const int code = sqlite3_step(statement_.get());
  if (code == SQLITE_ROW) return true;
  database_->check(code);
  sqlite3_reset(statement_.get());
  return false;
}

void Statement::run() {
  while (next()) {
  }
}

int Statement::column(const char* name) const {
  int column = sqlite3_column_count(statement_.get()) - 1;
  while (column >= 0 && std::string_view(sqlite3_column_name(statement_.get(), column)) != name) --column;
  assert(column >= 0);
  return column;
}

std::int64_t Statement::whole(int column) const { return sqlite3_column_int64(statement_.get(), column); }
bool Statement::is_null(int column) const { return sqlite3_column_type(statement_.get(), column) == SQLITE_NULL; }
std::optional<double> Statement::real(int column) const {
  return is_null(column) ? std::nullopt : std::optional(sqlite3_column_double(statement_.get(), column));
}
std::string Statement::text(int column) const {
  const auto* bytes = reinterpret_cast<const char*>(sqlite3_column_text(statement_.get(), column));
  return bytes == nullptr
             ? ""
             : std::string(bytes, static_cast<std::size_t>(sqlite3_column_bytes(statement_.get(), column)));
}

}  // namespace labmouse
