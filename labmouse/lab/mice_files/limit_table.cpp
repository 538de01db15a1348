#include "labmouse/lab/mice_files/limit_table.hpp"

#include <array>

namespace labmouse {
namespace {

constexpr std::array<std::string_view, 8> limit_keys = {"start",  "decision",  "silence", "contest",
                                                        "memory", "processes", "written", "cpu"};

}  // namespace

FileLimits read_limits(const toml::table& table, TomlFields& fields) {
  const toml::node* node = table.get("limits");
  if (node == nullptr) return {};
  const toml::table* limits = node->as_table();
  if (limits == nullptr) {
    fields.add(node->source().begin, "'limits' must be a table, such as { contest = 120 }");
    return {};
  }
  fields.refuse_unknown(*limits, limit_keys);
  constexpr double least_seconds = 0.001, most_seconds = 1e6;
  constexpr int most_mib = 1 << 20, least_mib = 16, most_processes = 4096;
  const auto seconds = [&](std::string_view key) {
    return fields.number(*limits, key, least_seconds, most_seconds, " of seconds");
  };
  FileLimits read;
  read.start = seconds("start");
  read.decision = seconds("decision");
  read.silence = seconds("silence");
  read.contest = seconds("contest");
  read.memory = fields.whole(*limits, "memory", least_mib, most_mib);
  read.written = fields.whole(*limits, "written", least_mib, most_mib);
  read.processes = fields.whole(*limits, "processes", 1, most_processes);
  read.processor_seconds = fields.whole(*limits, "cpu", 1, static_cast<int>(most_seconds));
  return read;
}

}  // namespace labmouse
