#include "labmouse/external/mms/driven_mms.hpp"

#include <algorithm>
#include <optional>
#include <string>
#include <utility>

namespace labmouse {
namespace {

/// A program that writes so many lines in a row without a move does so for ever.
constexpr int most_lines = 100'000;
/// A program that asks for Reset so often in a row is waiting for it, as in mms.
constexpr int most_questions = 100;

/// Whether a program for mms may end its search so: by its end, or by doing nothing any more.
bool ends_a_search(ForfeitReason reason) {
  return reason == ForfeitReason::none || reason == ForfeitReason::ended_early || reason == ForfeitReason::hung ||
         reason == ForfeitReason::late || reason == ForfeitReason::out_of_time;
}

}  // namespace

DrivenMms::DrivenMms(const Launch& launch, const Briefing& briefing)
    : CellwiseExplorer(briefing), talk_(launch, "mazeWidth"), heading_(briefing.start.heading) {}

StrategyReport DrivenMms::report() {
  if (was_in_goal() && ends_a_search(talk_.reason())) return {.last_words = talk_.errors()};
  return {.last_words = talk_.last_words(), .started = talk_.greeted()};
}

CellwiseExplorer::Order DrivenMms::next_order() {
  if (std::exchange(moves_, false)) {
    reply_ += was_blocked() ? "crash\n" : "ack\n";
    arrive();
    if (was_in_goal() && cell() == briefing().start.cell) return end_search(ForfeitReason::none);
  }
  for (;;) {
    const auto line = begun_ ? talk_.ask(std::exchange(reply_, "")) : talk_.greet("");
    if (!line) return end_search(talk_.reason());
    if (!std::exchange(begun_, true)) talk_.accept();
    if (++lines_ > most_lines) return end_search(ForfeitReason::out_of_time);
    const MmsLine read = read_mms_line(*line);
    questions_ = read.command && read.command->verb == MmsVerb::was_reset ? questions_ + 1 : 0;
    if (questions_ >= most_questions) return end_search(ForfeitReason::out_of_time);
    if (!read.command) continue;
    if (const auto order = obey(*read.command)) return *order;
  }
}

std::optional<CellwiseExplorer::Order> DrivenMms::obey(const MmsCommand& command) {
  switch (command.verb) {
    case MmsVerb::maze_width:
      reply_ = std::to_string(briefing().size.width) + '\n';
      return std::nullopt;
    case MmsVerb::maze_height:
      reply_ = std::to_string(briefing().size.height) + '\n';
      return std::nullopt;
    case MmsVerb::wall:
      // From the middle of a cell there is a post at 45 degrees.
      reply_ = command.eighths % 2 != 0 || sees_wall(turned(heading_, command.eighths / 2), command.half_steps)
                   ? "true\n"
                   : "false\n";
      return std::nullopt;
    case MmsVerb::get_stat:
      reply_ = statistic_reply(ledger_.statistics(), command.text).value_or("") + '\n';
      return std::nullopt;
    case MmsVerb::was_reset:
      reply_ = "false\n";
      return std::nullopt;
    case MmsVerb::move:
      return move(command.half_steps);
    case MmsVerb::turn:
      return turn(command.eighths);
    case MmsVerb::ack_reset:
      if (was_in_goal()) return end_search(ForfeitReason::none);
      ledger_.count_reset();
      heading_ = briefing().start.heading;
      move_to(briefing().start.cell);
      reply_ = "ack\n";
      return Order{};
    default:
      return std::nullopt;
  }
}

std::optional<CellwiseExplorer::Order> DrivenMms::move(std::int64_t half_steps) {
  if (half_steps < 1 || state(cell(), heading_) == WallState::closed) {
    reply_ = "crash\n";
    return std::nullopt;
  }
  if (half_steps % 2 != 0) return refuse("moves by half cells");
  ledger_.count_move(half_steps, cell() == briefing().start.cell);
  moves_ = true;
  lines_ = 0;
  const std::int64_t most = max_side;
  return Order{.direction = heading_, .cells = static_cast<int>(std::min(half_steps / 2, most))};
}

std::optional<CellwiseExplorer::Order> DrivenMms::turn(int eighths) {
  if (eighths % 2 != 0) return refuse("turns by 45 degrees");
  heading_ = turned(heading_, eighths / 2);
  ledger_.count_turn();
  arrive();
  reply_ = "ack\n";
  return std::nullopt;
}

/// Whether any of so many half steps from the middle of its cell would end at a wall.
bool DrivenMms::sees_wall(Heading direction, std::int64_t half_steps) const {
  Cell at = cell();
  do {
    if (state(at, direction) == WallState::closed) return true;
    at = neighbour(at, direction);
    half_steps -= 2;
  } while (half_steps > 0);
  return false;
}

void DrivenMms::arrive() { ledger_.count_arrival(briefing().goals.contains(cell()), cell() == briefing().start.cell); }

CellwiseExplorer::Order DrivenMms::end_search(ForfeitReason reason) {
  if (was_in_goal() && ends_a_search(talk_.reason())) return {.kind = Order::Kind::end};
  if (talk_.reason() == ForfeitReason::none) talk_.give_up(reason, "it wrote only lines that do not move the mouse");
  return {.kind = Order::Kind::forfeit, .reason = talk_.reason()};
}

CellwiseExplorer::Order DrivenMms::refuse(std::string_view what) {
  talk_.give_up(ForfeitReason::invalid_answer,
                "it " + std::string(what) + ", and the controller drives whole cells and turns by 90 degrees");
  return {.kind = Order::Kind::forfeit, .reason = talk_.reason()};
}

}  // namespace labmouse
