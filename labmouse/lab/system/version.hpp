// The origin of results: the build and the machine.
#pragma once

#include <string>
#include <string_view>

namespace labmouse {

/// Version of this build: the release, and the commit where it was built from a checkout.
std::string_view version();

/// The compiler of this build, such as `g++ 12.2.0`.
std::string compiler();

/// The name of this machine's processor, or `unknown`.
std::string processor();

}  // namespace labmouse
