#pragma once

#include <vector>

#include "can/hub/filter/filter_set.hpp"
#include "can/hub/member/member.hpp"

namespace hub {

/// A CAN_RAW socket: what it sends goes to the medium, and of what passes there it gets what the rules of such a
/// socket let through (net/can/raw.c).
class RawMember final : public Participant, public Member {
 public:
  RawMember(Core& core, os::Descriptor socket, userbus::Kind kind);
  RawMember(const RawMember&) = delete;
  RawMember& operator=(const RawMember&) = delete;
  ~RawMember() override;

  void receive(const Passage& passage) noexcept override;
  void on_room() noexcept override;
  [[nodiscard]] Identity identity() const noexcept override { return who(); }

  std::size_t agree_on_frames(std::size_t most) noexcept override;
  int set_filters(std::span<const can_filter> filters) noexcept override;
  [[nodiscard]] std::span<const can_filter> filters() const noexcept override { return filters_.filters(); }

 private:
  bool take_frame(const Sent& sent, canopen::TimePoint now) noexcept override;
  void option_changed(userbus::OptionName name, std::uint32_t value) noexcept override;
  void bound() noexcept override { filters_changed(); }
  void filters_changed() noexcept;
  [[nodiscard]] std::size_t may_read() const noexcept override;
  [[nodiscard]] bool is_done() const noexcept override { return waiting_ == 0; }
  [[nodiscard]] bool keep(const Passage& passage) noexcept;

  FilterSet filters_;
  std::vector<Passage> kept_;  // the medium had no room for them; nothing is read until it has
  std::size_t next_ = 0;       // of kept_
  std::size_t waiting_ = 0;
};

}  // namespace hub
