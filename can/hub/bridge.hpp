#pragma once

#include <algorithm>
#include <optional>
#include <string>

#include "can/connection/connection.hpp"
#include "can/connection/transmit_queue.hpp"
#include "can/hub/medium/medium.hpp"
#include "can/hub/medium/source.hpp"
#include "can/hub/notices.hpp"
#include "os/pollable.hpp"

namespace hub {

/// Joins another bus to the medium: what passes here goes there, and the other way round, but no frame goes back
/// to where it came from. Error frames stay where they are. A bus that is lost and comes back is joined again.
/// Between hubs frames carry marks, so that each passes once, whatever ring the bridges make.
class Bridge final : public Source, public Participant {
 public:
  /// Frames that wait here while the other bus has no room; more are lost and counted.
  static constexpr std::size_t kQueue = 1024;

  /// Takes part in @p medium until its end. @p name, a URL or the name of an interface, stands in statistics and
  /// in what @p notice gets: its link went down or up, the error state of its controller has changed.
  /// std::system_error if the kernel gives no descriptor.
  Bridge(Medium& medium, bus::Connection connection, std::string name, Notice notice);
  Bridge(const Bridge&) = delete;
  Bridge& operator=(const Bridge&) = delete;
  ~Bridge() override;

  [[nodiscard]] int descriptor() const noexcept override { return ready_.descriptor(); }
  void on_readable(canopen::TimePoint now) noexcept override;
  [[nodiscard]] canopen::TimePoint next_deadline() const noexcept override {
    return std::min(queue_.next_retry(), notices_.due());
  }
  void on_time(canopen::TimePoint now) noexcept override;
  [[nodiscard]] bool statistics(userbus::MemberStatistics& row) const noexcept override;

  void receive(const Passage& passage) noexcept override;
  void on_room() noexcept override;
  [[nodiscard]] Identity identity() const noexcept override;

 private:
  void follow_link(canopen::TimePoint now) noexcept;
  void read_frames(canopen::TimePoint now) noexcept;
  void put_on_medium(const canopen::Frame& frame, canopen::TimePoint now) noexcept;

  Medium& medium_;
  bus::Connection connection_;
  os::Pollable ready_;  ///< of port and link
  bus::TransmitQueue queue_;
  Notices notices_;
  std::optional<Passage> refused_;  ///< waits for room on the medium; meanwhile the port is not read
  std::uint64_t brought_ = 0;       ///< frames of the other bus
  std::uint64_t returned_ = 0;      ///< those that had been here before
};

}  // namespace hub
