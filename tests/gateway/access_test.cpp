#include "gateway/security/access.hpp"

#include <gtest/gtest.h>

namespace gateway {
namespace {

constexpr const char* kToken = "0123456789abcdef0123456789abcdef";

class AccessTest : public testing::Test {
 protected:
  /// The code of the refusal, "granted" without one.
  [[nodiscard]] std::string judge() const {
    const auto outcome = check_access(rules, request);
    return outcome ? "granted" : outcome.error().code;
  }
  std::string of_host(const std::string& host) {
    request.hosts = {host};
    return judge();
  }
  std::string of_origin(const std::string& origin) {
    request.origins = {origin};
    return judge();
  }
  std::string of_authorization(const std::string& authorization) {
    request.authorizations = {authorization};
    return judge();
  }

  AccessRules rules{.listen = {{"127.0.0.1", 8402}}, .token = kToken};
  Credentials request{.hosts = {"localhost:8402"}};
};

TEST_F(AccessTest, HostIsANameOfThisMachine) {
  for (const char* const host : {"localhost:8402", "127.0.0.1", "[::1]:99", "LOCALHOST"})
    EXPECT_EQ(of_host(host), "granted");
  for (const char* const host :
       {"evil.example", "evil.example:8402", "10.0.0.1:8402", "", "localhost.evil.example"})
    EXPECT_EQ(of_host(host), "wrong-host") << host;
}

TEST_F(AccessTest, HostIsThereOnce) {
  request.hosts.clear();
  EXPECT_EQ(judge(), "wrong-host");
  request.hosts = {"localhost", "localhost"};
  EXPECT_EQ(judge(), "wrong-host");
}

TEST_F(AccessTest, HostMayBeAnAddressThatIsServedAndANameThatIsAllowed) {
  rules.listen = {{"10.0.0.1", 8402}};
  rules.allow_hosts = {"drive.lab"};
  EXPECT_EQ(of_host("10.0.0.1:8402"), "granted");
  EXPECT_EQ(of_host("Drive.Lab"), "granted");
  EXPECT_EQ(of_host("10.0.0.2"), "wrong-host");
}

TEST_F(AccessTest, WhereAllAddressesAreServedEachIsAHostButNoNameIs) {
  rules.listen = {{"0.0.0.0", 8402}};
  EXPECT_EQ(of_host("10.0.0.2:8402"), "granted");
  EXPECT_EQ(of_host("evil.example"), "wrong-host");
}

TEST_F(AccessTest, PagesOfTheServerItselfMayUseIt) {
  EXPECT_EQ(of_origin("http://localhost:8402"), "granted");
  for (const char* const origin :
       {"http://evil.example", "null", "http://localhost:3000", "http://127.0.0.1:8402", ""})
    EXPECT_EQ(of_origin(origin), "forbidden-origin") << origin;
  request.origins = {"http://localhost:8402", "http://evil.example"};
  EXPECT_EQ(judge(), "forbidden-origin");
}

TEST_F(AccessTest, PagesOfOthersMayWhereTheyAreAllowed) {
  rules.allow_origins = {"http://localhost:3000"};
  EXPECT_EQ(of_origin("http://localhost:3000"), "granted");
  EXPECT_EQ(shared_origin(rules, request), "http://localhost:3000");
  EXPECT_EQ(of_origin("http://localhost:8402"), "granted");
  EXPECT_EQ(shared_origin(rules, request), std::nullopt);
}

TEST_F(AccessTest, WritingNeedsTheToken) {
  request.is_write = true;
  EXPECT_EQ(judge(), "token-missing");
  EXPECT_EQ(of_authorization(std::string{"Bearer "} + kToken), "granted");
  EXPECT_EQ(of_authorization(std::string{"bearer "} + kToken), "granted");
  EXPECT_EQ(of_authorization("Bearer 0123456789abcdef0123456789abcdeX"), "token-wrong");
  EXPECT_EQ(of_authorization("Bearer "), "token-wrong");
  EXPECT_EQ(of_authorization(kToken), "token-missing");
  EXPECT_EQ(of_authorization("Basic YTpi"), "token-missing");
}

TEST_F(AccessTest, WithoutATokenOfItsOwnTheServerTakesNone) {
  rules.token.clear();
  request.is_write = true;
  EXPECT_EQ(of_authorization("Bearer "), "token-wrong");
}

TEST_F(AccessTest, ReadOnlyIsReadOnlyWithTheTokenToo) {
  rules.read_only = true;
  EXPECT_EQ(judge(), "granted");
  request.is_write = true;
  EXPECT_EQ(of_authorization(std::string{"Bearer "} + kToken), "read-only-server");
}

TEST(ConstantTime, TellsSameFromOther) {
  EXPECT_TRUE(equal_in_constant_time("abc", "abc"));
  EXPECT_TRUE(equal_in_constant_time("", ""));
  for (const std::string_view other : {"abd", "bbc", "ab", "abcd", ""})
    EXPECT_FALSE(equal_in_constant_time("abc", other));
}

}  // namespace
}  // namespace gateway
