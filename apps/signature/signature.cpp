// Prints the behaviour signature as `labmouse bench` does, with nothing of the lab but the signature itself. The build
// runs it, so that stores know which build held a contest; scripts/portable compares what it prints on other machines.
#include "labmouse/lab/bench/signature.hpp"

#include <cstdio>

int main() { std::puts(labmouse::signature().c_str()); }
