// The option --world and the settings of all worlds.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "labmouse/lab/worlds/entering.hpp"
#include "options.hpp"

namespace labmouse::cli {

/// The world and the settings on the command line.
class WorldChoice {
 public:
  /// Adds --world and the settings of all worlds.
  void add_to(Command& command);

  /// Returns the mice that race in each world. Throws UsageError where a mouse cannot race, where no world with mice
  /// has a given setting, or where mice suit different worlds and the user did not ask for each.
  std::vector<Entry> enter(std::vector<Contestant> mice) const;
  /// The same for commands with one world; the entry may have no mice.
  Entry enter_one(std::vector<Contestant> mice) const;
  /// The world on the command line (by default the first one) with its settings.
  std::shared_ptr<const World> world() const;
  /// How many values the user gave a setting; 0 where it is not given.
  std::size_t values(const std::string& setting) const;

 private:
  std::vector<Entry> enter_worlds(std::vector<Contestant> mice) const;

  std::string world_;
  WorldSettings given_;
};

/// Adds a setting of a world as an option. The user's value goes to `given`, "true" for a flag.
void add_setting(Command& command, const WorldSetting& setting, const std::string& meaning,
                 const std::string& default_value, WorldSettings& given);

/// The default number of contests of a mouse in each maze, by world.
std::string usual_runs_text();

}  // namespace labmouse::cli
