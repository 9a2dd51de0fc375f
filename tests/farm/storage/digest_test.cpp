#include "farm/storage/digest.hpp"

#include <gtest/gtest.h>

namespace farm {
namespace {

TEST(Digest, OfKnownTextsIsKnown) {  // FIPS 180-2, appendix B
  EXPECT_EQ(digest_of(""), "SHA-256=47DEQpj8HBSa-_TImW-5JCeuQeRkm5NMpJWZG3hSuFU=");
  EXPECT_EQ(digest_of("abc"), "SHA-256=ungWv48Bz-pBQUDeXa4iI7ADYaOWF3qctBD_YfIAFa0=");
}

TEST(Base64Url, IsPadded) {  // RFC 4648, 10
  EXPECT_EQ(base64url(""), "");
  EXPECT_EQ(base64url("f"), "Zg==");
  EXPECT_EQ(base64url("fo"), "Zm8=");
  EXPECT_EQ(base64url("foo"), "Zm9v");
  EXPECT_EQ(base64url("foob"), "Zm9vYg==");
}

TEST(Base64Url, HasLettersThatASubjectMayHave) {
  EXPECT_EQ(base64url("\xFB\xEF\xFF"), "--__");
}

}  // namespace
}  // namespace farm
