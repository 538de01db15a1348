#include "labmouse/lab/records/packed_record.hpp"

#include <fmt/format.h>

#include "labmouse/functions/parse_number.hpp"
#include "labmouse/lab/records/record_parts.hpp"
#include "labmouse/lab/text/json_fields.hpp"

namespace labmouse {
namespace {

constexpr int usual_movement = 3;
constexpr int usual_movements = 2 * usual_movement + 1;
constexpr char first_letter = 'a';
constexpr char last_letter = 'u';
constexpr char reset_letter = 'R';
constexpr std::uint64_t largest_number = std::uint64_t{1} << 53U;  // JavaScript has all whole numbers up to this one

bool usual(const Action& step) {
  return (step.rotation == -90 || step.rotation == 0 || step.rotation == 90) && step.movement >= -usual_movement &&
         step.movement <= usual_movement;
}

std::string text_of(const Action& action) {
  if (action.kind == Action::Kind::reset) return {reset_letter};
  if (action.kind == Action::Kind::forfeit) return fmt::format("!{};", name_of(action.reason));
  if (!usual(action)) return fmt::format("({},{})", action.rotation, action.movement);
  return {static_cast<char>(first_letter + (action.rotation / 90 + 1) * usual_movements + action.movement +
                            usual_movement)};
}

Action usual_step(char letter) {
  const int number = letter - first_letter;
  return Action::step((number / usual_movements - 1) * 90, number % usual_movements - usual_movement);
}

std::optional<Action> read_unusual_step(std::string_view text) {
  text.remove_prefix(1);
  const auto rotation = take_whole<int>(text);
  if (!rotation || !text.starts_with(',')) return std::nullopt;
  text.remove_prefix(1);
  const auto movement = take_whole<int>(text);
  return movement ? std::optional(Action::step(*rotation, *movement)) : std::nullopt;
}

/// An action, and how many characters it takes.
struct PackedAction {
  Action action;
  std::size_t length = 0;
};

std::optional<PackedAction> read_forfeit(std::string_view text) {
  const std::size_t end = text.find(';');
  if (end == std::string_view::npos) return std::nullopt;
  const auto reason = forfeit_reason_of(text.substr(1, end - 1));
  return reason ? std::optional(PackedAction{Action::forfeit(*reason), end + 1}) : std::nullopt;
}

/// The action that the text, which is not empty, begins with.
std::optional<PackedAction> read_action(std::string_view text) {
  const char letter = text.front();
  if (letter == '!') return read_forfeit(text);
  std::optional<Action> action;
  if (letter >= first_letter && letter <= last_letter) action = usual_step(letter);
  if (letter == reset_letter) action = Action::reset();
  if (letter == '(') action = read_unusual_step(text);
  // Other forms of the same action are refused.
  if (!action || !text.starts_with(text_of(*action))) return std::nullopt;
  return PackedAction{*action, text_of(*action).size()};
}

void read_actions(std::string_view text, JsonFields& fields, RunRecord& run) {
  for (std::size_t at = 0; at < text.size();) {
    if (run.steps.size() == longest_record) return fields.fail(fmt::format("has more than {} actions", longest_record));
    const auto packed = read_action(text.substr(at));
    if (!packed) return fields.fail(fmt::format("has no action at character {} of 'actions'", at + 1));
    StepRecord step;
    step.step = static_cast<int>(run.steps.size()) + 1;
    step.action = packed->action;
    run.steps.push_back(step);
    at += packed->length;
  }
}

std::uint64_t read_seed(const ReadJson& seed, JsonFields& fields) {
  if (seed.is_number_unsigned()) return seed.get<std::uint64_t>();
  const auto number = parse_whole<std::uint64_t>(seed.is_string() ? seed.get<std::string>() : "");
  if (!number) fields.fail("has a seed that is not a number from 0 to 2^64 - 1");
  return number.value_or(0);
}

void read_outcome(const std::string& name, JsonFields& fields, RecordFile& file) {
  file.ended = true;
  if (const auto outcome = outcome_of(name))
    file.run.outcome = *outcome;
  else
    fields.fail("has an outcome that this version does not know");
}

/// Reads the fields that may be missing; returns what is wrong, or nothing.
std::string read_rest(const ReadJson& json, JsonFields& fields, RecordFile& file) {
  file.ended = false;
  if (fields.has("seed")) file.seed = read_seed(json["seed"], fields);
  if (fields.has("world")) file.world = fields.text("world");
  if (fields.has("outcome")) read_outcome(fields.text("outcome"), fields, file);
  if (fields.has("last_words")) file.run.last_words = fields.text("last_words").substr(0, longest_last_words);
  std::string error = fields.error();
  if (error.empty() && fields.has("rules")) error = read_record_rules(json["rules"], file.rules);
  if (error.empty() && fields.has("counts")) error = read_record_counts(json["counts"], file.run.counts);
  return error;
}

}  // namespace

Json pack_record(const RecordFile& file) {
  Json json = {{"mouse", file.mouse}, {"maze", file.maze_name}};
  if (file.seed <= largest_number)
    json["seed"] = file.seed;
  else
    json["seed"] = fmt::format("{}", file.seed);
  if (!file.world.empty()) json["world"] = file.world;
  if (file.rules != Rules())
    json["rules"] = {
        {"budget", file.rules.budget}, {"search_factor", file.rules.search_factor}, {"stride", file.rules.stride}};
  std::string actions;
  for (const StepRecord& step : file.run.steps) actions += text_of(step.action);
  json["actions"] = std::move(actions);
  if (file.ended) json["outcome"] = name_of(file.run.outcome);
  if (!file.run.last_words.empty()) json["last_words"] = file.run.last_words;
  for (const Count& count : file.run.counts) json["counts"][count.name] = count.value;
  return json;
}

UnpackResult unpack_record(const ReadJson& json, const Maze& maze) {
  RecordFile file;
  JsonFields fields(json, "record");
  file.maze = maze;
  file.mouse = fields.text("mouse");
  file.maze_name = fields.text("maze");
  read_actions(fields.text("actions"), fields, file.run);
  std::string error = read_rest(json, fields, file);
  if (!error.empty()) return {std::nullopt, std::move(error)};
  constexpr GivenFields none = {false, false, false, false, false};
  file.given.assign(file.run.steps.size(), none);
  file.given_end = none;
  return {std::move(file), ""};
}

}  // namespace labmouse
