// The behaviour signature of this build (hashes of what its mice do in fixed contests), computed at build time.
#pragma once

#include <string_view>

namespace labmouse {

/// What signature() (lab/bench) returns, computed when the library was built: cmake/LabmouseSignature.cmake.
std::string_view build_signature();

}  // namespace labmouse
