// Includes nothing that a microcontroller lacks: the portable checks compile this file with the rooms below the lab.
#include "labmouse/lab/signature.hpp"

#include "labmouse/contest/simulator.hpp"
#include "labmouse/maze/generators/generator.hpp"
#include "labmouse/strategies/roster.hpp"

namespace labmouse {
namespace {

/// FNV-1a over numbers.
class Hash {
 public:
  void add(int number) {
    const auto bits = static_cast<std::uint32_t>(number);
    for (unsigned shift = 0; shift < 32; shift += 8) hash_ = (hash_ ^ (bits >> shift & 0xFFU)) * 0x100000001B3U;
  }
  std::uint64_t value() const { return hash_; }

 private:
  std::uint64_t hash_ = 0xCBF29CE484222325U;
};

void add_contest(const Maze& maze, const RosterEntry& mouse, Hash& hash) {
  const Rules rules;
  const auto mind = mouse.make(brief(maze, rules, 1), Settings(mouse.parameters));
  const RunRecord record = run(maze, rules, *mind);
  for (const StepRecord& step : record.steps) {
    hash.add(static_cast<int>(step.action.kind));
    hash.add(step.action.rotation);
    hash.add(step.action.movement);
  }
  hash.add(static_cast<int>(record.outcome));
}

}  // namespace

std::uint64_t behaviour_signature() {
  Hash hash;
  for (const Generator* generator : all_generators())
    for (const Size size : {Size{7, 5}, Size{16, 16}, Size{32, 32}, Size{40, 64}}) {
      const GeneratorOrder order{size, 1, 100};
      if (!generator->refuses(order).empty()) continue;
      const Maze maze = generator->make(order);
      for (const RosterEntry* mouse : roster()) add_contest(maze, *mouse, hash);
    }
  return hash.value();
}

}  // namespace labmouse
