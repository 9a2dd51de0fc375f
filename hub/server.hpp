#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "bus/descriptor.hpp"
#include "hub/medium.hpp"
#include "hub/source.hpp"

namespace hub {

/// The loop of a hub: its members, its timers, and the sources beside them. One thread; nobody is waited for.
class Server final : public SourceList {
 public:
  /// How a hub behaves.
  struct Settings {
    std::uint32_t bit_rate = 0;  ///< bit/s, 0 = frames take no time
    bool on_demand = false;      ///< ends one second after its last member has left, or if none ever came
  };

  /// Serves @p listener, a listening AF_UNIX SOCK_SEQPACKET socket; std::system_error if the kernel has no
  /// descriptors or memory left.
  Server(bus::Descriptor listener, Settings settings);
  ~Server() override;

  void add(Source& source) override;
  void remove(Source& source) noexcept override;

  /// The wire, for sources that take part.
  Medium& medium() noexcept { return medium_; }

  /// Serves until stop(), or until the end that Settings::on_demand asks for.
  void run();
  /// Ends run() after the present turn; to be called from within it, by a source.
  void stop() noexcept { stopped_ = true; }

 private:
  Medium medium_;
  bool stopped_ = false;
};

}  // namespace hub
