// labmouse make: generates a maze. labmouse convert: converts a maze to another format.
#include <fmt/format.h>

#include <filesystem>
#include <memory>

#include "command.hpp"
#include "generated.hpp"
#include "labmouse/lab/system/streams.hpp"
#include "labmouse/lab/text/printable.hpp"
#include "labmouse/maze/generators/generator.hpp"
#include "named_things.hpp"

namespace labmouse::cli {
namespace {

const Format& format_named(const std::string& name) {
  if (const Format* format = find_format(name)) return *format;
  throw UsageError(fmt::format("error: unknown format '{}'; {}", name, suggestion(name, all_formats())));
}

/// The format with that name; without a name the format of the path's extension, or the drawing.
const Format& choose_format(const std::string& name, const std::string& path) {
  if (!name.empty()) return format_named(name);
  if (is_stream(path)) return drawing_format;
  if (const Format* format = format_of_file(path)) return *format;
  throw UsageError(fmt::format("{}: error: the extension '{}' belongs to no maze format; add --format with one of {}",
                               path, std::filesystem::path(path).extension().string(), list_of(all_formats())));
}

void write(const Maze& maze, std::string_view option, const std::string& path, const std::string& format_name) {
  const Format& format = choose_format(format_name, path);
  const WriteResult result = format.write(maze);
  if (!result.content)
    throw UsageError(
        fmt::format("{}: error: the format {} cannot hold this maze: {}", path, format.name, result.reason));
  keep_other_files(option, FileKind::maze, path);
  save(path, *result.content);
}

struct MakeOptions {
  GeneratedMazes maze;
  std::string out = "-", format;
  std::uint64_t seed = 1;
};

void make(const MakeOptions& options) {
  const GeneratorOrder order = options.maze.order(options.seed);
  write(options.maze.generator().make(order), "--out", options.out, options.format);
}

struct ConvertOptions {
  std::string in, out, format, from;
  ReadChoice choice;
};

void convert(const ConvertOptions& options) {
  ReadChoice choice = options.choice;
  if (!options.from.empty()) choice.format = &format_named(options.from);
  const NamedMaze maze = find_maze(options.in, {}, choice);
  std::error_code unknown;
  if (std::filesystem::equivalent(options.in == "-" ? "/dev/stdin" : maze.name, options.out, unknown))
    throw UsageError(fmt::format("{}: error: IN and OUT are the same file; use another name", options.out));
  write(maze.maze, "OUT", options.out, options.format);
  if (!maze.reading.empty()) tell(fmt::format("{}: read as {}\n", shown(maze.name), maze.reading));
}

}  // namespace

void add_make(Command& app, int& exit) {
  auto options = std::make_shared<MakeOptions>();
  Command* command = app.add_subcommand("make", "Generate a maze");
  command->add_option("kind", options->maze.kind, "Generator: " + list_of(all_generators()))
      ->required()
      ->type_name("KIND");
  options->maze.add_to(*command);
  command->add_option("--seed", options->seed, "Seed for all random choices")
      ->check(seed_number())
      ->capture_default_str();
  command->add_option("-o,--out", options->out, "File to write; - is standard output")
      ->type_name("FILE")
      ->capture_default_str();
  command
      ->add_option("--format", options->format,
                   "Format: " + list_of(all_formats()) + "; default: by the file's extension, otherwise drawing")
      ->type_name("FORMAT");
  command->footer("Example: labmouse make contest --size 32x32 --seed 7 -o my-maze.txt");
  command->callback([options, &exit] {
    make(*options);
    exit = exit_good;
  });
}

void add_convert(Command& app, int& exit) {
  auto options = std::make_shared<ConvertOptions>();
  Command* command = app.add_subcommand("convert", "Convert a maze to another format");
  command->add_option("in", options->in, "Maze file or built-in maze")->required()->type_name("IN");
  command->add_option("out", options->out, "File to write; - is standard output")->required()->type_name("OUT");
  command
      ->add_option("--format", options->format,
                   "Format: " + list_of(all_formats()) + "; default: by the extension of OUT, otherwise drawing")
      ->type_name("FORMAT");
  command->add_option("--from", options->from, "Format of IN, if it is recognised as another one")->type_name("FORMAT");
  command->add_flag("--transpose", options->choice.transposed, "Exchange x and y, if IN has columns for rows");
  command->add_flag("--repair", options->choice.repaired,
                    "If a few cells of IN contradict their neighbours, put walls there, and print them");
  command->add_flag("--border-gaps", options->choice.gaps_are_places,
                    "Start in one of the two gaps in the border of IN, the southern one; the goal is the other");
  command->add_flag("--close-unseen", options->choice.closes_unseen,
                    "Take the unseen walls of a partial map as closed");
  command->footer("Example: labmouse convert contest-01 maze.maz");
  command->callback([options, &exit] {
    convert(*options);
    exit = exit_good;
  });
}

}  // namespace labmouse::cli
