#include "labmouse/lab/bench/strategy_memory.hpp"

#include <gtest/gtest.h>

#include "labmouse/lab/robots/robot_files.hpp"
#include "labmouse/mouse/drive/drive_fields.hpp"
#include "labmouse/strategies/builtin_mice.hpp"
#include "tests/slowness.hpp"

namespace labmouse {
namespace {

/// The robots of each of the searches: of one speed, of one speed a turn, of many.
std::vector<DriveModel> models() {
  Robot one = find_robot("classic").robot;
  one.speeds = 1;
  return {find_robot("mm2021").model, make_drive_model(one), find_robot("classic").model};
}

TEST(StrategyMemory, IsSpentOnItsParts) {
  for (const DriveModel& model : models())
    for (const Size size : {Size{16, 16}, Size{32, 32}}) {
      const StrategyMemory memory = strategy_memory(size, model);
      EXPECT_EQ(memory.fields, DriveFields::bytes_for(size, model));
      std::size_t sum = 0;
      for (const MemoryPart& part : memory.layout) {
        EXPECT_LE(part.bytes, memory.fields) << part.name;
        sum += part.bytes;
      }
      EXPECT_EQ(sum, memory.fields);
    }
}

TEST(StrategyMemory, IsMeasuredOfAllMiceThatDrive) {
  const StrategyMemory memory = strategy_memory({16, 16}, find_robot("mm2021").model);
  for (const BuiltinMouse* mouse : builtin_mice())
    EXPECT_EQ(memory.own.count(std::string(mouse->name)), mouse->drives() ? 1U : 0U);
  if (test::sanitized) GTEST_SKIP() << "sanitizers have a heap of their own";
  EXPECT_GT(memory.own.at("flood"), 1000U);
  EXPECT_GT(memory.own.at("ariadne"), memory.own.at("flood"));
}

}  // namespace
}  // namespace labmouse
