#include "labmouse/lab/text/packing.hpp"

#include <zlib.h>

#include <algorithm>
#include <limits>
#include <new>

namespace labmouse {
namespace {

constexpr int gzip_window = MAX_WBITS + 16;  // zlib's flag for the gzip format

/// Compresses all bytes through a buffer; the stream must be initialised.
std::string deflated(z_stream& stream, std::string_view bytes) {
  std::string packed, buffer(std::size_t{1} << 18U, '\0');
  for (int state = Z_OK; state != Z_STREAM_END;) {
    if (stream.avail_in == 0 && !bytes.empty()) {
      const auto piece = bytes.substr(0, std::numeric_limits<uInt>::max());
      // zlib only reads the input; its interface just lacks const.
      stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(piece.data()));
      stream.avail_in = static_cast<uInt>(piece.size());
      bytes.remove_prefix(piece.size());
    }
    stream.next_out = reinterpret_cast<Bytef*>(buffer.data());
    stream.avail_out = static_cast<uInt>(buffer.size());
    state = deflate(&stream, bytes.empty() ? Z_FINISH : Z_NO_FLUSH);
    packed.append(buffer, 0, buffer.size() - stream.avail_out);
  }
  return packed;
}

}  // namespace

std::string gzip(std::string_view bytes) {
  z_stream stream{};
  if (deflateInit2(&stream, Z_BEST_COMPRESSION, Z_DEFLATED, gzip_window, MAX_MEM_LEVEL, Z_DEFAULT_STRATEGY) != Z_OK)
    throw std::bad_alloc();
  std::string packed = deflated(stream, bytes);
  deflateEnd(&stream);
  return packed;
}

std::string base64(std::string_view bytes) {
  std::string text;
  text.reserve((bytes.size() + 2) / 3 * 4);
  for (; !bytes.empty(); bytes.remove_prefix(std::min<std::size_t>(3, bytes.size()))) {
    unsigned three = 0;
    for (std::size_t i = 0; i < 3; ++i)
      three = three << 8U | (i < bytes.size() ? static_cast<unsigned char>(bytes[i]) : 0U);
    for (std::size_t i = 0; i < 4; ++i) text += i <= bytes.size() ? base64_digits[three >> (18 - 6 * i) & 63U] : '=';
  }
  return text;
}

}  // namespace labmouse
