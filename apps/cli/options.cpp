#include "options.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <optional>

#include "command.hpp"
#include "labmouse/contest/physical_conditions.hpp"
#include "labmouse/functions/parse_number.hpp"
#include "labmouse/lab/text/former_names.hpp"
#include "labmouse/lab/text/numbers.hpp"
#include "labmouse/strategies/parameter.hpp"

namespace labmouse::cli {
namespace {

/// Options that users often write wrongly, each with the option that they mean.
constexpr std::array<std::pair<std::string_view, std::string_view>, 10> often_meant = {{{"--mouse", "--mice"},
                                                                                        {"--maze", "--mazes"},
                                                                                        {"--mazes", "--maze"},
                                                                                        {"--output", "--out"},
                                                                                        {"--threads", "--jobs"},
                                                                                        {"--seeds", "--runs"},
                                                                                        {"--json", "--format"},
                                                                                        {"--csv", "--format"},
                                                                                        {"-v", "--version"},
                                                                                        {"-V", "--version"}}};

std::vector<std::string> commands_of(const CLI::App& app) {
  std::vector<std::string> names;
  for (const CLI::App* command : app.get_subcommands({})) names.push_back(command->get_name());
  return names;
}

/// The message for an unknown command, with the argument behind it.
std::string describe_unknown_command(const CLI::App& app, const std::string& word, const std::string& next = "") {
  const std::vector<std::string> names = commands_of(app);
  if (word == "help" && !next.empty() && std::find(names.begin(), names.end(), next) != names.end())
    return fmt::format("unknown command 'help'; write `labmouse {} --help`", next);
  // `labmouse help` is as common as `labmouse --help`.
  const bool is_option = app.get_option_no_throw("--" + word) != nullptr;
  const std::string near =
      is_option ? "--" + word
                : std::string(nearest_name(word, std::vector<std::string_view>(names.begin(), names.end())));
  return fmt::format("unknown command '{}'; {}", word,
                     near.empty() ? fmt::format("the commands are {}", fmt::join(names, ", "))
                                  : fmt::format("did you mean '{}'?", near));
}

/// The message for an argument too many.
std::string describe_unexpected_argument(const CLI::App& command, const std::string& word) {
  if (command.get_option_no_throw("--mice") != nullptr)
    return fmt::format("unexpected argument '{0}'; mice are named with --mice {0}", word);
  std::vector<std::string> places;
  for (const CLI::Option* option : command.get_options())
    if (option->get_positional()) places.push_back(fmt::format("'{}'", option->get_name(true)));
  return fmt::format("unexpected argument '{}'; {}", word,
                     places.empty() ? "this command takes only options"
                                    : fmt::format("this command takes {}", fmt::join(places, " and ")));
}

/// The first word that a command did not expect, with the option that it may have been meant to be.
std::string describe_unexpected(const CLI::App& command, const std::vector<std::string>& words) {
  auto word = std::find_if(words.begin(), words.end(), [](const std::string& w) { return w.starts_with("-"); });
  if (word == words.end())
    return commands_of(command).empty() ? describe_unexpected_argument(command, words.front())
                                        : describe_unknown_command(command, words.front());
  for (const auto& [wrong, right] : often_meant)
    if (*word == wrong && command.get_option_no_throw(std::string(right)) != nullptr)
      return fmt::format("unknown option '{}'; did you mean '{}'?", *word, right);
  std::vector<std::string> names;
  for (const CLI::Option* option : command.get_options())
    for (const std::string& name : option->get_lnames()) names.push_back("--" + name);
  const auto near = nearest_name(*word, std::vector<std::string_view>(names.begin(), names.end()));
  return fmt::format("unknown option '{}'{}", *word, near.empty() ? "" : fmt::format("; did you mean '{}'?", near));
}

/// The first example below the help of a command, to stand behind a message: "; for example `labmouse ...`".
std::string example_of(std::string_view footer) {
  constexpr std::string_view sign = "Example: ";
  const auto begin = footer.find(sign);
  if (begin == std::string_view::npos) return "";
  const std::string_view example = footer.substr(begin + sign.size());
  return fmt::format("; for example `{}`", example.substr(0, example.find('\n')));
}

/// The message for a missing command or option. `said` is CLI11's message, which begins with the option's name.
std::string describe_missing(const CLI::App& command, std::string_view said) {
  if (const auto names = commands_of(command); !names.empty())
    return fmt::format("a command is missing; the commands are {}", fmt::join(names, ", "));
  return fmt::format("'{}' is missing", said.substr(0, said.find(" is required")));
}

/// Bad usage: one line that says what is wrong and where help is.
UsageError usage_error(const CLI::App& app, const CLI::ParseError& error) {
  const CLI::App* command = &app;
  std::string name = app.get_name();
  while (!command->get_subcommands().empty()) {
    command = command->get_subcommands().front();
    name += " " + command->get_name();
  }
  // For an unknown subcommand of a command, CLI11 only reports that a subcommand is missing.
  const bool unexpected = dynamic_cast<const CLI::ExtrasError*>(&error) != nullptr ||
                          (command != &app && !command->get_subcommands({}).empty());
  const std::vector<std::string> words = app.remaining(true);
  const bool missing = words.empty() && dynamic_cast<const CLI::RequiredError*>(&error) != nullptr;
  const std::string problem = unexpected && !words.empty() ? describe_unexpected(*command, words)
                              : missing                    ? describe_missing(*command, error.what())
                                                           : error.what();
  return UsageError(
      fmt::format("error: {}{} (see `{} --help`)", problem, missing ? example_of(command->get_footer()) : "", name));
}

/// Throws if the first argument is neither a command nor an option: CLI11 would only report a missing command. `next`
/// is the argument behind it.
void refuse_unknown_command(const CLI::App& app, const std::string& word, const std::string& next) {
  if (word.starts_with('-')) {
    if (app.get_option_no_throw(word) == nullptr)
      throw UsageError(fmt::format("error: {} (see `{} --help`)", describe_unexpected(app, {word}), app.get_name()));
    return;
  }
  const std::vector<std::string> names = commands_of(app);
  if (std::find(names.begin(), names.end(), word) != names.end()) return;
  throw UsageError(
      fmt::format("error: {} (see `{} --help`)", describe_unknown_command(app, word, next), app.get_name()));
}

/// Reads the number of an option, in digits; returns what is wrong with it, or nothing.
std::string read_number(const std::string& text, double& number) {
  const std::string_view problem = why_no_number(text);
  number = parse_number(text).value_or(0.0);
  return problem.empty() ? "" : fmt::format("'{}' {}", text, problem);
}
template <class Whole>
std::string read_number(const std::string& text, Whole& number) {
  std::string_view rest = text;
  const NumberProblem problem = take_whole(rest, number);
  if (problem == NumberProblem::none && rest.empty()) return "";
  return fmt::format("'{}' is not a whole number{}", text,
                     problem == NumberProblem::too_large ? " of the size that is possible here" : "");
}

template <class Number>
Check between(Number low, Number high, const char* kind) {
  const auto problem = [low, high, kind](const std::string& text) {
    Number number = 0;
    if (read_number(text, number).empty() && number >= low && number <= high) return std::string();
    return fmt::format("'{}' is not a {} from {} to {}", text, kind, low, high);
  };
  Check check(problem);
  check.range = fmt::format("{} to {}", low, high);
  return check;
}

/// CLI11 would read octal and hexadecimal numbers, infinities, and decimal signs of the locale.
template <class Number>
CLI::Option* add_numeric(CLI::App& app, const std::string& name, const std::function<void(Number)>& take,
                         const std::string& meaning) {
  const auto read = [name, take](const std::string& text) {
    Number number = 0;
    if (std::string problem = read_number(text, number); !problem.empty()) throw CLI::ValidationError(name, problem);
    take(number);
  };
  return app.add_option_function<std::string>(name, read, meaning)->type_name("N");
}

template <class Number>
CLI::Option* add_numeric(CLI::App& app, const std::string& name, Number& value, const std::string& meaning) {
  const std::function<void(Number)> take = [&value](Number number) { value = number; };
  return add_numeric(app, name, take, meaning)->default_function([&value] { return fmt::format("{}", value); });
}

/// Refuses the empty value. A shell passes one for a quoted variable that is not set, and the program would treat it as
/// if the option were not given.
CLI::Validator not_empty() {
  return {[](const std::string& text) { return text.empty() ? "its value is empty" : ""; }, "", "not empty"};
}

}  // namespace

Check::Check(const CLI::Validator& validator) : validator_(std::make_shared<CLI::Validator>(validator)) {}
Check::Check(const std::function<std::string(const std::string&)>& problem)
    : Check(CLI::Validator([problem](const std::string& text) { return problem(text); }, "")) {}

Check in_range(int low, int high) { return between(low, high, "whole number"); }
Check in_range(std::uint64_t low, std::uint64_t high) { return between(low, high, "whole number"); }
Check in_range(double low, double high) { return between(low, high, "number"); }
Check setting_value(const WorldSetting& setting) {
  return Check([&setting](const std::string& text) {
    std::string problem;
    chosen_value(setting, text, problem);
    return problem;
  });
}
Check one_of(const std::vector<std::string>& words) {
  Check check([words](const std::string& text) {
    const bool good = std::find(words.begin(), words.end(), text) != words.end();
    return good ? "" : fmt::format("'{}' is not one of {}", text, fmt::join(words, ", "));
  });
  check.type = fmt::format("{}", fmt::join(words, "|"));
  return check;
}
Check existing_directory() {
  return Check([](const std::string& text) {
    return CLI::ExistingDirectory(text).empty() ? "" : fmt::format("there is no folder '{}'", text);
  });
}

Check seed_number() {
  return Check([](const std::string& text) {
    std::uint64_t seed = 0;
    const bool good = read_number(text, seed).empty();
    return good ? std::string() : fmt::format("'{}' is not a whole number from 0 to 2^64 - 1", text);
  });
}

Check finite_number() {
  return Check([](const std::string& text) {
    double number = 0.0;
    return read_number(text, number);
  });
}

Option* Option::type_name(const std::string& name) {
  option_->type_name(name);
  return this;
}
Option* Option::required() {
  option_->required();
  return this;
}
Option* Option::needs(const Option* other) {
  option_->needs(other->option_);
  return this;
}
Option* Option::expected(int count) {
  option_->expected(count);
  return this;
}
Option* Option::expected(int low, int high) {
  option_->expected(low, high);
  return this;
}
Option* Option::take_all() {
  option_->take_all();
  return this;
}
Option* Option::check(const Check& check) {
  option_->check(check.validator());
  if (!check.type.empty()) option_->type_name(check.type);
  if (!check.range.empty()) option_->description(fmt::format("{} ({})", option_->get_description(), check.range));
  return this;
}
Option* Option::capture_default_str() {
  option_->capture_default_str();
  return this;
}
Option* Option::default_str(const std::string& text) {
  option_->default_str(text);
  return this;
}
Option* Option::may_be_empty() {
  option_->get_validator(not_empty().get_name())->active(false);
  return this;
}
std::size_t Option::count() const { return option_->count(); }
std::string Option::name() const { return option_->get_name(); }

Command* Command::add_subcommand(const std::string& name, const std::string& meaning) {
  // By default a subcommand inherits the footer of its parent in CLI11, which has the example of another command.
  return &subcommands_.emplace_back(*app_->add_subcommand(name, meaning)->footer(""));
}
void Command::require_subcommand() { app_->require_subcommand(1); }

Option* Command::add(CLI::Option* option) { return &options_.emplace_back(*option->check(not_empty())->group(group_)); }
Option* Command::add_option(const std::string& name, std::string& value, const std::string& meaning) {
  return add(app_->add_option(name, value, meaning));
}
Option* Command::add_option(const std::string& name, std::vector<std::string>& value, const std::string& meaning) {
  return add(app_->add_option(name, value, meaning));
}
Option* Command::add_option(const std::string& name, int& value, const std::string& meaning) {
  return add(add_numeric(*app_, name, value, meaning));
}
Option* Command::add_option(const std::string& name, std::uint64_t& value, const std::string& meaning) {
  return add(add_numeric(*app_, name, value, meaning));
}
Option* Command::add_option(const std::string& name, double& value, const std::string& meaning) {
  return add(add_numeric(*app_, name, value, meaning));
}
Option* Command::add_integer(const std::string& name, const std::function<void(std::uint64_t)>& take,
                             const std::string& meaning) {
  return add(add_numeric(*app_, name, take, meaning));
}
Option* Command::add_number(const std::string& name, const std::function<void(double)>& take,
                            const std::string& meaning) {
  return add(add_numeric(*app_, name, take, meaning));
}
Option* Command::add_word(const std::string& name, const std::function<void(const std::string&)>& take,
                          const std::string& meaning) {
  return add(app_->add_option_function<std::string>(name, take, meaning));
}
Option* Command::add_flag(const std::string& name, bool& value, const std::string& meaning) {
  return &options_.emplace_back(*app_->add_flag(name, value, meaning)->group(group_));
}
Option* Command::add_flag(const std::string& name, const std::function<void()>& take, const std::string& meaning) {
  return &options_.emplace_back(*app_->add_flag_callback(name, take, meaning)->group(group_));
}

namespace {

/// The group of options that another command explains. CLI11 gives an option without a group no name in its messages.
constexpr const char* referred = "referred";

/// Leaves them out of the help that is now printed.
void hide_referred(CLI::App& app) {
  for (CLI::Option* option : app.get_options())
    if (option->get_group() == referred) option->group("");
  for (CLI::App* command : app.get_subcommands({})) hide_referred(*command);
}

}  // namespace

void Command::refer(std::initializer_list<std::string> headings, const std::string& command) {
  std::vector<std::string> left_out;
  for (CLI::Option* option : app_->get_options())
    if (std::find(headings.begin(), headings.end(), option->get_group()) != headings.end()) {
      left_out.push_back("--" + option->get_lnames().front());
      option->group(referred);
    }
  referred_ = fmt::format("Also, as explained by `{} --help`: {}\n\n", command, fmt::join(left_out, " "));
  app_->footer(referred_ + footer_);
}

void Command::footer(const std::string& text) {
  footer_ = text;
  app_->footer(referred_ + footer_);
}
void Command::callback(const std::function<void()>& action) { app_->callback(action); }
void Command::hand_over(const std::function<void(const std::vector<std::string>&)>& action) {
  app_->prefix_command();
  app_->callback([app = app_, action] { action(app->remaining()); });
}
std::size_t Command::count(const std::string& option) const {
  const CLI::Option* found = app_->get_option_no_throw(option);
  return found == nullptr ? 0 : found->count();
}

CommandLine::CommandLine(const std::string& program, const std::string& meaning, const std::string& version)
    : app_(std::make_unique<CLI::App>(meaning, program)), root_(*app_) {
  app_->set_version_flag("--version", version);
  app_->require_subcommand(1);
}

CommandLine::~CommandLine() = default;

namespace {

/// A command or an option under its name of today.
std::string today_word(const std::string& word, bool is_command) {
  constexpr std::array commands = std::to_array<FormerName>({{"lineup", "mice-file"}, {"hazards", "failure-rates"}});
  constexpr std::array options = std::to_array<FormerName>({{"--lineup", "--mice-file"},
                                                            {"--groups", "--causes"},
                                                            {"--spread", "--variation"},
                                                            {"--hazards", "--failure-rates"},
                                                            {"--guest-runs", "--external-runs"}});
  if (is_command)
    for (const FormerName& command : commands)
      if (word == command.former) return std::string(command.today);
  for (const FormerName& option : options)
    if (word == option.former || word.starts_with(std::string(option.former) + "="))
      return std::string(option.today) + word.substr(option.former.size());
  return word;
}

}  // namespace

bool CommandLine::run(int argc, char** argv) {
  if (argc <= 1) {
    print(start_page_);
    return true;
  }
  // CLI11 takes the words from their end.
  std::vector<std::string> words;
  for (int i = argc - 1; i > 0; --i) words.push_back(today_word(argv[i], i == 1));
  refuse_unknown_command(*app_, words.back(), words.size() > 1 ? words[words.size() - 2] : "");
  try {
    app_->parse(std::move(words));
    return false;
  } catch (const CLI::Success& asked) {  // for the help or the version
    hide_referred(*app_);
    app_->exit(asked);
    return true;
  } catch (const CLI::ParseError& error) {
    throw usage_error(*app_, error);
  }
}

}  // namespace labmouse::cli
