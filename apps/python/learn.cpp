// Binds batches of contests that are stepped together. labmouse.learn builds its Gymnasium environments on them.
#include <fmt/format.h>
#include <nanobind/ndarray.h>
#include <nanobind/stl/optional.h>
#include <nanobind/stl/pair.h>
#include <nanobind/stl/string.h>
#include <nanobind/stl/vector.h>

#include <utility>

#include "bindings.hpp"
#include "errors.hpp"
#include "labmouse/lab/learn/contest_batch.hpp"
#include "labmouse/lab/mazes/maze_files.hpp"
#include "labmouse/strategies/parameter.hpp"

namespace nb = nanobind;
using namespace nb::literals;

namespace labmouse::python {
namespace {

/// A numpy array in C order with exactly this dtype. nanobind must not convert it: the batch would then write to a copy
/// that the caller does not see.
template <class T>
using Array = nb::ndarray<T, nb::c_contig, nb::device::cpu>;
using Choices = nb::ndarray<const std::int64_t, nb::ndim<1>, nb::c_contig, nb::device::cpu>;

/// A batch, the random generator of draw_valid_choices, and references that keep the arrays alive that it writes to.
struct LearnBatch {
  ContestBatch batch;
  Rng rng{0};
  std::vector<nb::object> held;
};

MazeFamily family_of(const std::string& kind, std::pair<int, int> size, double loops, const std::string& split,
                     std::uint64_t count) {
  MazeFamily family;
  family.generator = find_generator(kind);
  if (family.generator == nullptr) {
    std::vector<std::string_view> names;
    for (const auto* generator : all_generators()) names.push_back(generator->name);
    throw UserError(fmt::format("unknown kind '{}'; the kinds are {}", kind, fmt::join(names, ", ")));
  }
  if (!(loops >= 0.0 && loops <= 1.0)) throw UserError(fmt::format("loops is a share from 0 to 1, not {}", loops));
  family.size = {size.first, size.second};
  family.loops = static_cast<int>(loops * 1000.0 + 0.5);
  family.count = count;
  bool known = false;
  for (const Split named : all_splits)
    if (name_of(named) == split) family.split = named, known = true;
  if (!known) throw UserError(fmt::format("unknown set of mazes '{}'; the sets are train, validation and test", split));
  if (const auto reason = refuses(family); !reason.empty()) throw UserError(std::string(reason));
  return family;
}

NamedMaze named_maze_of(const MazeFamily& family, std::uint64_t number) {
  return {fmt::format("{}-{}-{}x{}-{}", name_of(family.split), family.generator->name, family.size.width,
                      family.size.height, number),
          maze_of(family, number)};
}

Rules rules_of(int budget) {
  Rules rules;
  if (budget < 1 || budget > 32767) throw UserError(fmt::format("a budget is 1 to 32767 steps, not {}", budget));
  rules.budget = budget;
  return rules;
}

void check_count(int count) {
  if (count < 1) throw UserError(fmt::format("a batch has at least one contest, not {}", count));
}

MazeOrder order_of(bool in_turn) { return in_turn ? MazeOrder::in_turn : MazeOrder::drawn; }

LearnBatch batch_of_mazes(int count, const std::vector<NamedMaze>& named, bool in_turn, int budget) {
  check_count(count);
  if (named.empty()) throw UserError("there is no maze to play in");
  std::vector<Maze> mazes;
  for (const NamedMaze& maze : named) mazes.push_back(maze.maze);
  return {ContestBatch(count, mazes, order_of(in_turn), rules_of(budget)), Rng{0}, {}};
}

LearnBatch batch_of_family(int count, const MazeFamily& family, bool in_turn, int budget) {
  check_count(count);
  return {ContestBatch(count, family, order_of(in_turn), rules_of(budget)), Rng{0}, {}};
}

/// The array as a span, kept alive by the batch; empty if there is none. Throws UserError if its size is wrong.
template <class T>
std::span<T> memory_of(LearnBatch& self, const std::optional<Array<T>>& array, std::size_t size, const char* what) {
  if (!array) return {};
  if (array->size() != size) throw UserError(fmt::format("{} has {} items; it needs {}", what, array->size(), size));
  self.held.push_back(nb::cast(*array));
  return {array->data(), size};
}

void bind_memory(LearnBatch& self, const Array<double>& rewards, const Array<double>& returns,
                 const Array<std::uint8_t>& ended, const std::optional<Array<std::int16_t>>& rows,
                 const std::optional<Array<std::uint16_t>>& words, const std::optional<Array<std::uint8_t>>& bytes,
                 const std::optional<Array<std::int8_t>>& masks, const std::optional<Array<std::uint8_t>>& states,
                 const std::optional<Array<std::int64_t>>& mazes) {
  if (words && bytes) throw UserError("the belief is written as words or as bytes, not as both");
  const auto n = static_cast<std::size_t>(self.batch.count());
  const auto area = static_cast<std::size_t>(self.batch.size().area());
  BatchMemory memory;
  memory.rows = memory_of(self, rows, n * row_columns, "rows");
  memory.words = memory_of(self, words, n * area, "words");
  memory.bytes = memory_of(self, bytes, n * area * belief_planes, "bytes");
  memory.masks = memory_of(self, masks, n * choice_count, "masks");
  memory.rewards = memory_of(self, std::optional(rewards), n, "rewards");
  memory.returns = memory_of(self, std::optional(returns), n, "returns");
  memory.ended = memory_of(self, std::optional(ended), n, "ended");
  memory.states = memory_of(self, states, n, "states");
  memory.maze_numbers = memory_of(self, mazes, n, "mazes");
  self.batch.bind(memory);
}

void check_size(const LearnBatch& self, std::size_t size) {
  if (size != static_cast<std::size_t>(self.batch.count()))
    throw UserError(fmt::format("{} values for {} contests", size, self.batch.count()));
}

void check_bound(const LearnBatch& self) {
  if (self.held.empty()) throw UserError("the batch has no memory to write to; bind() gives it some");
}

/// Checks for Ctrl-C between generated mazes, of which a batch may need thousands at once.
class Interruption {
 public:
  ContestBatch::Stop stop() {
    return [this] {
      if (heard_) return true;
      const nb::gil_scoped_acquire lock;
      return heard_ = PyErr_CheckSignals() != 0;
    };
  }
  /// Call with the GIL.
  void raise() const {
    if (heard_) throw nb::python_error();
  }

 private:
  bool heard_ = false;
};

void step(LearnBatch& self, const Choices& choices) {
  check_bound(self);
  check_size(self, choices.size());
  bool played = false;
  Interruption interruption;
  {
    const nb::gil_scoped_release released;
    played = self.batch.step({choices.data(), choices.size()}, interruption.stop());
  }
  interruption.raise();
  if (!played) throw UserError(fmt::format("actions are numbers from 0 to {}", choice_count - 1));
}

void start(LearnBatch& self, const std::optional<nb::ndarray<const std::uint8_t, nb::ndim<1>, nb::c_contig>>& which) {
  check_bound(self);
  if (which) check_size(self, which->size());
  Interruption interruption;
  {
    const nb::gil_scoped_release released;
    if (which)
      self.batch.start({which->data(), which->size()}, interruption.stop());
    else
      self.batch.start(interruption.stop());
  }
  interruption.raise();
}

}  // namespace

void bind_learning(nb::module_& module) {
  nb::class_<MazeFamily>(module, "MazeFamily", "Generated mazes of one kind and split, by number.")
      .def(
          "__init__",
          [](MazeFamily* self, const std::string& kind, std::pair<int, int> size, double loops,
             const std::string& split,
             std::uint64_t count) { new (self) MazeFamily(family_of(kind, size, loops, split, count)); },
          "kind"_a, "size"_a, "loops"_a, "split"_a, "count"_a)
      .def("maze", &named_maze_of, "number"_a, nb::call_guard<nb::gil_scoped_release>());
  module.def(
      "split_of", [](const NamedMaze& maze) { return std::string(name_of(split_of(maze.maze))); }, "maze"_a,
      "The split of a maze: 'train', 'validation' or 'test'. A hash of its content decides.");
  module.def(
      "action_of",
      [](int choice) {
        if (choice < 0 || choice >= choice_count)
          throw UserError(fmt::format("actions are numbers from 0 to {}", choice_count - 1));
        const Action action = action_of(choice);
        return action.kind == Action::Kind::reset ? std::optional<std::pair<int, int>>()
                                                  : std::pair(action.rotation, action.movement);
      },
      "number"_a, "The (rotation in degrees, movement in cells) of an action, by its number; None for the reset.");
  module.attr("ACTIONS") = choice_count;
  module.attr("RESET") = reset_choice;
  module.attr("ROW_COLUMNS") = row_columns;
  module.attr("BELIEF_PLANES") = belief_planes;
  nb::class_<LearnBatch>(module, "ContestBatch", "Contests that are stepped together.")
      .def(
          "__init__",
          [](LearnBatch* self, int count, const std::vector<NamedMaze>& mazes, bool in_turn, int budget) {
            new (self) LearnBatch(batch_of_mazes(count, mazes, in_turn, budget));
          },
          "count"_a, "mazes"_a, "in_turn"_a = false, "budget"_a = 1000)
      .def(
          "__init__",
          [](LearnBatch* self, int count, const MazeFamily& family, bool in_turn, int budget) {
            new (self) LearnBatch(batch_of_family(count, family, in_turn, budget));
          },
          "count"_a, "mazes"_a, "in_turn"_a = false, "budget"_a = 1000)
      .def_prop_ro("count", [](const LearnBatch& self) { return self.batch.count(); })
      .def_prop_ro(
          "size", [](const LearnBatch& self) { return std::pair(self.batch.size().width, self.batch.size().height); },
          "Width and height of the largest maze.")
      .def_prop_ro(
          "bytes_a_contest", [](const LearnBatch& self) { return self.batch.bytes_a_contest(); },
          "Bytes of memory for each contest, without the arrays of bind().")
      .def("bind", &bind_memory, "rewards"_a.noconvert(), "returns"_a.noconvert(), "ended"_a.noconvert(), nb::kw_only(),
           "rows"_a.noconvert() = nb::none(), "words"_a.noconvert() = nb::none(), "bytes"_a.noconvert() = nb::none(),
           "masks"_a.noconvert() = nb::none(), "states"_a.noconvert() = nb::none(), "mazes"_a.noconvert() = nb::none(),
           "Sets the arrays to write to from now on. Follow it with start(). Raises Error if a size is wrong.")
      .def(
          "seed",
          [](LearnBatch& self, int contest, std::uint64_t seed) {
            if (contest < 0 || contest >= self.batch.count())
              throw UserError(fmt::format("there is no contest {}", contest));
            self.batch.seed(contest, seed);
          },
          "contest"_a, "seed"_a, "Sets the seed by which a contest draws its mazes.")
      .def("start", &start, "which"_a = nb::none(), "Begins new contests: all, or those where `which` is not 0.")
      .def("step", &step, "actions"_a.noconvert(), "One step of every contest.")
      .def(
          "seed_choices", [](LearnBatch& self, std::uint64_t seed) { self.rng = Rng(seed); }, "seed"_a)
      .def(
          "draw_valid_choices",
          [](LearnBatch& self, nb::ndarray<std::int64_t, nb::ndim<1>, nb::c_contig> into) {
            check_bound(self);
            check_size(self, into.size());
            self.batch.draw_valid_choices(self.rng, {into.data(), into.size()});
          },
          "into"_a.noconvert(), "Draws a valid action for each contest into an array of int64.");
}

}  // namespace labmouse::python
