#include "can/nats/server.hpp"

#include <gtest/gtest.h>

namespace nats {
namespace {

TEST(NatsServer, IsOpenToOthersOnAnotherHostWithoutTls) {
  Server plain;
  plain.url = "nats://x:4222";
  Server safe;
  safe.url = "tls://x:4222";
  for (const char* const near : {"localhost", "127.0.0.1", "127.1.2.3", "::1"}) {
    EXPECT_FALSE(is_open_to_others(plain, near)) << near;
    EXPECT_FALSE(is_open_to_others(safe, near)) << near;
  }
  for (const char* const far :
       {"192.0.2.1", "server", "127.example.org", "localhost.example.org", "2001:db8::1"}) {
    EXPECT_TRUE(is_open_to_others(plain, far)) << far;
    EXPECT_FALSE(is_open_to_others(safe, far)) << far;
  }
}

}  // namespace
}  // namespace nats
