// Recognises HTML, XML and SVG by their first tag.
#pragma once

#include <string>
#include <string_view>

namespace labmouse {

/// The beginning of the first tag of a text, in lower case and with one blank between words: `<!doctype html>`, `<svg`.
/// It comes after a byte order mark, blanks, comments and the XML declaration. Empty if other text comes first.
std::string first_tag(std::string_view text);

/// Whether the text is a web page or a picture: its first tag is that of HTML or SVG.
bool is_markup(std::string_view text);

}  // namespace labmouse
