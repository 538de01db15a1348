#include "labmouse/mouse/drive/search_field.hpp"

#include <gtest/gtest.h>

#include "labmouse/chance/rng.hpp"
#include "tests/drawn_maze.hpp"
#include "tests/mouse/drive_robots.hpp"
#include "tests/mouse/plain_search_field.hpp"
#include "tests/slowness.hpp"
#include "tests/strategies/random_mazes.hpp"

namespace labmouse {
namespace {

constexpr SearchPlace at_edge(int x, int y, Heading heading) { return {{{x, y}, heading}, false}; }
constexpr SearchPlace at_rest(int x, int y, Heading heading) { return {{{x, y}, heading}, true}; }

/// Whole times that tell apart what they are made of.
constexpr SearchDrive drive = {100, 70, 5000, 1000, 30};

TEST(SearchMotion, LeavesTheCellThatItIsIn) {
  EXPECT_EQ(after_search(at_edge(2, 2, Heading::north), Action::step(0, 2)), at_edge(2, 4, Heading::north));
  EXPECT_EQ(after_search(at_edge(2, 2, Heading::north), Action::step(90, 1)), at_edge(3, 2, Heading::east));
  EXPECT_EQ(after_search(at_edge(2, 2, Heading::north), Action::step(-90, 2)), at_edge(0, 2, Heading::west));
  EXPECT_EQ(after_search(at_edge(2, 2, Heading::north), Action::step(180, 1)), at_edge(2, 1, Heading::south));
  EXPECT_EQ(after_search(at_rest(2, 2, Heading::north), Action::step(0, 1)), at_edge(2, 3, Heading::north));
  EXPECT_EQ(after_search(at_edge(2, 2, Heading::north), Action::step(-90, 0)), at_rest(2, 2, Heading::west));
}

TEST(SearchMotion, TakesItsTimes) {
  const SearchPlace edge = at_edge(2, 2, Heading::north), rest = at_rest(2, 2, Heading::north);
  EXPECT_EQ(search_time(drive, edge, Action::step(0, 3)), 300);
  EXPECT_EQ(search_time(drive, edge, Action::step(90, 1)), 70);
  EXPECT_EQ(search_time(drive, edge, Action::step(-90, 3)), 270);
  EXPECT_EQ(search_time(drive, edge, Action::step(180, 2)), 5100);
  EXPECT_EQ(search_time(drive, edge, Action::step(0, 0)), 30);
  EXPECT_EQ(search_time(drive, edge, Action::step(180, 0)), 2030);
  EXPECT_EQ(search_time(drive, rest, Action::step(0, 2)), 130);
  EXPECT_EQ(search_time(drive, rest, Action::step(-90, 1)), 1030);
  EXPECT_EQ(search_time(drive, rest, Action::step(180, 1)), 2030);
  EXPECT_EQ(search_time(drive, rest, Action::step(90, 0)), 1000);
}

/// The same with dashes, of 170 over two cells and 220 over three.
SearchDrive with_dashes() {
  SearchDrive dashing = drive;
  for (std::size_t halves = 1; halves < dashing.onward.size(); ++halves)
    dashing.onward[halves] = 35 + 25 * static_cast<DriveTime>(halves);
  return dashing;
}

TEST(SearchMotion, DashesOverKnownCells) {
  const SearchDrive dashing = with_dashes();
  const SearchPlace edge = at_edge(2, 0, Heading::north), rest = at_rest(2, 0, Heading::north);
  CellSet known;
  for (const int y : {0, 1, 2, 5}) known.insert({2, y});
  // Over the cells 0 to 2; at the edge of 3 it has to read, and the next that it knows is 5.
  EXPECT_EQ(search_time(dashing, edge, Action::step(0, 3), known), dashing.dash(3));
  EXPECT_EQ(search_time(dashing, edge, Action::step(0, 6), known), dashing.dash(3) + 100 + dashing.dash(2));
  EXPECT_EQ(search_time(dashing, edge, Action::step(0, 1), known), 100);
  EXPECT_EQ(search_time(dashing, edge, Action::step(0, 3), {}), 300);
  // From rest it is at the search speed behind half a cell.
  EXPECT_EQ(search_time(dashing, rest, Action::step(0, 3), known), 30 + dashing.dash(2));
  EXPECT_EQ(search_time(dashing, at_edge(1, 0, Heading::north), Action::step(90, 3), known), 70 + 200);
  EXPECT_EQ(search_time(drive, edge, Action::step(0, 3), known), 300);
}

TEST(SearchMotion, PassesTheEdgesOfADashAsFarFromBothEnds) {
  const SearchDrive dashing = with_dashes();
  for (int cells = 2; cells <= max_drive_side; ++cells) {
    EXPECT_EQ(dashing.dash_part(cells, 0), 0);
    EXPECT_EQ(dashing.dash_part(cells, cells), dashing.dash(cells));
    for (int edge = 1; edge <= cells; ++edge) {
      EXPECT_GT(dashing.dash_part(cells, edge), dashing.dash_part(cells, edge - 1));
      EXPECT_EQ(dashing.dash_part(cells, edge) + dashing.dash_part(cells, cells - edge), dashing.dash(cells));
    }
  }
}

TEST(SearchMotion, KnowsWhatIsNoMove) {
  const SearchPlace edge = at_edge(2, 2, Heading::north), rest = at_rest(2, 2, Heading::north);
  EXPECT_TRUE(is_search_step(edge, Action::step(0, 0)));
  EXPECT_FALSE(is_search_step(rest, Action::step(0, 0)));
  EXPECT_TRUE(is_search_step(rest, Action::step(180, 0)));
  for (const Action& action : {Action::step(0, -1), Action::step(45, 1), Action::step(-180, 1), Action::step(270, 1),
                               Action::step(0, 1 << 30), Action::step(90, -2), Action::reset()})
    EXPECT_FALSE(is_search_step(edge, action));
}

TEST(SearchField, CountsCellsTurnsAndTheWayBack) {
  const Maze maze = test::drawn(R"(
    o---o---o---o
    |           |
    o   o---o   o
    |   |   | G |
    o   o---o---o
    | S |       |
    o---o---o---o
  )");
  SearchField field(maze.size(), drive);
  field.fill(maze.open_walls(), {}, maze.goals());
  // Half a cell, one on, and then the corner, two cells of which the second is a corner, too.
  EXPECT_EQ(field.from(at_rest(0, 0, Heading::north)), 30 + 100 + 70 + 100 + 70);
  EXPECT_EQ(field.from(at_rest(0, 0, Heading::east)), 1000 + 30 + 100 + 70 + 100 + 70);
  EXPECT_EQ(field.from(at_edge(0, 1, Heading::south)), 5000 + 70 + 100 + 70);
  EXPECT_EQ(field.from(at_edge(2, 1, Heading::south)), 0);
  EXPECT_EQ(field.from(at_edge(1, 1, Heading::south)), no_time);
  EXPECT_EQ(field.step(at_edge(0, 1, Heading::south)), Action::step(180, 1));
  EXPECT_EQ(field.step(at_edge(0, 2, Heading::north)), Action::step(90, 1));
  EXPECT_EQ(field.step(at_edge(2, 1, Heading::south)), Action::step(0, 0));
  EXPECT_EQ(field.step(at_rest(1, 1, Heading::south)), Action::forfeit(ForfeitReason::no_route));
}

TEST(SearchField, AddsWhatWallsCost) {
  WallPrices prices({3, 1});
  prices.set(wall_at({0, 0}, Heading::east), 7);
  prices.set(wall_at({1, 0}, Heading::east), 0);
  SearchField field({3, 1}, drive);
  SearchTolls tolls{drive};
  tolls.unit = 11;
  tolls.base = 5;
  field.fill(prices, tolls, {}, CellSet::of({2, 0}));
  EXPECT_EQ(field.from(at_edge(0, 0, Heading::east)), 200 + 77 + 5);
  EXPECT_EQ(field.from(at_edge(1, 0, Heading::east)), 100);
  tolls.closed = 7;
  field.fill(prices, tolls, {}, CellSet::of({2, 0}));
  EXPECT_EQ(field.from(at_edge(0, 0, Heading::east)), no_time);
}

TEST(SearchField, SavesWhereItEntersCells) {
  WallPrices prices({3, 1});
  for (const int x : {0, 1}) prices.set(wall_at({x, 0}, Heading::east), 0);
  const DriveTime savings[] = {0, 40, 1000};
  SearchTolls tolls{drive};
  tolls.savings = savings;
  SearchField field({3, 1}, drive);
  field.fill(prices, tolls, {}, CellSet::of({2, 0}));
  // A move takes some time, whatever it saves.
  EXPECT_EQ(field.from(at_edge(0, 0, Heading::east)), 100 - 40 + 1);
}

/// A robot for which no stop on the way can be worth it, as for any whose times follow from its speeds.
SearchDrive any_drive(Rng& rng) {
  SearchDrive times;
  times.half_cell = 100 + rng.below(200);
  times.quarter = 300 + rng.below(1000);
  times.cell = 50 + rng.below(2 * times.half_cell - 50);
  times.turn = 50 + rng.below(2 * times.half_cell + times.quarter - 50);
  times.back = 50 + rng.below(2 * times.half_cell + 2 * times.quarter - 50);
  if (rng.chance(1, 2)) {
    const int saved = 1 + rng.below(times.cell / 4 + 1);
    for (std::size_t halves = 1; halves < times.onward.size(); ++halves)
      times.onward[halves] = 1 + static_cast<DriveTime>(halves) * (times.cell / 2 - saved / 2);
  }
  return times;
}

CellSet any_cells(Size size, Rng& rng) {
  CellSet cells;
  CellSet::all(size).for_each([&](Cell cell) {
    if (rng.chance(3, 4)) cells.insert(cell);
  });
  return cells;
}

void expect_plain_times(const Maze& maze, const SearchDrive& times, const SearchField& field, const CellSet& known,
                        const test::PlainToll& toll) {
  std::vector<Cell> targets;
  maze.goals().for_each([&](Cell cell) { targets.push_back(cell); });
  const auto plain = test::plain_search_times(maze.size(), times, toll, known, targets);
  for (int index = 0; index < maze.size().area(); ++index)
    for (const Heading heading : all_headings)
      for (const bool rest : {false, true}) {
        const SearchPlace place = {{maze.size().cell_at(index), heading}, rest};
        const auto found = plain.find(test::plain(place));
        ASSERT_EQ(field.from(place), found == plain.end() ? no_time : found->second) << test::drawing_of(maze);
      }
}

TEST(SearchField, IsThatOfAPlainSearchInAnyMaze) {
  Rng rng(11);
  for (int round = 0; round < test::tenth(60); ++round) {
    const Maze maze = test::any_maze(rng, 12);
    const SearchDrive times = any_drive(rng);
    const CellSet known = any_cells(maze.size(), rng);
    SearchField field(maze.size(), times);
    field.fill(maze.open_walls(), known, maze.goals());
    expect_plain_times(maze, times, field, known, [&](int x, int y, int heading) -> std::optional<std::int64_t> {
      if (!maze.is_open({x, y}, all_headings[static_cast<unsigned>(heading)])) return std::nullopt;
      return 0;
    });
  }
}

TEST(SearchField, IsThatOfAPlainSearchOverPrices) {
  Rng rng(12);
  for (int round = 0; round < test::tenth(60); ++round) {
    const Maze maze = test::any_maze(rng, 10);
    const SearchDrive times = any_drive(rng);
    const CellSet known = any_cells(maze.size(), rng);
    WallPrices prices(maze.size());
    WallSet::all(maze.size()).for_each([&](Wall wall) {
      // What was seen costs nothing more.
      const bool seen = known.contains(wall.cell) || known.contains(neighbour(wall.cell, wall.side));
      const int price = seen ? 0 : rng.below(WallPrices::highest + 1);
      prices.set(wall, rng.chance(1, 3) ? WallPrices::closed : price);
    });
    std::vector<DriveTime> savings(static_cast<std::size_t>(maze.size().area()));
    CellSet::all(maze.size()).for_each([&](Cell cell) {
      if (!known.contains(cell))
        savings[static_cast<std::size_t>(maze.size().index(cell))] = rng.below(times.half_cell);
    });
    // Of a strategy that counts turns otherwise.
    SearchTolls tolls{times};
    tolls.drive.turn = 50 + rng.below(2 * times.half_cell + times.quarter - 50);
    tolls.unit = 13;
    tolls.base = rng.below(100);
    if (rng.chance(1, 2)) tolls.closed = rng.below(WallPrices::closed);
    if (rng.chance(2, 3)) tolls.savings = savings;
    SearchField field(maze.size(), times);
    field.fill(prices, tolls, known, maze.goals());
    const auto toll = [&](int x, int y, int heading) -> std::optional<std::int64_t> {
      const Heading direction = all_headings[static_cast<unsigned>(heading)];
      const Wall wall = wall_at({x, y}, direction);
      if (on_border(wall, maze.size()) || prices.of(wall) >= tolls.closed) return std::nullopt;
      const auto entered = static_cast<std::size_t>(maze.size().index(neighbour({x, y}, direction)));
      return (prices.of(wall) > 0 ? tolls.base + 13 * prices.of(wall) : 0) -
             (tolls.savings.empty() ? 0 : savings[entered]);
    };
    expect_plain_times(maze, tolls.drive, field, known, toll);
  }
}

TEST(SearchField, FindsForAPlaceWhatItFindsForAll) {
  Rng rng(14);
  for (int round = 0; round < 200; ++round) {
    const Maze maze = test::any_maze(rng, 12);
    const SearchDrive times = any_drive(rng);
    const CellSet known = any_cells(maze.size(), rng);
    const Cell cell = maze.size().cell_at(rng.below(maze.size().area()));
    SearchPlace place = {{cell, all_headings[static_cast<unsigned>(rng.below(4))]}, rng.chance(1, 4)};
    SearchField all(maze.size(), times), some(maze.size(), times);
    all.fill(maze.open_walls(), known, maze.goals());
    some.fill(maze.open_walls(), known, maze.goals(), &place);
    for (Action step = all.step(place); step.movement > 0; step = all.step(place)) {
      ASSERT_EQ(some.from(place), all.from(place));
      ASSERT_EQ(some.step(place), step);
      place = after_search(place, step);
    }
    EXPECT_EQ(some.from(place), all.from(place));
  }
}

/// Opens and shuts some walls, learns and forgets some cells, and moves some targets.
void change_a_little(Size size, Rng& rng, WallSet& passages, CellSet& known, CellSet& targets) {
  const auto any_cell = [&] { return size.cell_at(rng.below(size.area())); };
  for (int walls = rng.below(4); walls > 0; --walls) {
    const Wall wall = wall_at(any_cell(), rng.chance(1, 2) ? Heading::north : Heading::east);
    if (on_border(wall, size)) continue;
    passages.contains(wall) ? passages.erase(wall) : passages.insert(wall);
  }
  for (int cells = rng.below(3); cells > 0; --cells) {
    const Cell cell = any_cell();
    known.contains(cell) ? known.erase(cell) : known.insert(cell);
  }
  if (rng.chance(1, 4)) targets.insert(any_cell());
  if (rng.chance(1, 4) && targets.count() > 1) {
    Cell last;
    targets.for_each([&](Cell cell) { last = cell; });
    targets.erase(last);
  }
}

TEST(SearchField, IsAfterAnyChangesWhatItIsWhenFilledAnew) {
  Rng rng(15);
  for (int round = 0; round < test::tenth(100); ++round) {
    const Maze maze = test::any_maze(rng, 12);
    const Size size = maze.size();
    const SearchDrive times = any_drive(rng);
    WallSet passages = maze.open_walls();
    CellSet known = any_cells(size, rng), targets = maze.goals();
    SearchField repaired(size, times);
    SearchPlace place = {{maze.start(), maze.start_heading()}, true};
    SearchDrive moves = times;
    for (int change = 0; change < 40; ++change) {
      change_a_little(size, rng, passages, known, targets);
      // The times of moves change now and then, too, even to nothing.
      if (rng.chance(1, 10)) moves.turn = rng.below(times.turn + 1);
      // A field over prices lies between them now and then.
      if (rng.chance(1, 20)) repaired.fill(WallPrices(size), {times}, known, targets);
      const bool all = rng.chance(1, 4);
      if (rng.chance(1, 3)) place.pose = {size.cell_at(rng.below(size.area())), all_headings[rng.below(4)]};
      repaired.fill(moves, passages, known, targets, all ? nullptr : &place);
      SearchField anew(size, times);
      anew.fill(moves, passages, known, targets);
      ASSERT_EQ(repaired.from(place), anew.from(place));
      SearchPlace there = place;
      for (Action step = anew.step(there); step.movement > 0; step = anew.step(there)) {
        ASSERT_EQ(repaired.step(there), step);
        there = after_search(there, step);
      }
      ASSERT_EQ(repaired.step(there), anew.step(there));
      for (int edge = 0; all && edge < 4 * size.area(); ++edge) {
        const SearchPlace other = {{size.cell_at(edge / 4), all_headings[static_cast<unsigned>(edge % 4)]}, false};
        ASSERT_EQ(repaired.from(other), anew.from(other));
      }
      // On to where it leads, as a mouse does.
      if (const Action step = anew.step(place); step.movement > 0) place = after_search(place, step);
    }
  }
}

TEST(SearchField, IsInMemoryThatOthersWriteToWhatItIsInItsOwn) {
  Rng rng(16);
  for (int round = 0; round < 20; ++round) {
    const Maze maze = test::any_maze(rng, 8);
    const SearchDrive times = any_drive(rng);
    WallSet passages = maze.open_walls();
    CellSet known, targets = maze.goals();
    std::vector<std::uint32_t> memory(SearchField::bytes_for(maze.size()) / sizeof(std::uint32_t) + 1);
    SearchField external(maze.size(), times, std::as_writable_bytes(std::span(memory))), own(maze.size(), times);
    const SearchPlace place = {{maze.start(), maze.start_heading()}, true};
    for (int change = 0; change < 10; ++change) {
      change_a_little(maze.size(), rng, passages, known, targets);
      std::fill(memory.begin(), memory.end(), 0xa5a5a5a5);
      external.fill(passages, known, targets, &place);
      own.fill(passages, known, targets, &place);
      ASSERT_EQ(external.from(place), own.from(place));
      ASSERT_EQ(external.step(place), own.step(place));
    }
  }
}

TEST(SearchField, LeadsByItsStepsInTheTimeThatItSays) {
  Rng rng(13);
  for (int round = 0; round < test::tenth(60); ++round) {
    const Maze maze = test::any_maze(rng, 16);
    const SearchDrive times = any_drive(rng);
    const CellSet known = any_cells(maze.size(), rng);
    SearchField field(maze.size(), times);
    SearchPlace place = {{maze.start(), maze.start_heading()}, true};
    // Half of them only as far as that place needs.
    field.fill(maze.open_walls(), known, maze.goals(), rng.chance(1, 2) ? &place : nullptr);
    if (field.from(place) == no_time) continue;
    std::int64_t spent = 0;
    const DriveTime said = field.from(place);
    for (Action step = field.step(place); step.movement > 0; step = field.step(place)) {
      ASSERT_EQ(step.kind, Action::Kind::step);
      spent += search_time(times, place, step, known);
      place = after_search(place, step);
    }
    EXPECT_TRUE(maze.is_goal(place.pose.cell));
    EXPECT_EQ(spent, said);
  }
}

}  // namespace
}  // namespace labmouse
