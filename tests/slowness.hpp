// How much less a long test should do.
#pragma once

#include <cstdlib>

namespace labmouse::test {

#if defined(__SANITIZE_ADDRESS__)
inline constexpr bool sanitized = true;
#elif defined(__has_feature)
inline constexpr bool sanitized = __has_feature(address_sanitizer);
#else
inline constexpr bool sanitized = false;
#endif

/// Of that many cases a long test takes one: of 20 under the sanitizers, where all takes ten times as long, and of 4
/// otherwise; `make proof` sets LABMOUSE_PROOF and takes all.
inline const int slowness = sanitized ? 20 : std::getenv("LABMOUSE_PROOF") == nullptr ? 4 : 1;

/// Of so many cases an eighth under the sanitizers, and all otherwise.
template <class Count>
constexpr Count fewer(Count cases) {
  return sanitized ? (cases + 7) / 8 : cases;
}

}  // namespace labmouse::test
