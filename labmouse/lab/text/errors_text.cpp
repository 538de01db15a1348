#include "labmouse/lab/text/errors_text.hpp"

#include <fmt/format.h>

namespace labmouse {

std::string variation_text(double scale) {
  for (const NamedNumber& level : variation_levels)
    if (level.number == scale) return fmt::format("{:g} ({})", scale, level.name);
  return fmt::format("{:g}", scale);
}

std::string text_of(const ErrorScale& errors) {
  return fmt::format("noise {:g}{}, variation {}", errors.noise, errors.noise == 1.0 ? " (as measured)" : "",
                     variation_text(errors.variation));
}

std::string scales_text() {
  std::string text = "noise 1: as measured; variation ";
  for (const NamedNumber& level : variation_levels)
    text += fmt::format("{}{:g}: {}", &level == variation_levels.data() ? "" : ", ", level.number, level.name);
  return text;
}

}  // namespace labmouse
