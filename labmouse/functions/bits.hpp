// Access to the bits of a number.
#pragma once

namespace labmouse {

/// std::bit_cast, which the standard library of WebAssembly lacks: the same bits as another type of that size.
template <class To, class From>
constexpr To bits_as(const From& from) {
  static_assert(sizeof(To) == sizeof(From));
  return __builtin_bit_cast(To, from);
}

}  // namespace labmouse
