// What the subcommands share: how they end, how they find mazes, and how they speak.
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

/// exit_interrupted() is the one of a command that a signal stopped.
enum ExitCode { exit_good = 0, exit_finding = 1, exit_usage = 2, exit_signal = 128 };

/// Bad usage or input: one line or several for standard error; ends the program with exit code 2.
struct UsageError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// --start and --goal, which override what a maze file says.
struct Places {
  std::string start;
  std::vector<std::string> goals;
};
void add_places(Command& command, Places& places);

/// The mazes of the paths (the built-in ones where there is none), with the places applied. What was skipped is printed
/// on standard error; a path named directly that is no maze throws UsageError.
MazeCollection find_mazes(const std::vector<std::string>& paths, const Places& places);
/// Tells what is likely to be a mistake.
void tell_remarks(const std::vector<std::string>& remarks);
/// Names the first files that are no mazes and counts the others, which JSON lists all.
void tell_skipped(const std::vector<SkippedFile>& skipped);
/// The one maze of a path.
NamedMaze find_maze(const std::string& path, const Places& places);

/// A built-in robot or that of a file; throws UsageError with all that is wrong with it.
FoundRobot find_robot_or_refuse(const std::string& name);
/// Built-in rules or those of a file; throws UsageError with all that is wrong with them.
DriveRules find_rules_or_refuse(const std::string& name);
/// --robot, which has its default.
void add_robot_option(Command& command, std::string& robot);

/// Writes to standard output, or throws UsageError when it cannot; to standard error where a file takes its place.
void print(const std::string& text);
/// The same of a part of a long text, which need not be seen at once; print() writes what is left.
void print_part(std::string_view part);
/// Writes to standard error as far as that can be written.
void tell(const std::string& text);
/// Writes a file whole or throws UsageError; `-` is standard output.
void save(const std::string& path, const std::string& content);
/// Saves the results of a command that was stopped early as FILE.partial, so that FILE never holds less than all, and
/// names that file on standard error. To standard output and other streams they go as they are.
void save_partial(const std::string& path, const std::string& content);

/// Throws UsageError where the text of a file is of another kind than the one that a command reads there, so that
/// nobody has to guess that from a syntax error.
void refuse_other_kind(const std::string& path, std::string_view text, FileKind wanted);

/// Throws UsageError where save would fail now: to be asked before long work. No path is fine.
void require_writable(const std::string& path);

/// A file that a command will write: the option that names it, and its path; empty where it was not asked for.
struct Output {
  enum class Kind {
    file,   ///< written by save()
    other,  ///< opened in another way, such as a store: only compared with the others
    input   ///< read by the command, so nothing may take its place
  };

  std::string_view option;
  std::string path;
  Kind kind = Kind::file;
};
/// To be asked before long work: throws UsageError where one of them cannot be written now, or two are one. Where one
/// is standard output, what the command prints goes to standard error from now on, so that a program can read it.
void expect_outputs(std::initializer_list<Output> outputs);

/// Whether to colour what goes to standard output: it is a terminal and NO_COLOR is not set.
bool colours();

/// Adds each subcommand; its callback leaves the exit code in `exit`.
void add_race(Command& app, int& exit);
void add_sweep(Command& app, int& exit);
void add_learn(Command& app, int& exit);
void add_study(Command& app, int& exit);
void add_tune(Command& app, int& exit);
void add_mice_file(Command& app, int& exit);
void add_run(Command& app, int& exit);
void add_mms(Command& app, int& exit);
void add_show(Command& app, int& exit);
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

}  // namespace labmouse::cli
