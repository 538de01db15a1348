#include "labmouse/lab/live/live_reader.hpp"

#include <optional>
#include <utility>

namespace labmouse {

void LiveReader::end_line(std::vector<LiveLine>& read) {
  ++lines_;
  while (!line_.empty() && line_.back() == '\r') line_.pop_back();
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
