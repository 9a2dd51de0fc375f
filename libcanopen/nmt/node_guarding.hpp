#pragma once

#include "libcanopen/base/export.hpp"
#include "libcanopen/node/context.hpp"

namespace canopen {

/// Answers node guarding and watches the master's life (CiA 301, 7.2.8.3.2.1; objects 100Ch guard time in ms and
/// 100Dh life time factor, 0 = off). Watching begins with the first request.
class CANOPEN_EXPORT NodeGuarding final : public EntryOwner {
 public:
  /// @p timer is the number of its timer in the context's queue.
  NodeGuarding(Context& context, std::size_t timer);

  /// Starts over with the values of the objects; the toggle bit is 0 again.
  void reload() noexcept;
  /// True while remote frames are to be answered.
  bool is_on() const noexcept { return true; }
  /// A remote frame asks for the NMT state.
  void on_request() noexcept;
  /// The life time is over.
  void on_timer() noexcept;

  Result<void> write(const Entry& entry, std::int64_t value) override;

 private:
  Context& context_;
  std::size_t timer_;
};

}  // namespace canopen
