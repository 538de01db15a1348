// Numbers that a search may change: parameters of a mouse with the ranges in which values are looked for.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "labmouse/strategies/parameter.hpp"

namespace labmouse {

/// Whether a parameter is one number: not a flag, a choice or a list.
bool is_number(const Parameter& parameter);

/// A number of a mouse and where its values may lie, both ends among them.
struct ParameterRange {
  Parameter parameter;
  double low = 0.0;
  double high = 0.0;
};

/// The nearest value in the range as in a SPEC: whole where the parameter is, else with four significant digits, or
/// with as many more as it takes to stay in the range.
std::string written_value(const ParameterRange& range, double value);

/// The value at a share of the range, 0 to 1, as in a SPEC. Each value of a whole parameter has an equal share.
std::string value_at(const ParameterRange& range, double share);

/// A share, 0 to 1, at which that value stands; one outside of the range counts as the nearest in it.
double share_of(const ParameterRange& range, double value);

/// So many parameters are searched at once.
inline constexpr std::size_t most_ranges = 20;

/// What `NAME[=LOW:HIGH],...` says of the mouse of a SPEC, or the reason why it says nothing: exactly one of the two.
struct RangesResult {
  std::vector<ParameterRange> ranges;
  std::string error;
};

/// Without LOW:HIGH a parameter is searched in all of its declared range.
RangesResult read_ranges(std::string_view spec, std::string_view text);

}  // namespace labmouse
