#pragma once

#include "can/preload/socket/link.hpp"
#include "can/preload/socket/stamps.hpp"
#include "can/userbus/name.hpp"

namespace preload {

/// What calls on a CAN socket need to know of it.
struct SocketState {
  int32_t interface_index = -1;  ///< that it is bound to; 0 = all, -1 = not bound
  bool has_bit_rate = false;     ///< frames take time on the bus, and its queue can be full
  LinkWord* link = nullptr;      ///< whether the bus is whole; nullptr: it ends with its hub
  bool counts_dropped = false;   ///< SO_RXQ_OVFL
  Stamps stamps = Stamps{};      ///< SO_TIMESTAMP…

  /// Whether nothing can be sent at present.
  [[nodiscard]] bool is_cut() const noexcept { return link != nullptr && link->load() == 0; }
  /// Whether what is sent waits for the bus, in a queue that can be full.
  [[nodiscard]] bool has_queue() const noexcept { return has_bit_rate || link != nullptr; }
};

/// The state of CAN socket @p name at @p descriptor: as remembered, else as the hub tells. False with errno.
bool state_of(int descriptor, const userbus::Name& name, SocketState& state) noexcept;

/// The same for who can go on without: a state as at first if the hub has gone.
SocketState state_or_default(int descriptor, const userbus::Name& name) noexcept;

/// To be called after the hub has changed the state of any CAN socket for this process: nothing that was
/// remembered before is true any more.
void state_has_changed() noexcept;

/// Keeps when (ns, CLOCK_REALTIME) a message came in, for SIOCGSTAMP.
void note_received(int descriptor, const userbus::Name& name, int64_t time_ns) noexcept;

/// When the last message came in (ns, CLOCK_REALTIME); 0: none did.
int64_t last_received(int descriptor, const userbus::Name& name) noexcept;

/// Forgets what is remembered of @p descriptor.
void forget(int descriptor) noexcept;

}  // namespace preload
