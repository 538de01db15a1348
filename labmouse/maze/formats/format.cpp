#include "labmouse/maze/formats/format.hpp"

#include <array>

#include "labmouse/maze/formats/problem_list.hpp"
#include "labmouse/maze/formats/text.hpp"

namespace labmouse {
namespace {

// The first format that recognises a content reads it. What one format writes, no other recognises.
constexpr std::array formats_in_order = {&drawing_format, &capstone_format, &num_format,  &maz_format,
                                         &blocks_format,  &hex_format,      &dump_format, &csv_format,
                                         &steps_format,   &json_format,     &c_format};

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
    if (format->recognises(content)) {
      ReadResult result = format->read(content);
      const Maze* maze = result.maze ? &*result.maze : result.partial ? &result.partial->known : nullptr;
      if (maze != nullptr && result.reading.empty())
        result.reading = formats::joined(format->name, ", ", maze->size().width, "x", maze->size().height);
      return result;
    }
  std::string names;
  for (const Format* format : all_formats()) names += (names.empty() ? "" : ", ") + std::string(format->name);
  return formats::failure(0, 0, "not a maze in any known format: " + names);
}

}  // namespace labmouse
