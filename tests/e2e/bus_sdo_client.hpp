#pragma once

#include "tests/e2e/can_client.hpp"
#include "tests/sdo/sdo_client.hpp"

namespace e2e {

/// The client of the default SDO server of node 5.
class BusSdoClient final : public sdo_test::SdoClient {
 public:
  BusSdoClient() { can_.listen_to({kAnswer}); }

 private:
  static constexpr std::uint32_t kAnswer = 0x585;

  std::optional<canopen::Frame> ask(const canopen::Frame& request) override {
    can_.send(request);
    auto answer = can_.next();
    while (answer && answer->id != kAnswer) answer = can_.next();  // what came before the filter
    return answer;
  }

  CanClient can_{kTestInterface};
};

}  // namespace e2e
