// SHA-256, a cryptographic hash: whoever knows the hash of a secret text cannot find the text, but can check it later.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>

namespace labmouse {

using Sha256 = std::array<std::uint8_t, 32>;

/// The hash of the bytes (FIPS 180-4).
Sha256 sha256(std::string_view bytes);

/// The hash of a text as 64 hexadecimal digits.
std::string sha256_text(std::string_view text);

/// Whether the text is 64 hexadecimal digits, as sha256_text() writes them.
bool is_sha256_text(std::string_view text);

}  // namespace labmouse
