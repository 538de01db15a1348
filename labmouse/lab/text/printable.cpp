#include "labmouse/lab/text/printable.hpp"

#include <array>
#include <cstddef>

namespace labmouse {
namespace {

constexpr char32_t replacement = 0xFFFD;

struct Decoded {
  char32_t character = replacement;
  std::size_t length = 1;
};

/// Decodes the first character of a text that is not empty. Rejects overlong forms, surrogates and code points above
/// U+10FFFF.
Decoded first_of(std::string_view text) {
  const auto lead = static_cast<unsigned char>(text[0]);
  if (lead < 0x80) return {lead, 1};
  const std::size_t length = lead >= 0xF0 ? 4 : lead >= 0xE0 ? 3 : 2;
  if (lead < 0xC2 || lead > 0xF4 || text.size() < length) return {};
  char32_t character = lead & (0x7FU >> length);
  for (const char next : text.substr(1, length - 1)) {
    const auto byte = static_cast<unsigned char>(next);
    if ((byte & 0xC0U) != 0x80) return {};
    character = character << 6U | (byte & 0x3FU);
  }
  constexpr std::array<char32_t, 5> smallest = {0, 0, 0x80, 0x800, 0x10000};
  const bool surrogate = character >= 0xD800 && character <= 0xDFFF;
  if (character < smallest[length] || character > 0x10FFFF || surrogate) return {};
  return {character, length};
}

bool within(char32_t character, char32_t first, char32_t last) { return character >= first && character <= last; }

bool shows(char32_t character) {
  const bool control = character < 0x20 || within(character, 0x7F, 0x9F);
  const bool reorders = character == 0x61C || within(character, 0x200B, 0x200F) || within(character, 0x2028, 0x202E) ||
                        within(character, 0x2060, 0x206F) || character == 0xFEFF;
  const bool no_character = (character & 0xFFFEU) == 0xFFFE || within(character, 0xFDD0, 0xFDEF);
  return !control && !reorders && !no_character;
}

void append_utf8(std::string& text, char32_t character) {
  const auto tail = [&](unsigned shift) { text += static_cast<char>(0x80U | (character >> shift & 0x3FU)); };
  if (character < 0x80) {
    text += static_cast<char>(character);
  } else if (character < 0x800) {
    text += static_cast<char>(0xC0U | character >> 6U);
    tail(0);
  } else if (character < 0x10000) {
    text += static_cast<char>(0xE0U | character >> 12U);
    tail(6), tail(0);
  } else {
    text += static_cast<char>(0xF0U | character >> 18U);
    tail(12), tail(6), tail(0);
  }
}

}  // namespace

std::u32string printable(std::string_view text) {
  std::u32string characters;
  while (!text.empty()) {
    const Decoded next = first_of(text);
    text.remove_prefix(next.length);
    const bool blank = next.character == '\t' || next.character == '\n' || next.character == '\r';
    if (blank) characters += U' ';
    if (shows(next.character)) characters += next.character;
  }
  return characters;
}

std::string utf8(std::u32string_view characters) {
  std::string text;
  for (const char32_t character : characters) append_utf8(text, character);
  return text;
}

std::string shown(std::string_view text) { return utf8(printable(text)); }

std::string xml_escaped(std::string_view text) {
  std::string escaped;
  for (const char32_t character : printable(text)) {
    switch (character) {
      case U'&':
        escaped += "&amp;";
        break;
      case U'<':
        escaped += "&lt;";
        break;
      case U'>':
        escaped += "&gt;";
        break;
      case U'"':
        escaped += "&quot;";
        break;
      case U'\'':
        escaped += "&#39;";
        break;
      default:
        append_utf8(escaped, character);
    }
  }
  return escaped;
}

std::string csv_field(std::string_view text) {
  if (text.find_first_of(",\"\r\n") == std::string_view::npos) return std::string(text);
  std::string quoted = "\"";
  for (const char letter : text) quoted += letter == '"' ? std::string("\"\"") : std::string(1, letter);
  return quoted + "\"";
}

}  // namespace labmouse
