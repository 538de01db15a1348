// Text that is not in UTF-8, recognised by its first bytes.
#pragma once

#include <string_view>

namespace labmouse {

/// What the bytes are in place of text, and what to do about it: "is compressed with gzip; unpack it first with
/// `gunzip`". Empty for all that may be text, or a maze in bytes.
std::string_view foreign_encoding(std::string_view bytes);

}  // namespace labmouse
