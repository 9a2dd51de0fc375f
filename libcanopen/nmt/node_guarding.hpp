#pragma once

#include "libcanopen/base/export.hpp"
#include "libcanopen/node/context.hpp"

namespace canopen {

/// Answers node guarding and watches the master's life (CiA 301, 7.2.8.3.2.1; objects 100Ch guard time in ms and
/// 100Dh life time factor, 0 = off). Watching begins with the first request. While the node is a heartbeat
/// producer (1017h) there is no guarding; the policy says whether a write that would switch on both is refused.
class CANOPEN_EXPORT NodeGuarding final : public EntryOwner {
 public:
  /// @p timer is the number of its timer in the context's queue. To be constructed before the heartbeat producer,
  /// so that it is asked first whether 1017h may change.
  NodeGuarding(Context& context, std::size_t timer);

  /// Starts over with the values of the objects; the toggle bit is 0 again.
  void reload() noexcept;
  /// True if the node has the objects, so that remote frames are to be received.
  bool is_on() const noexcept { return exists_; }
  /// A remote frame asks for the NMT state.
  void on_request() noexcept;
  /// The life time is over.
  void on_timer() noexcept;

  Result<void> write(const Entry& entry, std::int64_t value) override;

 private:
  std::int64_t stored(std::uint16_t index) const noexcept;
  Result<void> judge(const Entry& entry, std::int64_t value) const noexcept;
  void stop() noexcept;

  Context& context_;
  std::size_t timer_;
  bool exists_;
  std::uint8_t toggle_ = 0;  ///< of the next answer: 0 or 80h
  Duration life_time_{};     ///< 0: not watched
  TimePoint deadline_{};     ///< the timer is not moved with every request
  bool watches_ = false;
  bool lost_ = false;
};

}  // namespace canopen
