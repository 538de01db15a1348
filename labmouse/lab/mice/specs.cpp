#include "labmouse/lab/mice/specs.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>

#include "labmouse/lab/bounds/bounds.hpp"
#include "labmouse/lab/mice/external_specs.hpp"
#include "labmouse/lab/mice/mice_file_specs.hpp"
#include "labmouse/lab/mice/named_spec.hpp"
#include "labmouse/lab/mice/prior_file.hpp"
#include "labmouse/lab/mice/prior_learning.hpp"
#include "labmouse/lab/system/files.hpp"
#include "labmouse/lab/text/former_names.hpp"
#include "labmouse/lab/text/printable.hpp"
#include "labmouse/strategies/builtin_mice.hpp"

namespace labmouse {
namespace {

constexpr std::string_view oracle_name = "oracle";

Contestant oracle() {
  Contestant contestant;
  contestant.name = oracle_name;
  contestant.reference = true;
  const auto make = [](const Maze& maze, const Briefing& briefing) {
    return make_oracle(maze, {.stride = briefing.motion.longest});
  };
  contestant.kind = Decider{make};
  return contestant;
}

/// Whether the mouse uses its default prior, which a prior learned from mazes could replace.
bool can_learn(const BuiltinMouse& entry, const Settings& settings) {
  return std::any_of(entry.parameters.begin(), entry.parameters.end(), [&](const Parameter& parameter) {
    return parameter.type == ParameterType::prior && settings.choice(parameter.name) == parameter.default_value;
  });
}

Contestant contestant_of(const BuiltinMouse& entry, Settings settings) {
  Contestant contestant;
  contestant.name = entry.name;
  for (std::size_t i = 0; i < entry.parameters.size(); ++i)
    if (const Setting& setting = settings.all()[i]; setting.value != entry.parameters[i].default_value)
      contestant.name += ":" + setting.name + "=" + setting.value;
  contestant.uses_chance = entry.uses_chance(settings);
  Decider decider;
  if (entry.walks())
    decider.make = [&entry, settings](const Maze&, const Briefing& briefing) { return entry.make(briefing, settings); };
  if (entry.drives())
    decider.drive = [&entry, settings](const Maze&, const Briefing& briefing) {
      return entry.drive(briefing, settings);
    };
  contestant.kind = std::move(decider);
  if (can_learn(entry, settings))
    contestant.taught = [&entry, settings](const std::vector<const Maze*>& training, const Rules& rules,
                                           const std::atomic<bool>* stop) {
      Settings learned = settings;
      learned.attach(std::make_shared<const WallPrior>(learn_prior(training, rules, stop)));
      return contestant_of(entry, std::move(learned));
    };
  contestant.settings = std::move(settings);
  return contestant;
}

/// A built-in mouse with the parts of its controller that `program` has.
Contestant with_parts(const Contestant& own, const Contestant& program) {
  Contestant mouse = program;
  const std::string& spec = spec_of(program);
  mouse.name = own.name + spec.substr(parts_place(spec));
  mouse.spec.clear();
  mouse.settings = own.settings;
  mouse.uses_chance = own.uses_chance;
  if (const auto* decider = std::get_if<Decider>(&own.kind)) mouse.kind = Decider{{}, decider->drive};
  if (own.taught)
    mouse.taught = [teach = own.taught, program](const std::vector<const Maze*>& training, const Rules& rules,
                                                 const std::atomic<bool>* stop) {
      return with_parts(teach(training, rules, stop), program);
    };
  return mouse;
}

/// Whether a text cannot be a mouse's name, but the path of a program or a part of a command.
bool looks_like_a_program(std::string_view name) {
  return name.find_first_of("/ ~") != std::string_view::npos || name.ends_with(".py") || name.ends_with(".js");
}

std::string unknown_parameter(const BuiltinMouse& entry, std::string_view key) {
  if (entry.parameters.empty())
    return fmt::format("mouse '{}' has no parameters, so '{}' cannot be set", entry.name, key);
  std::vector<std::string_view> names;
  for (const Parameter& parameter : entry.parameters) names.push_back(parameter.name);
  const auto near = nearest_name(key, names);
  return fmt::format("mouse '{}' has no parameter '{}'; {}", entry.name, key,
                     near.empty() ? fmt::format("its parameters are {}", fmt::join(names, ", "))
                                  : fmt::format("did you mean '{}'?", near));
}

/// Hint for a value that is neither a choice nor a readable file.
std::string hint_for(const Parameter& parameter, std::string_view value) {
  const auto near = value.find_first_of("./") == std::string::npos ? nearest_name(value, choices_of(parameter)) : "";
  return near.empty() ? "note that ':' and ',' end a path here" : fmt::format("did you mean '{}'?", near);
}

/// How the files of a SPEC are read. The user may name a pipe. A SPEC from a file may not, because reading a pipe
/// without a writer would block.
using ReadFile = FileContent (*)(const std::string& path, std::size_t most_bytes);

/// Attaches the prior of a file, or none if the value is a choice; returns the error, or an empty text.
std::string attach_prior(const Parameter& parameter, const std::string& value, ReadFile read_it, Settings& settings) {
  const auto choices = choices_of(parameter);
  settings.attach(nullptr);
  if (std::find(choices.begin(), choices.end(), value) != choices.end()) return "";
  // The value becomes part of the mouse's name in output.
  if (shown(value) != value)
    return fmt::format("the name of prior file '{}' contains unprintable characters", shown(value));
  const FileContent file = read_it(value, std::size_t{1} << 20U);
  if (!file.error.empty()) return fmt::format("prior file {}: {}; {}", value, file.error, hint_for(parameter, value));
  const ReadPriorResult read = read_prior(file.content);
  if (!read.prior) {
    const Problem& first = read.problems.front();
    const std::string place = first.line > 0 ? fmt::format(":{}:{}", first.line, first.column) : "";
    return fmt::format("prior file {}{}: {}", value, place, first.reason);
  }
  settings.attach(std::make_shared<const WallPrior>(*read.prior));
  return "";
}

/// Applies one `key=value`; returns the error, or an empty text.
std::string apply(const BuiltinMouse& entry, std::string_view assignment, ReadFile read, Settings& settings) {
  const auto equals = assignment.find('=');
  if (equals == std::string_view::npos)
    return fmt::format("'{}' of mouse '{}' is not of the form key=value", assignment, entry.name);
  std::string_view key = assignment.substr(0, equals), value = assignment.substr(equals + 1);
  const auto named = [&](std::string_view name) {
    return std::find_if(entry.parameters.begin(), entry.parameters.end(),
                        [&](const auto& p) { return p.name == name; });
  };
  auto parameter = named(key);
  if (parameter == entry.parameters.end()) parameter = named(key = today_key(key));
  if (parameter == entry.parameters.end()) return unknown_parameter(entry, assignment.substr(0, equals));
  if (parameter->name == "map") value = today_value(value);
  if (const auto reason = check_value(*parameter, value); !reason.empty())
    return fmt::format("value '{}' of parameter '{}' of mouse '{}' {}", value, key, entry.name, reason);
  settings.set(key, canonical_value(*parameter, value));
  return parameter->type == ParameterType::prior ? attach_prior(*parameter, std::string(value), read, settings) : "";
}

/// Reads one mouse into the list; returns the error, or an empty text.
std::string read_spec(std::string_view spec, ReadFile read, std::vector<Contestant>& contestants) {
  const auto colon = spec.find(':');
  const auto name = spec.substr(0, colon);
  if (name.empty()) return "a mouse has no name; write name[:key=value]..., separated by commas";
  if (name == oracle_name) {
    if (colon != std::string_view::npos) return "the oracle has no parameters";
    contestants.push_back(oracle());
    return "";
  }
  const BuiltinMouse* entry = find_mouse(name);
  if (entry == nullptr) return unknown_mouse(name);
  Settings settings(entry->parameters);
  std::vector<std::string_view> keys;
  auto rest = colon == std::string_view::npos ? std::string_view() : spec.substr(colon + 1);
  for (bool more = colon != std::string_view::npos; more;) {
    const auto next = rest.find(':');
    const auto assignment = rest.substr(0, next);
    if (auto error = apply(*entry, assignment, read, settings); !error.empty()) return error;
    keys.push_back(assignment.substr(0, assignment.find('=')));
    if (std::count(keys.begin(), keys.end(), keys.back()) > 1)
      return fmt::format("parameter '{}' of mouse '{}' is given twice", keys.back(), entry->name);
    more = next != std::string_view::npos;
    if (more) rest.remove_prefix(next + 1);
  }
  contestants.push_back(contestant_of(*entry, std::move(settings)));
  return "";
}

/// Of several mice with the same name, keeps the first.
void drop_repetitions(std::vector<Contestant>& mice) {
  for (std::size_t i = 0; i < mice.size(); ++i)
    mice.erase(std::remove_if(mice.begin() + static_cast<std::ptrdiff_t>(i) + 1, mice.end(),
                              [&](const Contestant& mouse) { return mouse.name == mice[i].name; }),
               mice.end());
}

SpecResult refused(std::string error) { return {{}, std::move(error)}; }

SpecResult read_external_variant(std::string_view spec, const Setting& setting, const ExternalOptions& options) {
  const std::string place = "{" + setting.name + "}";
  std::string text(spec);
  if (text.find(place) == std::string::npos)
    return refused(fmt::format("mouse '{}' has no place for the value; write {} in its command where the value belongs",
                               spec, place));
  for (auto at = text.find(place); at != std::string::npos; at = text.find(place, at + setting.value.size()))
    text.replace(at, place.size(), setting.value);
  return read_specs(text, options);
}

/// Reads one mouse of the user, which may have external parts, into the list; returns the error, or an empty text.
std::string read_users_spec(std::string_view spec, const ExternalOptions& options, std::vector<Contestant>& mice) {
  const auto place = parts_place(spec);
  if (auto error = read_spec(spec.substr(0, place), read_file, mice); !error.empty()) return error;
  if (place == std::string_view::npos) return "";
  SpecResult program;
  read_external_spec(spec, options, program);
  if (program.error.empty()) mice.back() = with_parts(mice.back(), program.contestants.front());
  return program.error;
}

/// The ReadOwnMouse for mice files.
std::string read_own(std::string_view spec, const ExternalOptions& options, const Setting* value,
                     std::vector<Contestant>& mice) {
  if (auto error = read_users_spec(spec, options, mice); !error.empty() || value == nullptr) return error;
  SpecResult variant = read_variant(mice.back(), {value, 1});
  if (variant.error.empty()) mice.back() = std::move(variant.contestants.front());
  return variant.error;
}

/// Source of a SPEC: only the user's may start programs and open mice files.
enum class Origin { of_the_user, of_a_file };

std::string_view without_blanks_behind(std::string_view text) { return text.substr(0, text.find_last_not_of(' ') + 1); }

/// Reads the mice of one text into the result; on failure sets its error.
void read_into(std::string_view text, Origin origin, const ExternalOptions& options, SpecResult& result) {
  for (bool more = true; more && result.error.empty();) {
    text.remove_prefix(std::min(text.find_first_not_of(' '), text.size()));
    const auto [name, spec] = named_spec(text);
    if (shown(name) != name) {
      result.error = fmt::format("the name '{}' contains unprintable characters", shown(name));
      return;
    }
    if (origin == Origin::of_a_file && (is_external_spec(spec) || is_mice_file_spec(spec))) {
      result.error = fmt::format("'{}' is no built-in mouse; a SPEC in a file starts no program", shown(spec));
      return;
    }
    if (is_mice_file_spec(spec) && !name.empty()) {
      result.error = fmt::format("a mice file cannot be named '{}'; its mice have their own names", name);
      return;
    }
    if (is_mice_file_spec(spec)) return read_mice_file_spec(spec, options, nullptr, read_own, result);
    const auto comma = is_external_spec(spec) ? std::string_view::npos : spec.find(',');
    if (is_external_spec(spec) && parts_place(spec) == std::string_view::npos)
      read_external_spec(spec, options, result);
    else if (origin == Origin::of_the_user)
      result.error = read_users_spec(without_blanks_behind(spec.substr(0, comma)), options, result.contestants);
    else
      result.error = read_spec(without_blanks_behind(spec.substr(0, comma)), read_found_file, result.contestants);
    if (!result.error.empty()) return;
    if (!name.empty()) rename(result.contestants.back(), std::string(name));
    more = comma != std::string_view::npos;
    if (more) text = spec.substr(comma + 1);
  }
}

/// Whether both are the same mouse. Equal SPECs of two mice files may differ in arguments or folders.
bool is_same(const Contestant& mouse, const Contestant& other) {
  return spec_of(mouse) == spec_of(other) && mouse.mice_file == other.mice_file;
}

std::string origin_of(const Contestant& mouse) {
  return mouse.mice_file.empty() ? spec_of(mouse) : fmt::format("{} in {}", spec_of(mouse), mouse.mice_file);
}

/// Removes duplicates; returns an error if two different mice have the same name.
std::string drop_repetitions_or_refuse(std::vector<Contestant>& mice) {
  for (std::size_t i = 0; i < mice.size(); ++i)
    for (std::size_t j = i + 1; j < mice.size(); ++j)
      if (mice[i].name == mice[j].name && !is_same(mice[i], mice[j]))
        return fmt::format("two mice are named '{}': {}, and {}; give each a name of its own, as in NAME=SPEC",
                           mice[i].name, origin_of(mice[i]), origin_of(mice[j]));
  drop_repetitions(mice);
  return "";
}

/// The single mouse of a SPEC with that value of a parameter.
SpecResult read_with_value(std::string_view spec, const Setting& value, const ExternalOptions& options) {
  const bool has_place = spec.find("{" + value.name + "}") != std::string_view::npos;
  if (is_external_spec(spec) && (has_place || parts_place(spec) == std::string_view::npos))
    return read_external_variant(spec, value, options);
  if (!is_mice_file_spec(spec)) return read_variant(spec, {&value, 1}, options);
  SpecResult result;
  read_mice_file_spec(spec, options, &value, read_own, result);
  if (!result.error.empty()) return {{}, result.error, result.problems};
  if (result.contestants.size() != 1)
    return refused(
        fmt::format("'{0}' names {1} mice; name exactly one, as in {0}:NAME", spec, result.contestants.size()));
  return result;
}

}  // namespace

const BuiltinMouse* entry_of(const Contestant& mouse) {
  const std::string_view spec = spec_of(mouse);
  return find_mouse(spec.substr(0, spec.find(':')));
}

std::string unknown_mouse(std::string_view name) {
  // named_spec() found no name before `=`, so that text contains a sign that names must not have.
  if (const auto equals = name.find('='); equals != std::string_view::npos && find_mouse(name.substr(equals + 1)))
    return fmt::format("'{}' is no name for a mouse; a name in NAME=SPEC has no blank, '/', ':' or ','",
                       name.substr(0, equals));
  if (name.ends_with(".py") && name.find(' ') == std::string_view::npos)
    return fmt::format(
        "unknown mouse '{0}'; write 'capstone:{0}' for a capstone robot, 'program:python3 {0}' for a program or "
        "'mms:python3 "
        "{0}' for one of mms, in quotes",
        name);
  if (looks_like_a_program(name))
    return fmt::format(
        "unknown mouse '{}'; to race your own program, write 'capstone:FILE', 'program:COMMAND', 'controller:COMMAND', "
        "'firmware:FILE' or 'mms:COMMAND', in quotes",
        name);
  std::vector<std::string_view> names = {oracle_name, "capstone", "program", "controller", "firmware", "mms"};
  for (const BuiltinMouse* entry : all_mice()) names.push_back(entry->name);
  std::string near(nearest_name(name, names));
  if (near == "capstone" || near == "firmware") near += ":FILE";
  if (near == "program" || near == "controller" || near == "mms") near += ":COMMAND";
  const auto hint = near.empty() ? std::string() : fmt::format("did you mean '{}'? ", near);
  return fmt::format("unknown mouse '{}'; {}`labmouse mice` lists all mice", name, hint);
}

namespace {

SpecResult read_texts(std::span<const std::string> texts, Origin origin, const ExternalOptions& options) {
  SpecResult result;
  for (const std::string& text : texts)
    if (result.error.empty()) read_into(text, origin, options, result);
  if (result.error.empty()) result.error = drop_repetitions_or_refuse(result.contestants);
  if (!result.error.empty()) result.contestants.clear();
  return result;
}

}  // namespace

SpecResult read_specs(std::span<const std::string> texts, const ExternalOptions& options) {
  return read_texts(texts, Origin::of_the_user, options);
}

SpecResult read_builtin_specs(std::string_view text) {
  const std::string whole(text);
  return read_texts({&whole, 1}, Origin::of_a_file, {});
}

SpecResult read_specs(std::string_view text, const ExternalOptions& options) {
  const std::string whole(text);
  return read_specs({&whole, 1}, options);
}

SpecResult read_variants(std::string_view spec, std::string_view parameter, std::span<const std::string> values,
                         const ExternalOptions& options) {
  SpecResult result;
  for (const std::string& value : values) {
    const Setting setting = {std::string(parameter), value};
    SpecResult variant = read_with_value(named_spec(spec).spec, setting, options);
    if (!variant.error.empty()) return variant;
    result.contestants.push_back(std::move(variant.contestants.front()));
  }
  drop_repetitions(result.contestants);
  return result;
}

SpecResult read_variant(std::string_view spec, std::span<const Setting> values, const ExternalOptions& options) {
  SpecResult result = read_specs(spec, options);
  if (!result.error.empty()) return result;
  if (result.contestants.size() != 1)
    return refused(fmt::format("'{}' names {} mice; name exactly one", spec, result.contestants.size()));
  return read_variant(result.contestants.front(), values);
}

SpecResult read_variant(const Contestant& mouse, std::span<const Setting> values) {
  const BuiltinMouse* entry = entry_of(mouse);
  if (entry == nullptr)
    return refused(mouse.reference ? "the oracle has no parameters"
                                   : fmt::format("mouse '{}' has no parameters", mouse.name));
  Settings settings = mouse.settings;
  for (const Setting& value : values)
    if (auto error = apply(*entry, fmt::format("{}={}", value.name, value.value), read_file, settings); !error.empty())
      return refused(error);
  Contestant variant = contestant_of(*entry, std::move(settings));
  return {{mouse.parts ? with_parts(variant, mouse) : std::move(variant)}, ""};
}

namespace {

bool counts_in_steps(const Parameter& parameter) {
  return parameter.scope == ParameterScope::steps || parameter.scope == ParameterScope::both;
}
bool counts_with_errors(const Parameter& parameter) { return parameter.scope != ParameterScope::steps; }
bool counts_in_seconds(const Parameter& parameter) {
  return counts_with_errors(parameter) && parameter.scope != ParameterScope::errors;
}
using Counts = bool (*)(const Parameter&);

/// In which worlds a parameter counts.
std::string_view worlds_of(ParameterScope scope) {
  switch (scope) {
    case ParameterScope::steps:
      return "in steps";
    case ParameterScope::seconds:
      return "in seconds";
    case ParameterScope::errors:
      return "in the physical world and the failure model";
    case ParameterScope::both:
      break;
  }
  return "everywhere";
}

/// An error if a setting of the mouse that is not the default has no effect in a world; else empty.
std::string refuse_idle_settings(const Contestant& mouse, Counts counts, std::string_view where) {
  const BuiltinMouse* entry = entry_of(mouse);
  for (std::size_t i = 0; entry != nullptr && i < entry->parameters.size(); ++i) {
    const Parameter& parameter = entry->parameters[i];
    if (counts(parameter) || mouse.settings.all()[i].value == parameter.default_value) continue;
    return fmt::format("parameter '{}' of mouse '{}' has no effect {}, only {} (see `labmouse mice {}`)",
                       parameter.name, entry->name, where, worlds_of(parameter.scope), entry->name);
  }
  return "";
}

/// An error for parts of a controller in a world without one.
std::string idle_parts(const Contestant& mouse, std::string_view where) {
  return fmt::format("parameter 'parts' of mouse '{}' has no effect {}, only in the physical world", mouse.name, where);
}

/// The settings whose parameters satisfy a condition.
template <class Holds>
Settings settings_where(const Contestant& mouse, const BuiltinMouse& entry, Holds holds) {
  std::vector<Parameter> parameters;
  std::copy_if(entry.parameters.begin(), entry.parameters.end(), std::back_inserter(parameters), holds);
  Settings settings(parameters);
  for (const Parameter& parameter : parameters) settings.set(parameter.name, mouse.settings.choice(parameter.name));
  return settings;
}

}  // namespace

std::string refuse_to_drive(std::span<const Contestant> mice, Driving driving) {
  if (driving != Driving::by_controller)
    for (const Contestant& mouse : mice)
      if (mouse.parts) return idle_parts(mouse, driving == Driving::ideal ? "in seconds" : "in the failure model");
  const auto stays = std::find_if(mice.begin(), mice.end(), [](const Contestant& mouse) { return !mouse.drives(); });
  if (stays == mice.end()) {
    for (const Contestant& mouse : mice)
      if (std::string reason = driving == Driving::ideal
                                   ? refuse_idle_settings(mouse, counts_in_seconds, "in seconds")
                                   : refuse_idle_settings(mouse, counts_with_errors, "where a mouse drives");
          !reason.empty())
        return reason;
    return "";
  }
  if (std::holds_alternative<ControllerProgram>(stays->kind))
    return fmt::format("'{}' controls motors, so it drives in the world physical only", stays->name);
  std::vector<std::string_view> drivers;
  for (const BuiltinMouse* entry : all_mice())
    if (entry->drives()) drivers.push_back(entry->name);
  return fmt::format("mouse '{}' cannot drive in seconds; mice that can are external ones and {}", stays->name,
                     fmt::join(drivers, ", "));
}

std::string refuse_to_walk(const Contestant& mouse) {
  if (mouse.parts) return idle_parts(mouse, "in steps");
  if (!mouse.walks())
    return fmt::format("mouse '{}' cannot race in steps; it races in the world {}", mouse.name,
                       std::holds_alternative<MmsProgram>(mouse.kind)          ? "mms"
                       : std::holds_alternative<ControllerProgram>(mouse.kind) ? "physical"
                                                                               : "seconds");
  return refuse_idle_settings(mouse, counts_in_steps, "in steps");
}

Settings settings_in_seconds(const Contestant& mouse) {
  const BuiltinMouse* entry = entry_of(mouse);
  if (entry == nullptr) return {};
  if (!entry->walks()) return mouse.settings;
  return settings_where(mouse, *entry, [&](const Parameter& parameter) {
    return parameter.scope == ParameterScope::both ||
           (parameter.scope == ParameterScope::seconds &&
            mouse.settings.choice(parameter.name) != parameter.default_value);
  });
}

Settings settings_in_steps(const Contestant& mouse) {
  const BuiltinMouse* entry = entry_of(mouse);
  if (entry == nullptr) return mouse.settings;
  return settings_where(mouse, *entry, counts_in_steps);
}

std::vector<Contestant> all_contestants() {
  std::vector<Contestant> contestants;
  for (const BuiltinMouse* entry : all_mice())
    contestants.push_back(contestant_of(*entry, Settings(entry->parameters)));
  return contestants;
}

}  // namespace labmouse
