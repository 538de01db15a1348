// Encodes bytes as text for an HTML page: gzip, then base64.
#pragma once

#include <string>
#include <string_view>

namespace labmouse {

inline constexpr std::string_view base64_digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";

/// Compresses bytes with gzip at the highest level. Equal input gives equal output, because the header has no time and
/// no name.
std::string gzip(std::string_view bytes);

/// Base64 (RFC 4648): four characters (letters, digits, `+`, `/`) for three bytes, with `=` as padding.
std::string base64(std::string_view bytes);

}  // namespace labmouse
