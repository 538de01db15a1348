#include "guests.hpp"

#include <fmt/format.h>

#include <cmath>

#include "command.hpp"

namespace labmouse::cli {
namespace {

void add_seconds(Command& command, const std::string& name, std::chrono::milliseconds& limit,
                 const std::string& meaning) {
  command
      .add_number(
          name, [&limit](double seconds) { limit = std::chrono::milliseconds(std::llround(1000.0 * seconds)); },
          meaning)
      ->type_name("SECONDS")
      ->check(finite_number())
      ->check(in_range(0.001, 1e6))
      ->default_str(fmt::format("{:g}", std::chrono::duration<double>(limit).count()));
}

}  // namespace

void add_python(Command& command, GuestOptions& guests) {
  command.add_option("--python", guests.python, "Python interpreter for capstone robots; default: the python3 in PATH")
      ->type_name("INTERPRETER");
}

void add_guest_options(Command& command, GuestOptions& guests) {
  constexpr int mib_bits = 20;
  GuestLimits& limits = guests.limits;
  command.add_option("--directory", guests.directory, "Working directory of the programs; default: the current one")
      ->type_name("DIR")
      ->check(existing_directory());
  add_seconds(command, "--start-limit", limits.start, "How long a program may take to write its first line");
  add_seconds(command, "--decision-limit", limits.decision,
              "How much processor time a program may take between two lines");
  add_seconds(command, "--silence-limit", limits.silence, "How long a program may be silent between two lines");
  add_seconds(command, "--contest-limit", limits.contest, "How long a program may run in one maze");
  command
      .add_integer(
          "--memory", [&limits](std::uint64_t mib) { limits.memory = mib << mib_bits; },
          "Memory limit for each process of a program")
      ->type_name("MIB")
      ->check(in_range(std::uint64_t{16}, std::uint64_t{1} << mib_bits))
      ->default_str(fmt::format("{}", limits.memory >> mib_bits));
  command.add_option("--cpu", limits.processor_seconds, "Processor time limit for each process of a program")
      ->type_name("SECONDS")
      ->check(in_range(1, 1'000'000))
      ->capture_default_str();
}

void add_racing_guests(Command& command, GuestOptions& guests) {
  add_python(command, guests);
  add_guest_options(command, guests);
  command.add_option("--guest-runs", guests.runs, "Contests in each maze for each guest; for guests that throw dice")
      ->type_name("N")
      ->check(in_range(1, 1'000'000))
      ->capture_default_str();
}

}  // namespace labmouse::cli
