// Commands and their options. The library behind them, CLI11, takes seconds to compile wherever it is included: that is
// options.cpp alone.
#pragma once

#include <cstdint>
#include <functional>
#include <initializer_list>
#include <list>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "labmouse/lab/races/world_setting.hpp"

namespace CLI {
class App;
class Option;
class Validator;
}  // namespace CLI

namespace labmouse::cli {

/// What the value of an option has to be.
class Check {
 public:
  explicit Check(const CLI::Validator& validator);
  /// `problem` says what is wrong with a value, or nothing.
  explicit Check(const std::function<std::string(const std::string&)>& problem);

  const CLI::Validator& validator() const { return *validator_; }

  std::string type;   ///< name of the value in the help; empty: Option::type_name() sets it
  std::string range;  ///< shown in the help after the meaning, such as "1 to 1000000"; may be empty

 private:
  std::shared_ptr<const CLI::Validator> validator_;
};

/// From `low` to `high`, both included.
Check in_range(int low, int high);
Check in_range(std::uint64_t low, std::uint64_t high);
Check in_range(double low, double high);
Check one_of(const std::vector<std::string>& words);
Check existing_directory();
/// 0 to 2^64 - 1, in digits.
Check seed_number();
/// What a setting of a world, which must outlive the check, can be.
Check setting_value(const WorldSetting& setting);
/// A finite decimal number.
Check finite_number();

/// One option, flag or positional argument of a command. Each of its setters returns it.
class Option {
 public:
  explicit Option(CLI::Option& option) : option_(&option) {}

  /// What its value is called in the help.
  Option* type_name(const std::string& name);
  Option* required();
  /// This option can be given only together with `other`.
  Option* needs(const Option* other);
  /// How many values stand behind the option each time that it is given.
  Option* expected(int count);
  Option* expected(int low, int high);
  /// It may be given several times, and every value counts.
  Option* take_all();
  /// Checks are made in the order in which they were added.
  Option* check(const Check& check);
  /// Allows the empty value, which all other options refuse.
  Option* may_be_empty();
  /// Shows the variable's present value as the default; to be called last.
  Option* capture_default_str();
  /// Shows `text` as the default.
  Option* default_str(const std::string& text);

  /// How often it was given.
  std::size_t count() const;
  /// With its dashes.
  std::string name() const;

 private:
  CLI::Option* option_;
};

/// Headings in the help that several commands use for groups of options.
namespace groups {
inline constexpr const char* mice = "Mice";
inline constexpr const char* mazes = "Mazes";
inline constexpr const char* world = "World";
inline constexpr const char* contests = "Contests";
inline constexpr const char* programs = "Limits of external programs";
inline constexpr const char* output = "Output";
}  // namespace groups

/// A command, or one of its own commands. The pointers that it returns stay valid as long as it exists.
class Command {
 public:
  explicit Command(CLI::App& app) : app_(&app) {}
  Command(const Command&) = delete;
  Command& operator=(const Command&) = delete;

  Command* add_subcommand(const std::string& name, const std::string& meaning);
  /// One of its own commands has to be named.
  void require_subcommand();

  /// `name` begins with dashes, or it is a positional argument; `value` has to outlive the command.
  Option* add_option(const std::string& name, std::string& value, const std::string& meaning);
  Option* add_option(const std::string& name, std::vector<std::string>& value, const std::string& meaning);
  Option* add_option(const std::string& name, int& value, const std::string& meaning);
  Option* add_option(const std::string& name, std::uint64_t& value, const std::string& meaning);
  Option* add_option(const std::string& name, double& value, const std::string& meaning);
  /// Calls `take` with the number that was given.
  Option* add_integer(const std::string& name, const std::function<void(std::uint64_t)>& take,
                      const std::string& meaning);
  Option* add_number(const std::string& name, const std::function<void(double)>& take, const std::string& meaning);
  /// Calls `take` with the text that was given.
  Option* add_word(const std::string& name, const std::function<void(const std::string&)>& take,
                   const std::string& meaning);
  Option* add_flag(const std::string& name, bool& value, const std::string& meaning);
  /// Calls `take` if the flag was given.
  Option* add_flag(const std::string& name, const std::function<void()>& take, const std::string& meaning);

  /// Sets the heading in the help for all options that are added after this call.
  void group(const std::string& heading) { group_ = heading; }
  /// Leaves the options of these headings out of its help and names the command whose help has them.
  void refer(std::initializer_list<std::string> headings, const std::string& command);

  /// Sets the text below the command's help.
  void footer(const std::string& text);
  /// What the command does once its options are read.
  void callback(const std::function<void()>& action);
  /// Like callback(), but `action` gets all arguments after the command unparsed, to pass them to another program.
  void hand_over(const std::function<void(const std::vector<std::string>&)>& action);

  /// How often the option of that name was given; 0 where the command has none.
  std::size_t count(const std::string& option) const;
  const std::list<Option>& options() const { return options_; }

 private:
  Option* add(CLI::Option* option);

  CLI::App* app_;
  std::string group_ = "Options";
  std::string referred_, footer_;
  std::list<Option> options_;
  std::list<Command> subcommands_;
};

/// The command line of a program that has commands.
class CommandLine {
 public:
  CommandLine(const std::string& program, const std::string& meaning, const std::string& version);
  CommandLine(const CommandLine&) = delete;
  CommandLine& operator=(const CommandLine&) = delete;
  ~CommandLine();

  Command& root() { return root_; }
  /// What is printed where no word follows the name of the program.
  void start_page(const std::string& text) { start_page_ = text; }

  /// Parses the arguments and runs the command that they name. Returns true where the help or the version was asked
  /// for and printed instead. Throws UsageError with one line that says what is wrong and where the help is.
  bool run(int argc, char** argv);

 private:
  std::unique_ptr<CLI::App> app_;
  Command root_;
  std::string start_page_;
};

}  // namespace labmouse::cli
