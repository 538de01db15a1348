// Prints the behaviour signature as `labmouse bench` does, with nothing of the lab but the signature itself.
#include <cstdio>

#include "labmouse/lab/bench/signature.hpp"

int main() { std::puts(labmouse::signature().c_str()); }
