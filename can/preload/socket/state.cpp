#include "can/preload/socket/state.hpp"

#include <atomic>
#include <cerrno>

#include "can/preload/hub.hpp"

namespace preload {

namespace {

/// What is remembered of the socket at one descriptor. Nobody ever waits for another, since a call may come from a
/// signal handler: who finds a memory being written does without.
struct Memory {
  std::atomic<uint64_t> number;  ///< the socket's, from its name; 0 = the rest means nothing
  std::atomic<LinkWord*> link;
  std::atomic<uint32_t> change;  ///< the last one when the hub was asked
  std::atomic<int32_t> interface_index;
  std::atomic<uint32_t> stamps;
  std::atomic<bool> has_bit_rate;
  std::atomic<bool> counts_dropped;
  std::atomic<bool> busy;          ///< somebody is writing
  std::atomic<uint64_t> receiver;  ///< number of the socket that last_received is of
  std::atomic<int64_t> last_received;
};

/// Sockets at greater descriptors work, too, but ask the hub every time.
constexpr int kMostDescriptors = 4096;

Memory memories[kMostDescriptors];
std::atomic<uint32_t> changes;

Memory* memory_of(int descriptor) noexcept {
  return descriptor >= 0 && descriptor < kMostDescriptors ? &memories[descriptor] : nullptr;
}

/// False if @p memory is not of socket @p number, or is out of date.
bool remember(const Memory& memory, uint64_t number, SocketState& state) noexcept {
  if (memory.number != number || memory.change != changes) return false;
  state.interface_index = memory.interface_index;
  state.has_bit_rate = memory.has_bit_rate;
  state.link = memory.link;
  state.counts_dropped = memory.counts_dropped;
  state.stamps = Stamps{memory.stamps};
  return memory.number == number;
}

/// Writes what was true after @p change.
void keep(Memory& memory, uint64_t number, const SocketState& state, uint32_t change) noexcept {
  if (memory.busy.exchange(true)) return;
  memory.number = 0;
  memory.change = change;
  memory.interface_index = state.interface_index;
  memory.has_bit_rate = state.has_bit_rate;
  memory.link = state.link;
  memory.counts_dropped = state.counts_dropped;
  memory.stamps = state.stamps.value();
  memory.number = number;
  memory.busy = false;
}

uint32_t option(const userbus::MemberState& state, userbus::OptionName name) noexcept {
  return state.options[static_cast<size_t>(name)];
}

bool ask_hub(int descriptor, SocketState& state) noexcept {
  userbus::MemberState answer{};
  const userbus::Answer outcome = ask(descriptor, userbus::Operation::ReadState, 0, &answer, sizeof answer);
  if (outcome.error != 0 || outcome.size != sizeof answer) {
    errno = outcome.error != 0 ? outcome.error : ENETDOWN;
    return false;
  }
  state.interface_index = answer.interface_index;
  state.has_bit_rate = answer.bit_rate != 0;
  state.link = link_of(descriptor);
  state.counts_dropped = option(answer, userbus::OptionName::CountDropped) != 0;
  state.stamps = Stamps{option(answer, userbus::OptionName::Timestamps)};
  return true;
}

}  // namespace

bool state_of(int descriptor, const userbus::Name& name, SocketState& state) noexcept {
  Memory* const memory = memory_of(descriptor);
  if (memory != nullptr && remember(*memory, name.number, state)) return true;
  if (name.kind == userbus::Kind::Down) {
    errno = ENETDOWN;
    return false;
  }
  const uint32_t change = changes;  // before the hub is asked: what another thread changes meanwhile counts
  if (!ask_hub(descriptor, state)) return false;
  if (memory != nullptr) keep(*memory, name.number, state, change);
  return true;
}

SocketState state_or_default(int descriptor, const userbus::Name& name) noexcept {
  const int error = errno;
  SocketState state;
  if (!state_of(descriptor, name, state)) state = SocketState{};
  errno = error;
  return state;
}

void state_has_changed() noexcept {
  ++changes;
}

void note_received(int descriptor, const userbus::Name& name, int64_t time_ns) noexcept {
  Memory* const memory = memory_of(descriptor);
  if (memory == nullptr) return;
  memory->last_received.store(time_ns, std::memory_order_relaxed);
  memory->receiver.store(name.number, std::memory_order_release);
}

int64_t last_received(int descriptor, const userbus::Name& name) noexcept {
  const Memory* const memory = memory_of(descriptor);
  if (memory == nullptr || memory->receiver.load(std::memory_order_acquire) != name.number) return 0;
  return memory->last_received.load(std::memory_order_relaxed);
}

void forget(int descriptor) noexcept {
  Memory* const memory = memory_of(descriptor);
  if (memory == nullptr) return;
  memory->number = 0;
  memory->receiver = 0;
}

}  // namespace preload
