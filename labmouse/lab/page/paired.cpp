// Compares mice until it is decided which is better. The page runs the contests batch by batch, in several workers, and
// asks for the verdict in between: no call takes long, and none keeps anything for the next.
#include <algorithm>
#include <utility>

#include "labmouse/lab/page/answers.hpp"
#include "labmouse/lab/page/entrants.hpp"
#include "labmouse/lab/page/page_world.hpp"
#include "labmouse/lab/page/request.hpp"
#include "labmouse/lab/studies/compare.hpp"
#include "labmouse/lab/text/optional_json.hpp"
#include "labmouse/lab/worlds/entering.hpp"

namespace labmouse {
namespace {

/// Each request for a verdict contains the shares of all mazes.
constexpr int most_mazes = 20'000;

struct Paired {
  std::vector<Contestant> mice;
  CompareOrder order;
};

Paired read_paired(PageRequest& request) {
  Paired paired;
  Entry entry = read_page_world(request);
  paired.mice = read_mice(request, entry.world.get());
  if (paired.mice.size() < 2) request.reject("there is nothing to compare; name two mice or more that differ");
  CompareOrder& order = paired.order;
  std::vector<NamedMaze> mazes;
  if (request.has("mazes")) {
    order.mazes.list = mazes = read_mazes(request, entry.world.get());
  } else {
    const GeneratedMazes generated = read_generator(request);
    order.mazes.generator = generated.generator;
    order.mazes.order = generated.order;
    if (request.error().empty()) mazes = {drawn_maze(order.mazes, 0, 0)};
  }
  order.race.seed = request.seed();
  order.race.jobs = 1;
  order.most = static_cast<std::size_t>(request.whole("most", 1, most_mazes));
  order.test.better_by = request.number("better_by", least_better_by, most_better_by);
  order.test.alpha = request.number("alpha", 0.0001, 0.5);
  order.test.beta = request.number("beta", 0.0001, 0.5);
  if (request.has("test")) {
    const std::string test = request.text("test");
    if (test != "bets" && test != "gsprt") request.reject("'test' is neither bets nor gsprt");
    order.test.method = test == "gsprt" ? SequentialMethod::gsprt : SequentialMethod::bets;
  }
  if (!request.error().empty()) return paired;
  suit_defaults(entry, mazes);
  order.race.world = entry.world;
  return paired;
}

Json json_of(const std::vector<MazeShares>& all) {
  Json list = Json::array();
  for (const MazeShares& shares : all) {
    Json& maze = list.emplace_back(Json::array());
    for (const auto& share : shares) maze.push_back(or_null(share));
  }
  return list;
}

std::vector<MazeShares> read_shares(PageRequest& request, std::size_t mice) {
  std::vector<MazeShares> all;
  for (const ReadJson& maze : request.list("shares")) {
    MazeShares& shares = all.emplace_back();
    for (const ReadJson& share : maze) {
      const bool is_share = share.is_number() && share.get<double>() >= 0.0 && share.get<double>() <= 1.0;
      if (!is_share && !share.is_null()) request.reject("'shares' has an entry that is neither null nor from 0 to 1");
      shares.push_back(is_share ? std::optional(share.get<double>()) : std::nullopt);
    }
    if (!maze.is_array() || shares.size() != mice) request.reject("'shares' has a maze without a share for each mouse");
    if (!request.error().empty()) break;
  }
  return all;
}

}  // namespace

PageReply answer_paired_shares(const ReadJson& json, std::string_view) {
  PageRequest request(json);
  Paired paired = read_paired(request);
  const auto begin = static_cast<std::size_t>(request.whole("begin", 0, most_mazes));
  if (request.error().empty() && (begin >= paired.order.most || begin != batch_with(begin)))
    request.reject("'begin' is not the first maze of a batch");
  if (!request.error().empty()) return failed(request.error());
  return answered({{"shares", json_of(shares_of_batch(std::move(paired.mice), paired.order, {begin}))}});
}

PageReply answer_verdict(const ReadJson& json, std::string_view) {
  PageRequest request(json);
  Paired paired = read_paired(request);
  const std::vector<MazeShares> shares = read_shares(request, paired.mice.size());
  if (!request.error().empty()) return failed(request.error());
  const Compared compared = judged(std::move(paired.mice), paired.order, shares);
  return answered({{"comparison", comparison_json(compared)}, {"over", is_over(compared)}});
}

}  // namespace labmouse
