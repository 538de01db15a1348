// labmouse bench: the behaviour signature, and the speeds and memory of this build on this machine.
#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <vector>

#include "command.hpp"
#include "labmouse/lab/bench/distance_speed.hpp"
#include "labmouse/lab/bench/signature.hpp"
#include "labmouse/lab/bench/speed_json.hpp"
#include "labmouse/lab/bench/strategy_memory.hpp"
#include "labmouse/lab/robots/builtin_robots.hpp"
#include "labmouse/lab/system/version.hpp"
#include "labmouse/lab/text/json.hpp"

namespace labmouse::cli {
namespace {

std::string bench_table(const std::string& signature, const Speed& speed) {
  std::string text = fmt::format(
      "signature {}\n{}, {}\n\ndistance field, strides of three, median ns\n{:>5}{:>10}{:>16}{:>10}{:>10}{:>14}\n",
      signature, compiler(), processor(), "side", "rows", "rows, portable", "queue", "plain", "queue / rows");
  for (const auto& [side, ns] : speed.distance_ns)
    text += fmt::format("{:>5}{:>10.0f}{:>16.0f}{:>10.0f}{:>10.0f}{:>14.1f}\n", side, ns.rows, ns.portable_rows,
                        ns.queue, ns.plain, ns.queue / ns.rows);
  text += "\ncontests a second on one thread, 16x16\n";
  for (const auto& [mouse, contests] : speed.contests_per_second)
    text += fmt::format("{:>14}{:>10.0f}\n", mouse, contests);
  return text;
}

std::string bench_json(const std::string& signature, const Speed& speed) {
  Json json;
  json["signature"] = signature;
  json["labmouse"] = version();
  json["compiler"] = compiler();
  json["processor"] = processor();
  json["distance_ns"] = distance_json(speed.distance_ns);
  for (const auto& [mouse, contests] : speed.contests_per_second) json["contests_per_second"][mouse] = contests;
  return json.dump(1) + "\n";
}

/// The memory of strategies that drive one robot, in mazes of one size.
struct RobotMemory {
  std::string robot;
  StrategyMemory strategies;
};

std::vector<RobotMemory> memory_of(const std::vector<std::string>& names) {
  std::vector<RobotMemory> memory;
  for (const std::string& name : names) {
    const FoundRobot found = find_robot_or_refuse(name);
    for (const int side : {16, max_drive_side}) memory.push_back({name, strategy_memory({side, side}, found.model)});
  }
  return memory;
}

/// The memory of whole strategies: the shared fields and the strategy's own memory.
MemoryLayout whole_strategies(const StrategyMemory& memory) {
  MemoryLayout strategies;
  for (const auto& [mouse, own] : memory.own) strategies.push_back({mouse, memory.fields + own});
  return strategies;
}
MemoryLayout fields_of(const StrategyMemory& memory) {
  MemoryLayout parts = memory.layout;
  parts.push_back({"fields", memory.fields});
  parts.push_back({"tables", memory.tables});
  return parts;
}

/// A table with a line for each robot and size. `parts_of` names the parts.
template <class Parts>
std::string memory_table(const std::vector<RobotMemory>& robots, Parts parts_of) {
  std::size_t longest = 12;
  for (const auto& [robot, memory] : robots) longest = std::max(longest, robot.size());
  std::string text;
  for (const auto& [robot, memory] : robots) {
    std::string heads, figures;
    for (const auto& [name, bytes] : parts_of(memory)) {
      const std::size_t width = std::max<std::size_t>(name.size() + 2, 10);
      heads += fmt::format("{:>{}}", name, width);
      figures += fmt::format("{:>{}.1f}", static_cast<double>(bytes) / 1024.0, width);
    }
    if (text.empty()) text += fmt::format("{:<{}}  {:>5}{}\n", "robot", longest, "maze", heads);
    text += fmt::format("{:<{}}  {:>5}{}\n", robot, longest,
                        fmt::format("{0}x{1}", memory.size.width, memory.size.height), figures);
  }
  return text;
}

std::string memory_text(const std::vector<RobotMemory>& robots) {
  return "a mouse that drives, KiB\n" + memory_table(robots, whole_strategies) +
         "\nits fields among that, and the tables that all strategies share, KiB\n" + memory_table(robots, fields_of);
}

std::string memory_json(const std::vector<RobotMemory>& robots) {
  Json rows = Json::array();
  for (const auto& [robot, memory] : robots) {
    Json row = {{"robot", robot}, {"width", memory.size.width}, {"height", memory.size.height}};
    row["fields_bytes"] = memory.fields;
    row["tables_bytes"] = memory.tables;
    for (const auto& [name, bytes] : memory.layout) row["layout_bytes"][std::string(name)] = bytes;
    for (const auto& [mouse, own] : memory.own) row["own_bytes"][mouse] = own;
    rows.push_back(std::move(row));
  }
  return rows.dump(1) + "\n";
}

}  // namespace

void add_bench(Command& app, int& exit) {
  auto format = std::make_shared<std::string>("table");
  auto signature_only = std::make_shared<bool>(false);
  auto memory = std::make_shared<bool>(false);
  auto robots = std::make_shared<std::vector<std::string>>();
  Command* command = app.add_subcommand("bench", "Print the behaviour signature and measure speeds");
  command->add_option("--format", *format, "What is printed")->check(one_of({"table", "json"}))->capture_default_str();
  command->add_flag("--signature", *signature_only, "Print only the behaviour signature");
  const Option* asks_memory =
      command->add_flag("--memory", *memory, "Print only the memory of mice that drive, by mouse, size and robot");
  command->add_option("--robot", *robots, "Robots for --memory: built-in ones or files; default: all built-in ones")
      ->type_name("ROBOT")
      ->needs(asks_memory);
  command->footer("Example: labmouse bench --memory --robot classic");
  command->callback([format, signature_only, memory, robots, &exit] {
    exit = exit_good;
    if (*memory) {
      if (robots->empty())
        for (const BuiltinRobot& robot : builtin_robots()) robots->emplace_back(robot.name);
      const std::vector<RobotMemory> taken = memory_of(*robots);
      print(*format == "json" ? memory_json(taken) : memory_text(taken));
      return;
    }
    const std::string signature = labmouse::signature();
    if (*signature_only) {
      print(signature + "\n");
      return;
    }
    const Speed speed = measure_speed();
    print(*format == "json" ? bench_json(signature, speed) : bench_table(signature, speed));
  });
}

}  // namespace labmouse::cli
