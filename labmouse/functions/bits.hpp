// The bits of a number.
#pragma once

namespace labmouse {

/// The same bits as a number of another type of that size: std::bit_cast, which the library of WebAssembly lacks.
template <class To, class From>
constexpr To bits_as(const From& from) {
  static_assert(sizeof(To) == sizeof(From));
  return __builtin_bit_cast(To, from);
}

}  // namespace labmouse
