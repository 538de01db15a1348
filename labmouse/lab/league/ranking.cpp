#include "labmouse/lab/league/ranking.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <tuple>

#include "labmouse/lab/numbers/maze_interval.hpp"
#include "labmouse/lab/text/printable.hpp"

namespace labmouse {
namespace {

/// Seed of all resamples: equal shares give equal intervals.
constexpr std::uint64_t seed = 1;

std::vector<RankedMouse> in_order(const std::vector<MouseShares>& all) {
  std::vector<RankedMouse> mice;
  for (const MouseShares& mouse : all) {
    const double mean = labmouse::mean(mouse.shares);
    const Interval found = mean_interval(mouse.shares, seed);
    mice.push_back(
        {mouse.name, mice.size(), 0, mean, including({std::max(found.low, 0.0), std::min(found.high, 1.0)}, mean)});
  }
  std::sort(mice.begin(), mice.end(), [](const RankedMouse& a, const RankedMouse& b) {
    return std::tuple(-a.mean, std::string_view(a.name)) < std::tuple(-b.mean, std::string_view(b.name));
  });
  return mice;
}

/// The difference of a mouse from another one. It is turned, because lower is better in verdicts.
PairedDifference turned_difference(const std::vector<double>& mouse, const std::vector<double>& other) {
  std::vector<double> differences;
  for (std::size_t maze = 0; maze < mouse.size(); ++maze) differences.push_back(other[maze] - mouse[maze]);
  return paired_difference(differences, seed);
}

TestVerdict opposite(TestVerdict verdict) {
  if (verdict == TestVerdict::better) return TestVerdict::worse;
  return verdict == TestVerdict::worse ? TestVerdict::better : verdict;
}

void compare_all(const std::vector<MouseShares>& all, Ranking& ranking) {
  const std::size_t count = ranking.mice.size();
  ranking.pairs.assign(count, std::vector<RankedPair>(count));
  // Over all pairs of 50 mice, no p-value of the test would be small enough: it has steps of 1 in 10,000.
  const auto comparisons = static_cast<double>(count - 1);
  for (std::size_t a = 0; a < count; ++a)
    for (std::size_t b = a + 1; b < count; ++b) {
      const PairedDifference one =
          turned_difference(all[ranking.mice[a].place].shares, all[ranking.mice[b].place].shares);
      const TestVerdict verdict = verdict_of(one, std::min(1.0, one.p * comparisons));
      // + 0.0 turns -0.0 into 0.
      ranking.pairs[a][b] = {-one.mean + 0.0, scaled(one.interval, -1.0), verdict};
      ranking.pairs[b][a] = {one.mean, one.interval, opposite(verdict)};
    }
}

}  // namespace

Ranking rank_mice(const std::vector<MouseShares>& all) {
  Ranking ranking;
  ranking.mice = in_order(all);
  compare_all(all, ranking);
  std::size_t best = 0;
  for (std::size_t mouse = 0; mouse < ranking.mice.size(); ++mouse) {
    if (mouse > best && ranking.pairs[best][mouse].verdict == TestVerdict::better) best = mouse;
    ranking.mice[mouse].rank = static_cast<int>(best) + 1;
  }
  return ranking;
}

std::string groups_text(const Ranking& ranking) {
  const std::vector<RankedMouse>& mice = ranking.mice;
  std::string text;
  for (std::size_t first = 0, end = 0; first < mice.size(); first = end) {
    std::vector<std::string> others;
    for (end = first + 1; end < mice.size() && mice[end].rank == mice[first].rank; ++end)
      others.push_back(shown(mice[end].name));
    if (others.empty()) continue;
    text += fmt::format("Rank {}: {} cannot be told apart from {}.\n", mice[first].rank, shown(mice[first].name),
                        fmt::join(others, ", "));
    if (end - first == mice.size()) text += "All mice share one rank; more examination mazes may tell them apart.\n";
  }
  return text;
}

}  // namespace labmouse
