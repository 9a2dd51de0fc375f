#pragma once

#include <cstddef>
#include <cstdint>

#include "libcanopen/base/export.hpp"
#include "libcanopen/service/context.hpp"

namespace canopen {

class IdentifierList;

/// When a service takes over its communication objects while the node boots or reloads.
enum class ReloadStage : std::uint8_t {
  Senders,      ///< before the others: what their values and errors cause is not sent under settings that are over
  Values,       ///< the rest
  AfterBootUp,  ///< error control: when all identifiers are claimed and the boot-up message is out
};

/// What happens to what a service has been doing.
enum class Reload : std::uint8_t {
  Afresh,    ///< the node boots: nothing goes on
  TakeOver,  ///< Node::reload(): what has not changed goes on undisturbed
};

/// What a node must know of a service to run it.
struct ServiceFacts {
  NmtStates lives_in;           ///< in other NMT states it gets no frame and no timer
  std::size_t identifiers = 0;  ///< most that it names in list_identifiers()
  std::size_t timers = 0;
  ReloadStage stage = ReloadStage::Values;
};

/// A service of a node: what listens to identifiers of its own, sends, or keeps time. It registers itself when it
/// is constructed, before the node starts; the node knows it by what stands here alone. Of two services that want
/// one identifier the one registered first gets its frames, and of timers due at the same time its timers come
/// first.
class CANOPEN_EXPORT Service {
 public:
  virtual ~Service() = default;
  Service(const Service&) = delete;
  Service& operator=(const Service&) = delete;

  /// Names the identifiers that the service works with now, no matter in which NMT state. Whenever they change it
  /// calls IdentifierUse::on_identifiers_changed().
  virtual void list_identifiers(IdentifierList& list) const noexcept { (void)list; }
  /// A data frame of the identifier that was listed with @p slot.
  virtual void on_frame(const Frame& frame, std::size_t slot) noexcept { (void)frame, (void)slot; }
  /// A remote frame of the identifier that was listed with @p slot.
  virtual void on_request(std::size_t slot) noexcept { (void)slot; }
  /// Timer @p which of the service is due; it is no longer armed.
  virtual void on_timer(std::size_t which) noexcept { (void)which; }
  /// The dictionary has other values, or the node boots: takes over what its communication objects say.
  virtual void reload(Reload how) noexcept { (void)how; }
  /// Takes those of its identifiers that no other service uses; all other services have theirs already.
  virtual void claim_identifiers() noexcept {}
  /// The service lives from now on, and the application knows it; again after a reload.
  virtual void start() noexcept {}
  /// The service does not live any longer.
  virtual void stop() noexcept {}

 protected:
  /// Registers itself with the node of @p context. Throws std::length_error if that has too many services.
  Service(Context& context, const ServiceFacts& facts);
  /// One that no node knows.
  explicit Service(Context& context) noexcept : context_{context} {}

  /// Sets or moves the deadline of timer @p which.
  void arm(std::size_t which, TimePoint when) noexcept { context_.timers.arm(first_timer_ + which, when); }
  /// Nothing happens if timer @p which is not armed.
  void cancel(std::size_t which) noexcept { context_.timers.cancel(first_timer_ + which); }
  bool is_armed(std::size_t which) const noexcept { return context_.timers.is_armed(first_timer_ + which); }
  /// The number of its first timer in the queue of the node.
  std::size_t first_timer() const noexcept { return first_timer_; }

  Context& context_;

 private:
  std::size_t first_timer_ = 0;
};

}  // namespace canopen
