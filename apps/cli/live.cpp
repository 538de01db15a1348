// labmouse live: draws the map of a real robot while the robot explores.
#include <fmt/format.h>

#include <deque>
#include <memory>
#include <optional>
#include <random>

#include "command.hpp"
#include "contests.hpp"
#include "frames.hpp"
#include "generated.hpp"
#include "labmouse/lab/live/live_drawing.hpp"
#include "labmouse/lab/live/live_plan.hpp"
#include "labmouse/lab/replays/maze_data.hpp"
#include "labmouse/lab/system/live_source.hpp"
#include "labmouse/lab/system/page_server.hpp"
#include "page.hpp"

namespace labmouse::cli {
namespace {

struct LiveOptions {
  std::string source, against, save, size, robot, page;
  std::string host = "127.0.0.1";
  bool plan = false, serves = false;
  Places places;
  int baud = 115'200;
};

/// The fastest routes in the map for a robot; nothing without one.
class Planning {
 public:
  /// @param robot a name or file; may be empty.
  Planning(const std::string& robot, Size size) {
    if (robot.empty()) return;
    robot_ = find_robot_or_refuse(robot);
    tell_remarks(robot_.remarks);
    if (size.width > max_drive_side || size.height > max_drive_side)
      throw UsageError(fmt::format("error: --robot plans in mazes up to {}x{}", max_drive_side, max_drive_side));
    planner_.emplace(robot_.model);
  }

  /// Plans if the map has changed.
  /// @return the line for the robot, if it is another than before; else nothing.
  std::string update(const PartialMap& map) {
    if (!planner_ || (last_ && last_->known == map.known && last_->unseen == map.unseen)) return {};
    last_ = map;
    const LivePlan plan = planner_->plan(map);
    text_ = planner_->text_of(plan) + "\n";
    std::string line = planner_->line_of(plan);
    if (line == line_) return {};
    line_ = std::move(line);
    return line_;
  }
  /// What is planned, as a line.
  const std::string& text() const { return text_; }

 private:
  FoundRobot robot_;
  std::optional<LivePlanner> planner_;
  std::optional<PartialMap> last_;
  std::string text_, line_;
};

/// Shows the map and what is found: on a terminal as a picture that changes, elsewhere the findings line by line and
/// the map at the end.
class Show {
 public:
  Show(Size size, const Planning& planning)
      : frames_(size, static_cast<int>(most_findings) + lines_below), planning_(planning) {}

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
  static constexpr int lines_below = 5;  ///< two of the drawing, two of the summary, one of the plan

  void draw(const LiveMap& map, const LiveReader& reader) const {
    frames_.show(draw_live(map, colours()) + live_summary(map, reader) + planning_.text() +
                 fmt::format("{}", fmt::join(findings_, "")));
  }

  Frames frames_;
  const Planning& planning_;
  std::deque<std::string> findings_;  ///< the newest ones
};

/// The page of --page for browsers, fed with all that the robot sends; nothing without that option.
class Pages {
 public:
  Pages(const LiveOptions& options, const LiveMap& map) {
    if (!options.serves) return;
    std::string page = find_page(options.page);
    if (const std::string wrong = wrong_live_page(page); !wrong.empty())
      throw UsageError("error: the page of --page " + wrong + "; build it again with `make page`");
    // What the robot has seen when it begins: nothing.
    const Maze& known = map.map().known;
    Json begin{{"width", known.size().width}, {"height", known.size().height}};
    if (!options.against.empty()) begin = {{"maze", maze_data("", find_maze(options.against, options.places).maze)}};
    // The page knows built-in robots by name; it cannot read files.
    if (!options.robot.empty() && options.robot.find('/') == std::string::npos && !options.robot.ends_with(".toml"))
      begin["robot"] = options.robot;
    OpenedServer opened =
        open_page_server({.host = options.host, .token = token(), .page = std::move(page), .begin = begin.dump()});
    if (!opened.server) throw UsageError(fmt::format("error: --host {}: {}", options.host, opened.error));
    server_ = std::move(opened.server);
    tell(fmt::format("Open {} in a browser; Ctrl-C ends it.\n", server_->link()));
  }
  bool serving() const { return server_ != nullptr; }
  void add(std::string_view bytes) {
    if (server_) server_->add(bytes);
  }
  void serve(int milliseconds) {
    if (server_) server_->serve(milliseconds);
  }
  /// Goes on for those who open the page later.
  void end(const Interruptible& interrupt) {
    if (!server_) return;
    server_->end();
    constexpr int patience = 200;  // ms until it looks for a signal
    while (!interrupt.stopped()) server_->serve(patience);
  }

 private:
  /// 128 bits that nobody can guess, from the system.
  static std::string token() {
    std::random_device device;
    std::string token;
    for (int i = 0; i < 4; ++i) token += fmt::format("{:08x}", static_cast<std::uint32_t>(device()));
    return token;
  }

  std::unique_ptr<PageServer> server_;
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
  Planning planning(options.robot, map.map().known.size());
  Show show(map.map().known.size(), planning);
  OpenedSource opened =
      open_source(options.source, options.baud, options.plan ? LiveUse::read_and_answer : LiveUse::read);
  if (!opened.source) throw UsageError(fmt::format("{}: error: {}", options.source, opened.error));
  Pages pages(options, map);
  LiveReader reader(map.map().known.size());
  LiveSource::Piece piece;
  char last = '\n';  // the last line may lack its end
  const Interruptible interrupt;
  while (!piece.ended && !interrupt.stopped()) {
    const int patience = pages.serving() ? 10 : 200;  // ms until it looks for browsers, and for a signal
    piece = opened.source->read(patience);
    if (!piece.bytes.empty()) last = piece.bytes.back();
    if (piece.ended && piece.error.empty() && last != '\n') piece.bytes += '\n';
    pages.add(piece.bytes);
    pages.serve(0);
    for (const LiveLine& line : reader.feed(piece.bytes))
      for (const LiveFinding& finding : map.add(line)) show.add(finding);
    if (piece.bytes.empty()) continue;
    const std::string line = planning.update(map.map());
    if (options.plan) opened.source->send(line);
    show.update(map, reader);
  }
  show.end(map, reader);
  if (!options.save.empty()) save(options.save, *write_partial_map(map.map()).content);
  pages.end(interrupt);
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
  auto* robot = command->add_option("--robot", options->robot,
                                    "Built-in robot, or a file whose name contains a slash or ends in .toml: says how "
                                    "fast its known route is, and whether an unseen wall can make it faster");
  robot->type_name("ROBOT");
  command->add_flag("--plan", options->plan, "Send the known route to the robot whenever it changes")->needs(robot);
  auto* page =
      command->add_option("--page", options->page,
                          "Serve the page to browsers on this computer, where it shows the robot; with a FILE, "
                          "that page. Goes on after the end of SOURCE, until Ctrl-C");
  page->expected(0, 1)->type_name("[FILE]");
  command
      ->add_option("--host", options->host,
                   "IPv4 address of this computer at which other computers reach the page: who knows the link sees the "
                   "robot")
      ->needs(page)
      ->type_name("ADDRESS")
      ->capture_default_str();
  command->add_option("--save", options->save, "Save the map as a drawing at the end")->type_name("FILE");
  command->footer(
      "It ends at the end of SOURCE or with Ctrl-C. docs/reference/protocols.md describes the lines of the robot.\n"
      "Example: labmouse live /dev/ttyUSB0 --against contest-01\n"
      "         labmouse live /dev/ttyUSB0 --robot classic --plan\n"
      "         labmouse live /dev/ttyUSB0 --page");
  command->callback([options, page, &exit] {
    options->serves = page->count() > 0;
    exit = live(*options);
  });
}

}  // namespace labmouse::cli
