#include "labmouse/lab/mice/pilot_in_c.hpp"

#include <algorithm>

#include "labmouse/lab/mice/told_in_c.hpp"

namespace labmouse {
namespace {

class PilotInC final : public PilotCode {
 public:
  PilotInC(const struct labmouse_pilot& table, const PilotBriefing& briefing)
      : table_(table), told_(briefing_in_c(briefing)), memory_(table.begin(&told_)) {}
  PilotInC(const PilotInC&) = delete;
  PilotInC& operator=(const PilotInC&) = delete;
  ~PilotInC() override { table_.end(memory_); }

  PilotTick tick(const Sense& sense) override {
    const labmouse_sense read = sense_in_c(sense);
    const labmouse_drive said = table_.tick(memory_, &read);
    const auto duty = [](std::int32_t number) {
      return static_cast<std::int16_t>(std::clamp<std::int32_t>(number, -PilotTick::full, PilotTick::full));
    };
    const bool known = said.word >= LABMOUSE_DRIVE && said.word <= LABMOUSE_FORFEIT;
    return {duty(said.left), duty(said.right), known ? static_cast<PilotWord>(said.word) : PilotWord::give_up};
  }
  void carried(bool crashed) override { table_.carried(memory_, crashed ? 1 : 0); }

 private:
  const struct labmouse_pilot& table_;
  labmouse_briefing told_;
  void* memory_;
};

static_assert(static_cast<int>(PilotWord::give_up) == LABMOUSE_FORFEIT && PilotTick::full == LABMOUSE_FULL);

}  // namespace

std::unique_ptr<PilotCode> pilot_in_c(const struct labmouse_pilot& table, const PilotBriefing& briefing) {
  return std::make_unique<PilotInC>(table, briefing);
}

}  // namespace labmouse
