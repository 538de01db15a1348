#include "labmouse/lab/text/packing.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "labmouse/chance/rng.hpp"
#include "tests/lab/reports/unpacking.hpp"

namespace labmouse {
namespace {

TEST(Base64, IsThatOfItsStandard) {
  // The examples of RFC 4648.
  EXPECT_EQ(base64(""), "");
  EXPECT_EQ(base64("f"), "Zg==");
  EXPECT_EQ(base64("fo"), "Zm8=");
  EXPECT_EQ(base64("foo"), "Zm9v");
  EXPECT_EQ(base64("foob"), "Zm9vYg==");
  EXPECT_EQ(base64("\xFB\xFF\xBF"), "+/+/");
}

RC_GTEST_PROP(Packing, LosesNothing, (const std::string& bytes)) {
  RC_ASSERT(test::from_base64(base64(bytes)) == bytes);
  RC_ASSERT(test::from_gzip(gzip(bytes)) == bytes);
}

TEST(Packing, OfMoreThanABufferLosesNothing) {
  Rng rng(1);
  std::string bytes;
  while (bytes.size() < 1'000'000) bytes += static_cast<char>(rng.bits() & 0xFFU);
  EXPECT_EQ(test::from_gzip(gzip(bytes)), bytes);
  EXPECT_LT(gzip(std::string(1'000'000, 'a')).size(), 2'000U);
}

TEST(Packing, HoldsNoTime) {
  // Bytes 4 to 7 of gzip are the time of a file; 0 is none. Byte 3 has no bit for a name.
  EXPECT_EQ(gzip("a mouse").substr(3, 5), std::string(5, '\0'));
}

}  // namespace
}  // namespace labmouse
