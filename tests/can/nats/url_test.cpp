#include "can/nats/url.hpp"

#include <string>

#include <gtest/gtest.h>

namespace nats {
namespace {

TEST(NatsUrl, NamesAServerAndWhatIsMeantThere) {
  const auto url = parse_url("nats://server:4223/lab", "NAME");
  ASSERT_TRUE(url) << url.error();
  EXPECT_EQ(url->server.url, "nats://server:4223");
  EXPECT_EQ(url->host, "server");
  EXPECT_EQ(url->name, "lab");
}

TEST(NatsUrl, HasAUsualPort) {
  EXPECT_EQ(parse_url("tls://10.0.0.1/a-b_C9", "NAME")->server.url, "tls://10.0.0.1:4222");
  EXPECT_EQ(parse_url("nats://[::1]/lab", "NAME")->server.url, "nats://[::1]:4222");
  EXPECT_EQ(parse_url("nats://[::1]/lab", "NAME")->host, "::1");
}

TEST(NatsUrl, NamesNothingWhereNothingIsAskedFor) {
  const auto url = parse_url("nats://server", "");
  ASSERT_TRUE(url) << url.error();
  EXPECT_EQ(url->server.url, "nats://server:4222");
  EXPECT_EQ(url->name, "");
}

struct Wrong {
  const char* text;
  const char* what;
  std::string expected;
};

TEST(NatsUrl, SaysWhatWasExpected) {
  const std::string form = "expected nats://HOST[:PORT]/FARM or tls://HOST[:PORT]/FARM";
  const std::string name = "expected a name of 1 to 32 letters, digits, '-' and '_' behind the slash";
  for (const Wrong& wrong : {
           Wrong{"http://server/x", "FARM", form},
           Wrong{"server/x", "FARM", form},
           Wrong{"nats://server", "FARM", form},
           Wrong{"nats:///x", "FARM", form},
           Wrong{"nats://server/", "FARM", name},
           Wrong{"nats://server/a.b", "FARM", name},
           Wrong{"nats://server/a/b", "FARM", name},
           Wrong{"nats://server/123456789012345678901234567890123", "FARM", name},
           Wrong{"nats://u:p@server/x", "FARM", "expected no user in the URL: --credentials names a file"},
           Wrong{"nats://[::1/x", "FARM", "expected a ] behind the host"},
           Wrong{"nats://server:0/x", "FARM", "expected a port 1 to 65535 behind the host"},
           Wrong{"nats://server:/x", "FARM", "expected a port 1 to 65535 behind the host"},
           Wrong{"nats://server:70000/x", "FARM", "expected a port 1 to 65535 behind the host"},
           Wrong{"nats://server/x", "", "expected nats://HOST[:PORT] or tls://HOST[:PORT]"},
       }) {
    const auto url = parse_url(wrong.text, wrong.what);
    ASSERT_FALSE(url) << wrong.text;
    EXPECT_EQ(url.error(), wrong.expected) << wrong.text;
  }
}

}  // namespace
}  // namespace nats
