// Numbers with their nouns.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace labmouse {

/// A number with its noun: "1 step", "2 steps".
std::string counted(int count, std::string_view one, std::string_view many);
std::string counted(std::size_t count, std::string_view one, std::string_view many);

}  // namespace labmouse
