#include "labmouse/lab/live/live_reader.hpp"

#include <memory>
#include <optional>
#include <string_view>
#include <utility>

#include "labmouse/maze/formats/format.hpp"

namespace labmouse {

bool LiveReader::takes_drawn_line(std::vector<LiveLine>& read) {
  constexpr std::string_view sides = "|: .";
  const bool is_wall_line = drawing_format.recognises(line_);
  const bool is_cell_line = !line_.empty() && sides.find(line_.front()) != std::string_view::npos;
  const bool goes_on = drawn_lines_ % 2 == 0 ? is_wall_line : is_cell_line;
  if (!goes_on) {
    noise_ += drawn_lines_;
    drawn_lines_ = 0;
    drawing_.clear();
    if (!is_wall_line) return false;
  }
  drawing_ += line_ + '\n';
  if (++drawn_lines_ <= 2 * size_.height) return true;
  const ReadResult drawn = drawing_format.read(drawing_);
  const Maze* known = drawn.maze ? &*drawn.maze : drawn.partial ? &drawn.partial->known : nullptr;
  if (!has_checksums_ && known != nullptr && known->size() == size_)
    read.push_back({.number = lines_,
                    .drawing = std::make_shared<PartialMap>(drawn.maze ? PartialMap{*known, {}} : *drawn.partial)});
  else
    noise_ += drawn_lines_;
  drawn_lines_ = 0;
  drawing_.clear();
  return true;
}

void LiveReader::end_line(std::vector<LiveLine>& read) {
  ++lines_;
  while (!line_.empty() && line_.back() == '\r') line_.pop_back();
  if (!is_too_long_ && takes_drawn_line(read)) return line_.clear();
  auto line = is_too_long_ ? std::nullopt : read_live_line(line_);
  if (line && (line->has_checksum || !has_checksums_)) {
    has_checksums_ = line->has_checksum;
    line->number = lines_;
    read.push_back(std::move(*line));
  } else if (is_too_long_ || line_.find_first_not_of(" \t") != std::string::npos) {
    ++noise_;
  }
  line_.clear();
  is_too_long_ = false;
}

std::vector<LiveLine> LiveReader::feed(std::string_view bytes) {
  std::vector<LiveLine> read;
  for (const char letter : bytes) {
    if (letter == '\n')
      end_line(read);
    else if (line_.size() < longest_line)
      line_ += letter;
    else
      is_too_long_ = true;
  }
  return read;
}

}  // namespace labmouse
