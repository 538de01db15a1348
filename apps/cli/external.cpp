#include "external.hpp"

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

void add_runners(Command& command, ExternalOptions& external_mice) {
  command.group(groups::programs);
  command
      .add_option("--python", external_mice.python,
                  "Python interpreter for capstone robots; default: the python3 in PATH")
      ->type_name("INTERPRETER");
  command
      .add_option(
          "--board", external_mice.board,
          "Board of firmware: a file that says which pin is wired to what, or a built-in one; default: ukmarsbot")
      ->type_name("BOARD");
}

void add_limits(Command& command, ExternalLimits& limits) {
  command.group(groups::programs);
  add_seconds(
      command, "--start-limit", limits.start,
      "Time limit for the first line of a program; its own time is measured: time that it waits for a processor does "
      "not count");
  add_seconds(command, "--decision-limit", limits.decision,
              "Limit of the processor time between two lines of a program");
  add_seconds(command, "--silence-limit", limits.silence, "Limit of a program's own time between two lines");
  add_seconds(command, "--contest-limit", limits.contest, "Limit of a program's own time in one maze");
  add_mebibytes(command, "--memory", limits.memory, "Memory limit of a program and all processes that it starts");
  add_mebibytes(command, "--written", limits.written, "Limit of what a program and its processes write to files");
  command.add_option("--processes", limits.processes, "Highest number of processes of a program")
      ->type_name("N")
      ->check(in_range(1, 4096))
      ->capture_default_str();
  command.add_option("--cpu", limits.processor_seconds, "Limit of the processor time of each process of a program")
      ->type_name("SECONDS")
      ->check(in_range(1, 1'000'000))
      ->capture_default_str();
}

void add_external_options(Command& command, ExternalOptions& external_mice) {
  command.group(groups::programs);
  command
      .add_option("--directory", external_mice.directory, "Working directory of the programs; default: the current one")
      ->type_name("DIR")
      ->check(existing_directory());
  command
      .add_word(
          "--sandbox", [&external_mice](const std::string& word) { external_mice.sandbox = sandbox_use(word); },
          "Run each program in a copy of its folder, without access to mazes, other files and the network: where that "
          "is possible (auto), always (on) or never (off)")
      ->check(one_of({"auto", "on", "off"}))
      ->default_str("auto");
  command.add_flag("--keep-folder", external_mice.keep_folder,
                   "Let programs write to their own folders, so that they can remember earlier contests");
  add_limits(command, external_mice.limits);
}

void add_program_options(Command& command, ExternalOptions& external_mice) {
  add_runners(command, external_mice);
  add_external_options(command, external_mice);
  command
      .add_option("--label", external_mice.label,
                  "In a store of contests, stands for the files of external mice: the same label is the same mouse")
      ->type_name("TEXT");
}

void add_racing_options(Command& command, ExternalOptions& external_mice) {
  add_program_options(command, external_mice);
  command
      .add_option("--external-runs", external_mice.runs,
                  "Contests in each maze for each external mouse, for stochastic ones")
      ->type_name("N")
      ->check(in_range(1, 1'000'000))
      ->capture_default_str();
}

}  // namespace labmouse::cli
