#include "labmouse/external/mms/host.hpp"

#include <algorithm>
#include <utility>

#include "labmouse/external/quoted_line.hpp"

namespace labmouse {
namespace {

// Units of work, and units per second at the default position of mms's speed slider, 33 of 0 to 99: ((1 - f) * 10^(1/4)
// + f * 5000^(1/4))^4 with f = 33/99.
constexpr double straight_work = 50, diagonal_work = 70.71, eighth_work = 16.66, quarter_work = 33.33;
constexpr double work_a_second = 253.07061515961826;

/// A mouse that asks for Reset so often in a row is waiting for it.
constexpr int patience = 100;

constexpr std::size_t most_logged = 100;

}  // namespace

MmsHost::MmsHost(const Maze& maze, const MmsOptions& options)
    : MmsHost({maze.size(), [maze](Cell cell, Heading side) { return maze.is_open(cell, side); }, HalfPose(),
               mms_goals(maze.size())},
              options) {}

MmsHost::MmsHost(MmsMaze maze, const MmsOptions& options)
    : maze_(std::move(maze)), options_(options), pose_(maze_.start), canvas_(maze_.size) {}

void MmsHost::obey(std::string_view line, std::string& replies) {
  if (!goes_on()) return;
  ++lines_;
  const MmsLine read = read_mms_line(line);
  if (!read.command || read.command->verb != MmsVerb::was_reset) questions_ = 0;
  if (!read.command) return log_invalid(line, read.problem);
  const std::size_t begin = replies.size();
  const bool changed = obey(*read.command, replies);
  const std::string_view reply = std::string_view(replies).substr(begin);
  if (changed && listener_) listener_({line, reply.substr(0, reply.find('\n')), pose_, clock()});
}

/// Obeys a command. Returns whether the mouse or its drawing changed.
bool MmsHost::obey(const MmsCommand& command, std::string& replies) {
  switch (command.verb) {
    case MmsVerb::maze_width:
      replies += std::to_string(maze_.size.width) + '\n';
      return false;
    case MmsVerb::maze_height:
      replies += std::to_string(maze_.size.height) + '\n';
      return false;
    case MmsVerb::wall:
      replies += sees_wall(turned(pose_.heading, command.eighths), command.half_steps) ? "true\n" : "false\n";
      return false;
    case MmsVerb::get_stat:
      replies += statistic_reply(statistics(), command.text).value_or("") + '\n';
      return false;
    case MmsVerb::was_reset:
      replies += was_reset_ ? "true\n" : "false\n";
      note_question();
      return false;
    case MmsVerb::move: {
      const std::int64_t gone = move(command.half_steps);
      replies += gone == command.half_steps && gone > 0 ? "ack\n" : "crash\n";
      return gone > 0;
    }
    case MmsVerb::turn:
      turn(command.eighths);
      break;
    case MmsVerb::ack_reset:
      pose_ = maze_.start;
      was_reset_ = false;
      ledger_.count_reset();
      break;
    default:
      return draw(command);
  }
  replies += "ack\n";
  return true;
}

bool MmsHost::is_blocked(HalfPlace place, Compass direction) const {
  return blocked_by(maze_.is_open, place, direction);
}

/// Whether any of so many half steps would end in a wall or a post; at least the first one is checked.
bool MmsHost::sees_wall(Compass direction, std::int64_t half_steps) const {
  HalfPlace place = pose_.place;
  // The border ends the loop at the latest.
  while (!is_blocked(place, direction)) {
    if (--half_steps < 1) return false;
    place = half_step(place, direction);
  }
  return true;
}

/// Moves until a wall, and returns the half steps made. As in mms, the statistics count all that were asked for.
std::int64_t MmsHost::move(std::int64_t half_steps) {
  if (half_steps < 1 || is_blocked(pose_.place, pose_.heading)) return 0;
  ledger_.count_move(half_steps, cell_of(pose_.place) == cell_of(maze_.start.place));
  std::int64_t gone = 0;
  for (; gone < half_steps && !is_blocked(pose_.place, pose_.heading); ++gone)
    pose_.place = half_step(pose_.place, pose_.heading);
  work_ += static_cast<double>(gone) * (is_diagonal(pose_.heading) ? diagonal_work : straight_work);
  arrive();
  return gone;
}

void MmsHost::turn(int eighths) {
  ledger_.count_turn();
  pose_.heading = turned(pose_.heading, eighths);
  work_ += eighths % 2 == 0 ? quarter_work : eighth_work;
  arrive();
}

void MmsHost::arrive() {
  const Cell cell = cell_of(pose_.place);
  ledger_.count_arrival(maze_.goals.contains(cell), cell == cell_of(maze_.start.place));
}

bool MmsHost::draw(const MmsCommand& command) {
  if (command.verb == MmsVerb::clear_all_colour) {
    canvas_.clear_colours();
    return true;
  }
  if (command.verb == MmsVerb::clear_all_text) {
    canvas_.clear_texts();
    return true;
  }
  const Size size = maze_.size;
  if (command.x < 0 || command.y < 0 || command.x >= size.width || command.y >= size.height) return false;
  draw({command.x, command.y}, command);
  return true;
}

void MmsHost::draw(Cell cell, const MmsCommand& command) {
  switch (command.verb) {
    case MmsVerb::set_wall:
    case MmsVerb::clear_wall:
      return canvas_.set_wall(cell, command.side, command.verb == MmsVerb::set_wall);
    case MmsVerb::set_colour:
      return canvas_.set_colour(cell, command.colour);
    case MmsVerb::clear_colour:
      return canvas_.set_colour(cell, 0);
    default:
      return canvas_.set_text(cell, command.verb == MmsVerb::set_text ? command.text : "");
  }
}

/// Counts questions for Reset in a row, and presses the button for a mouse that waits.
void MmsHost::note_question() {
  if (was_reset_) return;
  if (++questions_ < patience || options_.presses <= 0) return;
  --options_.presses;
  press_reset();
}

void MmsHost::on_event(std::function<void(const MmsEvent&)> listener) { listener_ = std::move(listener); }

bool MmsHost::goes_on() const { return !waits() && !is_endless() && !(options_.strict && invalid_lines_ > 0); }

bool MmsHost::is_endless() const { return clock() >= options_.most_seconds || lines_ >= options_.most_lines; }

bool MmsHost::waits() const { return questions_ >= patience; }

void MmsHost::press_reset() {
  was_reset_ = true;
  questions_ = 0;
}

double MmsHost::clock() const { return work_ / work_a_second; }

void MmsHost::log_invalid(std::string_view line, const std::string& problem) {
  ++invalid_lines_;
  if (log_.size() < most_logged)
    log_.push_back("line " + std::to_string(lines_) + ": " + quoted_line(line) + " " + problem + mms_suggestion(line));
}

}  // namespace labmouse
