#pragma once

#include <utility>
#include <vector>

#include "libcanopen/base/frame.hpp"

namespace fakes {

/// A bus that keeps every frame it is given, in order.
class VectorBus final : public canopen::FrameSink {
 public:
  void send(const canopen::Frame& frame, canopen::Delivery delivery) override {
    sent.push_back(frame);
    deliveries.push_back(delivery);
  }
  /// The frames since the last call.
  std::vector<canopen::Frame> take() {
    deliveries.clear();
    return std::exchange(sent, {});
  }

  std::vector<canopen::Frame> sent;
  std::vector<canopen::Delivery> deliveries;  ///< of the frame at the same place in `sent`
};

}  // namespace fakes
