// Shows which route of a maze is fastest as one or two numbers of the robot vary.
#include <fmt/format.h>

#include <optional>

#include "labmouse/lab/page/answers.hpp"
#include "labmouse/lab/page/request.hpp"
#include "labmouse/lab/page/robot_request.hpp"
#include "labmouse/lab/robots/robot_family.hpp"
#include "labmouse/lab/robots/robot_file.hpp"
#include "labmouse/lab/routes/region_data.hpp"
#include "labmouse/lab/routes/region_picture.hpp"
#include "labmouse/lab/routes/route_regions.hpp"
#include "labmouse/lab/routes/route_report.hpp"

namespace labmouse {
namespace {

VariedNumber varied_number(PageRequest& request, const char* name) {
  constexpr double most = 1e12;
  static const ReadJson nothing;
  JsonFields fields(request.has(name) ? request.json()[name] : nothing, name);
  VariedNumber number = {fields.text("key"), fields.number("from", -most, most), fields.number("to", -most, most)};
  request.reject(fields.error());
  request.reject(why_not_varied(number.key));
  if (!(number.from < number.to))
    request.reject(fmt::format("'{}' needs a range from a smaller number to a larger one", name));
  return number;
}

}  // namespace

PageReply answer_regions(const ReadJson& json, std::string_view bytes) {
  PageRequest request(json);
  const std::string name = request.text("name");
  const NamedMaze maze = request.maze();
  const std::string text = robot_text_of(request, bytes);
  const VariedNumber across = varied_number(request, "vary");
  std::optional<VariedNumber> along;
  if (request.has("and")) along = varied_number(request, "and");
  if (along && along->key == across.key) request.reject("'and.key' names the same number as 'vary.key'");
  if (!request.error().empty()) return failed(request.error());
  const RobotResult robot = read_robot(text, name);
  if (!robot.robot) return failed("the robot is refused", robot.problems);
  if (const std::string why = route_report(maze.maze, robot.model).error; !why.empty())
    return failed(fmt::format("{} {}", maze.name, why));
  const RegionOrder order = order_of(across, along);
  const RouteRegions found = find_regions(maze.maze, RobotFamily(text, name), order);
  if (found.routes.empty())
    return failed(fmt::format("no robot of this range has a route: {}", found.rows.front().regions.front().refusal));
  return answered({{"regions", regions_json(found, order, maze.name, name)},
                   {"svg", draw_regions(maze.maze, found, order, title_of_regions(maze.name, name))}});
}

}  // namespace labmouse
