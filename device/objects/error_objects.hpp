#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "drive/drive_unit.hpp"
#include "libcanopen/node/node.hpp"
#include "libcanopen/od/dictionary.hpp"

namespace device {

/// Shows the faults and alarms of the unit on the bus: error register 1001h, active messages 1003h (not a history)
/// and emergency messages.
class ErrorObjects final : public canopen::EntryOwner {
 public:
  /// Owns the reading of 1003h:00 in @p dictionary; the arguments must outlive this.
  ErrorObjects(canopen::Dictionary& dictionary, const drive::DriveUnit& unit);

  /// Brings the objects up to date if messages have @p changed and sends an emergency message for every message
  /// that entered since the last call, and one with code 0000h when the last one has left. A fault outside the
  /// communication acts on the NMT state as 1029h:02 says.
  void update(canopen::Node& node, bool changed) noexcept;
  /// The dictionary has had its initial values: the next update() shows again what is active.
  void show_again() noexcept { stale_ = true; }
  /// While the bus is off nothing is sent; what has entered meanwhile is sent with the update() after it.
  void set_bus_off(bool off) noexcept;

  canopen::Result<std::int64_t> read(const canopen::Entry& entry, std::int64_t stored) override;

 private:
  /// An active message and the drive object that it is reported for.
  struct Reported {
    const drive::FaultEntry* entry;
    std::uint8_t object;
  };
  /// Messages in the order of their appearance.
  struct Messages {
    std::array<Reported, drive::kMostObjects * 2 * drive::FaultMemory::kCapacity> items{};
    std::size_t count = 0;

    std::span<const Reported> all() const noexcept { return {items.data(), count}; }
    void add(const drive::FaultEntry& entry, std::uint8_t object) noexcept;
  };

  std::uint8_t error_register() const noexcept;
  Messages messages() const noexcept;
  void fill(const Messages& messages) noexcept;
  void set(unsigned sub_index, std::uint32_t value) noexcept;
  bool report(const Messages& messages, canopen::Node& node) noexcept;

  canopen::Dictionary& dictionary_;
  const drive::DriveUnit& unit_;
  canopen::Cell<std::uint8_t> error_register_;
  std::uint32_t seen_sequence_ = 0;
  std::uint32_t entries_ = 0;  ///< messages that 1003h shows now
  bool told_ = false;          ///< the bus knows of a message
  bool bus_off_ = false;
  bool stale_ = false;  ///< an update is due though no message has changed
};

}  // namespace device
