#include "labmouse/lab/records/record_parts.hpp"

#include <fmt/format.h>

#include "labmouse/lab/text/json_fields.hpp"
#include "labmouse/mouse/motion.hpp"

namespace labmouse {
namespace {

constexpr std::size_t most_counts = 64;
constexpr std::size_t longest_count_name = 64;
constexpr std::int64_t largest_count = std::int64_t{1} << 53U;  // every JSON reader keeps numbers up to this exactly

bool is_count(const ReadJson& value) {
  if (value.is_number_unsigned()) return value.get<std::uint64_t>() <= static_cast<std::uint64_t>(largest_count);
  return value.is_number_integer() && value.get<std::int64_t>() >= -largest_count;
}

}  // namespace

std::string read_record_rules(const ReadJson& json, Rules& rules) {
  JsonFields fields(json, "rules");
  if (fields.has("budget")) rules.budget = fields.whole("budget", 1, longest_record);
  if (fields.has("search_factor")) rules.search_factor = fields.whole("search_factor", 1, longest_record);
  if (fields.has("stride")) rules.stride = fields.whole("stride", 1, Motion::max_longest);
  return fields.error();
}

std::string read_record_counts(const ReadJson& json, std::vector<Count>& counts) {
  if (!json.is_object()) return "'counts' is not an object";
  if (json.size() > most_counts) return fmt::format("'counts' has more than {} names", most_counts);
  for (const auto& [name, value] : json.items()) {
    if (name.empty() || name.size() > longest_count_name)
      return fmt::format("'counts' has a name that is not 1 to {} bytes long", longest_count_name);
    if (!is_count(value)) return "'counts' has a value that is not a whole number from -2^53 to 2^53";
    counts.push_back({name, value.get<std::int64_t>()});
  }
  return "";
}

std::optional<Outcome> outcome_of(std::string_view name) {
  for (const Outcome outcome : {Outcome::finished, Outcome::out_of_steps, Outcome::never_reset,
                                Outcome::speed_run_unfinished, Outcome::forfeit})
    if (name_of(outcome) == today_value(name)) return outcome;
  return std::nullopt;
}

std::optional<ForfeitReason> forfeit_reason_of(std::string_view name) {
  for (const ForfeitReason reason : all_forfeit_reasons)
    if (name_of(reason) == today_value(name)) return reason;
  return std::nullopt;
}

}  // namespace labmouse
