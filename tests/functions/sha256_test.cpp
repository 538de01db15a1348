#include "labmouse/functions/sha256.hpp"

#include <gtest/gtest.h>

#include <string>

namespace labmouse {
namespace {

std::string hex_of(std::string_view text) {
  std::string hex;
  constexpr std::string_view digits = "0123456789abcdef";
  for (const std::uint8_t byte : sha256(text)) hex = hex + digits[byte / 16U] + digits[byte % 16U];
  return hex;
}

// The examples of FIPS 180-4.
TEST(Sha256OfExamples, AreThoseOfTheStandard) {
  EXPECT_EQ(hex_of(""), "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
  EXPECT_EQ(hex_of("abc"), "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
  EXPECT_EQ(hex_of("abcdbcdecdefdefgefghfghighijhijkijkljklmklmnlmnomnopnopq"),
            "248d6a61d20638b8e5c026930c3e6039a33ce45964ff2167f6ecedd419db06c1");
  EXPECT_EQ(hex_of(std::string(1'000'000, 'a')), "cdc76e5c9914fb9281a1c7e284d73e67f1809a48a497200e046d39ccc7112cd0");
}

// The length does not fit behind 56 to 63 bytes of a block.
TEST(Sha256OfExamples, AreRightAboutTheEndOfABlock) {
  EXPECT_EQ(hex_of(std::string(55, 'a')), "9f4390f8d30c2dd92ec9f095b65e2b9ae9b0a925a5258e241c9f1e910f734318");
  EXPECT_EQ(hex_of(std::string(63, 'a')), "7d3e74a05d7db15bce4ad9ec0658ea98e3f06eeecf16b4c6fff2da457ddc2f34");
  EXPECT_EQ(hex_of(std::string(64, 'a')), "ffe054fe7ae0cb6dc65c3af9b61d5209f439851db43d0ba5997337df154668eb");
}

}  // namespace
}  // namespace labmouse
