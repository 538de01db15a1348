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

void add_mebibytes(Command& command, const std::string& name, std::uint64_t& limit, const std::string& meaning) {
  constexpr int mib_bits = 20;
  command
      .add_integer(
          name, [&limit](std::uint64_t mib) { limit = mib << mib_bits; }, meaning)
      ->type_name("MIB")
      ->check(in_range(std::uint64_t{16}, std::uint64_t{1} << mib_bits))
      ->default_str(fmt::format("{}", limit >> mib_bits));
}

SandboxUse sandbox_use(const std::string& word) {
  if (word == "on") return SandboxUse::always;
  return word == "off" ? SandboxUse::never : SandboxUse::where_possible;
}

}  // namespace

void add_python(Command& command, GuestOptions& guests) {
  command.group(groups::programs);
  command.add_option("--python", guests.python, "Python interpreter for capstone robots; default: the python3 in PATH")
      ->type_name("INTERPRETER");
}

void add_guest_options(Command& command, GuestOptions& guests) {
  GuestLimits& limits = guests.limits;
  command.group(groups::programs);
  command.add_option("--directory", guests.directory, "Working directory of the programs; default: the current one")
      ->type_name("DIR")
      ->check(existing_directory());
  command
      .add_word(
          "--sandbox", [&guests](const std::string& word) { guests.sandbox = sandbox_use(word); },
          "Give each program a copy of its folder, and keep it from mazes, other files and the network: where that is "
          "possible (auto), always or never")
      ->check(one_of({"auto", "on", "off"}))
      ->default_str("auto");
  command.add_flag("--keep-folder", guests.keep_folder,
                   "Let programs write to their folders themselves, so that they may remember earlier contests");
  add_seconds(
      command, "--start-limit", limits.start,
      "How much of its own time a program may take to write its first line: processor time of all that it starts, and "
      "time in which none of that works or waits for a processor");
  add_seconds(command, "--decision-limit", limits.decision,
              "How much processor time a program may take between two lines");
  add_seconds(command, "--silence-limit", limits.silence,
              "How much of its own time a program may be silent between two lines");
  add_seconds(command, "--contest-limit", limits.contest, "How much of its own time a program may take in one maze");
  add_mebibytes(command, "--memory", limits.memory, "Memory limit for a program with all that it starts");
  add_mebibytes(command, "--written", limits.written, "How much a program with all that it starts may write");
  command.add_option("--processes", limits.processes, "How many processes a program may be, with all that it starts")
      ->type_name("N")
      ->check(in_range(1, 4096))
      ->capture_default_str();
  command.add_option("--cpu", limits.processor_seconds, "Processor time limit for each process of a program")
      ->type_name("SECONDS")
      ->check(in_range(1, 1'000'000))
      ->capture_default_str();
}

void add_racing_guests(Command& command, GuestOptions& guests) {
  add_python(command, guests);
  add_guest_options(command, guests);
  command
      .add_option("--label", guests.label,
                  "In a store of contests, stands for the files of external mice: the same label is the same mouse")
      ->type_name("TEXT");
  command.add_option("--guest-runs", guests.runs, "Contests in each maze for each external mouse, for stochastic ones")
      ->type_name("N")
      ->check(in_range(1, 1'000'000))
      ->capture_default_str();
}

}  // namespace labmouse::cli
