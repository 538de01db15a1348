#include "labmouse/mouse/drive/search_clock.hpp"

#include "labmouse/mouse/robot/drive_model.hpp"

namespace labmouse {
namespace {

bool within(const WallSet& walls, const WallSet& others) {
  WallSet beyond = walls;
  beyond -= others;
  return beyond.empty();
}

}  // namespace

SearchClock::SearchClock(const Briefing& briefing)
    : start_(briefing.start),
      goals_(briefing.goals),
      search_(briefing.drive.model->search),
      pace_(briefing.drive.pace),
      time_limit_(briefing.drive.time_limit),
      fields_(*briefing.drive.fields) {}

bool SearchClock::is_too_late_after(const Action& step, const Knowledge& knowledge, const SearchPlace& place) {
  // At the start it stops and turns to its start heading, by at most half a turn.
  const std::int64_t arrival = slowed(search_.half_cell + 2 * search_.quarter);
  const std::int64_t then = time_ + time_of(step, knowledge, place);
  // An upper limit: home the way that it came, and a run on the same way at the search speed.
  if (3 * then + slowed(search_.back) + arrival < time_limit_) return false;
  // More seen walls make no way longer, so that this is an upper limit, too.
  const SearchPlace there = after_search(place, step);
  fields_.home().fill(knowledge.open(), knowledge.known_cells(), CellSet::of(start_.cell), &there);
  const std::int64_t home = then + slowed(fields_.home().from(there)) + arrival;
  // A run that was planned earlier and whose walls are still open is no faster than the fastest one.
  if (run_ < no_time && within(run_walls_, knowledge.open()) && home + run_ <= time_limit_) return false;
  fields_.routes().fill_for(start_, knowledge.open(), goals_);
  run_ = fields_.routes().time_from(start_);
  if (run_ == no_time) return false;
  run_walls_ = fields_.routes().walls_from(start_);
  return home + run_ > time_limit_;
}

}  // namespace labmouse
