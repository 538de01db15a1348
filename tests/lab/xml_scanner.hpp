// Is it XML? As much of the answer as the tests of drawings need.
#pragma once

#include <algorithm>
#include <string>
#include <string_view>
#include <vector>

namespace labmouse {

/// A strict scanner for the XML that the drawings use: tags balance, attributes are quoted and separated, `&` begins
/// one of five entities, no control characters. Returns the first complaint, or nothing.
class XmlScanner {
 public:
  explicit XmlScanner(std::string_view text) : text_(text) {}

  std::string complaint() {
    while (!text_.empty()) {
      const std::string found = text_.front() == '<' ? tag() : content();
      if (!found.empty()) return found;
    }
    return open_.empty() ? roots_ == 1 ? "" : "not one root" : "not closed: " + open_.back();
  }

 private:
  std::string content() {
    const auto end = std::min(text_.find('<'), text_.size());
    const std::string_view piece = text_.substr(0, end);
    text_.remove_prefix(end);
    if (open_.empty() && piece.find_first_not_of(" \n") != std::string_view::npos) return "text outside of the root";
    return characters(piece);
  }

  static std::string characters(std::string_view piece) {
    for (std::size_t at = 0; at < piece.size(); ++at) {
      const auto byte = static_cast<unsigned char>(piece[at]);
      if (byte < 0x20 && byte != '\n') return "control character";
      if (byte != '&') continue;
      bool known = false;
      for (const std::string_view entity : {"&amp;", "&lt;", "&gt;", "&quot;", "&#39;"})
        known = known || piece.substr(at).starts_with(entity);
      if (!known) return "bare &";
    }
    return "";
  }

  std::string tag() {
    const auto end = text_.find('>');
    if (end == std::string_view::npos) return "tag without end";
    std::string_view inside = text_.substr(1, end - 1);
    text_.remove_prefix(end + 1);
    if (inside.starts_with('/')) {
      if (open_.empty() || open_.back() != inside.substr(1)) return "wrong end tag " + std::string(inside);
      open_.pop_back();
      return "";
    }
    const bool alone = inside.ends_with('/');
    if (alone) inside.remove_suffix(1);
    const auto name = inside.substr(0, inside.find(' '));
    if (open_.empty()) ++roots_;
    if (!alone) open_.emplace_back(name);
    return attributes(inside.substr(name.size()));
  }

  static std::string attributes(std::string_view rest) {
    while (!rest.empty()) {
      const auto quote = rest.find("=\"");
      if (!rest.starts_with(' ') || quote == std::string_view::npos) return "bad attribute in" + std::string(rest);
      const auto end = rest.find('"', quote + 2);
      if (end == std::string_view::npos) return "attribute without end";
      const std::string_view value = rest.substr(quote + 2, end - quote - 2);
      if (value.find('<') != std::string_view::npos) return "< in an attribute";
      if (const auto found = characters(value); !found.empty()) return found;
      rest.remove_prefix(end + 1);
    }
    return "";
  }

  std::string_view text_;
  std::vector<std::string> open_;
  int roots_ = 0;
};

}  // namespace labmouse
