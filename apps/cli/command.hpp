// Shared by all subcommands: exit codes, finding of mazes, output and errors.
#pragma once

#include <initializer_list>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "labmouse/contest/drive_rules.hpp"
#include "labmouse/contest/rules.hpp"
#include "labmouse/lab/mazes/maze_files.hpp"
#include "labmouse/lab/reports/file_kind.hpp"
#include "labmouse/lab/robots/robot_files.hpp"
#include "options.hpp"

namespace labmouse::cli {

/// exit_finding: the command ran, but found something wrong, such as a record that does not match its maze. exit_usage:
/// bad usage, bad input or another error. exit_signal plus the number of a signal: stopped by it (exit_interrupted()).
enum ExitCode { exit_good = 0, exit_finding = 1, exit_usage = 2, exit_signal = 128 };

/// Bad usage or input: one line or several for standard error; ends the program with exit code 2.
struct UsageError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// --start and --goal, which override those of the maze file.
struct Places {
  std::string start;
  std::vector<std::string> goals;
};
void add_places(Command& command, Places& places);

/// Splits paths at commas, if there is no file with the whole name.
std::vector<std::string> separated(const std::vector<std::string>& paths);
/// Loads the mazes of the paths (all built-in ones without a path) and applies the places. Prints skipped files on
/// standard error. Throws UsageError for a directly named path that is no maze.
MazeCollection find_mazes(const std::vector<std::string>& paths, const Places& places, const ReadChoice& choice = {});
/// Prints remarks on likely mistakes to standard error.
void tell_remarks(const std::vector<std::string>& remarks);
/// Prints the first files that are no mazes and counts the others; JSON output lists all.
void tell_skipped(const std::vector<SkippedFile>& skipped);
/// Loads the maze of a path, which must have exactly one.
NamedMaze find_maze(const std::string& path, const Places& places, const ReadChoice& choice = {});

/// Finds a built-in robot or that of a file; throws UsageError with all its problems.
FoundRobot find_robot_or_refuse(const std::string& name);
/// Finds built-in rules or those of a file; throws UsageError with all their problems.
DriveRules find_rules_or_refuse(const std::string& name);
/// Adds --robot; `robot` has its default.
void add_robot_option(Command& command, std::string& robot);

/// Writes to standard output, or to standard error where a file is written to standard output. Throws UsageError on
/// failure.
void print(const std::string& text);
/// The same for a part of a long text, without flushing; print() writes the rest.
void print_part(std::string_view part);
/// Writes to standard error; failures are ignored.
void tell(const std::string& text);
/// Writes a file, completely or not at all; `-` is standard output. Throws UsageError on failure.
void save(const std::string& path, const std::string& content);
/// Saves incomplete results as FILE.partial, so that FILE never has less than all, and prints that name on standard
/// error. Streams such as standard output get the results directly.
void save_partial(const std::string& path, const std::string& content);

/// Throws UsageError where a file is of another kind than the command reads, which is clearer than a syntax error.
void refuse_other_kind(const std::string& path, std::string_view text, FileKind wanted);

/// Throws UsageError if save() would fail now. Call it before long work. An empty path is accepted.
void require_writable(const std::string& path);

/// Throws UsageError where the path is that of a file that is there and not empty, and that does not look like what the
/// option writes.
void keep_other_files(std::string_view option, FileKind kind, const std::string& path);

/// A file of the command line that must not be the file of another option.
struct Output {
  std::string_view option;
  std::string path;                   ///< empty if not requested
  FileKind kind = FileKind::unknown;  ///< what save() writes there; unknown: it is read, or written in another way
  bool partial = false;               ///< whether save_partial() may write there
};
/// Call this before long work. Throws UsageError where a file cannot be written now, two are the same, or a file is
/// there that is of another kind: so no input of another kind is lost, wherever it is named. If a file goes to standard
/// output, print() uses standard error from now on, so that programs can read that file.
void expect_outputs(std::initializer_list<Output> outputs);

/// Whether to colour printed text: it goes to a terminal, and NO_COLOR is not set.
bool colours();

/// Add the subcommands; their callbacks set `exit` to the exit code.
void add_race(Command& app, int& exit);
void add_compare(Command& app, int& exit);
void add_sweep(Command& app, int& exit);
void add_learn(Command& app, int& exit);
void add_study(Command& app, int& exit);
void add_tune(Command& app, int& exit);
void add_mice_file(Command& app, int& exit);
void add_grade(Command& app, int& exit);
void add_league(Command& app, int& exit);
void add_run(Command& app, int& exit);
void add_mms(Command& app, int& exit);
void add_show(Command& app, int& exit);
void add_live(Command& app, int& exit);
void add_inspect(Command& app, int& exit);
void add_make(Command& app, int& exit);
void add_convert(Command& app, int& exit);
void add_mice(Command& app, int& exit);
void add_robot(Command& app, int& exit);
void add_rules(Command& app, int& exit);
void add_bound(Command& app, int& exit);
void add_route(Command& app, int& exit);
void add_drive(Command& app, int& exit);
void add_failure_rates(Command& app, int& exit);
void add_replay(Command& app, int& exit);
void add_score(Command& app, int& exit);
void add_page(Command& app, int& exit);
void add_report(Command& app, int& exit);
void add_store(Command& app, int& exit);
void add_bench(Command& app, int& exit);
void add_demo(Command& app, int& exit);
void add_doctor(Command& app, int& exit);

}  // namespace labmouse::cli
