#pragma once

#include <functional>

#include "bench/trunk/tally.hpp"
#include "can/hub/medium/medium.hpp"

namespace bench {

/// Traffic without members: sends numbered frames as fast as a hub's medium takes them, and keeps account of all
/// that pass.
class Load final : public hub::Participant {
 public:
  struct Settings {
    unsigned sender = 0;  ///< its number, below `senders`
    unsigned senders = 1;
    std::uint32_t count = 0;  ///< frames of each of them
  };
  /// Takes part in @p medium; calls @p on_complete when the frames of all have passed.
  Load(hub::Medium& medium, Settings settings, std::function<void()> on_complete);
  Load(const Load&) = delete;
  Load& operator=(const Load&) = delete;
  ~Load() override;

  /// Sends from now on.
  void begin(canopen::TimePoint now) noexcept;
  [[nodiscard]] const Tally& tally() const noexcept { return tally_; }

  void receive(const hub::Passage& passage) noexcept override;
  void on_room() noexcept override { begin(medium_.now()); }

 private:
  hub::Medium& medium_;
  Settings settings_;
  std::function<void()> on_complete_;
  Tally tally_;
  std::uint32_t sent_ = 0;
};

}  // namespace bench
