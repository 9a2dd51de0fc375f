#pragma once

#include <chrono>
#include <thread>

#include "tests/e2e/can_client.hpp"
#include "tests/e2e/program.hpp"
#include "tests/sdo/sdo_client.hpp"

namespace e2e {

/// The client of the default SDO server of node 5.
class BusSdoClient final : public sdo_test::SdoClient {
 public:
  BusSdoClient() { can_.listen_to({kAnswer}); }

  /// The statusword @p index comes to @p wanted. It is asked for once in the time of a cycle: candump has to keep
  /// up.
  testing::AssertionResult comes_to(std::uint16_t index, const DriveState& wanted,
                                    std::chrono::seconds patience = kPatience) {
    const auto end = std::chrono::steady_clock::now() + patience;
    while (std::chrono::steady_clock::now() < end) {
      if ((upload(index).number() & wanted.mask) == wanted.value) return testing::AssertionSuccess();
      std::this_thread::sleep_for(std::chrono::milliseconds{4});
    }
    return testing::AssertionFailure() << std::hex << index << "h never " << wanted.name;
  }

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
