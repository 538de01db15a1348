// How a fuzzer is defined. All of them are one program: compiling and linking one for each takes several times as long.
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstdlib>

namespace labmouse::fuzz {

/// What libFuzzer calls with each input; returns 0.
using Fuzzer = int (*)(const std::uint8_t* bytes, std::size_t size);

/// Adds a fuzzer to those that the program has.
bool add_fuzzer(const char* name, Fuzzer fuzzer);

// Stays in every build, unlike assert.
inline void require(bool holds) {
  if (!holds) std::abort();
}

}  // namespace labmouse::fuzz

/// Defines the fuzzer of that name: a body with `bytes` and `size`. It runs where the program is called fuzz_NAME.
#define LABMOUSE_FUZZER(name)                                                 \
  static int fuzz_##name(const std::uint8_t* bytes, std::size_t size);        \
  static const bool has_fuzz_##name = add_fuzzer("fuzz_" #name, fuzz_##name); \
  static int fuzz_##name(const std::uint8_t* bytes, std::size_t size)
