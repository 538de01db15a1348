#include "labmouse/lab/live/live_line.hpp"

#include <algorithm>
#include <utility>

#include "labmouse/functions/parse_number.hpp"
#include "labmouse/maze/formats/step_line.hpp"

namespace labmouse {
namespace {

constexpr std::string_view between_words = " \t";

bool is_printable(std::string_view text) {
  return std::all_of(text.begin(), text.end(),
                     [](char letter) { return (letter >= ' ' && letter <= '~') || letter == '\t'; });
}

/// Takes a checksum off the end: a star and two hexadecimal digits, the exclusive or of all bytes before the star.
/// Returns whether it is right; nothing where there is none.
std::optional<bool> take_checksum(std::string_view& line) {
  constexpr std::size_t length = 3;
  if (line.size() < length || line[line.size() - length] != '*') return std::nullopt;
  const auto sum = parse_whole<unsigned>(line.substr(line.size() - 2), 16);
  line.remove_suffix(length);
  unsigned found = 0;
  for (const char letter : line) found ^= static_cast<unsigned char>(letter);
  return found == sum;
}

/// Takes the next word between between_words off the line; empty at its end.
std::string_view take_word(std::string_view& line) {
  line.remove_prefix(std::min(line.find_first_not_of(between_words), line.size()));
  const std::string_view word = line.substr(0, line.find_first_of(between_words));
  line.remove_prefix(word.size());
  return word;
}

bool are_numbers(std::string_view value, int least, int most) {
  int count = 0;
  for (bool more = true; more; ++count) {
    const auto comma = value.find(',');
    if (!parse_number(value.substr(0, comma))) return false;
    more = comma != std::string_view::npos;
    if (more) value.remove_prefix(comma + 1);
  }
  return count >= least && count <= most;
}

/// A field whose value has a meaning, and how many numbers it has.
struct NumberField {
  std::string_view name;
  int least = 1, most = 1;
};

constexpr auto number_fields = std::to_array<NumberField>({{"pose", 3, 3}, {"v"}, {"ir", 1, 16}, {"batt"}, {"cost"}});

bool is_value_of(std::string_view name, std::string_view value) {
  if (name == "route") return value.find_first_not_of("NESW") == std::string_view::npos;
  for (const NumberField& field : number_fields)
    if (field.name == name) return are_numbers(value, field.least, field.most);
  return !value.empty();
}

bool is_name(std::string_view name) {
  return !name.empty() && name.find_first_not_of("abcdefghijklmnopqrstuvwxyz0123456789_") == std::string_view::npos;
}

/// Appends the fields that the rest of a line has. Returns false where there is anything else.
bool take_fields(std::string_view rest, std::vector<LiveField>& fields) {
  for (std::string_view word = take_word(rest); !word.empty(); word = take_word(rest)) {
    const auto equals = word.find('=');
    if (equals == std::string_view::npos) return false;
    const std::string_view name = word.substr(0, equals), value = word.substr(equals + 1);
    if (!is_name(name) || !is_value_of(name, value)) return false;
    fields.push_back({std::string(name), std::string(value)});
  }
  return true;
}

SeenCell seen_in(const formats::StepLine& line) { return {{line.cell, line.heading}, line.closed}; }

/// Whether the first word is a number: then the line is one of ours or a part of it.
bool begins_with_a_number(std::string_view line) {
  return parse_number(line.substr(0, line.find_first_of(" \t,;"))).has_value();
}

bool are_same(const PartialMap* one, const PartialMap* other) {
  if (one == nullptr || other == nullptr) return one == other;
  return one->known == other->known && one->unseen == other->unseen;
}

}  // namespace

bool operator==(const LiveLine& one, const LiveLine& other) {
  return one.number == other.number && one.has_checksum == other.has_checksum && one.is_restart == other.is_restart &&
         one.seen == other.seen && one.fields == other.fields && are_same(one.drawing.get(), other.drawing.get());
}

std::optional<LiveLine> read_live_line(std::string_view line) {
  if (!is_printable(line)) return std::nullopt;
  const std::optional<bool> checksum = take_checksum(line);
  if (checksum == false) return std::nullopt;
  line.remove_prefix(std::min(line.find_first_not_of(between_words), line.size()));
  LiveLine read;
  read.has_checksum = checksum.has_value();
  if (const auto step = formats::read_step_line(line)) {
    read.seen = seen_in(*step);
    // What another program prints of a step may have anything behind it.
    if (!step->plain) return begins_with_a_number(line) ? std::nullopt : std::optional(std::move(read));
    line = step->rest;
    if (!line.empty() && between_words.find(line.front()) == std::string_view::npos) return std::nullopt;
  } else {
    std::string_view rest = line;
    read.is_restart = take_word(rest) == "start";
    if (read.is_restart) line = rest;
  }
  const bool good = take_fields(line, read.fields) && (read.seen || read.is_restart || !read.fields.empty());
  return good ? std::optional(std::move(read)) : std::nullopt;
}

}  // namespace labmouse
