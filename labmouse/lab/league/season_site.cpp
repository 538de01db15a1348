#include "labmouse/lab/league/season_site.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>

#include "labmouse/functions/sha256.hpp"
#include "labmouse/lab/standings/race_json.hpp"
#include "labmouse/lab/standings/race_notes.hpp"
#include "labmouse/lab/standings/standings.hpp"
#include "labmouse/lab/store/contest_key.hpp"
#include "labmouse/lab/text/counted.hpp"
#include "labmouse/lab/text/json.hpp"
#include "labmouse/lab/text/packing.hpp"
#include "labmouse/lab/text/printable.hpp"

namespace labmouse {
namespace {

constexpr std::string_view style =
    "body{font-family:sans-serif;max-width:70em;margin:2em auto;padding:0 1em;line-height:1.5}"
    "table{border-collapse:collapse}td,th{border:1px solid #999;padding:.2em .5em;text-align:left}"
    "div{overflow-x:auto}.number{text-align:right}.shown{font-weight:bold}";

constexpr std::string_view promises =
    "A mouse that is a program runs in a sandbox: it sees a copy of its own folder, its interpreter and the programs "
    "of "
    "the system, and neither mazes, seeds, names of mazes, other entries nor the network.\n"
    "The sandbox does not hide the clock, the number of processors and how busy they are, and programs that run at the "
    "same time share processors and caches. It cannot rule out mistakes in the kernel of the system.\n";

/// The entry of that name; null for a built-in mouse.
const LeagueEntry* entry_of(const League& league, const std::string& name) {
  const auto found = std::find_if(league.entries.begin(), league.entries.end(),
                                  [&](const LeagueEntry& entry) { return entry.manifest.name == name; });
  return found == league.entries.end() ? nullptr : &*found;
}

/// How many contests of that mouse were finished.
int finished_of(const Race& race, const RankedMouse& mouse) {
  return static_cast<int>(std::count_if(race.results.begin(), race.results.end(), [&](const ContestResult& contest) {
    return contest.mouse == mouse.place && contest.score.has_value();
  }));
}

Json contests_of(const Race& race, std::size_t mouse) {
  Json contests = Json::array();
  for (const ContestResult& contest : race.results) {
    if (contest.mouse != mouse) continue;
    contests.push_back({{"maze", race.mazes[contest.maze].name},
                        {"outcome", contest.outcome},
                        {"score", contest.score ? Json(*contest.score) : Json(nullptr)},
                        {"share_of_best", share_of_best(race, contest).value_or(0.0)}});
  }
  return contests;
}

Json interval_of(const Interval& interval) { return {interval.low, interval.high}; }

Json mouse_json(const SeasonResults& results, const RankedMouse& mouse) {
  const Race& examination = results.races.examination.race;
  Json json = {{"name", mouse.name},
               {"rank", mouse.rank},
               {"share_of_best", mouse.mean},
               {"share_interval", interval_of(mouse.interval)},
               {"finished", finished_of(examination, mouse)}};
  if (const LeagueEntry* entry = entry_of(results.league, mouse.name)) {
    json["authors"] = entry->manifest.authors;
    json["licence"] = entry->manifest.licence;
    json["kind"] = entry->manifest.kind;
    json["launch"] = entry->manifest.launch;
    json["files_sha256"] = entry->hash;
  } else {
    json["builtin"] = true;
  }
  if (results.revealed) json["examination"] = contests_of(examination, mouse.place);
  json["practice"] = contests_of(results.races.practice.race, mouse.place);
  return json;
}

Json limits_json(const ExternalLimits& limits) {
  return {{"start_ms", limits.start.count()},     {"decision_ms", limits.decision.count()},
          {"silence_ms", limits.silence.count()}, {"contest_ms", limits.contest.count()},
          {"memory_bytes", limits.memory},        {"written_bytes", limits.written},
          {"processes", limits.processes},        {"processor_seconds", limits.processor_seconds}};
}

Json season_json(const SeasonResults& results) {
  const Season& season = results.league.season;
  Json json = {{"title", season.title},
               {"version", season.version},
               {"world", results.league.world->traits().name},
               {"conditions", Json::parse(conditions_text(*results.league.world))},
               {"unit", results.league.world->traits().unit},
               {"limits", limits_json(season.limits)},
               {"examination_mazes", season.examination.count},
               {"examination_kind", season.examination.kind},
               {"examination_side", season.examination.side},
               {"examination_seed_sha256", season.seed_hash}};
  if (!results.league.hash.empty()) json["season_sha256"] = results.league.hash;
  if (results.revealed) json["examination_seed"] = *results.revealed;
  json["practice"] = Json::array();
  for (const NamedMaze& maze : results.league.practice) json["practice"].push_back(maze.name);
  return json;
}

std::string percent(double share) { return fmt::format("{:.1f}", 100.0 * share); }

std::string interval_text(const Interval& interval) {
  return fmt::format("{} to {}", percent(interval.low), percent(interval.high));
}

std::string element(std::string_view name, std::string_view attribute, const std::string& html) {
  return fmt::format("<{0}{1}>{2}</{0}>", name, attribute, html);
}
std::string head(const std::string& html) { return element("th", "", html); }
std::string cell(const std::string& html) { return element("td", "", html); }
std::string number_cell(const std::string& html) { return element("td", " class=\"number\"", html); }

std::string ranking_html(const SeasonResults& results) {
  std::string html = "<div><table>\n<tr>" + head("rank") + head("mouse") + head("share of best, %") +
                     head("95 % interval") + head("finished") + "</tr>\n";
  for (const RankedMouse& mouse : results.ranking.mice)
    html += "<tr>" + number_cell(fmt::format("{}", mouse.rank)) +
            cell(xml_escaped(mouse.name) + (entry_of(results.league, mouse.name) == nullptr ? " (built-in)" : "")) +
            number_cell(percent(mouse.mean)) + cell(interval_text(mouse.interval)) +
            cell(fmt::format("{} of {}", finished_of(results.races.examination.race, mouse),
                             results.league.season.examination.count)) +
            "</tr>\n";
  return html + "</table></div>\n";
}

std::string pairs_html(const Ranking& ranking) {
  std::string html = "<div><table>\n<tr>" + head("");
  for (const RankedMouse& mouse : ranking.mice) html += head(xml_escaped(mouse.name));
  html += "</tr>\n";
  for (std::size_t a = 0; a < ranking.mice.size(); ++a) {
    html += "<tr>" + head(xml_escaped(ranking.mice[a].name));
    for (std::size_t b = 0; b < ranking.mice.size(); ++b) {
      const RankedPair& pair = ranking.pairs[a][b];
      const bool is_shown = pair.verdict == TestVerdict::better || pair.verdict == TestVerdict::worse;
      html += a == b ? cell("")
                     : element("td", is_shown ? " class=\"number shown\"" : " class=\"number\"",
                               fmt::format("{:+.1f}", 100.0 * pair.difference));
    }
    html += "</tr>\n";
  }
  return html + "</table></div>\n";
}

/// How that mouse did in the season; null where it was not in it.
const EarlierMouse* mouse_of(const EarlierSeason& season, const std::string& name) {
  const auto found = std::find_if(season.mice.begin(), season.mice.end(),
                                  [&](const EarlierMouse& mouse) { return mouse.name == name; });
  return found == season.mice.end() ? nullptr : &*found;
}

/// The names of all mice of all seasons: those of this season first, then those of the season before, and so on.
std::vector<std::string> names_of_all_seasons(const SeasonResults& results) {
  std::vector<std::string> names;
  std::set<std::string> known;
  const auto add = [&](const auto& mice) {
    for (const auto& mouse : mice)
      if (known.insert(mouse.name).second) names.push_back(mouse.name);
  };
  add(results.ranking.mice);
  const std::vector<EarlierSeason>& earlier = results.league.earlier;
  for (auto season = earlier.rbegin(); season != earlier.rend(); ++season) add(season->mice);
  return names;
}

/// A rank and a share, as in "2 (71.3)".
std::string place_cell(int rank, double share) { return number_cell(fmt::format("{} ({})", rank, percent(share))); }

/// The ranks of all mice in all seasons.
std::string history_html(const SeasonResults& results) {
  const std::vector<EarlierSeason>& earlier = results.league.earlier;
  std::string html = "<div><table>\n<tr>" + head("mouse");
  for (const EarlierSeason& season : earlier) html += head(xml_escaped(season.title));
  html += head(xml_escaped(results.league.season.title)) + "</tr>\n";
  std::map<std::string, const RankedMouse*> now;
  for (const RankedMouse& mouse : results.ranking.mice) now[mouse.name] = &mouse;
  for (const std::string& name : names_of_all_seasons(results)) {
    html += "<tr>" + head(xml_escaped(name));
    for (const EarlierSeason& season : earlier) {
      const EarlierMouse* mouse = mouse_of(season, name);
      html += mouse == nullptr ? cell("") : place_cell(mouse->rank, mouse->share);
    }
    const auto found = now.find(name);
    html += (found == now.end() ? cell("") : place_cell(found->second->rank, found->second->mean)) + "</tr>\n";
  }
  return html + "</table></div>\n";
}

std::string entries_html(const League& league) {
  std::string html =
      "<div><table>\n<tr>" + head("mouse") + head("authors") + head("licence") + head("started by") + "</tr>\n";
  for (const LeagueEntry& entry : league.entries)
    html += "<tr>" + cell(xml_escaped(entry.manifest.name)) +
            cell(xml_escaped(fmt::format("{}", fmt::join(entry.manifest.authors, ", ")))) +
            cell(xml_escaped(entry.manifest.licence)) +
            cell(xml_escaped(entry.manifest.kind + " " + entry.manifest.launch)) + "</tr>\n";
  return html + "</table></div>\n";
}

std::string lines_html(const std::string& text) {
  std::string html;
  for (std::size_t begin = 0; begin < text.size();) {
    const auto end = std::min(text.find('\n', begin), text.size());
    html += fmt::format("<p>{}</p>\n", xml_escaped(text.substr(begin, end - begin)));
    begin = end + 1;
  }
  return html;
}

std::string season_html(const SeasonResults& results) {
  const League& league = results.league;
  const Season& season = league.season;
  std::vector<std::string> practice;
  for (const NamedMaze& maze : league.practice) practice.push_back(maze.name);
  const ExternalLimits& limits = season.limits;
  constexpr double thousand = 1000.0;
  std::string text = fmt::format(
      "World {}, conditions {}. {}Practice mazes: {}. Examination: {} of the kind {}, {} by {} cells, one contest of "
      "each mouse in each maze.\nLimits of each program: start {} s, decision {} s, silence {} s, contest {} s, memory "
      "{} MiB, written {} MiB, {} processes, {} s of processor time.\nSHA-256 of the seed of the examination mazes, "
      "fixed before the season: {}\n",
      league.world->traits().name, conditions_text(*league.world), score_note(*league.world), fmt::join(practice, ", "),
      counted(static_cast<std::size_t>(season.examination.count), "maze", "mazes"), season.examination.kind,
      season.examination.side, season.examination.side, static_cast<double>(limits.start.count()) / thousand,
      static_cast<double>(limits.decision.count()) / thousand, static_cast<double>(limits.silence.count()) / thousand,
      static_cast<double>(limits.contest.count()) / thousand, limits.memory >> 20U, limits.written >> 20U,
      limits.processes, limits.processor_seconds, season.seed_hash);
  if (!league.hash.empty())
    text += fmt::format(
        "Hash of the season, fixed before it: {}. It is the SHA-256 of the file {}, which has the hash of each file "
        "that "
        "decides the ranking besides the entries.\n",
        league.hash, frozen_file_name);
  text += results.revealed ? fmt::format(
                                 "The seed: {}\nWith it in a file, `labmouse league publish` makes these files "
                                 "again from the folder of the season.\n",
                                 *results.revealed)
                           : "The seed is published after the season.\n";
  return lines_html(text);
}

}  // namespace

SeasonResults results_of(const League& league, const SeasonRaces& races, std::optional<std::string> revealed) {
  return {league, races, rank_mice(examination_shares(races.examination.race)), std::move(revealed)};
}

std::string promises_of(const SeasonResults& results) {
  std::vector<Contestant> mice;
  for (const LeagueEntry& entry : results.league.entries) mice.push_back(entry.mouse);
  const bool free =
      std::any_of(mice.begin(), mice.end(), [](const Contestant& mouse) { return mouse.sandboxed == false; });
  return free ? freedom_note(mice) + "They could also read seeds and other entries.\n"
              : std::string(promises) + freedom_note(mice);
}

std::string table_of(const SeasonResults& results) {
  std::size_t width = 5;
  for (const RankedMouse& mouse : results.ranking.mice) width = std::max(width, shown(mouse.name).size() + 2);
  std::string text = fmt::format("{:>4}  {:<{}} {:>8}  {:<14} {:>9}\n{:>4}  {:<{}} {:>8}  {:<14}\n", "rank", "mouse",
                                 width, "share of", "95 %", "finished", "", "", width, "best, %", "interval");
  for (const RankedMouse& mouse : results.ranking.mice)
    text += fmt::format("{:>4}  {:<{}} {:>8}  {:<14} {:>9}\n", mouse.rank,
                        shown(mouse.name) + (entry_of(results.league, mouse.name) == nullptr ? " *" : ""), width,
                        percent(mouse.mean), interval_text(mouse.interval),
                        fmt::format("{}/{}", finished_of(results.races.examination.race, mouse),
                                    results.league.season.examination.count));
  text += fmt::format("\n* built-in mouse\n{}{}\n", groups_text(results.ranking), ranking_rule);
  return text + promises_of(results);
}

std::string json_of(const SeasonResults& results) {
  Json json = {{"labmouse", "league"}, {"format", 1}, {"season", season_json(results)}, {"rule", ranking_rule}};
  json["mice"] = Json::array();
  for (const RankedMouse& mouse : results.ranking.mice) json["mice"].push_back(mouse_json(results, mouse));
  json["pairs"] = Json::array();
  const Ranking& ranking = results.ranking;
  for (std::size_t a = 0; a < ranking.mice.size(); ++a)
    for (std::size_t b = a + 1; b < ranking.mice.size(); ++b)
      json["pairs"].push_back({{"mouse", ranking.mice[a].name},
                               {"against", ranking.mice[b].name},
                               {"difference", ranking.pairs[a][b].difference},
                               {"interval", interval_of(ranking.pairs[a][b].interval)},
                               {"verdict", name_of(ranking.pairs[a][b].verdict)}});
  json["earlier_seasons"] = json_of(results.league.earlier);
  json["sandbox"] = promises_of(results);
  return text_of(json);
}

std::string index_page(const SeasonResults& results) {
  const Sha256 hash = sha256(style);
  const std::string title = xml_escaped(results.league.season.title);
  std::string html = fmt::format(
      "<!doctype html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
      "<meta http-equiv=\"Content-Security-Policy\" content=\"default-src 'none'; style-src 'sha256-{}'; base-uri "
      "'none'; form-action 'none'\">\n<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n"
      "<title>{}</title>\n<style>{}</style>\n</head>\n<body>\n<h1>{}</h1>\n",
      base64({reinterpret_cast<const char*>(hash.data()), hash.size()}), title, style, title);
  html += "<h2>Ranking</h2>\n" + ranking_html(results) +
          lines_html(groups_text(results.ranking) + std::string(ranking_rule));
  html += "<p><a href=\"report.html\">All contests in the practice mazes, with replays</a>";
  if (results.revealed) html += " · <a href=\"examination.html\">those of the examination</a>";
  html +=
      " · <a href=\"results.json\">all results as JSON</a></p>\n<h2>Differences of pairs</h2>\n"
      "<p>Mean share of the best possible score of the mouse of the line minus that of the column, in percentage "
      "points; bold where a difference is shown.</p>\n" +
      pairs_html(results.ranking);
  if (!results.league.earlier.empty())
    html +=
        "<h2>History</h2>\n<p>Rank, and share of the best possible score in %. Each season has mazes of its own: "
        "compare with the built-in mice of the same season.</p>\n" +
        history_html(results);
  html += "<h2>Entries</h2>\n" + entries_html(results.league) + "<h2>Season</h2>\n" + season_html(results);
  return html + "<h2>Sandbox</h2>\n" + lines_html(promises_of(results)) + "</body>\n</html>\n";
}

}  // namespace labmouse
