// Bytes as a text that can stand in a page: compressed, then in letters.
#pragma once

#include <string>
#include <string_view>

namespace labmouse {

inline constexpr std::string_view base64_digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";

/// The bytes by gzip, as small as it makes them. The same bytes give the same bytes: no time and no name stand in it.
std::string gzip(std::string_view bytes);

/// Four characters for three bytes (RFC 4648): letters, digits, `+`, `/`, and `=` at the end.
std::string base64(std::string_view bytes);

}  // namespace labmouse
