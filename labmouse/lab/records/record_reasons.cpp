#include "labmouse/lab/records/record_reasons.hpp"

#include <algorithm>
#include <limits>

#include "labmouse/lab/text/json_fields.hpp"

namespace labmouse {
namespace {

constexpr int largest_cost = std::numeric_limits<int>::max();

Json candidate_json(const Candidate& candidate) {
  const auto cell = [](Cell at) { return Json{at.x, at.y}; };
  Json line;
  if (candidate.goal)
    line["goal"] = true;
  else
    line["wall"] = {candidate.wall.cell.x, candidate.wall.cell.y, name_of(candidate.wall.side)};
  line["seen_from"] = cell(candidate.seen_from);
  line["through"] = candidate.through;
  line["travel"] = candidate.travel;
  if (!candidate.worth) line["worth"] = false;
  line["score"] = candidate.score;
  return line;
}

/// A wall [x, y, side], which must lie between two cells of the maze.
Wall read_wall(JsonFields& fields, Size size) {
  const ReadJson& wall = fields.list("wall");
  const bool named = wall.size() == 3 && (wall[2] == name_of(Heading::north) || wall[2] == name_of(Heading::east));
  if (!named) return fields.fail("has a wall that is not [x, y, \"north\" or \"east\"]", Wall());
  const Wall read = {fields.cell(ReadJson::array({wall[0], wall[1]}), "wall"),
                     wall[2] == "north" ? Heading::north : Heading::east};
  if (on_border(read, size)) fields.fail("has a wall that is not inside the maze");
  return read;
}

Candidate read_candidate(JsonFields& fields, Size size) {
  Candidate candidate;
  candidate.goal = fields.has("goal") && fields.flag("goal");
  if (!candidate.goal)
    candidate.wall = read_wall(fields, size);
  else if (fields.has("wall"))
    fields.fail("has both a goal and a wall");
  candidate.seen_from = fields.cell("seen_from");
  if (!size.contains(candidate.seen_from)) fields.fail("is seen from outside the maze");
  candidate.through = fields.whole("through", 0, largest_cost);
  candidate.travel = fields.whole("travel", 0, largest_cost);
  candidate.worth = !fields.has("worth") || fields.flag("worth");
  candidate.score = fields.number("score", -largest_cost, largest_cost);
  return candidate;
}

Ground read_ground(JsonFields& fields) {
  const std::string name = fields.text("ground");
  for (const Ground ground : {Ground::candidates, Ground::flood, Ground::no_loops})
    if (name == name_of(ground)) return ground;
  fields.fail("has an unknown 'ground'");
  return Ground::candidates;
}

/// Reads the candidates; returns what is wrong, or nothing.
std::string read_candidates(const ReadJson& list, Size size, std::vector<Candidate>& candidates) {
  const int most = 2 * size.area();
  if (list.size() > static_cast<std::size_t>(most))
    return fmt::format("'reasons.candidates' has more than {} entries", most);
  candidates.reserve(list.size());
  for (const ReadJson& each : list) {
    JsonFields fields(each, fmt::format("reasons.candidates[{}]", candidates.size()));
    candidates.push_back(read_candidate(fields, size));
    if (!fields.error().empty()) return fields.error();
  }
  return "";
}

}  // namespace

Json reasons_json(const Reasons& reasons) {
  auto candidates = Json::array();
  for (const Candidate& candidate : reasons.candidates) candidates.push_back(candidate_json(candidate));
  Json line;
  if (reasons.ground != Ground::candidates) line["ground"] = name_of(reasons.ground);
  line["candidates"] = std::move(candidates);
  line["chosen"] = reasons.chosen;
  line["known"] = reasons.known;
  line["way_here"] = reasons.way_here;
  line["hope"] = reasons.hope;
  line["price"] = reasons.price;
  return line;
}

std::string read_reasons(const ReadJson& object, Size size, Reasons& reasons) {
  JsonFields fields(object, "reasons");
  const ReadJson& candidates = fields.list("candidates");
  if (!fields.error().empty()) return fields.error();
  if (auto error = read_candidates(candidates, size, reasons.candidates); !error.empty()) return error;
  if (fields.has("ground")) reasons.ground = read_ground(fields);
  reasons.chosen = fields.whole("chosen", -1, static_cast<int>(candidates.size()) - 1);
  reasons.known = fields.whole("known", 0, largest_cost);
  reasons.way_here = fields.number("way_here", 0, 1);
  reasons.hope = fields.number("hope", 0, largest_cost);
  reasons.price = fields.number("price", 0, largest_cost);
  return fields.error();
}

bool fit(const Reasons& reasons, Size size) {
  return std::all_of(reasons.candidates.begin(), reasons.candidates.end(), [&](const Candidate& each) {
    return size.contains(each.seen_from) && (each.goal || !on_border(each.wall, size));
  });
}

}  // namespace labmouse
