#include "command.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>

#include "labmouse/lab/system/calls.hpp"
#include "labmouse/lab/system/file_problems.hpp"
#include "labmouse/lab/system/files.hpp"
#include "labmouse/lab/system/streams.hpp"
#include "labmouse/lab/text/commas.hpp"
#include "labmouse/lab/text/printable.hpp"
#include "labmouse/mouse/pose.hpp"
#include "labmouse/strategies/parameter.hpp"
#include "terminal.hpp"

namespace labmouse::cli {
namespace {

/// Reads `X,Y` or, if allowed, `X,Y,HEADING`.
Pose read_place(const std::string& text, bool with_heading) {
  const std::vector<std::string> parts = between_commas(text);
  std::vector<std::string_view> headings;
  for (const Heading heading : all_headings) headings.push_back(name_of(heading));
  const auto bad = [&] {
    const auto form = with_heading
                          ? fmt::format("; or X,Y,HEADING with one of the headings {}", fmt::join(headings, ", "))
                          : std::string();
    return UsageError(fmt::format("error: '{}' is not a position; write X,Y with numbers from 0 to {}, such as 0,0{}",
                                  text, max_side - 1, form));
  };
  if (parts.size() < 2 || parts.size() > (with_heading ? 3U : 2U)) throw bad();
  const double x = parse_plain_number(parts[0]).value_or(-1.0), y = parse_plain_number(parts[1]).value_or(-1.0);
  if (x < 0 || y < 0 || x >= max_side || y >= max_side || x != static_cast<int>(x) || y != static_cast<int>(y))
    throw bad();
  Pose pose{{static_cast<int>(x), static_cast<int>(y)}, Heading::north};
  if (parts.size() == 2) return pose;
  for (const Heading heading : all_headings)
    if (parts[2] == name_of(heading)) return {pose.cell, heading};
  const auto near = nearest_name(parts[2], headings);
  throw UsageError(fmt::format("error: unknown heading '{}' in '{}'; {}", parts[2], text,
                               near.empty() ? fmt::format("the headings are {}", fmt::join(headings, ", "))
                                            : fmt::format("did you mean '{}'?", near)));
}

void require_inside(const NamedMaze& maze, Cell cell, const char* what) {
  const Size size = maze.maze.size();
  if (size.contains(cell)) return;
  throw UsageError(fmt::format("{}: error: the {} ({},{}) is outside the maze, which is {}x{}", maze.name, what, cell.x,
                               cell.y, size.width, size.height));
}

void apply(const Places& places, NamedMaze& maze) {
  if (!places.start.empty()) {
    const Pose start = read_place(places.start, true);
    require_inside(maze, start.cell, "start");
    maze.maze = maze.maze.with_start(start.cell, start.heading);
  }
  if (places.goals.empty()) return;
  CellSet goals;
  for (const std::string& text : places.goals) {
    const std::vector<std::string> parts = between_commas(text);
    // An odd number of parts is refused as a whole.
    for (std::size_t i = 0; i < parts.size(); i += 2) {
      const Cell goal = read_place(parts.size() % 2 == 0 ? parts[i] + "," + parts[i + 1] : text, false).cell;
      require_inside(maze, goal, "goal");
      goals.insert(goal);
    }
  }
  maze.maze = maze.maze.with_goals(goals);
}

/// Where print() writes: standard error once a file is written to standard output.
std::FILE* printed = stdout;

/// Where incomplete results are saved.
std::string partial(const std::string& path) { return path + ".partial"; }

void write_out(std::string_view text, std::FILE* stream, bool at_once = true) {
  const bool written = std::fwrite(text.data(), 1, text.size(), stream) == text.size();
  if (written && (!at_once || std::fflush(stream) == 0)) return;
  // A reader that closed the pipe (`| head`) is no error: end the program.
  if (errno == EPIPE) std::exit(exit_good);
  throw UsageError(fmt::format("error: cannot write to standard output: {}", cause_of(errno)));
}

struct KindWords {
  std::string_view name;
  std::string_view made;   ///< the command that writes such a file; empty where there is none
  std::string_view shown;  ///< the command that shows it
};

KindWords words_of(FileKind kind) {
  switch (kind) {
    case FileKind::maze:
      return {"a maze", "`labmouse make` writes one", "`labmouse show` draws it"};
    case FileKind::record:
      return {"a record", "`labmouse run MOUSE MAZE --record FILE` writes one",
              "`labmouse show --record FILE` draws it"};
    case FileKind::results:
      return {"the results of a race", "`labmouse race --out FOLDER` writes them", "`labmouse report` shows them"};
    case FileKind::csv:
      return {"the CSV of a race", "`labmouse race --format csv` prints it", "a spreadsheet shows it"};
    case FileKind::page:
      return {"a page", "`labmouse page` writes one", "a browser shows it"};
    case FileKind::picture:
      return {"a picture", "`labmouse show MAZE --svg FILE` writes one", "a browser shows it"};
    case FileKind::log:
      return {"a log", "`labmouse drive --log FILE` writes one", "a spreadsheet shows it"};
    case FileKind::prior:
      return {"a prior", "`labmouse learn` writes one", "a mouse with `prior=FILE` uses it"};
    case FileKind::failure_rates:
      return {"a file of failure rates", "`labmouse failure-rates --save FILE` writes one",
              "`--failure-rates FILE` uses it"};
    case FileKind::junit:
      return {"a JUnit file", "`labmouse race --junit FILE` writes one", "tools for tests show it"};
    case FileKind::gradescope:
      return {"results for Gradescope", "`labmouse grade --gradescope FOLDER` writes them", "Gradescope shows them"};
    case FileKind::study:
      return {"the CSV of a study", "`labmouse study --csv FILE` writes it", "a spreadsheet shows it"};
    case FileKind::sweep:
      return {"the CSV of a sweep", "`labmouse sweep --csv FILE` writes it", "a spreadsheet shows it"};
    case FileKind::tune:
      return {"the log of a tuning", "`labmouse tune --log FILE` writes it", "a spreadsheet shows it"};
    case FileKind::unknown:
      break;
  }
  // Mice files are the only input whose kind is not recognised.
  return {"a mice file", "`labmouse mice-file init FOLDER` writes one", ""};
}

/// Throws UsageError where the file is a labmouse file of another kind.
void refuse_other_file(const std::string& path) {
  std::error_code unknown;
  if (std::filesystem::is_regular_file(path, unknown))
    refuse_other_kind(path, read_file(path, std::size_t{1} << 28U).content, FileKind::maze);
}

std::string describe_all(const std::vector<SkippedFile>& files) {
  std::string text;
  for (const SkippedFile& file : files) {
    for (const Problem& problem : file.problems) text += describe(file.path, problem) + "\n";
    if (file.repairable)
      text += fmt::format("{}: `labmouse convert FILE NEW --repair` closes these walls\n", shown(file.path));
  }
  if (!text.empty()) text.pop_back();
  return text;
}

}  // namespace

void refuse_other_kind(const std::string& path, std::string_view text, FileKind wanted) {
  const FileKind kind = kind_of_file(text);
  if (kind == FileKind::unknown || kind == wanted) return;
  const KindWords is = words_of(kind), reads = words_of(wanted);
  throw UsageError(fmt::format("{}: error: this is {}, not {}; {}", path, is.name, reads.name,
                               kind == FileKind::maze ? reads.made : is.shown));
}

void tell_skipped(const std::vector<SkippedFile>& skipped) {
  constexpr std::size_t told = 10;
  const auto end = skipped.begin() + static_cast<std::ptrdiff_t>(std::min(skipped.size(), told));
  if (skipped.empty()) return;
  tell(fmt::format("{}\n", describe_all({skipped.begin(), end})));
  if (skipped.size() > told) tell(fmt::format("... and {} more files skipped\n", skipped.size() - told));
}

void add_places(Command& command, Places& places) {
  command.add_option("--start", places.start, "Start at X,Y or X,Y,HEADING instead of where the file says")
      ->type_name("X,Y[,HEADING]");
  command.add_option("--goal", places.goals, "Goal cells, replacing those of the file (repeatable)")
      ->type_name("X,Y[,X,Y...]")
      ->expected(1)
      ->take_all();
}

void tell(const std::string& text) {
  // A failure cannot be reported anywhere, so it is ignored; fmt::print() would throw.
  std::fwrite(text.data(), 1, text.size(), stderr);
}

void tell_remarks(const std::vector<std::string>& remarks) {
  for (const std::string& remark : remarks) tell("remark: " + remark + "\n");
}

std::vector<std::string> separated(const std::vector<std::string>& paths) {
  std::vector<std::string> all;
  for (const std::string& path : paths) {
    std::error_code unknown;
    const bool whole = path.find(',') == std::string::npos || std::filesystem::exists(path, unknown);
    for (std::string& part : whole ? std::vector{path} : between_commas(path)) all.push_back(std::move(part));
  }
  return all;
}

MazeCollection find_mazes(const std::vector<std::string>& names, const Places& places, const ReadChoice& choice) {
  const std::vector<std::string> paths = separated(names);
  if (std::find(paths.begin(), paths.end(), "") != paths.end())
    throw UsageError("error: the name of a maze is empty; remove the extra comma");
  MazeCollection collection = paths.empty() ? load_builtin_mazes() : load_mazes(paths, choice);
  for (const SkippedFile& file : collection.errors) refuse_other_file(file.path);
  if (!collection.errors.empty()) throw UsageError(describe_all(collection.errors));
  tell_skipped(collection.skipped);
  for (const MazeNote& note : collection.notes) tell(fmt::format("{}: note: {}\n", shown(note.path), note.text));
  if (collection.mazes.empty())
    throw UsageError("error: no mazes found; name a maze file, or omit the paths to use the built-in mazes");
  for (NamedMaze& maze : collection.mazes) apply(places, maze);
  return collection;
}

NamedMaze find_maze(const std::string& path, const Places& places, const ReadChoice& choice) {
  MazeCollection collection = find_mazes({path}, places, choice);
  if (collection.mazes.size() == 1) return collection.mazes.front();
  throw UsageError(fmt::format("{}: error: this names {} mazes; name exactly one", path, collection.mazes.size()));
}

void print(const std::string& text) { write_out(text, printed); }

void print_part(std::string_view part) { write_out(part, printed, false); }

void keep_other_files(std::string_view option, FileKind kind, const std::string& path) {
  std::error_code unknown;
  if (is_stream(path) || !std::filesystem::is_regular_file(path, unknown)) return;
  constexpr std::size_t enough = std::size_t{1} << 20U;
  std::ifstream file(path, std::ios::binary);
  if (!file) throw UsageError(fmt::format("{}: error: cannot be read, so {} does not replace it", path, option));
  std::string begin(enough, '\0');
  file.read(begin.data(), static_cast<std::streamsize>(begin.size()));
  begin.resize(static_cast<std::size_t>(file.gcount()));
  if (begin.empty() || kind_of_file(begin) == kind) return;
  throw UsageError(
      fmt::format("{}: error: this does not look like a file that {} writes, so it is not replaced; use "
                  "another name, or remove the file",
                  path, option));
}

void save(const std::string& path, const std::string& content) {
  if (descriptor_to_write(path) == standard_output) return write_out(content, stdout);
  if (const auto error = write_file(path, content); !error.empty())
    throw UsageError(fmt::format("{}: error: {}", path, error));
}

void save_partial(const std::string& path, const std::string& content) {
  if (is_stream(path)) return save(path, content);
  save(partial(path), content);
  tell(fmt::format("Stopped early: {} has the results so far.\n", shown(partial(path))));
}

void require_writable(const std::string& path) {
  if (path.empty()) return;
  if (const auto error = check_writable(path); !error.empty())
    throw UsageError(fmt::format("{}: error: {}", path, error));
}

namespace {

/// Whether writing one of the files would destroy the other.
bool collide(const Output& one, const Output& other) {
  if (one.path.empty() || other.path.empty()) return false;
  if ((one.partial && is_same_file(partial(one.path), other.path)) ||
      (other.partial && is_same_file(one.path, partial(other.path))))
    return true;
  if (one.kind != FileKind::unknown && other.kind != FileKind::unknown) return is_same_file(one.path, other.path);
  // A path such as `-` is a stream for one option and may be a file name for the other. Reading a stream destroys
  // nothing.
  const bool streams = descriptor_to_write(one.path) || descriptor_to_write(other.path);
  return !streams && !is_stream(one.path) && is_same_file(one.path, other.path);
}

/// Refuses an SVG file under the name of a picture of another kind.
void refuse_other_pictures(std::string_view option, const std::string& path) {
  constexpr std::array<std::string_view, 6> others = {".png", ".jpg", ".jpeg", ".gif", ".pdf", ".webp"};
  const std::string ending = std::filesystem::path(path).extension().string();
  if (std::find(others.begin(), others.end(), ending) != others.end())
    throw UsageError(fmt::format("{}: error: {} writes SVG; end the name in .svg", path, option));
}

}  // namespace

void expect_outputs(std::initializer_list<Output> outputs) {
  for (const auto* one = outputs.begin(); one != outputs.end(); ++one)
    for (const auto* other = outputs.begin(); other != one; ++other)
      if (collide(*other, *one))
        throw UsageError(
            fmt::format("error: {} and {} name the same file; use two different files", other->option, one->option));
  for (const auto& [option, path, kind, has_partial] : outputs) {
    if (path.empty() || kind == FileKind::unknown) continue;
    if (kind == FileKind::picture) refuse_other_pictures(option, path);
    require_writable(path);
    keep_other_files(option, kind, path);
    if (has_partial) keep_other_files(option, kind, partial(path));
    if (descriptor_to_write(path) == standard_output) printed = stderr;
  }
}

bool colours() {
  const char* no_colour = std::getenv("NO_COLOR");
  return is_terminal(printed) && (no_colour == nullptr || *no_colour == '\0');
}

}  // namespace labmouse::cli
