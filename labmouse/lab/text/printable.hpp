// Text from outside (names of files and mice, labels), made fit to be shown.
#pragma once

#include <string>
#include <string_view>

namespace labmouse {

/// The characters of UTF-8 text that can be shown. Tabs and line ends become spaces, invalid bytes U+FFFD; what steers
/// a terminal, reorders a line or is forbidden in XML is dropped.
std::u32string printable(std::string_view text);

/// The UTF-8 of characters as `printable` returns them.
std::string utf8(std::u32string_view characters);

/// The text, printable, as UTF-8: on a terminal it stays on its line and steers nothing.
std::string shown(std::string_view text);

/// The text, printable, for the content or an attribute of an XML element.
std::string xml_escaped(std::string_view text);

/// The text as one field of CSV, as it is or in quotation marks (RFC 4180).
std::string csv_field(std::string_view text);

}  // namespace labmouse
