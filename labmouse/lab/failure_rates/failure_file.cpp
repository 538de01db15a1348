#include "labmouse/lab/failure_rates/failure_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <mutex>
#include <numeric>

#include "labmouse/chance/rng.hpp"
#include "labmouse/lab/failure_rates/builtin_failure_rates.hpp"
#include "labmouse/lab/failure_rates/physical_settings.hpp"
#include "labmouse/lab/mazes/maze_files.hpp"
#include "labmouse/lab/system/named_text.hpp"
#include "labmouse/lab/text/json.hpp"
#include "labmouse/lab/text/json_fields.hpp"
#include "labmouse/lab/text/json_problem.hpp"
#include "labmouse/lab/text/printable.hpp"

namespace labmouse {
namespace {

constexpr std::int64_t most_counted = std::int64_t{1} << 40U;

/// Reads counts; what is wrong with any of them is in `error`.
class FailureFileReader {
 public:
  std::string error;

  FailureTally tally(const ReadJson& json) {
    JsonFields fields(json, "variations");
    FailureTally tally;
    tally.variation = *number_of(read_value(variation_row.setting, fields));
    tally.pace = *number_of(read_value(pace_row.setting, fields));
    const ReadJson& classes = list_of(fields, "by_brightness", brightness_classes);
    for (std::size_t bright = 0; bright < classes.size(); ++bright)
      tally.by_brightness[bright] = counts(classes[bright]);
    note(fields);
    return tally;
  }

 private:
  void note(const JsonFields& fields) {
    if (error.empty()) error = fields.error();
  }

  /// The list under `key`; reports an error and returns an empty list if it does not have `size` entries.
  const ReadJson& list_of(JsonFields& fields, const char* key, std::size_t size) {
    static const ReadJson none = ReadJson::array();
    const ReadJson& list = fields.list(key);
    if (list.size() == size) return list;
    fields.reject(fmt::format("'{}' has {} entries in place of {}", key, list.size(), size));
    return none;
  }

  /// Zeros at the end are left out.
  template <std::size_t Size>
  void numbers(const ReadJson& list, std::string_view what, std::array<std::int64_t, Size>& into) {
    if (!error.empty()) return;
    if (!list.is_array() || list.size() > Size) {
      error = fmt::format("'{}' has an entry that is no list of at most {} counts", what, Size);
      return;
    }
    for (std::size_t i = 0; i < list.size(); ++i) {
      if (!list[i].is_number_unsigned() || list[i].get<std::uint64_t>() > std::uint64_t{most_counted}) {
        error = fmt::format("'{}' has an entry that is no count", what);
        return;
      }
      into[i] = list[i].get<std::int64_t>();
    }
  }

  FailureCounts counts(const ReadJson& json) {
    JsonFields fields(json, "by_brightness");
    FailureCounts counts;
    counts.contests = fields.long_whole("contests", 0, most_counted);
    counts.finished = fields.long_whole("finished", 0, counts.contests);
    numbers(fields.list("put"), "put", counts.put);
    if (!fields.has("manoeuvres") || !fields.has("readings"))
      fields.reject("'by_brightness' lacks its manoeuvres or readings");
    note(fields);
    if (!error.empty()) return counts;
    JsonFields manoeuvres(json["manoeuvres"], "manoeuvres"), readings(json["readings"], "readings");
    for (const Manoeuvre manoeuvre : all_manoeuvres) {
      const ReadJson& list = list_of(manoeuvres, std::string(name_of(manoeuvre)).c_str(), position_error_levels);
      for (std::size_t level = 0; level < list.size(); ++level)
        counts.manoeuvres[static_cast<std::size_t>(manoeuvre)][level] = manoeuvre_count(list[level]);
    }
    for (const Reading reading : all_readings) {
      const ReadJson& list = list_of(readings, std::string(name_of(reading)).c_str(), position_error_levels);
      for (std::size_t level = 0; level < list.size(); ++level)
        numbers(list[level], name_of(reading), counts.readings[static_cast<std::size_t>(reading)][level].by_evidence);
    }
    note(manoeuvres);
    note(readings);
    return counts;
  }

  /// How often, crashes, crashes by sliding, and the levels of localization error after the others.
  ManoeuvreCount manoeuvre_count(const ReadJson& json) {
    std::array<std::int64_t, 3 + position_error_levels> entries{};
    numbers(json, "manoeuvres", entries);
    ManoeuvreCount count = {entries[0], entries[1], entries[2], {}};
    std::copy(entries.begin() + 3, entries.end(), count.after.begin());
    const std::int64_t ended = std::accumulate(entries.begin() + 3, entries.end(), count.crashes);
    if (error.empty() && (ended != count.times || count.slid > count.crashes))
      error = "'manoeuvres' has counts that do not add up";
    return count;
  }
};

bool comes_before(const FailureTally& a, const FailureTally& b) {
  return a.pace < b.pace || (a.pace == b.pace && a.variation < b.variation);
}

/// "failure_rates/mine.json" gives "mine".
std::string short_name(const std::string& name) {
  std::string alone = name.substr(name.rfind('/') + 1);
  return alone.ends_with(".json") ? alone.substr(0, alone.size() - 5) : alone;
}

/// Read once: every world, record and report of failures needs them, and reading takes as long as a contest.
const FoundRates& builtin_rates(const BuiltinRates& brought) {
  static std::mutex mutex;
  static std::map<std::string_view, FoundRates> known;
  const std::lock_guard lock(mutex);
  const auto found = known.find(brought.name);
  if (found != known.end()) return found->second;
  return known.emplace(brought.name, read_rates(brought.text, std::string(brought.name))).first->second;
}

}  // namespace

FoundRates read_rates(std::string_view text, const std::string& name) {
  const auto wrong = [&](std::string_view why) {
    return FoundRates{std::nullopt, fmt::format("{}: error: {}", shown(name), why)};
  };
  const ReadJson json = with_today_names(read_json(text));
  if (json.is_discarded()) return {std::nullopt, describe(name, json_problem(text))};
  if (!json.is_object() || !json.contains("labmouse_failure_rates"))
    return wrong("is no file of failure rates; `labmouse failure-rates --save` writes one");
  JsonFields fields(json, "");
  if (fields.has("stopped") && fields.flag("stopped"))
    return wrong("has only some of the counts, because `labmouse failure-rates` was stopped; run it again");
  FailureFile file;
  file.name = short_name(name);
  if (fields.whole("labmouse_failure_rates", 1, 1'000'000) != failure_rates_format)
    fields.reject(
        fmt::format("'labmouse_failure_rates' is not {}, the only format that this version knows; count them again",
                    failure_rates_format));
  file.robot = fields.text("robot");
  file.tables = fields.text("tables");
  file.edition = fields.whole("edition", 1, 1'000'000);
  file.noise = *number_of(read_value(noise_row.setting, fields));
  file.search_speed = *number_of(read_value(search_speed_row.setting, fields));
  FailureFileReader reader;
  const ReadJson& variations = fields.list("variations");
  if (variations.empty() || variations.size() > 100) fields.reject("'variations' has no entries, or more than 100");
  if (!fields.error().empty()) return wrong(fields.error());
  for (const ReadJson& variation : variations) {
    file.tallies.push_back(reader.tally(variation));
    if (!reader.error.empty()) return wrong(reader.error);
    const std::size_t count = file.tallies.size();
    if (count > 1 && !comes_before(file.tallies[count - 2], file.tallies[count - 1]))
      return wrong("'variations' do not increase, by pace and variation");
  }
  file.hash = fmt::format("{:016x}", seed_for(0, text));
  return {std::move(file), ""};
}

std::optional<FailureFile> builtin_rates_of(const std::string& name, std::string_view hash) {
  if (name.find_first_of("/.\n-") != std::string::npos) return std::nullopt;
  FoundRates found = find_rates(name);
  return found.file && found.file->hash == hash ? std::move(found.file) : std::nullopt;
}

FoundRates find_rates(const std::string& name) {
  for (const BuiltinRates& brought : builtin_failure_rates())
    if (brought.name == name) return builtin_rates(brought);
  const NamedText text = find_text("failure rates", builtin_failure_rates(), name, ".json");
  if (!text.error.empty()) return {std::nullopt, text.error};
  return read_rates(text.text, name_alone(name));
}

}  // namespace labmouse
