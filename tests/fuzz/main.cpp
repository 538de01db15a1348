// libFuzzer's two functions: the fuzzer is the one by whose name the program is called.
#include <cstdio>
#include <cstdlib>
#include <map>
#include <string>

#include "labmouse/lab/system/version.hpp"
#include "tests/fuzz/fuzzer.hpp"

namespace labmouse::fuzz {
namespace {

std::map<std::string, Fuzzer>& fuzzers() {
  static std::map<std::string, Fuzzer> all;
  return all;
}

Fuzzer chosen = nullptr;

}  // namespace

bool add_fuzzer(const char* name, Fuzzer fuzzer) { return fuzzers().emplace(name, fuzzer).second; }

}  // namespace labmouse::fuzz

// A store names the version that wrote it; that of a fuzzer is none.
std::string_view labmouse::version() { return "fuzzer"; }

using namespace labmouse::fuzz;

extern "C" int LLVMFuzzerInitialize(int*, char*** arguments) {
  const std::string path = **arguments;
  const auto found = fuzzers().find(path.substr(path.rfind('/') + 1));
  if (found == fuzzers().end()) {
    std::fprintf(stderr, "%s is no fuzzer; call the program by the name of one, such as fuzz_maz\n", path.c_str());
    std::exit(2);
  }
  chosen = found->second;
  return 0;
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) { return chosen(bytes, size); }
