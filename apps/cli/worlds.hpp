// --world, and what can be set of each world.
#pragma once

#include <map>
#include <memory>
#include <string>
#include <vector>

#include "labmouse/lab/worlds/entering.hpp"
#include "options.hpp"

namespace labmouse::cli {

/// The world that was asked for, and its settings.
class WorldChoice {
 public:
  /// Adds --world and the settings of all worlds.
  void add_to(Command& command);

  /// Which of the mice race where; throws UsageError where one cannot, and where a setting was given that none of the
  /// worlds has in which a mouse races.
  std::vector<Entry> enter(std::vector<Contestant> mice) const;
  /// The same where all have to race in one world; takes those away that are left out.
  std::shared_ptr<const World> enter_one(std::vector<Contestant>& mice) const;
  /// The world that was asked for, with its settings, or the first world.
  std::shared_ptr<const World> world() const;

 private:
  WorldSettings given() const;

  const Command* command_ = nullptr;
  std::string world_;
  std::map<std::string, std::string> texts_;
  std::map<std::string, bool> flags_;
};

/// How many contests a mouse has in each maze where nobody says, by world.
std::string usual_runs_text();

}  // namespace labmouse::cli
