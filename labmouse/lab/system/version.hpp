// Where results come from: the build and the machine that made them.
#pragma once

#include <string>
#include <string_view>

namespace labmouse {

/// Version of this build: the release, and the commit where it was built from a checkout.
std::string_view version();

/// The compiler of this build, `g++ 12.2.0`.
std::string compiler();

/// The processor of this machine as it calls itself, or `unknown`.
std::string processor();

}  // namespace labmouse
