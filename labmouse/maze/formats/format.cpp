#include "labmouse/maze/formats/format.hpp"

#include <array>

#include "labmouse/maze/formats/problem_list.hpp"
#include "labmouse/maze/formats/text.hpp"

namespace labmouse {
namespace {

// No content matches two of them: the text formats differ in their first line, and the bytes of a maz file cannot occur
// in text.
constexpr std::array<const Format*, 4> formats_in_order = {&drawing_format, &capstone_format, &num_format, &maz_format};

}  // namespace

std::span<const Format* const> all_formats() { return formats_in_order; }

const Format* find_format(std::string_view name) {
  for (const Format* format : all_formats())
    if (format->name == name) return format;
  return nullptr;
}

ReadResult read_maze(std::string_view content) {
  if (formats::is_blank(content)) return formats::failure(0, 0, "the file is empty");
  for (const Format* format : all_formats())
    if (format->recognises(content)) return format->read(content);
  return formats::failure(0, 0, "not a maze in any known format: drawing (o---o), capstone, num or maz");
}

}  // namespace labmouse
