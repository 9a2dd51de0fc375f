#include "can/hub/member/outbox.hpp"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <new>
#include <utility>

#include <sys/socket.h>

namespace hub {

namespace {

/// Whether the socket may take with errno @p error what it has refused: it is full, or memory is short.
bool passes(int error) noexcept {
  return error == EAGAIN || error == ENOBUFS || error == ENOMEM;
}

/// Of as many frames as may be gathered.
constexpr auto kFrameLengths = [] {
  std::array<std::uint32_t, userbus::kMostFrames> lengths{};
  lengths.fill(sizeof(userbus::FrameMessage));
  return lengths;
}();

}  // namespace

void Outbox::set_most_frames(std::size_t most) noexcept {
  in_one_ = most > 1;
  most_at_once_ = in_one_ ? most : kAtOnce;
}

/// What goes with several messages, or has found no room at once.
void Outbox::hand_over_rest() noexcept {
  const std::span frames = std::span{gathered_}.first(std::exchange(count_, 0));
  const Batch batch{std::as_bytes(frames), std::span{kFrameLengths}.first(frames.size())};
  const Outcome outcome = empty() ? write(batch) : Outcome{};
  taken_ += outcome.sent;
  dropped_ += static_cast<std::uint32_t>(outcome.lost);
  for (std::size_t i = outcome.sent + outcome.lost; i < frames.size(); ++i)
    if (keep(std::as_bytes(frames.subspan(i, 1))))
      ++taken_;
    else
      ++dropped_;
}

void Outbox::send(std::span<const std::byte> message) noexcept {
  if (!offer(message)) ++dropped_;
}

bool Outbox::offer(std::span<const std::byte> message) noexcept {
  hand_over();
  const auto length = static_cast<Length>(message.size());
  const Outcome outcome = empty() ? write({message, {&length, 1}}) : Outcome{};
  const bool taken = outcome.sent > 0 || (outcome.lost == 0 && keep(message));
  if (taken) ++taken_;
  return taken;
}

void Outbox::flush() noexcept {
  std::array<std::byte, userbus::kLongestMessage> room{};
  std::array<Length, kAtOnce> lengths{};
  while (!empty()) {
    const Batch batch = oldest(room, lengths);
    const Outcome outcome = write(batch);
    const std::size_t done = outcome.sent + outcome.lost;
    dropped_ += static_cast<std::uint32_t>(outcome.lost);
    for (const Length length : batch.lengths.first(done)) {
      first_ = (first_ + sizeof length + length) % kRoom;
      used_ -= sizeof length + length;
    }
    messages_ -= done;
    if (done < batch.lengths.size()) return;
  }
}

Outbox::Outcome Outbox::write(const Batch& batch) const noexcept {
  return batch.lengths.size() == 1 || in_one_ ? write_in_one(batch) : write_each(batch);
}

Outbox::Outcome Outbox::write_in_one(const Batch& batch) const noexcept {
  const std::size_t count = batch.lengths.size();
  if (write_message(batch.bytes.data(), batch.bytes.size())) return {.sent = count};
  return passes(errno) ? Outcome{} : Outcome{.lost = count};
}

Outbox::Outcome Outbox::write_each(const Batch& batch) const noexcept {
  const std::size_t count = batch.lengths.size();
  std::array<iovec, kAtOnce> parts{};
  std::array<mmsghdr, kAtOnce> headers{};
  std::size_t offset = 0;
  for (std::size_t i = 0; i < count; offset += batch.lengths[i++]) {
    // NOLINTNEXTLINE(cppcoreguidelines-pro-type-const-cast): an iovec is for both directions
    parts[i] = {const_cast<std::byte*>(&batch.bytes[offset]), batch.lengths[i]};
    headers[i].msg_hdr.msg_iov = &parts[i];
    headers[i].msg_hdr.msg_iovlen = 1;
  }
  const int sent = sendmmsg(descriptor_, headers.data(), static_cast<unsigned>(count), kFlags);
  if (sent >= 0) return {.sent = static_cast<std::size_t>(sent)};
  return passes(errno) ? Outcome{} : Outcome{.lost = count};
}

/// As many of the messages that wait as go with one system call, in @p bytes and @p lengths.
Outbox::Batch Outbox::oldest(std::span<std::byte> bytes, std::span<Length> lengths) const noexcept {
  std::size_t size = 0;
  std::size_t count = 0;
  for (std::size_t offset = 0; count < std::min(messages_, most_at_once_); ++count) {
    Length length = 0;
    get(std::as_writable_bytes(std::span{&length, 1}), offset);
    if (length > bytes.size() - size) break;
    get(bytes.subspan(size, length), offset + sizeof length);
    lengths[count] = length;
    size += length;
    offset += sizeof length + length;
  }
  return {bytes.first(size), lengths.first(count)};
}

bool Outbox::keep(std::span<const std::byte> message) noexcept {
  if (!ring_) ring_.reset(new (std::nothrow) std::byte[kRoom]);
  const auto length = static_cast<Length>(message.size());
  if (!ring_ || messages_ == kMessages || kRoom - used_ < sizeof length + length) return false;
  put(std::as_bytes(std::span{&length, 1}));
  put(message);
  ++messages_;
  return true;
}

void Outbox::put(std::span<const std::byte> bytes) noexcept {
  const std::size_t at = (first_ + used_) % kRoom;
  const std::size_t before_end = std::min(bytes.size(), kRoom - at);
  std::memcpy(&ring_[at], bytes.data(), before_end);
  std::memcpy(&ring_[0], bytes.data() + before_end, bytes.size() - before_end);
  used_ += bytes.size();
}

void Outbox::get(std::span<std::byte> bytes, std::size_t offset) const noexcept {
  const std::size_t at = (first_ + offset) % kRoom;
  const std::size_t before_end = std::min(bytes.size(), kRoom - at);
  std::memcpy(bytes.data(), &ring_[at], before_end);
  std::memcpy(bytes.data() + before_end, &ring_[0], bytes.size() - before_end);
}

}  // namespace hub
