// Binds single contests and their records.
#include "labmouse/contest/record.hpp"

#include <fmt/format.h>
#include <nanobind/stl/map.h>
#include <nanobind/stl/optional.h>
#include <nanobind/stl/pair.h>
#include <nanobind/stl/shared_ptr.h>
#include <nanobind/stl/string.h>
#include <nanobind/stl/tuple.h>
#include <nanobind/stl/vector.h>

#include <cstring>
#include <memory>

#include "bindings.hpp"
#include "entering.hpp"
#include "errors.hpp"
#include "orders.hpp"
#include "report.hpp"
#include "values.hpp"
#include "work.hpp"

namespace nb = nanobind;
using namespace nb::literals;

namespace labmouse::python {
namespace {

/// A contest that has ended or was stopped, kept as a race with one mouse and one maze.
struct HeldContest {
  Race race;
  ContestOutput held;

  const ContestResult& result() const { return race.results.front(); }
};

/// A contest that runs in a thread.
class RunningContest {
 public:
  RunningContest(const GivenMice& mice, NamedMaze maze, const GivenWorld& world, std::uint64_t seed) {
    Field field = enter(choice_of(mice, {std::move(maze)}, world), &work_.stopped());
    if (field.entry.mice.size() != 1) throw UserError("run takes one mouse; to run several, use race");
    remarks_ = std::move(field.remarks);
    held_ = std::make_shared<HeldContest>();
    Race& race = held_->race;
    race.order.world = field.entry.world;
    race.order.runs = 1;
    race.order.seed = seed;
    race.order.jobs = 1;
    race.mice = std::move(field.entry.mice);
    race.mazes = std::move(field.mazes);
    race.results.emplace_back().seed = seed;
    work_.start([this] {
      Race& held = held_->race;
      held.facts.push_back(held.world().facts(held.mazes.front().maze));
      held_->held = held.world().hold(held, held.results.front(), {true, true}, &work_.stopped());
      held.stopped = !held.results.front().done;
    });
  }

  Work& work() { return work_; }
  const std::vector<std::string>& remarks() const { return remarks_; }
  std::shared_ptr<HeldContest> result() {
    work_.finish();
    return held_;
  }

 private:
  std::shared_ptr<HeldContest> held_;
  std::vector<std::string> remarks_;
  Work work_;  // last, so that its thread ends before the members that it uses
};

template <class Field>
void append(std::string& bytes, const Field& field) {
  bytes.append(reinterpret_cast<const char*>(&field), sizeof field);
}

/// The steps of a contest as bytes in the layout of labmouse._records.STEP; None in worlds without steps.
nb::object steps_of(const HeldContest& held) {
  const std::optional<RunRecord>& record = held.held.run;
  if (!record) return nb::none();
  std::string bytes;
  for (const StepRecord& step : record->steps) {
    append(bytes, std::int32_t{step.step});
    append(bytes, static_cast<std::uint8_t>(step.run));
    append(bytes, step.pose.cell.x);
    append(bytes, step.pose.cell.y);
    append(bytes, static_cast<std::uint8_t>(step.pose.heading));
    append(bytes, static_cast<std::int8_t>(step.sighting.left));
    append(bytes, static_cast<std::int8_t>(step.sighting.ahead));
    append(bytes, static_cast<std::int8_t>(step.sighting.right));
    append(bytes, static_cast<std::uint8_t>(step.action.kind));
    append(bytes, std::int32_t{step.action.rotation});
    append(bytes, std::int32_t{step.action.movement});
    append(bytes, static_cast<std::uint8_t>(step.blocked));
  }
  return nb::bytes(bytes.data(), bytes.size());
}

nb::dict figures(const HeldContest& held) {
  nb::dict found;
  for (const ContestField& field : held.race.world().traits().fields->contest) {
    const Value value = field.of(held.race, held.result());
    if (!std::holds_alternative<std::monostate>(value))
      found[nb::str(field.key.data(), field.key.size())] = object_of(value);
  }
  return found;
}

}  // namespace

void bind_records(nb::module_& module) {
  nb::class_<HeldContest>(module, "HeldContest")
      .def_prop_ro("complete", [](const HeldContest& held) { return held.result().done; })
      .def_prop_ro("world", [](const HeldContest& held) { return std::string(held.race.world().traits().name); })
      .def_prop_ro("mouse", [](const HeldContest& held) { return held.race.mice.front().name; })
      .def_prop_ro("maze", [](const HeldContest& held) { return held.race.mazes.front(); })
      .def_prop_ro("seed", [](const HeldContest& held) { return held.result().seed; })
      .def_prop_ro("outcome", [](const HeldContest& held) { return held.result().outcome; })
      .def_prop_ro("score", [](const HeldContest& held) { return held.result().score; })
      .def_prop_ro("bound", [](const HeldContest& held) { return held.race.facts.front().bound; })
      .def_prop_ro("last_words",
                   [](const HeldContest& held) {
                     const Value said = figure_of(held.race, held.result(), said_last);
                     return std::holds_alternative<std::string>(said) ? std::get<std::string>(said) : std::string();
                   })
      .def_prop_ro("svg", [](const HeldContest& held) { return held.held.picture; })
      .def_prop_ro("record", [](const HeldContest& held) { return held.held.record; })
      .def("steps", &steps_of, nb::sig("def steps(self) -> bytes | None"))
      .def("figures", &figures, nb::sig("def figures(self) -> dict[str, object]"))
      .def("report", [](const HeldContest& held) {
        return report_of(held.race, {{held.result(), held.held}});
      });
  nb::class_<RunningContest>(module, "RunningContest")
      .def(nb::init<const GivenMice&, NamedMaze, const GivenWorld&, std::uint64_t>(), "mice"_a, "maze"_a, "world"_a,
           "seed"_a)
      .def_prop_ro("remarks", &RunningContest::remarks)
      .def_prop_ro("done", [](RunningContest& running) { return running.work().done(); })
      .def_prop_ro("all", [](RunningContest& running) { return running.work().all(); })
      .def(
          "wait", [](RunningContest& running, double seconds) { return running.work().wait(seconds); }, "seconds"_a)
      .def("stop", [](RunningContest& running) { running.work().stop(); })
      .def("result", &RunningContest::result);
}

}  // namespace labmouse::python
