// Any bytes as a contest with a map that doubts, in which readings mean little: it comes to an end that is no fault of
// the strategy, and the strategy goes not round and round.
#include <array>
#include <cstring>

#include "tests/fuzz/fuzzer.hpp"
#include "tests/lab/wild_contest.hpp"

namespace labmouse::fuzz {

LABMOUSE_FUZZER(log_odds_map) {
  std::array<std::uint8_t, 8> first{};
  std::memcpy(first.data(), bytes, size < first.size() ? size : first.size());
  test::WildContest contest;
  contest.seed = 256U * first[0] + first[1];
  contest.strategy = first[2];
  contest.side = 3 + first[3] % 6;
  contest.loops = 4 * first[4] % 1001;
  contest.wild = first[5] / 255.0;
  contest.crash = first[6] / 2550.0;
  const PhysicalRecord record = test::held(contest);
  require(test::came_to_its_end(record));
  require(record.drive.decisions < test::most_decisions);
  return 0;
}

}  // namespace labmouse::fuzz
