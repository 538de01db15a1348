// The version that results name.
#pragma once

#include <string_view>

namespace labmouse {

/// Version of this build: the release, and the commit where it was built from a checkout.
std::string_view version();

}  // namespace labmouse
