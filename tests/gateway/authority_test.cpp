#include "gateway/security/authority.hpp"

#include <gtest/gtest.h>

namespace gateway {
namespace {

std::string read_back(std::string_view text) {
  const auto authority = parse_authority(text);
  return authority ? authority->text() : "none";
}

TEST(Authority, IsANameOrAnAddressWithOrWithoutAPort) {
  EXPECT_EQ(read_back("localhost"), "localhost");
  EXPECT_EQ(read_back("LocalHost:8402"), "localhost:8402");
  EXPECT_EQ(read_back("127.0.0.1:80"), "127.0.0.1:80");
  EXPECT_EQ(read_back("[::1]:8402"), "[::1]:8402");
  EXPECT_EQ(read_back("[::1]"), "[::1]");
}

TEST(Authority, IsNothingElse) {
  for (const std::string_view text : {"", ":80", "a b", "a:", "a:b", "a:65536", "a:-1", "a@b", "a/b", "[::1",
                                      "[x]", "::1", "[::1]x", "a:80:80", "[127.0.0.1]"})
    EXPECT_EQ(read_back(text), "none") << text;
  EXPECT_EQ(read_back(std::string(300, 'a')), "none");
}

TEST(Authority, OriginHasAScheme) {
  EXPECT_EQ(parse_origin("http://localhost:8402")->text(), "http://localhost:8402");
  EXPECT_EQ(parse_origin("HTTPS://Drive.Lab")->text(), "https://drive.lab");
  for (const std::string_view text : {"null", "", "localhost", "file://", "ftp://localhost", "http://a/b"})
    EXPECT_FALSE(parse_origin(text)) << text;
}

TEST(Authority, LoopbackIsThisMachineAlone) {
  for (const std::string host : {"localhost", "127.0.0.1", "127.255.1.2", "::1"})
    EXPECT_TRUE(is_loopback(host)) << host;
  for (const std::string host :
       {"localhost.evil.example", "128.0.0.1", "0.0.0.0", "::", "::2", "127.0.0.1.nip.io", ""})
    EXPECT_FALSE(is_loopback(host)) << host;
}

TEST(Authority, WildcardIsEveryAddress) {
  for (const std::string host : {"0.0.0.0", "::"}) EXPECT_TRUE(is_wildcard(host)) << host;
  for (const std::string host : {"127.0.0.1", "::1", "localhost"}) EXPECT_FALSE(is_wildcard(host)) << host;
}

}  // namespace
}  // namespace gateway
