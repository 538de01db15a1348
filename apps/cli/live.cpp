// labmouse live: draws the map of a real robot while the robot explores.
#include <fmt/format.h>

#include <deque>
#include <memory>
#include <optional>

#include "command.hpp"
#include "contests.hpp"
#include "frames.hpp"
#include "generated.hpp"
#include "labmouse/lab/live/live_drawing.hpp"
#include "labmouse/lab/system/live_source.hpp"

namespace labmouse::cli {
namespace {

struct LiveOptions {
  std::string source, against, save, size;
  Places places;
  int baud = 115'200;
};

/// Shows the map and what is found: on a terminal as a picture that changes, elsewhere the findings line by line and
/// the map at the end.
class Show {
 public:
  explicit Show(Size size) : frames_(size, static_cast<int>(most_findings) + lines_below) {}

  void add(const LiveFinding& finding) {
    const std::string words = words_of(finding) + "\n";
    if (!frames_.moving()) return print(words);
    findings_.push_back(words);
    if (findings_.size() > most_findings) findings_.pop_front();
  }
  void update(const LiveMap& map, const LiveReader& reader) const {
    if (frames_.moving()) draw(map, reader);
  }
  void end(const LiveMap& map, const LiveReader& reader) const { draw(map, reader); }

 private:
  static constexpr std::size_t most_findings = 5;
  static constexpr int lines_below = 4;  ///< two of the drawing, two of the summary

  void draw(const LiveMap& map, const LiveReader& reader) const {
    frames_.show(draw_live(map, colours()) + live_summary(map, reader) + fmt::format("{}", fmt::join(findings_, "")));
  }

  Frames frames_;
  std::deque<std::string> findings_;  ///< the newest ones
};

LiveMap new_map(const LiveOptions& options) {
  if (options.against.empty()) return LiveMap(read_size(options.size.empty() ? "16x16" : options.size));
  return LiveMap(find_maze(options.against, options.places).maze);
}

int live(const LiveOptions& options) {
  expect_outputs({{"--save", options.save, FileKind::maze}});
  if (options.against.empty() && !(options.places.start.empty() && options.places.goals.empty()))
    throw UsageError("error: --start and --goal need the maze of --against MAZE");
  if (!options.against.empty() && !options.size.empty())
    throw UsageError("error: --against names a maze, which has its size; leave out --size");
  LiveMap map = new_map(options);
  Show show(map.map().known.size());
  OpenedSource opened = open_source(options.source, options.baud);
  if (!opened.source) throw UsageError(fmt::format("{}: error: {}", options.source, opened.error));
  LiveReader reader(map.map().known.size());
  LiveSource::Piece piece;
  char last = '\n';  // the last line may lack its end
  const Interruptible interrupt;
  while (!piece.ended && !interrupt.stopped()) {
    constexpr int patience = 200;  // ms until it looks for a signal
    piece = opened.source->read(patience);
    if (!piece.bytes.empty()) last = piece.bytes.back();
    if (piece.ended && piece.error.empty() && last != '\n') piece.bytes += '\n';
    for (const LiveLine& line : reader.feed(piece.bytes))
      for (const LiveFinding& finding : map.add(line)) show.add(finding);
    if (!piece.bytes.empty()) show.update(map, reader);
  }
  show.end(map, reader);
  if (!options.save.empty()) save(options.save, *write_partial_map(map.map()).content);
  if (!piece.error.empty()) throw UsageError(fmt::format("{}: error: {}", options.source, piece.error));
  return interrupt.stopped() ? exit_interrupted() : exit_good;
}

}  // namespace

void add_live(Command& app, int& exit) {
  auto options = std::make_shared<LiveOptions>();
  Command* command = app.add_subcommand("live", "Draw the map of a real robot while the robot explores");
  command
      ->add_option("source", options->source,
                   "What sends the lines of the robot: a serial port, pseudo-terminal, pipe or file; tcp:HOST:PORT; - "
                   "for standard input")
      ->required()
      ->type_name("SOURCE");
  command->add_option("--baud", options->baud, "Bits per second of a serial port")
      ->check(in_range(1, 10'000'000))
      ->capture_default_str();
  command->add_option("--size", options->size, "Width and height of the maze in cells, where --against names no maze")
      ->type_name("WxH")
      ->default_str("16x16");
  command->add_option("--against", options->against, "The maze in which the robot is: marks false and missed walls")
      ->type_name("MAZE");
  add_places(*command, options->places);
  command->add_option("--save", options->save, "Save the map as a drawing at the end")->type_name("FILE");
  command->footer(
      "It ends at the end of SOURCE or with Ctrl-C. docs/reference/protocols.md describes the lines of the robot.\n"
      "Example: labmouse live /dev/ttyUSB0 --against contest-01");
  command->callback([options, &exit] { exit = live(*options); });
}

}  // namespace labmouse::cli
