// Any bytes as a record or a robot, drawn as the commands draw them: the picture is XML, and all of its numbers are
// finite.
#include "labmouse/lab/drawing/drawing.hpp"
#include "labmouse/lab/pictures/drive_picture.hpp"
#include "labmouse/lab/pictures/picture_layers.hpp"
#include "labmouse/lab/pictures/robot_picture.hpp"
#include "labmouse/lab/robots/robot_file.hpp"
#include "labmouse/lab/steps/steps_files.hpp"
#include "labmouse/lab/system/version.hpp"
#include "tests/fuzz/fuzzer.hpp"
#include "tests/lab/xml_scanner.hpp"

namespace labmouse::fuzz {

namespace {

bool is_part_of_number(char letter) {
  return (letter >= '0' && letter <= '9') || letter == '.' || letter == '-' || letter == ' ' || letter == ',' ||
         letter == '"' || letter == '(' || letter == ')';
}

/// "nan" or "inf" where a number stands: inside of a tag, between what parts numbers. Names are text between tags, or
/// in attributes that begin with a letter.
bool has_strange_number(std::string_view svg) {
  bool inside = false;
  for (std::size_t at = 0; at + 4 < svg.size(); ++at) {
    if (svg[at] == '<' || svg[at] == '>') inside = svg[at] == '<';
    if (!inside || !is_part_of_number(svg[at]) || !is_part_of_number(svg[at + 4])) continue;
    const std::string_view word = svg.substr(at + 1, 3);
    if (word == "nan" || word == "inf") return true;
  }
  return false;
}

void check(const std::string& svg) {
  require(XmlScanner(svg).complaint().empty());
  require(!has_strange_number(svg));
}

void draw_steps(std::string_view text) {
  ReadRecordResult read = read_record(text);
  if (!read.file || !read.file->maze) return;
  ReplayResult played = replay(*read.file, *read.file->maze);
  if (!played.disagreement.empty()) return;
  read.file->run = std::move(played.run);
  check(picture_of(*read.file));
  LayerSet layers = all_layers();
  layers.erase(Layer::cells);
  check(draw_svg(*read.file->maze, layers_of(*read.file, layers)));
}

void draw_seconds(std::string_view text) {
  const ReadDriveRecordResult read = read_drive_record(text);
  if (read.file && replay(*read.file).empty()) check(draw_contest(*read.file));
}

void draw_a_robot(std::string_view text) {
  const RobotResult read = read_robot(text, "fuzz");
  if (read.robot) check(draw_robot(*read.robot, read.model));
}

}  // namespace

LABMOUSE_FUZZER(picture) {
  const std::string_view text(reinterpret_cast<const char*>(bytes), size);
  if (!text.starts_with('{'))
    draw_a_robot(text);
  else if (is_drive_record(text))
    draw_seconds(text);
  else
    draw_steps(text);
  return 0;
}

}  // namespace labmouse::fuzz
