// Any bytes as the parameters of a search: a mouse's name in the first line, then `NAME[=LOW:HIGH],...`. There are
// ranges or an error, and each value that a search may try is in its range and a value of that mouse.
#include <algorithm>
#include <string>

#include "labmouse/lab/mice/specs.hpp"
#include "labmouse/lab/studies/parameter_range.hpp"
#include "labmouse/strategies/builtin_mice.hpp"
#include "tests/fuzz/fuzzer.hpp"

namespace labmouse::fuzz {

namespace {

void check_range(std::string_view mouse, const ParameterRange& range) {
  require(range.low < range.high);
  for (const double share : {0.0, 0.001, 0.3, 0.5, 0.999, 1.0}) {
    const Setting setting = {std::string(range.parameter.name), value_at(range, share)};
    const std::optional<double> value = parse_plain_number(setting.value);
    require(value && *value >= range.low && *value <= range.high);
    const double back = share_of(range, *value);
    require(back >= 0.0 && back <= 1.0);
    require(read_variant(mouse, {&setting, 1}).error.empty());
  }
}

}  // namespace

LABMOUSE_FUZZER(tune) {
  const std::string_view all(reinterpret_cast<const char*>(bytes), size);
  // Built-in mice alone: other words would name files and programs.
  const std::string_view first = all.substr(0, all.find('\n'));
  const auto mice = builtin_mice();
  const auto known =
      std::find_if(mice.begin(), mice.end(), [&](const BuiltinMouse* mouse) { return mouse->name == first; });
  const std::string_view mouse = known == mice.end() ? "ariadne" : (*known)->name;
  const RangesResult read = read_ranges(mouse, all.substr(std::min(size, first.size() + 1)));
  require(read.ranges.empty() != read.error.empty());
  require(read.ranges.size() <= most_ranges);
  for (const ParameterRange& range : read.ranges) check_range(mouse, range);
  return 0;
}

}  // namespace labmouse::fuzz
