// The way back from the blocks of a report.
#pragma once

#include <gtest/gtest.h>
#include <unistd.h>
#include <zlib.h>

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>

namespace labmouse::test {

/// The bytes of a base64 text, which must be whole.
inline std::string from_base64(std::string_view text) {
  constexpr std::string_view digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string bytes;
  EXPECT_EQ(text.size() % 4, 0U);
  unsigned bits = 0, count = 0;
  for (const char letter : text.substr(0, text.find('='))) {
    const auto digit = digits.find(letter);
    EXPECT_NE(digit, std::string_view::npos) << letter;
    bits = bits << 6U | static_cast<unsigned>(digit & 63U);
    if ((count += 6) < 8) continue;
    count -= 8;
    bytes += static_cast<char>(bits >> count & 0xFFU);
  }
  return bytes;
}

/// The bytes that gzip packed.
inline std::string from_gzip(std::string packed) {
  std::string bytes(packed.size() * 1100 + 1000, '\0');  // deflate packs 1032 to 1 at best
  z_stream stream{};
  EXPECT_EQ(inflateInit2(&stream, MAX_WBITS + 16), Z_OK);
  stream.next_in = reinterpret_cast<Bytef*>(packed.data());
  stream.avail_in = static_cast<uInt>(packed.size());
  stream.next_out = reinterpret_cast<Bytef*>(bytes.data());
  stream.avail_out = static_cast<uInt>(bytes.size());
  EXPECT_EQ(inflate(&stream, Z_FINISH), Z_STREAM_END);
  EXPECT_EQ(stream.avail_in, 0U);
  bytes.resize(stream.total_out);
  inflateEnd(&stream);
  return bytes;
}

/// The JSON in the block of that name, as a browser finds it.
inline nlohmann::ordered_json block_of(const std::string& page, const std::string& name) {
  const std::string begin = "<script type=\"text/plain\" id=\"" + name + "\">";
  const auto at = page.find(begin);
  if (at == std::string::npos) return ADD_FAILURE() << "no block " << name, nlohmann::ordered_json();
  EXPECT_EQ(page.find(begin, at + 1), std::string::npos);
  const auto from = at + begin.size();
  return nlohmann::ordered_json::parse(
      from_gzip(from_base64(std::string_view(page).substr(from, page.find("</script>", from) - from))));
}

/// An empty folder of this test, which goes with it.
class AFolder {
 public:
  AFolder() { std::filesystem::create_directories(path_); }
  AFolder(const AFolder&) = delete;
  AFolder& operator=(const AFolder&) = delete;
  ~AFolder() { std::filesystem::remove_all(path_); }
  std::string path() const { return path_.string(); }

 private:
  static std::string name_of_test() {
    std::string name = testing::UnitTest::GetInstance()->current_test_info()->name();
    std::replace(name.begin(), name.end(), '/', '-');
    return name;
  }

  std::filesystem::path path_ =
      std::filesystem::temp_directory_path() / ("labmouse-lab-" + std::to_string(getpid()) + "-" + name_of_test());
};

}  // namespace labmouse::test
