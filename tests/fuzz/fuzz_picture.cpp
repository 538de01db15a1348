// Any bytes as a record or a robot, drawn as the commands draw them: the picture is XML, and all of its numbers are
// finite.
#include "labmouse/lab/drawing/drawing.hpp"
#include "labmouse/lab/pictures/robot_picture.hpp"
#include "labmouse/lab/robots/robot_file.hpp"
#include "labmouse/lab/worlds/worlds.hpp"
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

void draw_a_record(std::string_view text) {
  const OpenedRecord opened = kind_of_record(text).open(text, nullptr);
  if (!opened.replay) return;
  check(opened.replay->picture());
  LayerSet layers = opened.replay->layers();
  layers.erase(Layer::cells);
  const RecordDrawing drawing = opened.replay->drawing(layers, 0);
  check(draw_svg(drawing.maze, drawing.layers));
}

void draw_a_robot(std::string_view text) {
  const RobotResult read = read_robot(text, "fuzz");
  if (read.robot) check(draw_robot(*read.robot, read.model));
}

}  // namespace

LABMOUSE_FUZZER(picture) {
  const std::string_view text(reinterpret_cast<const char*>(bytes), size);
  if (text.starts_with('{'))
    draw_a_record(text);
  else
    draw_a_robot(text);
  return 0;
}

}  // namespace labmouse::fuzz
