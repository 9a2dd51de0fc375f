#pragma once

#include "libcanopen/service/service.hpp"

namespace canopen {

/// Answers node guarding and watches the master's life (CiA 301, 7.2.8.3.2.1; objects 100Ch guard time in ms and
/// 100Dh life time factor, 0 = off). Watching begins with the first request. While 1017h is not 0 the heartbeat
/// takes its place: no request is answered and no life time runs.
class NodeGuarding final : public Service, public EntryOwner {
 public:
  /// Answers if the dictionary has both objects. To be constructed before the heartbeat producer, so that it is
  /// asked first whether 1017h may change.
  explicit NodeGuarding(Context& context);

  void list_identifiers(IdentifierList& list) const noexcept override;
  /// Afresh: the toggle bit is 0 again. Else it goes on too, and another life time is counted from now on.
  void reload(Reload how) noexcept override;
  /// A remote frame asks for the NMT state.
  void on_request(std::size_t slot) noexcept override;
  /// The life time may be over.
  void on_timer(std::size_t which) noexcept override;

  /// InvalidValue if the policy says Refuse and both life guarding and the heartbeat would be on, DeviceState if
  /// life guarding would be on where there are no remote frames.
  Result<void> write(const Entry& entry, std::int64_t value) override;

 private:
  enum class Life : std::uint8_t { Unwatched, Present, Lost };

  std::int64_t stored(std::uint16_t index) const noexcept;
  Duration stored_life_time() const noexcept;
  Result<void> check(const Entry& entry, std::int64_t value) noexcept;
  void begin_anew() noexcept;
  void take_over() noexcept;
  void switch_heartbeat(bool on) noexcept;
  void set_life_time(Duration life_time) noexcept;
  void watch() noexcept;
  void stop_watching() noexcept;

  Duration life_time_{};
  TimePoint deadline_{};
  Life master_ = Life::Unwatched;
  bool exists_;
  bool heartbeat_ = false;
  bool toggle_ = false;
};

}  // namespace canopen
