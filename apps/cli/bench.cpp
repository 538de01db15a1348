// labmouse bench: one number for behaviour, and the speeds of this build on this machine.
#include <fmt/format.h>

#include <memory>

#include "command.hpp"
#include "labmouse/lab/bench/distance_speed.hpp"
#include "labmouse/lab/bench/signature.hpp"
#include "labmouse/lab/bench/speed_json.hpp"
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

}  // namespace

void add_bench(Command& app, int& exit) {
  auto format = std::make_shared<std::string>("table");
  auto signature_only = std::make_shared<bool>(false);
  Command* command = app.add_subcommand("bench", "Print the behaviour signature and measure speeds");
  command->add_option("--format", *format, "Output")->check(one_of({"table", "json"}))->capture_default_str();
  command->add_flag("--signature", *signature_only, "Print only the behaviour signature");
  command->footer("Example: labmouse bench --format json");
  command->callback([format, signature_only, &exit] {
    const std::string signature = labmouse::signature();
    exit = exit_good;
    if (*signature_only) {
      print(signature + "\n");
      return;
    }
    const Speed speed = measure_speed();
    print(*format == "json" ? bench_json(signature, speed) : bench_table(signature, speed));
  });
}

}  // namespace labmouse::cli
