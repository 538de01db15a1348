// A file of SQLite: what is asked of it, and what goes wrong.
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

/// A connection. Once something went wrong it does nothing more, and says what that was: so it has to be asked only at
/// the end of what belongs together. For one thread at a time.
class Database {
 public:
  enum class Access : std::uint8_t {
    read,    ///< of a file that is there
    write,   ///< the same
    create,  ///< where there is no file, makes one
    scratch  ///< the same, of a file that need not outlive a power cut
  };

  Database(const std::string& path, Access access);

  /// What went wrong first, in words: "is no database", "cannot be written: no space is left on the device"; or
  /// nothing.
  const std::string& error() const { return error_; }
  bool good() const { return error_.empty(); }
  /// Notes what went wrong outside of SQLite, if nothing did before.
  void fail(const std::string& error);

  /// Runs statements that have no values.
  void run(const std::string& sql);
  /// The same for what needs the file alone: where several programs ask for that at once, SQLite itself waits for none.
  void run_patiently(const std::string& sql);
  Statement prepare(std::string_view sql);
  /// The number that a statement gives, or 0.
  std::int64_t number(std::string_view sql);
  /// Rows that the last statement changed, and where the last one was inserted.
  std::int64_t changes() const;
  std::int64_t last_row() const;
  /// Leaves a transaction that was begun, where there is one, also after an error.
  void roll_back();

 private:
  friend class Statement;

  struct Close {
    void operator()(sqlite3* database) const;
  };

  /// Notes what SQLite says; true where all is well.
  bool check(int code);

  std::string path_;
  bool writes_;
  std::unique_ptr<sqlite3, Close> database_;
  std::string error_;
};

/// A statement of a database, which has to outlive it: values by number, counted from 1, and rows with columns by name,
/// or counted from 0.
class Statement {
 public:
  Statement& bind(int place, std::int64_t value);
  Statement& bind(int place, std::string_view value);
  Statement& bind(int place, const std::optional<double>& value);
  /// The value in a column of the present row of a statement, of this database or another.
  Statement& bind(int place, const Statement& row, int column);

  /// Goes to the next row; false behind the last one, and then the statement can be used again.
  bool next();
  /// Runs it to its end.
  void run();

  std::int64_t whole(int column) const;
  std::optional<double> real(int column) const;
  /// Empty where the column is null.
  std::string text(int column) const;
  bool is_null(int column) const;

  /// The same of the column that has that name, which must be there.
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
