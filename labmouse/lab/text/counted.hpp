// Numbers with their nouns.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace labmouse {

/// A number with its noun: "1 step", "2 steps".
std::string counted(std::int64_t count, std::string_view one, std::string_view many);

}  // namespace labmouse
