#include "tests/fuzz/check_reader.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  labmouse::fuzz::check_reader(labmouse::drawing_format, bytes, size);
  return 0;
}
