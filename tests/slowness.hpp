// How much less a long test should do. Under the sanitizers all takes ten times as long, and a part of it has to do
// there.
#pragma once

namespace labmouse::test {

#if defined(__SANITIZE_ADDRESS__)
inline constexpr int slowness = 20;
#elif defined(__has_feature)
#if __has_feature(address_sanitizer)
inline constexpr int slowness = 20;
#else
inline constexpr int slowness = 1;
#endif
#else
inline constexpr int slowness = 1;
#endif

}  // namespace labmouse::test
