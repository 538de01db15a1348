#include "labmouse/lab/league/secret_seed.hpp"

#include <fmt/format.h>

#include "labmouse/functions/sha256.hpp"
#include "labmouse/maze/generators/generator.hpp"

namespace labmouse {

std::string sha256_text(std::string_view text) {
  std::string digits;
  for (const std::uint8_t byte : sha256(text)) digits += fmt::format("{:02x}", byte);
  return digits;
}

std::string secret_in(std::string_view text) {
  constexpr std::string_view blanks = " \t\r";
  while (!text.empty()) {
    const auto end = std::min(text.find('\n'), text.size());
    const std::string_view line = text.substr(0, end);
    text.remove_prefix(std::min(end + 1, text.size()));
    const auto begin = line.find_first_not_of(blanks);
    if (begin != std::string_view::npos && line[begin] != '#')
      return std::string(line.substr(begin, line.find_last_not_of(blanks) + 1 - begin));
  }
  return "";
}

std::string secret_text(const std::string& secret) {
  return "# The secret seed of the examination. Do not publish this file before the season ends.\n" + secret + "\n";
}

std::uint64_t number_from(const std::string& secret, std::string_view purpose) {
  const Sha256 hash = sha256(fmt::format("{}\n{}", purpose, secret));
  std::uint64_t number = 0;
  for (std::size_t i = 0; i < sizeof number; ++i) number = number << 8U | hash[i];
  // 53 bits, as in contest_seed(): readers of JSON that keep numbers as doubles get them whole.
  return number >> 11U;
}

std::vector<NamedMaze> examination_mazes(const ExaminationMazes& mazes, const std::string& secret) {
  std::vector<NamedMaze> all;
  for (int number = 1; number <= mazes.count; ++number) {
    std::string name = fmt::format("examination {:03}", number);
    const std::uint64_t seed = number_from(secret, name);
    all.push_back({std::move(name), find_generator(mazes.kind)->make({{mazes.side, mazes.side}, seed, 0})});
  }
  return all;
}

}  // namespace labmouse
