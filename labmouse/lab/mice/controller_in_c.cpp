#include "labmouse/lab/mice/controller_in_c.hpp"

#include <algorithm>

#include "labmouse/lab/mice/in_c.hpp"

namespace labmouse {
namespace {

class ControllerInC final : public ControllerCode {
 public:
  ControllerInC(const struct labmouse_controller& table, const ControllerBriefing& briefing)
      : table_(table), told_(briefing_in_c(briefing)), memory_(table.begin(&told_)) {}
  ControllerInC(const ControllerInC&) = delete;
  ControllerInC& operator=(const ControllerInC&) = delete;
  ~ControllerInC() override { table_.end(memory_); }

  ControllerTick tick(const Sense& sense) override {
    const labmouse_sense read = sense_in_c(sense);
    const labmouse_drive said = table_.tick(memory_, &read);
    const auto duty = [](std::int32_t number) {
      return static_cast<std::int16_t>(std::clamp<std::int32_t>(number, -ControllerTick::full, ControllerTick::full));
    };
    const bool known = said.word >= LABMOUSE_DRIVE && said.word <= LABMOUSE_FORFEIT;
    return {duty(said.left), duty(said.right),
            known ? static_cast<ControllerWord>(said.word) : ControllerWord::give_up};
  }
  void carried(bool crashed) override { table_.carried(memory_, crashed ? 1 : 0); }

 private:
  const struct labmouse_controller& table_;
  labmouse_briefing told_;
  void* memory_;
};

static_assert(static_cast<int>(ControllerWord::give_up) == LABMOUSE_FORFEIT && ControllerTick::full == LABMOUSE_FULL);

}  // namespace

std::unique_ptr<ControllerCode> controller_in_c(const struct labmouse_controller& table,
                                                const ControllerBriefing& briefing) {
  return std::make_unique<ControllerInC>(table, briefing);
}

}  // namespace labmouse
