// Prints the behaviour signature as `labmouse bench` does, with nothing of the lab but the signature itself.
#include <cinttypes>
#include <cstdio>

#include "labmouse/lab/signature.hpp"

int main() { std::printf("%016" PRIx64 "\n", labmouse::behaviour_signature()); }
