#include "tests/fuzz/check_reader.hpp"
#include "tests/fuzz/fuzzer.hpp"

namespace labmouse::fuzz {

LABMOUSE_FUZZER(drawing) {
  check_reader(drawing_format, bytes, size);
  return 0;
}

}  // namespace labmouse::fuzz
