#include "generated.hpp"

#include <fmt/format.h>

#include "command.hpp"
#include "labmouse/functions/parse_number.hpp"
#include "named_things.hpp"

namespace labmouse::cli {
Size read_size(const std::string& text) {
  const auto cross = text.find('x');
  const double width = parse_plain_number(text.substr(0, cross)).value_or(0.0);
  const double height = parse_plain_number(text.substr(cross == std::string::npos ? 0 : cross + 1)).value_or(0.0);
  const bool good = width >= 1 && height >= 1 && width <= max_side && height <= max_side;
  const Size size = good ? Size{static_cast<int>(width), static_cast<int>(height)} : Size{};
  if (good && size.width == width && size.height == height) return size;
  throw UsageError(fmt::format("error: '{}' is not a size; write WIDTHxHEIGHT with sides from 1 to {}, such as 16x16",
                               text, max_side));
}

void GeneratedMazes::add_to(Command& command) {
  command.add_option("--size", size, "Width and height of a generated maze in cells")
      ->type_name("WxH")
      ->capture_default_str();
  command
      .add_option("--loops", loops, "Share of the remaining inner walls of a generated maze to remove, to make loops")
      ->check(finite_number())
      ->check(in_range(0.0, 1.0))
      ->capture_default_str();
}

const Generator& GeneratedMazes::generator() const {
  if (const Generator* generator = find_generator(kind)) return *generator;
  throw UsageError(fmt::format("error: unknown generator '{}'; {}", kind, suggestion(kind, all_generators())));
}

GeneratorOrder GeneratedMazes::order(std::uint64_t seed) const {
  const GeneratorOrder order{read_size(size), seed, static_cast<int>(loops * 1000.0 + 0.5)};
  if (const auto reason = generator().refuses(order); !reason.empty())
    throw UsageError(fmt::format("error: {}", reason));
  return order;
}

}  // namespace labmouse::cli
