// labmouse league: a season of entries, ranked in mazes that nobody knows before.
#include "labmouse/lab/league/league.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <memory>
#include <random>

#include "command.hpp"
#include "contests.hpp"
#include "external.hpp"
#include "labmouse/external/sandbox.hpp"
#include "labmouse/functions/sha256.hpp"
#include "labmouse/lab/league/frozen_files.hpp"
#include "labmouse/lab/league/season_site.hpp"
#include "labmouse/lab/races/never_started.hpp"
#include "labmouse/lab/reports/race_page.hpp"
#include "labmouse/lab/system/calls.hpp"
#include "labmouse/lab/system/file_names.hpp"
#include "labmouse/lab/system/files.hpp"
#include "labmouse/lab/system/version.hpp"
#include "labmouse/lab/text/counted.hpp"
#include "labmouse/lab/text/printable.hpp"
#include "page.hpp"

namespace labmouse::cli {
namespace {

namespace fs = std::filesystem;

struct LeagueOptions {
  std::string folder, seed_file, entry, site, page, after, store;
  std::vector<std::string> practice;
  std::string title = "labmouse league";
  Contests contests;
  SecretMazes examination = Season().examination;
  ExternalOptions external_mice;
  std::string sandbox = "on";
  int jobs = 0;
  Shard shard;
  bool replace = false, no_check = false, reveal = false, templates = false;
};

std::string path_in(const LeagueOptions& options, std::string_view name) {
  return fmt::format("{}/{}", options.folder, name);
}

/// A seed that nobody can guess, from the system.
std::string drawn_seed() {
  std::random_device device;
  std::string seed;
  for (int i = 0; i < 8; ++i) seed += fmt::format("{:08x}", static_cast<std::uint32_t>(device()));
  return seed;
}

/// Throws UsageError.
std::string valid(SecretSeed seed) {
  if (!seed.error.empty()) throw UsageError(seed.error);
  return std::move(seed.secret);
}

/// Copies the files that settings name into the folder, so that the season does not depend on them.
void freeze_settings(const LeagueOptions& options, NamedWorld& world) {
  for (const WorldSetting& setting : world.entry->settings) {
    const auto chosen = world.settings.find(setting.name);
    if (chosen == world.settings.end() || !can_be_file(setting, chosen->second)) continue;
    const FileContent file = read_file(chosen->second);
    if (!file.error.empty()) throw UsageError(fmt::format("{}: error: {}", chosen->second, file.error));
    const std::string name = std::string(setting.name) + fs::path(chosen->second).extension().string();
    save(path_in(options, name), file.content);
    chosen->second = name;
  }
}

/// The season before; its results.json becomes a file of the new season. Throws UsageError.
PreviousSeason previous_of(const LeagueOptions& options) {
  if (options.after.empty()) return {};
  PreviousSeason previous = read_previous_season(options.after);
  if (!previous.error.empty()) throw UsageError(previous.error);
  return previous;
}

/// Throws UsageError if the seed is one that was published with an earlier season.
void expect_new_seed(const PreviousSeason& previous, const std::string& seed_hash) {
  for (const EarlierSeason& season : previous.seasons)
    if (season.seed_hash == seed_hash)
      throw UsageError(shown(fmt::format(
          "error: the seed is that of the season '{}', which everybody knows; choose another one", season.title)));
}

/// The text of the maze's file.
std::string drawing_of(const NamedMaze& maze) {
  WriteResult written = drawing_format.write(maze.maze);
  if (!written.content) throw UsageError(fmt::format("{}: error: {}", maze.name, written.reason));
  return std::move(*written.content);
}

/// Writes the practice mazes into the folder.
std::size_t freeze_practice(const LeagueOptions& options, const std::vector<NamedMaze>& mazes) {
  std::vector<std::string> names;
  for (const NamedMaze& maze : mazes) names.push_back(stem_of(maze.name));
  names = file_names(names);
  for (std::size_t i = 0; i < mazes.size(); ++i)
    save(path_in(options, fmt::format("{}/{}.txt", practice_folder_name, names[i])), drawing_of(mazes[i]));
  return mazes.size();
}

/// Writes a file that no other user can read at any time: the right is taken from an empty file, and writing keeps it.
void save_for_owner(const std::string& path, const std::string& content) {
  save(path, "");
  std::error_code error;
  fs::permissions(path, fs::perms::owner_read | fs::perms::owner_write, error);
  if (error) throw UsageError(fmt::format("{}: error: cannot be kept from others: {}", path, error.message()));
  save(path, content);
}

int init(LeagueOptions& options) {
  Season season;
  season.title = options.title;
  season.version = version();
  Entry entry = options.contests.world.enter_one({});
  season.world = {find_world(entry.world->traits().name), {}};
  season.examination = options.examination;
  season.limits = options.external_mice.limits;
  if (shown(season.title) != season.title || season.title.empty())
    throw UsageError("error: --title must be printable and not empty");
  if (const std::string reason = refuse(season.examination); !reason.empty()) throw UsageError("error: " + reason);
  if (const std::string reason = refuse_for_league(*entry.world); !reason.empty()) throw UsageError("error: " + reason);
  if (options.templates && !entry.world->traits().rules_in_steps)
    throw UsageError(
        fmt::format("error: the templates of --templates cannot race in the world {}; leave the option out",
                    entry.world->traits().name));
  const std::string season_file = path_in(options, season_file_name), secret_file = path_in(options, secret_file_name),
                    frozen_file = path_in(options, frozen_file_name);
  for (const std::string& path : {season_file, secret_file, frozen_file})
    if (std::error_code unknown; fs::exists(path, unknown))
      throw UsageError(
          fmt::format("{}: error: is there already; a season is not changed, so choose another folder", path));
  const PreviousSeason previous = previous_of(options);
  const MazeCollection mazes = find_mazes_of(entry, options.contests);
  season.is_frozen = true;
  season.world.settings = entry.settings;
  const std::string secret = options.seed_file.empty() ? drawn_seed() : valid(read_secret_seed(options.seed_file));
  season.seed_hash = sha256_text(secret);
  expect_new_seed(previous, season.seed_hash);
  if (const std::string reason = refuse_examination(*entry.world, season.examination, secret); !reason.empty())
    throw UsageError("error: " + reason);
  freeze_settings(options, season.world);
  const std::size_t practice = freeze_practice(options, mazes.mazes);
  if (options.templates)
    for (const EntryFile& file : template_entries())
      save(path_in(options, fmt::format("{}/{}", entries_folder_name, file.path)), file.content);
  if (!previous.content.empty()) save(path_in(options, previous_file_name), previous.content);
  save_for_owner(secret_file, secret_text(secret));
  // The store and the records will have mazes of the examination.
  std::error_code ignored;
  fs::permissions(options.folder, fs::perms::owner_all, ignored);
  const std::string text = season_text(season);
  const FrozenFiles frozen = frozen_files(options.folder, season, text);
  if (!frozen.error.empty()) throw UsageError(frozen.error);
  save(frozen_file, frozen.list);
  save(season_file, text);
  print(
      fmt::format("wrote {}: {}, {} of practice and {} of the examination\n"
                  "Publish the hash of the season now: {}\nKeep {} to yourself until the season ends.\n",
                  season_file, season.world.entry->name, counted(practice, "maze", "mazes"), season.examination.count,
                  sha256_text(frozen.list), secret_file));
  return exit_good;
}

/// @param any_entries whether others may have errors, which are printed then.
League league_of(LeagueOptions& options, const std::atomic<bool>& stopped, bool any_entries = false) {
  options.external_mice.sandbox = options.sandbox == "off" ? SandboxUse::never : SandboxUse::always;
  options.external_mice.stop = &stopped;
  std::vector<std::string> others;
  for (const std::string& path : {options.seed_file, options.store})
    if (!path.empty()) others.push_back(path);
  League league = load_league(options.folder, options.external_mice, others);
  if (any_entries)
    tell_remarks(league.entry_errors);
  else
    league.errors.insert(league.errors.end(), league.entry_errors.begin(), league.entry_errors.end());
  if (!league.errors.empty()) throw UsageError(fmt::format("{}", fmt::join(league.errors, "\n")));
  tell_remarks(league.remarks);
  return league;
}

/// Runs the mouse of an entry once in the first practice maze. Throws UsageError where it does not start.
std::string tried(const League& league, const LeagueEntry& entry) {
  RaceOrder order;
  order.world = league.world;
  order.runs = 1;
  order.jobs = 1;
  order.files = league.hidden();
  const Race race = hold_race({entry.mouse}, {league.practice.front()}, order);
  if (const std::string lines = never_started_lines(race); !lines.empty())
    throw UsageError("error: " + lines.substr(0, lines.size() - 1) + "; --no-check adds it all the same");
  return fmt::format("{} in {}", race.results.front().outcome, race.mazes.front().name);
}

/// Removes a folder when it goes out of scope.
struct Removed {
  std::string path;
  ~Removed() {
    std::error_code ignored;
    fs::remove_all(path, ignored);
  }
};

/// Where an entry of that name is or will be: names that differ may be the same as names of files.
std::string place_of(const League& league, const std::string& name) {
  const auto in_place = [&](const auto& is) { return std::find_if(league.entries.begin(), league.entries.end(), is); };
  const auto same = in_place([&](const LeagueEntry& entry) { return entry.manifest.name == name; });
  if (same != league.entries.end()) return same->folder;
  const std::string first = fmt::format("{}/{}/{}", league.folder, entries_folder_name, file_names({name}).front());
  std::string place = first;
  // What is there and no entry is one with errors, which may be replaced.
  for (int number = 2;
       in_place([&](const LeagueEntry& entry) { return entry.folder == place; }) != league.entries.end(); ++number)
    place = fmt::format("{}~{}", first, number);
  return place;
}

int add(LeagueOptions& options) {
  const Interruptible interruptible;
  const League league = league_of(options, interruptible.stopped(), true);
  if (LeagueEntryResult read = read_entry(league, options.entry, options.external_mice); !read.entry)
    throw UsageError(fmt::format("{}", fmt::join(read.errors, "\n")));
  const std::string entries = path_in(options, entries_folder_name);
  // Others may add theirs meanwhile.
  const Removed partial = {fmt::format("{}/.partial-{}", entries, process_number())};
  std::error_code unknown;
  if (const std::string error = copy_entry(options.entry, partial.path); !error.empty()) throw UsageError(error);
  LeagueEntryResult copied = read_entry(league, partial.path, options.external_mice);
  if (!copied.entry) throw UsageError(fmt::format("{}", fmt::join(copied.errors, "\n")));
  const std::string& name = copied.entry->manifest.name;
  const std::string target = place_of(league, name);
  const bool exists = fs::exists(target, unknown);
  if (exists && !options.replace)
    throw UsageError(fmt::format("{}: error: is there already; --replace replaces it", shown(target)));
  const std::string how = options.no_check ? "not run" : tried(league, *copied.entry);
  if (interruptible.stopped()) return exit_interrupted();
  const Removed former = {fmt::format("{}/.former-{}", entries, process_number())};
  std::error_code error;
  if (exists) fs::rename(target, former.path, error);
  if (!error) {
    fs::rename(partial.path, target, error);
    if (error && exists) fs::rename(former.path, target, unknown);
  }
  if (error) throw UsageError(fmt::format("{}: error: cannot be written: {}", shown(target), error.message()));
  print(fmt::format("added {}: {}\n", shown(name), shown(how)));
  return exit_good;
}

std::string store_of(const LeagueOptions& options) {
  return options.store.empty() ? path_in(options, store_file_name) : options.store;
}

/// Runs what is missing of the season, with a progress bar. Throws UsageError.
SeasonRaces run_contests(const LeagueOptions& options, const League& league, const std::string& secret,
                         const std::atomic<bool>& stopped) {
  auto store = std::make_shared<Store>(store_of(options));
  if (store->failed()) throw UsageError(store->finish());
  SeasonOrder order;
  order.secret = secret;
  order.jobs = options.jobs;
  order.shard = options.shard;
  order.store = store;
  order.stop = &stopped;
  Progress progress;
  order.advanced = [&](std::size_t all, bool) { progress.advance(all); };
  SeasonRaces races = run_season(league, order);
  if (const std::string error = store->finish(); !error.empty()) throw UsageError(error);
  if (!races.error.empty()) throw UsageError(races.error);
  return races;
}

/// Writes the files of the site.
void write_site(const LeagueOptions& options, const SeasonResults& results, const std::string& page) {
  const auto file = [&](const char* name) { return fmt::format("{}/{}", options.site, name); };
  save(file(results_name), json_of(results));
  save(file("report.html"), race_page(results.races.practice.race, results.races.practice.records, page));
  if (results.revealed)
    save(file("examination.html"), race_page(results.races.examination.race, results.races.examination.records, page));
  save(file("index.html"), index_page(results));
  print(fmt::format("wrote {}\n", shown(file("index.html"))));
}

/// Whether the path is that of the folder, or of something in it.
bool is_in(const std::string& path, const std::string& folder) {
  std::error_code unknown;
  const fs::path real = fs::weakly_canonical(path, unknown), outer = fs::weakly_canonical(folder, unknown);
  return std::mismatch(outer.begin(), outer.end(), real.begin(), real.end()).first == outer.end();
}

/// Throws UsageError where the pages cannot be written, or would replace pages of somebody else.
void expect_site(const LeagueOptions& options) {
  if (is_in(options.site, options.folder))
    throw UsageError(
        fmt::format("{}: error: lies in the folder of the season, which has the secret seed; choose "
                    "another folder",
                    shown(options.site)));
  const std::string index = options.site + "/index.html", results = fmt::format("{}/{}", options.site, results_name);
  std::error_code unknown;
  if (fs::exists(index, unknown) && !fs::exists(results, unknown))
    throw UsageError(
        fmt::format("{}: error: is there, and not from `labmouse league publish`; choose another folder", index));
  require_writable(index);
}

/// run, and publish where there is a site.
int run_or_publish(LeagueOptions& options) {
  const bool publishes = !options.site.empty();
  if (publishes) expect_site(options);
  const std::string page = publishes ? find_page(options.page) : "";
  std::optional<Interruptible> interruptible(std::in_place);
  const League league = league_of(options, interruptible->stopped());
  const std::string secret = valid(read_secret_seed_of(league, options.seed_file));
  const SeasonRaces races = run_contests(options, league, secret, interruptible->stopped());
  interruptible.reset();
  if (races.stopped) {
    tell("Stopped early: nobody is ranked. The next run goes on where this one stopped.\n");
    return exit_interrupted();
  }
  if (races.not_judged > 0) {
    tell(fmt::format("{} not judged, because the machine was too busy: nobody is ranked; run it again\n",
                     counted(static_cast<std::size_t>(races.not_judged), "contest was", "contests were")));
    return exit_finding;
  }
  if (options.shard.of > 1) {
    print(fmt::format(
        "part {} of {}: {} in {}\n", options.shard.number, options.shard.of,
        counted(races.practice.race.results.size() + races.examination.race.results.size(), "contest", "contests"),
        shown(store_of(options))));
    return exit_good;
  }
  const SeasonResults results = results_of(league, races, options.reveal ? std::optional(secret) : std::nullopt);
  if (publishes)
    write_site(options, results, page);
  else
    print(table_of(results));
  return exit_good;
}

Command* add_with_folder(Command& command, LeagueOptions& options, const std::string& name,
                         const std::string& meaning) {
  Command* added = command.add_subcommand(name, meaning);
  added->add_option("folder", options.folder, "Folder of the season")->required()->type_name("FOLDER");
  return added;
}

void add_programs(Command& command, LeagueOptions& options) {
  add_runners(command, options.external_mice);
  command
      .add_option("--sandbox", options.sandbox,
                  "Run programs in a sandbox and refuse a system without one (on), or without a sandbox (off)")
      ->check(one_of({"on", "off"}))
      ->capture_default_str();
}

void add_running(Command& command, LeagueOptions& options) {
  command
      .add_option("--seed-file", options.seed_file,
                  "File with the seed of the examination; default: FOLDER/secret-seed.txt")
      ->type_name("FILE");
  command.add_option("--jobs", options.jobs, "Number of threads; 0 uses all processors")
      ->check(in_range(0, 1024))
      ->capture_default_str();
  add_programs(command, options);
}

void add_init(Command& league, std::shared_ptr<LeagueOptions> options, int& exit) {
  Command* command = add_with_folder(league, *options, "init", "Make the folder of a season");
  command->add_option("--title", options->title, "Title of the season")->type_name("TEXT")->capture_default_str();
  command
      ->add_option("--practice", options->contests.mazes,
                   "Practice mazes: files, folders, patterns or built-in mazes; default: all built-in mazes")
      ->type_name("PATH")
      ->expected(1, 1 << 20)
      ->take_all();
  command->add_option("--examination", options->examination.count, "Number of examination mazes")
      ->check(in_range(1, most_secret_mazes))
      ->type_name("N")
      ->capture_default_str();
  command->add_option("--kind", options->examination.kind, "Generator of the examination mazes")
      ->type_name("KIND")
      ->capture_default_str();
  command->add_option("--side", options->examination.side, "Width and height of the examination mazes, in cells")
      ->check(in_range(1, max_side))
      ->type_name("CELLS")
      ->capture_default_str();
  command
      ->add_option("--seed-file", options->seed_file,
                   "File with the secret seed of the examination mazes; default: one from the system's randomness")
      ->type_name("FILE");
  command
      ->add_option("--after", options->after,
                   "The season before, whose ranks the pages show: the folder of its pages, published with --reveal")
      ->type_name("DIR");
  command->add_flag("--templates", options->templates,
                    "Enter the templates of robots that come with labmouse, besides the built-in mice");
  command->group(groups::world);
  options->contests.world.add_to(*command);
  add_limits(*command, options->external_mice.limits);
  command->footer("Example: labmouse league init spring --title 'Spring league' --practice capstone-1,contest-05");
  command->callback([options, &exit] { exit = init(*options); });
}

}  // namespace

void add_league(Command& app, int& exit) {
  Command* league = app.add_subcommand("league", "Run a season: collect entries, rank them and publish the results");
  league->require_subcommand();
  add_init(*league, std::make_shared<LeagueOptions>(), exit);
  auto options = std::make_shared<LeagueOptions>();
  Command* add_command = add_with_folder(*league, *options, "add", "Add an entry: a folder with an entry.toml");
  add_command->add_option("entry", options->entry, "Folder of the entry")
      ->required()
      ->type_name("ENTRY")
      ->check(existing_directory());
  add_command->add_flag("--replace", options->replace, "Replace an earlier entry of the same name");
  add_command->add_flag("--no-check", options->no_check, "Do not run the mouse in a practice maze first");
  add_programs(*add_command, *options);
  add_command->footer("Example: labmouse league add spring ada/");
  add_command->callback([options, &exit] { exit = add(*options); });
  Command* run_command =
      add_with_folder(*league, *options, "run", "Run all contests that are missing, and print the ranking");
  add_running(*run_command, *options);
  auto* shard = add_shard(*run_command, options->shard, "season");
  auto* store = run_command
                    ->add_option("--store", options->store,
                                 "Store for the contests of a part; default without --shard: FOLDER/results.db")
                    ->type_name("FILE")
                    ->needs(shard);
  shard->needs(store);
  run_command->footer(
      "Example: labmouse league run spring\n"
      "         labmouse league run spring --shard 3/64 --store part-3.db");
  run_command->callback([options, &exit] { exit = run_or_publish(*options); });
  Command* publish_command =
      add_with_folder(*league, *options, "publish", "Write the results as pages; runs contests that are missing");
  publish_command->add_option("-o,--out,--output", options->site, "Folder for the pages")->required()->type_name("DIR");
  publish_command->add_flag("--reveal", options->reveal,
                            "The season is over: publish the seed, and the contests of the examination");
  publish_command->add_option("--page", options->page, "Use this page for the replays instead of the built-in one")
      ->type_name("FILE");
  add_running(*publish_command, *options);
  publish_command->footer("Example: labmouse league publish spring -o site --reveal");
  publish_command->callback([options, &exit] { exit = run_or_publish(*options); });
  league->footer(
      "Example: labmouse league init spring\n         labmouse league add spring ada/\n"
      "         labmouse league run spring\n         labmouse league publish spring -o site");
}

}  // namespace labmouse::cli
