// Ranges of parameters in which a search may look for values.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "labmouse/strategies/parameter.hpp"

namespace labmouse {

/// Whether a parameter is one number: not a flag, a choice or a list.
bool is_number(const Parameter& parameter);

/// A numeric parameter of a mouse and its range, both ends included.
struct ParameterRange {
  Parameter parameter;
  double low = 0.0;
  double high = 0.0;
};

/// The nearest value in the range, as text for a SPEC. It is whole for a whole parameter; else it has four significant
/// digits, or more where rounding would leave the range.
std::string written_value(const ParameterRange& range, double value);

/// The value at a share of the range (0 to 1), as text for a SPEC. All values of a whole parameter have equal shares.
std::string value_at(const ParameterRange& range, double share);

/// A share (0 to 1) at which that value lies. A value outside the range is moved to its nearest end.
double share_of(const ParameterRange& range, double value);

/// Largest number of parameters in one search.
inline constexpr std::size_t most_ranges = 20;

/// The ranges that `NAME[=LOW:HIGH],...` gives for the mouse of a SPEC, or an error: exactly one of the two.
struct RangesResult {
  std::vector<ParameterRange> ranges;
  std::string error;
};

/// Parses ranges. Without LOW:HIGH, a parameter has its whole declared range.
RangesResult read_ranges(std::string_view spec, std::string_view text);

}  // namespace labmouse
