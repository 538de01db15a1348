#include "labmouse/lab/store/contest_key.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <variant>
#include <vector>

#include "labmouse/lab/mazes/maze_link.hpp"
#include "labmouse/lab/mice/specs.hpp"
#include "labmouse/lab/races/value_json.hpp"
#include "labmouse/lab/store/build_signature.hpp"
#include "labmouse/lab/text/former_names.hpp"
#include "labmouse/lab/worlds/worlds.hpp"
#include "labmouse/mouse/cellwise_explorer.hpp"
#include "labmouse/mouse/wall_prior.hpp"

namespace labmouse {
namespace {

/// All numbers of a prior, each as two hexadecimal digits.
std::string prior_text(const WallPrior& prior) {
  std::string text;
  for (const std::uint8_t number : prior.walls) text += fmt::format("{:02x}", number);
  for (const std::uint8_t number : prior.rim) text += fmt::format("{:02x}", number);
  return text;
}

/// Whether contests under these conditions are driven by a robot: they name its tables.
bool has_robot(const std::vector<Condition>& conditions) {
  return std::any_of(conditions.begin(), conditions.end(),
                     [](const Condition& condition) { return condition.key == "tables"; });
}

}  // namespace

std::string conditions_text(const World& world) { return one_line(conditions_json(world)); }

std::string key_of(const World& world) {
  // Uses the names of the first version, so that existing stores stay valid.
  std::string fields;
  for (const ContestField& field : world.traits().fields->contest) fields += fmt::format(" {}", former_key(field.key));
  const Json conditions = with_names(conditions_json(world), former_key, former_value);
  std::string formula = world.traits().formula;
  if (const auto place = formula.find("search steps"); place != std::string::npos)
    formula.replace(place, 6, "exploration");
  const auto failure = world.traits().failure_score;
  const WorldEntry* entry = find_world(world.traits().name);
  const std::string_view name =
      entry != nullptr && !entry->former_name.empty() ? entry->former_name : world.traits().name;
  return fmt::format("world {}\nedition {}\nformula {}\nfailure {}\nconditions {}\nfields{}\n", name,
                     world.traits().edition, formula, failure ? fmt::format("{}", *failure) : "none",
                     one_line(conditions), fields);
}

std::string key_of(const World& world, const Contestant& mouse) {
  std::string text;
  if (mouse.identity) {
    // The results of an external mouse that is driven depend on what drives it, too.
    const bool driven = mouse.external && !mouse.parts && !std::holds_alternative<ControllerProgram>(mouse.kind) &&
                        has_robot(world.traits().conditions);
    text =
        mouse.identity() + (driven ? fmt::format("driven {}\nsignature {}\n", driven_edition, build_signature()) : "");
    if (!mouse.parts) return text;
  }
  const BuiltinMouse* entry = entry_of(mouse);
  if (entry == nullptr && !mouse.reference) return "";
  text += fmt::format("mouse {}\n", entry != nullptr ? entry->name : std::string_view(spec_of(mouse)));
  const Settings settings = world.settings(mouse);
  for (const Setting& setting : settings.all())
    text += fmt::format("{} {}\n", former_key(setting.name), former_value(setting.value));
  if (const WallPrior* learned = mouse.settings.attached()) text += fmt::format("learned {}\n", prior_text(*learned));
  return text + fmt::format("signature {}\n", build_signature());
}

std::string key_of(const Maze& maze) { return link_of({"", maze}); }

}  // namespace labmouse
