#include "contests.hpp"

#include <fmt/format.h>

#include <chrono>
#include <cmath>
#include <csignal>
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <string_view>

#include "labmouse/lab/mice/specs.hpp"
#include "labmouse/lab/system/files.hpp"
#include "labmouse/lab/text/commas.hpp"
#include "labmouse/lab/text/counted.hpp"
#include "labmouse/lab/text/printable.hpp"
#include "labmouse/lab/text/time_left.hpp"
#include "labmouse/lab/worlds/worlds.hpp"
#include "terminal.hpp"

namespace labmouse::cli {
namespace {

std::atomic<bool> stop_flag{false};
std::atomic<int> caught_signal{0};
std::atomic<std::int64_t> caught_at{0};

std::int64_t milliseconds_now() {
  const auto now = std::chrono::steady_clock::now().time_since_epoch();
  return std::chrono::duration_cast<std::chrono::milliseconds>(now).count();
}

/// Signal handler: raises the flag. A second signal ends the program, if it comes `patience` milliseconds later or
/// more: a terminal that closes, and `timeout`, send their signal twice at once.
void stop_or_end(int number) {
  constexpr std::int64_t patience = 1000;
  if (stop_flag.exchange(true) && caught_signal != 0) {
    if (milliseconds_now() - caught_at < patience) return;
    std::signal(number, SIG_DFL);
    std::raise(number);
    return;
  }
  caught_at = milliseconds_now();
  caught_signal = number;
}

/// Parses a part such as "3/64"; nothing for an invalid text.
std::optional<Shard> shard_of(const std::string& text) {
  Shard shard;
  const auto slash = text.find('/');
  if (slash == std::string::npos) return std::nullopt;
  const double number = parse_plain_number(text.substr(0, slash)).value_or(0.0);
  const double of = parse_plain_number(text.substr(slash + 1)).value_or(0.0);
  constexpr double most = 1e6;
  if (number != std::floor(number) || of != std::floor(of) || number < 1 || number > of || of > most)
    return std::nullopt;
  return Shard{static_cast<std::size_t>(number), static_cast<std::size_t>(of)};
}

}  // namespace

void add_mazes(Command& command, Contests& contests, const std::string& default_mazes) {
  command.group(groups::mazes);
  command
      .add_option("--mazes", contests.mazes,
                  "Maze files, folders, patterns or built-in mazes; default: " + default_mazes)
      ->type_name("PATH")
      ->expected(1, 1 << 20)
      ->take_all();
  add_places(command, contests.places);
}

void add_contests(Command& command, Contests& contests) {
  add_mazes(command, contests, "all built-in mazes");
  command.group(groups::contests);
  command
      .add_integer(
          "--runs", [&contests](std::uint64_t runs) { contests.runs = static_cast<int>(runs); },
          "Contests in each maze for each stochastic mouse, and for each mouse in a stochastic world; default: " +
              usual_runs_text())
      ->check(in_range(1, 1'000'000));
  add_world_and_seed(command, contests);
}

void add_world_and_seed(Command& command, Contests& contests) {
  command.group(groups::world);
  contests.world.add_to(command);
  command.group(groups::contests);
  command.add_option("--seed", contests.order.seed, "Seed for all random choices")
      ->check(seed_number())
      ->capture_default_str();
  command
      .add_option("--store", contests.store_path,
                  "File that keeps all contests: stored ones are not run again (docs/how-to/clusters-and-stores.md)")
      ->type_name("FILE");
  command.add_option("--jobs", contests.order.jobs, "Number of threads; 0 uses all processors")
      ->check(in_range(0, 1024))
      ->capture_default_str();
}

RaceOrder Contests::order_in(std::shared_ptr<const World> chosen) const {
  RaceOrder held = order;
  held.world = std::move(chosen);
  held.runs = runs.value_or(find_world(held.world->traits().name)->usual_runs);
  if (store_path.empty()) return held;
  held.files.push_back(store_path);
  if (!store_) store_ = std::make_shared<Store>(store_path);
  if (store_->failed()) throw UsageError(store_->finish());
  held.store = store_;
  return held;
}

void Contests::finish_store(bool below_a_table) const {
  if (!store_) return;
  const std::string error = store_->finish();
  std::string text = fmt::format("Store {}: {} from it, {} added", shown(store_->path()),
                                 counted(store_->recalled(), "contest", "contests"), store_->added());
  if (store_->passed_by() > 0)
    text += fmt::format(", {} not kept, because nothing is known of their mice", store_->passed_by());
  if (below_a_table)
    print("\n" + text + ".\n");
  else
    tell(text + ".\n");
  if (!error.empty()) throw UsageError(error);
}

Option* add_shard(Command& command, Shard& shard, std::string_view what) {
  return command
      .add_word(
          "--shard", [&shard](const std::string& text) { shard = *shard_of(text); },
          fmt::format("Run only the I-th of N parts of the {}; `labmouse store merge` joins their stores", what))
      ->type_name("I/N")
      ->check(Check([](const std::string& text) {
        return shard_of(text) ? "" : fmt::format("{} is no part: write 3/64 for the third of 64", text);
      }));
}

std::vector<Contestant> mice_of(SpecResult read) {
  if (!read.problems.empty()) throw UsageError(fmt::format("{}", fmt::join(read.problems, "\n")));
  if (!read.error.empty()) throw UsageError("error: " + read.error);
  return std::move(read.contestants);
}

std::vector<Contestant> find_contestants(const std::vector<std::string>& specs, const WorldChoice& world,
                                         ExternalOptions options) {
  if (!specs.empty()) return find_contestants(specs, std::move(options));
  std::vector<Contestant> mice = residents_of(*world.world());
  if (mice.empty())
    throw UsageError(fmt::format("error: labmouse has no built-in mice for the world {}; name your own with --mice",
                                 world.world()->traits().name));
  return mice;
}

std::vector<Contestant> find_contestants(const std::vector<std::string>& specs, ExternalOptions options) {
  options.stop = &stop_flag;
  return mice_of(read_specs(specs, options));
}

void add_mice_files(Command& command, std::vector<std::string>& mice_files) {
  command.group(groups::mice);
  command
      .add_option("--mice-file", mice_files,
                  "Mice file: names of mice with their commands, as docs/reference/files.md explains (repeatable)")
      ->type_name("FILE")
      ->expected(1)
      ->take_all();
}

std::vector<std::string> with_mice_files(std::vector<std::string> specs, const std::vector<std::string>& mice_files) {
  for (const std::string& file : mice_files) {
    // Only regular files are checked here: a pipe can be read only once, and FILE:NAME is not the name of a file.
    std::error_code unknown;
    if (std::filesystem::is_regular_file(file, unknown))
      refuse_other_kind(file, read_file(file).content, FileKind::unknown);
    specs.push_back("mice-file:" + file);
  }
  return specs;
}

MazeCollection find_mazes_of(Entry& entry, const Contests& contests, bool again) {
  const World& world = *entry.world;
  const Places& places = contests.places;
  if (const auto fixed = world.traits().fixed_places;
      !fixed.empty() && (!places.start.empty() || !places.goals.empty()))
    throw UsageError(
        fmt::format("error: --start and --goal cannot be used in the world {}, which {}", world.traits().name, fixed));
  MazeCollection mazes = find_mazes(contests.mazes, places);
  const auto before = static_cast<std::ptrdiff_t>(mazes.skipped.size());
  if (const std::string refused = leave_out(world, separated(contests.mazes), mazes); !refused.empty())
    throw UsageError(refused);
  if (!again) tell_skipped({mazes.skipped.begin() + before, mazes.skipped.end()});
  if (mazes.mazes.empty())
    throw UsageError(
        fmt::format("error: no mazes to race on: none of these can be used in the world {}", world.traits().name));
  const std::string remark = suit_defaults(entry, mazes.mazes);
  // Who named no mazes did not ask for those of one class.
  if (!remark.empty() && !again && !contests.mazes.empty()) tell_remarks({remark});
  return mazes;
}

std::unique_ptr<ResultsFolder> take_folder(const std::string& out, bool overwrite) {
  if (out.empty()) return nullptr;
  auto folder = std::make_unique<ResultsFolder>(out, overwrite);
  if (!folder->error().empty()) throw UsageError(folder->error());
  return folder;
}

Progress::Progress() : shown_(is_terminal(stderr)) {}

Progress::~Progress() {
  if (shown_ && done_ > 0) tell("\r\x1b[K");
}

void Progress::advance(std::size_t all) {
  if (!shown_) return;
  const auto percent = ++done_ * 100 / all;
  const auto now = std::chrono::steady_clock::now();
  if (percent == percent_ && now - drawn_ < std::chrono::seconds(1)) return;
  percent_ = percent;
  drawn_ = now;
  const auto left = seconds_left(done_, all, std::chrono::duration<double>(now - begin_).count());
  tell(fmt::format("\r[{:<40}] {:>3} %{}\x1b[K", std::string(percent * 40 / 100, '#'), percent,
                   left ? fmt::format(", {} left", duration_text(*left)) : ""));
}

Interruptible::Interruptible() {
  stop_flag = false;
  caught_signal = 0;
  for (const int number : ending_signals())
    // `nohup` starts programs with SIGHUP ignored; this must stay so.
    if (std::signal(number, stop_or_end) == SIG_IGN && is_hangup(number)) std::signal(number, SIG_IGN);
}

Interruptible::~Interruptible() {
  // After a signal the handlers stay: the results have still to be printed, and the signal may come twice.
  if (caught_signal != 0) return;
  for (const int number : ending_signals())
    if (std::signal(number, SIG_DFL) == SIG_IGN) std::signal(number, SIG_IGN);
}

const std::atomic<bool>& Interruptible::stopped() const { return stop_flag; }

void Interruptible::stop() { stop_flag = true; }

ExitCode exit_interrupted() {
  return static_cast<ExitCode>(exit_signal + (caught_signal != 0 ? caught_signal.load() : SIGINT));
}

std::vector<double> numbers_of(const WorldSetting& setting, const std::string& text) {
  std::vector<double> numbers;
  for (const std::string& part : between_commas(text)) {
    std::string problem;
    const Value value = chosen_value(setting, part, problem);
    if (!problem.empty()) throw UsageError(fmt::format("error: --{}: {}", setting.name, problem));
    numbers.push_back(*number_of(value));
  }
  return numbers;
}

}  // namespace labmouse::cli
