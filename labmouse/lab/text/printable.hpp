// Makes text from outside (names of files and mice, labels) safe to print.
#pragma once

#include <string>
#include <string_view>

namespace labmouse {

/// The printable characters of UTF-8 text. Tabs and line ends become spaces, invalid bytes U+FFFD. Removes control
/// characters, characters that reorder a line, and characters that XML forbids.
std::u32string printable(std::string_view text);

/// Encodes the characters that printable() returns as UTF-8.
std::string utf8(std::u32string_view characters);

/// The printable text as UTF-8. On a terminal it stays on one line and controls nothing.
std::string shown(std::string_view text);

/// The printable text, escaped for the content or an attribute of an XML element.
std::string xml_escaped(std::string_view text);

/// The text as one field of CSV, in quotation marks if needed (RFC 4180).
std::string csv_field(std::string_view text);

}  // namespace labmouse
