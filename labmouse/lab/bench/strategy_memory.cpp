#include "labmouse/lab/bench/strategy_memory.hpp"

#include <memory>
#include <vector>

#include "labmouse/contest/drive.hpp"
#include "labmouse/contest/drive_rules.hpp"
#include "labmouse/lab/bench/heap.hpp"
#include "labmouse/maze/maze.hpp"
#include "labmouse/mouse/drive/drive_fields.hpp"
#include "labmouse/strategies/builtin_mice.hpp"

namespace labmouse {
namespace {

/// Number of strategies to average over. A new strategy may reuse blocks that were free before, which the measurement
/// misses; over many strategies this is negligible.
constexpr std::size_t strategies = 64;

std::size_t own_memory(const BuiltinMouse& mouse, const Briefing& briefing) {
  const Settings settings(mouse.parameters);
  std::vector<std::unique_ptr<DrivingStrategy>> made(strategies);
  const std::size_t before = heap_in_use();
  for (auto& strategy : made) strategy = mouse.drive(briefing, settings);
  return (heap_in_use() - before) / strategies;
}

}  // namespace

StrategyMemory strategy_memory(Size size, const DriveModel& model) {
  const Maze maze(MazeDraft(size, MazeDraft::Inside::open));
  DriveFields fields = DriveFields::in_own_memory(size, model);
  Briefing briefing = brief(maze, DriveRules(), model, 1);
  briefing.drive.fields = &fields;
  StrategyMemory memory{size,
                        DriveFields::bytes_for(size, model),
                        DriveFields::layout(size, model),
                        route_tables_of(model)->table_bytes(size),
                        {}};
  for (const BuiltinMouse* mouse : builtin_mice())
    if (mouse->drives()) memory.own[std::string(mouse->name)] = own_memory(*mouse, briefing);
  return memory;
}

}  // namespace labmouse
