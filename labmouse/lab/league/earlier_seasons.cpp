#include "labmouse/lab/league/earlier_seasons.hpp"

#include <fmt/format.h>

#include <set>

#include "labmouse/functions/sha256.hpp"
#include "labmouse/lab/mazes/secret_mazes.hpp"
#include "labmouse/lab/text/json_fields.hpp"
#include "labmouse/lab/text/json_problem.hpp"
#include "labmouse/lab/text/printable.hpp"

namespace labmouse {
namespace {

constexpr std::size_t most_seasons = 1000, most_mice = 10'000;

/// Reads seasons; what is wrong with the first wrong one is in `error`.
class SeasonReader {
 public:
  std::string error;

  /// @param json an object with `season` and `mice`.
  EarlierSeason season(const ReadJson& json, const std::string& path) {
    JsonFields fields(json, path);
    JsonFields about(fields.value("season"), path + "season");
    EarlierSeason season;
    season.title = name(about, "title");
    season.world = name(about, "world");
    season.mazes = about.whole("examination_mazes", 1, most_secret_mazes);
    season.seed_hash = hash(about, "examination_seed_sha256");
    note(about);
    const ReadJson& mice = fields.list("mice");
    if (mice.size() > most_mice) fields.reject(fmt::format("'{}mice' has more than {} entries", path, most_mice));
    note(fields);
    std::set<std::string> names;
    for (std::size_t i = 0; i < mice.size() && error.empty(); ++i) {
      season.mice.push_back(mouse(mice[i], fmt::format("{}mice[{}]", path, i), static_cast<int>(mice.size())));
      if (!names.insert(season.mice.back().name).second && error.empty())
        error = fmt::format("'{}mice' has two mice of one name", path);
    }
    return season;
  }

  /// Why the season is not over, or its seed is another one.
  void check_seed(const ReadJson& json) {
    JsonFields about(json.at("season"), "season");
    if (!about.has("examination_seed"))
      about.reject("the season is not over: `labmouse league publish --reveal` writes results with the seed");
    else if (sha256_text(about.text("examination_seed")) != about.text("examination_seed_sha256"))
      about.fail("has a seed of another hash");
    note(about);
  }

  void note(const JsonFields& fields) {
    if (error.empty()) error = fields.error();
  }

 private:
  static std::string name(JsonFields& fields, const char* key) {
    std::string text = fields.text(key);
    constexpr std::size_t longest = 1000;
    if (fields.error().empty() && (text.empty() || text.size() > longest || shown(text) != text))
      fields.fail(fmt::format("has a {} that is empty, longer than {} bytes or not printable", key, longest));
    return text;
  }

  static std::string hash(JsonFields& fields, const char* key) {
    std::string text = fields.text(key);
    if (fields.error().empty() && !is_sha256_text(text)) fields.fail(fmt::format("has a {} that is no hash", key));
    return text;
  }

  EarlierMouse mouse(const ReadJson& json, const std::string& path, int mice) {
    JsonFields fields(json, path);
    EarlierMouse mouse;
    mouse.name = name(fields, "name");
    mouse.rank = fields.whole("rank", 1, mice);
    mouse.share = fields.number("share_of_best", 0.0, 1.0);
    const ReadJson& interval = fields.list("share_interval");
    const auto is_share = [](const ReadJson& value) {
      return value.is_number() && value.get<double>() >= 0.0 && value.get<double>() <= 1.0;
    };
    if (interval.size() == 2 && is_share(interval[0]) && is_share(interval[1]))
      mouse.interval = {interval[0].get<double>(), interval[1].get<double>()};
    else
      fields.fail("has a share_interval that is no pair of shares");
    if (fields.has("files_sha256")) mouse.hash = hash(fields, "files_sha256");
    note(fields);
    return mouse;
  }
};

}  // namespace

EarlierSeasonsResult read_earlier_seasons(std::string_view text) {
  const ReadJson json = read_json(text);
  if (json.is_discarded()) {
    const Problem problem = json_problem(text);
    return {{}, shown(fmt::format("line {}, column {}: {}", problem.line, problem.column, problem.reason))};
  }
  JsonFields fields(json, "");
  if (fields.text("labmouse") != "league" || fields.whole("format", 1, 1) != 1 || !fields.error().empty())
    return {{}, "is no results.json of `labmouse league publish`"};
  SeasonReader reader;
  std::vector<EarlierSeason> seasons;
  if (fields.has("earlier_seasons")) {
    const ReadJson& earlier = fields.list("earlier_seasons");
    if (earlier.size() >= most_seasons)
      fields.reject(fmt::format("'earlier_seasons' has {} entries or more", most_seasons));
    reader.note(fields);
    for (std::size_t i = 0; i < earlier.size() && reader.error.empty(); ++i)
      seasons.push_back(reader.season(earlier[i], fmt::format("earlier_seasons[{}].", i)));
  }
  if (reader.error.empty()) seasons.push_back(reader.season(json, ""));
  if (reader.error.empty()) reader.check_seed(json);
  if (!reader.error.empty()) return {{}, shown(reader.error)};
  return {std::move(seasons), ""};
}

Json json_of(const std::vector<EarlierSeason>& seasons) {
  Json all = Json::array();
  for (const EarlierSeason& season : seasons) {
    Json mice = Json::array();
    for (const EarlierMouse& mouse : season.mice) {
      mice.push_back({{"name", mouse.name},
                      {"rank", mouse.rank},
                      {"share_of_best", mouse.share},
                      {"share_interval", {mouse.interval.low, mouse.interval.high}}});
      if (!mouse.hash.empty()) mice.back()["files_sha256"] = mouse.hash;
    }
    all.push_back({{"season",
                    {{"title", season.title},
                     {"world", season.world},
                     {"examination_mazes", season.mazes},
                     {"examination_seed_sha256", season.seed_hash}}},
                   {"mice", std::move(mice)}});
  }
  return all;
}

}  // namespace labmouse
