#pragma once

#include "can/hub/server.hpp"
#include "os/descriptor.hpp"

namespace canhub {

/// SIGTERM and SIGINT end the hub. To be made before there is any thread.
class Signals final : public hub::Source {
 public:
  /// Blocks the signals and takes them as messages instead; std::system_error.
  explicit Signals(hub::Server& server);
  Signals(const Signals&) = delete;
  Signals& operator=(const Signals&) = delete;
  ~Signals() override;

  [[nodiscard]] int descriptor() const noexcept override { return descriptor_.get(); }
  void on_readable(canopen::TimePoint now) noexcept override;

 private:
  hub::Server& server_;
  os::Descriptor descriptor_;
};

}  // namespace canhub
