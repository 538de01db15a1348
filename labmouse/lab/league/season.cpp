#include "labmouse/lab/league/season.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "labmouse/functions/sha256.hpp"
#include "labmouse/lab/mice_files/limit_table.hpp"

namespace labmouse {
namespace {

constexpr auto season_keys = std::to_array<std::string_view>(
    {"title", "labmouse", "frozen", "world", "settings", "limits", "examination", "examination_seed_sha256"});
constexpr auto examination_keys = std::to_array<std::string_view>({"count", "kind", "side"});
constexpr int mib_bits = 20;

SecretMazes read_examination(const toml::table& table, TomlFields& fields) {
  SecretMazes mazes = Season().examination;
  const toml::node* node = table.get("examination");
  if (node == nullptr) return mazes;
  const toml::table* examination = node->as_table();
  if (examination == nullptr) {
    fields.add(node->source().begin, "'examination' must be a table, such as { count = 20 }");
    return mazes;
  }
  fields.refuse_unknown(*examination, examination_keys);
  mazes.count = fields.whole(*examination, "count", 1, most_secret_mazes).value_or(mazes.count);
  mazes.side = fields.whole(*examination, "side", 1, max_side).value_or(mazes.side);
  if (examination->contains("kind")) mazes.kind = fields.text(*examination, "kind");
  if (const std::string reason = refuse(mazes); !reason.empty()) fields.add(node->source().begin, reason);
  return mazes;
}

std::string read_hash(const toml::table& table, TomlFields& fields) {
  const std::string_view key = "examination_seed_sha256";
  const toml::node* node = table.get(key);
  if (node == nullptr) {
    fields.add({1, 1}, fmt::format("has no {}; `labmouse league init` writes it", key));
    return "";
  }
  std::string hash = fields.text(table, key);
  if (!hash.empty() && !is_sha256_text(hash))
    fields.add(node->source().begin, fmt::format("'{}' must be 64 hexadecimal digits", key));
  return hash;
}

double seconds(std::chrono::milliseconds time) { return std::chrono::duration<double>(time).count(); }

std::string setting_text(const WorldSetting& setting, const std::string& text) {
  const bool is_text = setting.kind == WorldSetting::Kind::text;
  const bool is_name = std::any_of(setting.named.begin(), setting.named.end(),
                                   [&](const NamedNumber& number) { return number.name == text; });
  return is_text || is_name ? quoted_toml(text) : text;
}

}  // namespace

std::string refuse_for_league(const World& world) {
  if (world.traits().has_ratio) return "";
  return fmt::format("the scores of the world {} have no best possible one to be measured by; choose another world",
                     world.traits().name);
}

SeasonResult read_season(std::string_view text) {
  const TomlText toml = parse_toml(text);
  if (!toml.problems.empty()) return {{}, toml.problems};
  TomlFields fields;
  fields.refuse_unknown(toml.table, season_keys);
  Season season;
  season.title = fields.text(toml.table, "title");
  if (season.title.empty()) season.title = "labmouse league";
  season.version = fields.text(toml.table, "labmouse");
  season.is_frozen = toml.table.contains("frozen") && fields.flag(toml.table, "frozen");
  season.world = read_world(toml.table, fields);
  season.examination = read_examination(toml.table, fields);
  season.seed_hash = read_hash(toml.table, fields);
  season.limits = read_limits(toml.table, fields).over({});
  if (!fields.good()) return {{}, fields.problems()};
  return {std::move(season), {}};
}

std::string season_text(const Season& season) {
  std::string text =
      fmt::format("# A season of labmouse league. It stays as it is until the season ends.\ntitle = {}\n",
                  quoted_toml(season.title));
  if (!season.version.empty()) text += fmt::format("labmouse = {}\n", quoted_toml(season.version));
  if (season.is_frozen) text += "frozen = true\n";
  text +=
      fmt::format("world = {}\n# SHA-256 of the secret seed of the examination mazes\nexamination_seed_sha256 = {}\n",
                  quoted_toml(season.world.entry->name), quoted_toml(season.seed_hash));
  if (!season.world.settings.empty()) text += "\n[settings]\n";
  for (const WorldSetting& setting : season.world.entry->settings)
    if (const auto chosen = season.world.settings.find(setting.name); chosen != season.world.settings.end())
      text += fmt::format("{} = {}\n", key_of(setting), setting_text(setting, chosen->second));
  text += fmt::format("\n[examination]\ncount = {}\nkind = {}\nside = {}\n", season.examination.count,
                      quoted_toml(season.examination.kind), season.examination.side);
  const ExternalLimits& limits = season.limits;
  return text + fmt::format(
                    "\n[limits]  # of each mouse: seconds, MiB\nstart = {}\ndecision = {}\nsilence = {}\ncontest = {}\n"
                    "memory = {}\nwritten = {}\nprocesses = {}\ncpu = {}\n",
                    seconds(limits.start), seconds(limits.decision), seconds(limits.silence), seconds(limits.contest),
                    limits.memory >> mib_bits, limits.written >> mib_bits, limits.processes, limits.processor_seconds);
}

std::string secret_text(const std::string& secret) {
  return "# The secret seed of the examination. Do not publish this file before the season ends.\n" + secret + "\n";
}

}  // namespace labmouse
