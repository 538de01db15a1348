// Any bytes as what a mouse of mms writes: each command has its one reply, and the mouse stays where a mouse can be.
#include <limits>

#include "labmouse/external/line_buffer.hpp"
#include "labmouse/external/mms/host.hpp"
#include "tests/drawn_maze.hpp"
#include "tests/fuzz/fuzzer.hpp"

namespace labmouse::fuzz {

namespace {

const Maze& maze() {
  static const Maze small = test::drawn(R"(
    o---o---o---o---o
    |       |       |
    o   o   o   o   o
    |   |           |
    o   o---o   o---o
    | S |           |
    o---o---o---o---o
  )");
  return small;
}

bool is_inside(HalfPlace place) {
  const Size size = maze().size();
  return place.x > 0 && place.y > 0 && place.x < 2 * size.width && place.y < 2 * size.height &&
         (place.x % 2 == 1 || place.y % 2 == 1);
}

/// One line of mms's alphabet, or nothing.
bool is_reply(std::string_view reply, bool wanted) {
  if (!wanted) return reply.empty();
  if (reply.size() < 2 || reply.find('\n') != reply.size() - 1) return false;
  const std::string_view word = reply.substr(0, reply.size() - 1);
  return word == "true" || word == "false" || word == "ack" || word == "crash" ||
         word.find_first_not_of("0123456789.e+-") == std::string_view::npos;
}

/// What a finished run costs, and more than all that before the first.
float best_of(const MmsStatistics& all) {
  return all.finished ? all.best_run_effective_distance + all.best_run_turns : std::numeric_limits<float>::max();
}

void obey(MmsHost& host, std::string_view line) {
  const MmsStatistics before = host.statistics();
  const bool goes_on = host.goes_on();
  const MmsLine read = read_mms_line(line);
  require(read.command.has_value() == read.problem.empty());
  std::string reply;
  host.obey(line, reply);
  require(is_reply(reply, goes_on && read.command && read.command->verb < MmsVerb::set_wall));
  require(is_inside(host.pose().place));
  const MmsStatistics& after = host.statistics();
  require(best_of(after) <= best_of(before) && after.finished >= before.finished);
  require(after.total_distance >= before.total_distance && after.total_turns >= before.total_turns);
  require(after.total_effective_distance >= after.current_run_effective_distance);
  if (!after.finished) require(after.score == 2000);
  require(goes_on || after == before);
}

}  // namespace

LABMOUSE_FUZZER(mms) {
  MmsHost host(maze(), {.strict = size % 4 == 3, .presses = 1});
  LineBuffer lines(4096);
  lines.append({reinterpret_cast<const char*>(bytes), size});
  std::int64_t count = 0;
  while (const auto line = lines.next()) {
    if (host.goes_on()) ++count;
    obey(host, *line);
  }
  require(host.lines() == count && host.invalid_lines() <= count);
  require(host.log().size() <= 100 && host.clock() >= 0);
  for (int i = 0; i < maze().size().area(); ++i)
    require(host.canvas().text(maze().size().cell_at(i)).find_first_of("\\\n\t") == std::string_view::npos);
  return 0;
}

}  // namespace labmouse::fuzz
