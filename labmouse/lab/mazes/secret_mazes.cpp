#include "labmouse/lab/mazes/secret_mazes.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "labmouse/functions/sha256.hpp"
#include "labmouse/maze/generators/generator.hpp"

namespace labmouse {
namespace {

GeneratorOrder order_of(const SecretMazes& mazes, std::uint64_t seed) { return {{mazes.side, mazes.side}, seed, 0}; }

}  // namespace

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

std::uint64_t number_from(const std::string& secret, std::string_view purpose) {
  const Sha256 hash = sha256(fmt::format("{}\n{}", purpose, secret));
  std::uint64_t number = 0;
  for (std::size_t i = 0; i < sizeof number; ++i) number = number << 8U | hash[i];
  // 53 bits, as in contest_seed(): readers of JSON that keep numbers as doubles get them whole.
  return number >> 11U;
}

std::string refuse(const SecretMazes& mazes) {
  const Generator* generator = find_generator(mazes.kind);
  if (generator == nullptr)
    return fmt::format("there is no generator '{}'; `labmouse make --help` lists them", mazes.kind);
  return std::string(generator->refuses(order_of(mazes, 1)));
}

Maze secret_maze(const SecretMazes& mazes, const std::string& secret, std::string_view purpose) {
  return find_generator(mazes.kind)->make(order_of(mazes, number_from(secret, purpose)));
}

}  // namespace labmouse
