// Sums up by cell where contests in one maze lose steps.
#include <fmt/format.h>

#include <numeric>

#include "labmouse/contest/score.hpp"
#include "labmouse/contest/simulator.hpp"
#include "labmouse/lab/bounds/bounds.hpp"
#include "labmouse/lab/page/answers.hpp"
#include "labmouse/lab/page/mouse_spec.hpp"
#include "labmouse/lab/page/request.hpp"
#include "labmouse/lab/replays/lost_steps.hpp"

namespace labmouse {
namespace {

/// A limit, because the module has one thread and answers nothing else meanwhile.
constexpr std::size_t most_contests_with_losses = 5'000;

struct Entrant {
  Contestant mouse;
  std::uint64_t seed = 0;
};

std::vector<Entrant> read_entrants(PageRequest& request) {
  std::vector<Entrant> entrants;
  const ReadJson& list = request.list("contests");
  if (list.empty()) request.reject("'contests' is empty");
  if (list.size() > most_contests_with_losses)
    request.reject(fmt::format("{} contests are too many for the page, whose limit is {}", list.size(),
                               most_contests_with_losses));
  for (const ReadJson& each : list) {
    if (!request.error().empty()) break;
    PageRequest fields(each);
    const std::string spec = fields.text("mouse");
    const std::uint64_t seed = fields.seed();
    request.reject(fields.error());
    if (!request.error().empty()) break;
    SpecResult mice = read_page_mice({&spec, 1});
    request.reject(mice.error);
    if (mice.contestants.size() != 1)
      request.reject(fmt::format("'{}' names several mice; name exactly one", spec));
    else
      request.reject(refuse_to_walk(mice.contestants.front()));
    if (request.error().empty()) entrants.push_back({std::move(mice.contestants.front()), seed});
  }
  return entrants;
}

void add(std::vector<int>& sum, const std::vector<int>& more) {
  for (std::size_t i = 0; i < sum.size(); ++i) sum[i] += more[i];
}

}  // namespace

PageReply answer_losses(const ReadJson& json, std::string_view) {
  PageRequest request(json);
  const NamedMaze maze = request.maze();
  const Rules rules = request.rules();
  const std::vector<Entrant> entrants = request.error().empty() ? read_entrants(request) : std::vector<Entrant>();
  if (!request.error().empty()) return failed(request.error());

  const LossMeter meter(maze.maze, rules);
  const auto cells = static_cast<std::size_t>(maze.maze.size().area());
  LostSteps sum = {std::vector<int>(cells), std::vector<int>(cells)};
  int finished = 0;
  double score_sum = 0;
  for (const Entrant& entrant : entrants) {
    const auto strategy = entrant.mouse.strategy(maze.maze, brief(maze.maze, rules, entrant.seed));
    const RunRecord record = run(maze.maze, rules, *strategy);
    const std::optional<LostSteps> lost = meter.lost(record);
    if (!lost) continue;
    ++finished;
    score_sum += *score(record, rules).value;
    add(sum.search_run, lost->search_run);
    add(sum.speed, lost->speed);
  }
  // Mean loss per finished contest by cell, in points of the score.
  Json points = Json::array();
  for (std::size_t i = 0; i < cells; ++i)
    points.push_back(finished == 0 ? 0.0 : score_of(sum.search_run[i], sum.speed[i], rules) / finished);
  const std::optional<double> bound = bound_of(maze.maze, rules).score;
  return answered({{"contests", entrants.size()},
                   {"finished", finished},
                   {"bound", bound ? Json(*bound) : Json()},
                   {"mean_score", finished == 0 ? Json() : Json(score_sum / finished)},
                   {"search", sum.search_run},
                   {"speed", sum.speed},
                   {"points", std::move(points)}});
}

}  // namespace labmouse
