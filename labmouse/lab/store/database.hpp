// A thin wrapper of SQLite that collects errors.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

struct sqlite3;
struct sqlite3_stmt;

namespace labmouse {

class Statement;

/// A connection to a database. After the first error it does nothing and keeps that error, so a check at the end of a
/// series of calls is enough. Use it in one thread at a time.
class Database {
 public:
  enum class Access : std::uint8_t {
    read,    ///< reads an existing file
    write,   ///< reads and writes an existing file
    create,  ///< creates the file if needed
    scratch  ///< the same, for a file that need not survive a power failure
  };

  Database(const std::string& path, Access access);

  /// The first error in words, such as "cannot be written: no space left on the device"; empty where there is none.
  const std::string& error() const { return error_; }
  bool good() const { return error_.empty(); }
  /// Records an error outside SQLite, unless there is one already.
  void fail(const std::string& error);

  /// Runs statements without parameters.
  void run(const std::string& sql);
  /// The same for statements that need exclusive access. It retries, because SQLite itself does not wait for such a
  /// lock.
  void run_patiently(const std::string& sql);
  Statement prepare(std::string_view sql);
  /// The number that a query returns, or 0.
  std::int64_t number(std::string_view sql);
  /// The number of rows that the last statement changed, and the id of the last inserted row.
  std::int64_t changes() const;
  std::int64_t last_row() const;
  /// Rolls back an open transaction, if there is one, even after an error.
  void roll_back();

 private:
  friend class Statement;

  struct Close {
    void operator()(sqlite3* database) const;
  };

  /// Records SQLite's error; true where there is none.
  bool check(int code);

  std::string path_;
  bool writes_;
  std::unique_ptr<sqlite3, Close> database_;
  std::string error_;
};

/// A prepared statement; its database must outlive it. Parameters are numbered from 1. Columns have names, or numbers
/// from 0.
class Statement {
 public:
  Statement& bind(int place, std::int64_t value);
  Statement& bind(int place, std::string_view value);
  Statement& bind(int place, const std::optional<double>& value);
  /// Binds a column of the current row of another statement, of any database.
  Statement& bind(int place, const Statement& row, int column);
  Statement& bind(int place, const Statement& row, const char* name) { return bind(place, row, row.column(name)); }

  /// Moves to the next row. Returns false after the last one; the statement can then be used again.
  bool next();
  /// Runs it to its end.
  void run();

  std::int64_t whole(int column) const;
  std::optional<double> real(int column) const;
  /// Empty where the column is null.
  std::string text(int column) const;
  bool is_null(int column) const;

  /// The same by the name of a column, which must exist.
  std::int64_t whole(const char* name) const { return whole(column(name)); }
  std::optional<double> real(const char* name) const { return real(column(name)); }
  std::string text(const char* name) const { return text(column(name)); }
  bool is_null(const char* name) const { return is_null(column(name)); }

 private:
  friend class Database;

  int column(const char* name) const;

  struct Finish {
    void operator()(sqlite3_stmt* statement) const;
  };

  Statement(Database& database, sqlite3_stmt* statement) : database_(&database), statement_(statement) {}

  Database* database_;
  std::unique_ptr<sqlite3_stmt, Finish> statement_;
};

}  // namespace labmouse
