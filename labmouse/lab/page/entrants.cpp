#include "labmouse/lab/page/entrants.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "labmouse/lab/page/mouse_spec.hpp"
#include "labmouse/lab/worlds/entering.hpp"

namespace labmouse {

std::vector<Contestant> read_mice(PageRequest& request, const World* world) {
  const ReadJson& list = request.list("mice");
  if (world == nullptr) return {};
  if (list.empty()) return residents_of(*world);
  std::vector<std::string> specs;
  for (const ReadJson& spec : list)
    if (spec.is_string())
      specs.push_back(spec.get<std::string>());
    else
      request.reject("'mice' has an entry that is not a string");
  SpecResult result = read_page_mice(specs);
  request.reject(result.error);
  for (const Contestant& mouse : result.contestants) request.reject(world->refuse(mouse));
  return std::move(result.contestants);
}

std::vector<NamedMaze> read_mazes(PageRequest& request, const World* world) {
  std::vector<NamedMaze> mazes;
  for (const ReadJson& each : request.list("mazes")) {
    mazes.push_back(request.maze_at(each, fmt::format("mazes[{}]", mazes.size())));
    const auto same = [&](const NamedMaze& maze) { return maze.name == mazes.back().name; };
    if (std::count_if(mazes.begin(), mazes.end(), same) > 1)
      request.reject(fmt::format("two mazes are named '{}'", mazes.back().name));
    if (const std::string reason = world != nullptr ? world->refuse(mazes.back().maze) : ""; !reason.empty())
      request.reject(fmt::format("{} {}", mazes.back().name, reason));
    if (!request.error().empty()) break;
  }
  if (mazes.empty()) request.reject("a race needs at least one maze");
  return mazes;
}

GeneratedMazes read_generator(PageRequest& request) {
  const std::string name = request.text("generator");
  const Size size{request.whole("width", 1, max_side), request.whole("height", 1, max_side)};
  const double loops = request.number("loops", 0.0, 1.0);
  const GeneratorOrder order{size, request.seed(), static_cast<int>(std::lround(loops * 1000.0))};
  const Generator* generator = find_generator(name);
  if (generator == nullptr)
    request.reject(fmt::format("unknown generator '{}'", name));
  else
    request.reject(std::string(generator->refuses(order)));
  return {generator, order};
}

}  // namespace labmouse
