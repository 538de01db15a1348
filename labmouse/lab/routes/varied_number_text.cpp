// A file of its own, because only the command line reads such texts.
#include <optional>

#include "labmouse/functions/parse_number.hpp"
#include "labmouse/lab/robots/robot_family.hpp"
#include "labmouse/lab/routes/varied_number.hpp"

namespace labmouse {

VariedNumberResult read_varied_number(std::string_view text) {
  const auto refused = [](std::string why) { return VariedNumberResult{{}, std::move(why)}; };
  const auto equals = text.find('=');
  const auto colon = equals == std::string_view::npos ? equals : text.find(':', equals);
  if (colon == std::string_view::npos)
    return refused("write KEY=FROM:TO, such as curve.lateral_acceleration=5000:40000");
  const std::string_view key = text.substr(0, equals);
  if (std::string why = why_not_varied(key); !why.empty()) return refused(std::move(why));
  const auto from = parse_number(text.substr(equals + 1, colon - equals - 1)),
             to = parse_number(text.substr(colon + 1));
  if (!from || !to || !(*from < *to)) return refused("FROM and TO must be numbers, and FROM the smaller one");
  return {{std::string(key), *from, *to}, ""};
}

}  // namespace labmouse
