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

const Format* format_of_file(std::string_view name) {
  const std::string_view file = name.substr(name.find_last_of('/') + 1);  // npos + 1 is 0
  const std::size_t dot = file.rfind('.');
  const std::string_view extension = dot == 0 || dot == std::string_view::npos ? "" : file.substr(dot);
  if (extension.empty() || extension == ".maze") return &drawing_format;
  if (extension == ".c") return &c_format;
  for (const Format* format : all_formats())
    if (format->extension == extension) return format;
  return nullptr;
}

const Format* recognised_format(std::string_view content) {
  for (const Format* format : all_formats())
    if (format->recognises(content)) return format;
  return nullptr;
}

ReadResult read_maze(std::string_view content) {
  if (formats::is_blank(content)) return formats::failure(0, 0, "the file is empty");
  const Format* format = recognised_format(content);
  if (format == nullptr) {
    std::string names;
    for (const Format* each : all_formats()) names += (names.empty() ? "" : ", ") + std::string(each->name);
    return formats::failure(0, 0, "not a maze in any known format: " + names);
  }
  ReadResult result = format->read(content);
  const Maze* maze = result.maze ? &*result.maze : result.partial ? &result.partial->known : nullptr;
  if (maze != nullptr && result.reading.empty())
    result.reading = formats::joined(format->name, ", ", maze->size().width, "x", maze->size().height);
  return result;
}

}  // namespace labmouse
