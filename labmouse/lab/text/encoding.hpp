// Recognises text that is not in UTF-8 by its first bytes.
#pragma once

#include <string_view>

namespace labmouse {

/// The kind of bytes that are no text, and what to do: "is compressed with gzip; unpack it with `gunzip` first". Empty
/// for bytes that may be text or a binary maze file.
std::string_view foreign_encoding(std::string_view bytes);

}  // namespace labmouse
