#pragma once

#include "libcanopen/node/node.hpp"

namespace device {

/// Where the frames of a node go: to the bus, or nowhere while that is off.
class BusOutlet {
 public:
  /// Both arguments must outlive this.
  BusOutlet(canopen::Node& node, canopen::FrameSink& sink) noexcept : node_{node}, sink_{&sink} {}
  /// Leads the frames of the node to the bus if @p is_on.
  void lead(bool is_on) noexcept {
    is_on_ = is_on;
    node_.send_to(is_on ? *sink_ : nowhere_);
  }
  /// From now on the bus is @p sink, which must outlive this.
  void connect(canopen::FrameSink& sink) noexcept {
    sink_ = &sink;
    lead(is_on_);
  }

 private:
  struct Nowhere final : canopen::FrameSink {
    void send(const canopen::Frame&, canopen::Delivery) override {}
  };

  canopen::Node& node_;
  canopen::FrameSink* sink_;
  bool is_on_ = true;
  Nowhere nowhere_{};
};

}  // namespace device
