#include "can/hub/broadcast/broadcast_manager.hpp"

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <new>
#include <utility>

#include "can/hub/broadcast/reception.hpp"
#include "can/hub/broadcast/transmission.hpp"

namespace hub {

namespace {

using broadcast::Reception;
using broadcast::Request;
using broadcast::Transmission;

/// Where in @p operations the one that @p request names is.
template <class Operations>
auto find(Operations& operations, const Request& request) noexcept {
  return std::find_if(operations.begin(), operations.end(),
                      [&](const auto& operation) { return operation->is_named_by(request); });
}

template <class Operations>
int read_one(const Operations& operations, const Request& request) noexcept {
  const auto found = find(operations, request);
  if (found == operations.end()) return EINVAL;
  (*found)->read();
  return 0;
}

template <class Operations>
int delete_one(Operations& operations, const Request& request) noexcept {
  const auto found = find(operations, request);
  if (found == operations.end()) return EINVAL;
  operations.erase(found);
  return 0;
}

/// Where in @p operations a new one goes, so that a frame is told in the kernel's order: first to those for all
/// interfaces, and to the newest of each kind before the others.
template <class Operations>
auto place_of(Operations& operations, const Request& request) noexcept {
  return std::find_if(operations.begin(), operations.end(), [&](const auto& operation) {
    return request.interface_index == 0 || !operation->is_for_all_interfaces();
  });
}

/// Sets up the operation that @p request names, which is made if there is none and @p has_room.
template <class Operation>
int set_up_one(std::vector<std::unique_ptr<Operation>>& operations, const broadcast::Outlet& outlet,
               const Request& request, bool has_room) {
  if (const auto found = find(operations, request); found != operations.end()) return (*found)->set_up(request);
  if (!has_room) return ENOMEM;
  auto made = std::make_unique<Operation>(outlet, request);
  operations.reserve(operations.size() + 1);
  const int error = made->set_up(request);
  if (error == 0) operations.insert(place_of(operations, request), std::move(made));
  return error;
}

template <class Operations>
canopen::TimePoint earliest(const Operations& operations) noexcept {
  canopen::TimePoint due = canopen::kNever;
  for (const auto& operation : operations) due = std::min(due, operation->due());
  return due;
}

}  // namespace

/// What an opcode asks for.
struct BroadcastManager::Operation {
  std::uint32_t opcode;
  int (BroadcastManager::*carry_out)(const Request&);
};

BroadcastManager::BroadcastManager(Medium& medium, BroadcastSink& sink) : outlet_{medium, *this, sink} {
  medium.attach(*this);
  hear_what_is_watched();
}

BroadcastManager::~BroadcastManager() {
  outlet_.medium.detach(*this);
}

int BroadcastManager::request(std::span<const std::byte> message, int interface_index,
                              canopen::TimePoint now) noexcept {
  Request request{.head = {}, .frames = {}, .interface_index = interface_index, .now = now};
  if (message.size() < sizeof request.head) return EINVAL;
  std::memcpy(&request.head, message.data(), sizeof request.head);
  request.frames = message.subspan(sizeof request.head);
  if ((request.head.flags & CAN_FD_FRAME) != 0 || request.frames.size() % sizeof(can_frame) != 0) return EINVAL;
  try {
    return carry_out(request);
  } catch (const std::bad_alloc&) {
    return ENOMEM;
  }
}

int BroadcastManager::carry_out(const Request& request) {
  static constexpr std::array kOperations{
      Operation{TX_SETUP, &BroadcastManager::set_up_transmission},
      Operation{TX_SEND, &BroadcastManager::send_once},
      Operation{TX_DELETE, &BroadcastManager::delete_transmission},
      Operation{TX_READ, &BroadcastManager::read_transmission},
      Operation{RX_SETUP, &BroadcastManager::set_up_reception},
      Operation{RX_DELETE, &BroadcastManager::delete_reception},
      Operation{RX_READ, &BroadcastManager::read_reception},
  };
  const auto* const found = std::find_if(kOperations.begin(), kOperations.end(),
                                         [&](const Operation& row) { return row.opcode == request.head.opcode; });
  return found == kOperations.end() ? EINVAL : (this->*found->carry_out)(request);
}

int BroadcastManager::set_up_transmission(const Request& request) {
  if (request.interface_index == 0) return ENODEV;
  if (request.head.nframes == 0 || request.head.nframes > userbus::kMostBcmFrames) return EINVAL;
  if (!broadcast::has_valid_intervals(request.head)) return EINVAL;
  return set_up_one(transmissions_, outlet_, request, has_room());
}

int BroadcastManager::set_up_reception(const Request& request) {
  const Request normal = Reception::normal(request);
  if (const int error = Reception::check(normal); error != 0) return error;
  const int error = set_up_one(receptions_, outlet_, normal, has_room());
  hear_what_is_watched();
  return error;
}

int BroadcastManager::send_once(const Request& request) {
  if (request.head.nframes != 1 || request.frames.size() != sizeof(can_frame)) return EINVAL;
  if (request.interface_index == 0) return ENODEV;
  const can_frame frame = request.frame(0);
  if (frame.can_dlc > CAN_MAX_DLEN) return EINVAL;
  return outlet_.send(frame, request.interface_index, request.now) ? 0 : ENOBUFS;
}

int BroadcastManager::delete_transmission(const Request& request) {
  return delete_one(transmissions_, request);
}

int BroadcastManager::delete_reception(const Request& request) {
  const int error = delete_one(receptions_, request);
  hear_what_is_watched();
  return error;
}

int BroadcastManager::read_transmission(const Request& request) {
  return read_one(transmissions_, request);
}

int BroadcastManager::read_reception(const Request& request) {
  return read_one(receptions_, request);
}

/// Most only send.
void BroadcastManager::hear_what_is_watched() noexcept {
  const bool hears = !receptions_.empty();
  if (hears == std::exchange(hears_, hears)) return;
  if (hears)
    outlet_.medium.hear_all(*this);
  else
    outlet_.medium.hear_nothing(*this);
}

bool BroadcastManager::has_room() const noexcept {
  return transmissions_.size() + receptions_.size() < kMostOperations;
}

canopen::TimePoint BroadcastManager::next_deadline() const noexcept {
  return std::min(earliest(transmissions_), earliest(receptions_));
}

void BroadcastManager::on_time(canopen::TimePoint now) noexcept {
  for (const auto& transmission : transmissions_) transmission->on_time(now);
  for (const auto& reception : receptions_) reception->on_time(now);
}

void BroadcastManager::receive(const Passage& passage) noexcept {
  if (!passage.loopback || (passage.frame.can_id & CAN_ERR_FLAG) != 0) return;
  for (const auto& reception : receptions_) reception->receive(passage, outlet_.medium.now());
}

}  // namespace hub
