#include "labmouse/external/mms/driven_mms.hpp"

#include <cstdlib>
#include <utility>

namespace labmouse {
namespace {

/// More lines in a row without a move end the search.
constexpr std::int64_t most_idle_lines = 100'000;

/// Whether a program may end a search for this reason: it ended, or it did nothing any more.
bool is_an_end(ForfeitReason reason) {
  return reason == ForfeitReason::none || reason == ForfeitReason::ended_early || reason == ForfeitReason::hung ||
         reason == ForfeitReason::late || reason == ForfeitReason::out_of_time;
}

HalfPose half_pose_of(Cell cell, Compass heading) { return {{2 * cell.x + 1, 2 * cell.y + 1}, heading}; }

Compass compass_of(Heading heading) { return static_cast<Compass>(eighths(heading)); }

bool is_middle(HalfPlace place) { return place.x % 2 != 0 && place.y % 2 != 0; }

}  // namespace

DrivenMms::DrivenMms(const Launch& launch, const Briefing& briefing)
    : CellwiseExplorer(briefing),
      talk_(launch, "mazeWidth"),
      host_({briefing.size, [this](Cell at, Heading side) { return state(at, side) != WallState::closed; },
             half_pose_of(briefing.start.cell, compass_of(briefing.start.heading)), briefing.goals},
            {}) {}

StrategyReport DrivenMms::report() {
  if (was_in_goal() && is_an_end(talk_.reason())) return {.last_words = talk_.errors()};
  return {.last_words = talk_.last_words(), .started = talk_.greeted()};
}

CellwiseExplorer::Order DrivenMms::next_order() {
  if (std::exchange(moves_, false)) {
    settle_move();
    if (was_in_goal() && cell() == briefing().start.cell) return end_search(ForfeitReason::none, "");
  }
  for (;;) {
    const auto line = begun_ ? talk_.ask(std::exchange(replies_, "")) : talk_.greet("");
    if (!line) return end_search(talk_.reason(), "");
    if (!std::exchange(begun_, true)) talk_.accept();
    const HalfPose before = host_.pose();
    const MmsLine read = read_mms_line(*line);
    host_.obey(*line, replies_);
    if (!host_.goes_on() || host_.lines() - last_move_ > most_idle_lines)
      return end_search(ForfeitReason::out_of_time,
                        host_.waits() ? "it waits for Reset" : "it only writes other lines than moves");
    if (const auto order = order_of(before, read.command && read.command->verb == MmsVerb::ack_reset)) return *order;
  }
}

/// The mouse may have got less far than the map had let expect.
void DrivenMms::settle_move() {
  if (!was_blocked()) return;
  host_.put(half_pose_of(cell(), host_.pose().heading));
  replies_ = "crash\n";
}

/// What the mouse has to drive because of a line, if anything.
std::optional<CellwiseExplorer::Order> DrivenMms::order_of(const HalfPose& before, bool reset) {
  if (reset) {
    if (was_in_goal()) return end_search(ForfeitReason::none, "");
    move_to(briefing().start.cell);
    return Order{};
  }
  const HalfPlace from = before.place, to = host_.pose().place;
  if (from == to) return std::nullopt;
  if (!is_middle(to) || is_diagonal(before.heading))
    return end_search(ForfeitReason::invalid_answer,
                      "it moved by half a cell or diagonally, and the controller drives whole cells");
  moves_ = true;
  last_move_ = host_.lines();
  return Order{.direction = heading_of(before.heading),
               .cells = (std::abs(to.x - from.x) + std::abs(to.y - from.y)) / 2};
}

/// After a goal it may end its search; otherwise it forfeits, with its own reason if it has one.
CellwiseExplorer::Order DrivenMms::end_search(ForfeitReason reason, std::string_view sentence) {
  if (was_in_goal() && is_an_end(reason)) return {.kind = Order::Kind::end};
  talk_.give_up(reason, sentence);
  return {.kind = Order::Kind::forfeit, .reason = talk_.reason()};
}

}  // namespace labmouse
