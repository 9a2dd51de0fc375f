#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "daemon/instance/memory/retention_schedule.hpp"
#include "daemon/instance/memory/state_files.hpp"
#include "daemon/instance/memory/state_writer.hpp"
#include "device/device.hpp"

namespace axisd {

/// What the unit keeps through a power cut: the saved parameters, and what survives of itself (fault buffer,
/// operating time, energy), each in a file. The files are written beside the loop.
///
/// A file that is damaged is set aside. One that cannot be read, or does not fit this unit, stays where it is: it
/// is not in use, and is not replaced before somebody asks for the values of a new unit (on_restore()).
class UnitMemory {
 public:
  /// The files in @p folder, which exists; all arguments must outlive this. Throws std::system_error.
  UnitMemory(const std::filesystem::path& folder, device::Device& device, const Log& log);

  /// The saved parameters in @p folder, as they are; empty if there are none that can be read.
  static std::vector<std::byte> saved_parameters(const std::filesystem::path& folder, const Log& log);
  /// Hands what the files hold to the unit, which has not been started yet.
  void load();
  /// Once the unit is on the bus: F01002 of the control unit for each file that is not in use (fault value: see
  /// docs/reference/configuration.md).
  void raise_faults() noexcept;
  /// How the file of the saved parameters, or the other one, is used: a few words for the status.
  std::string parameters_text() const { return usage_of(parameters_); }
  std::string retained_text() const { return usage_of(retained_); }

  /// Begins to save @p image; Device::on_stored() follows. Refused while there is a file that must stay.
  device::Keeping store(std::span<const std::byte> image) noexcept;
  /// Readable when a write has ended and take_ended() has something to do, and once at the beginning.
  int descriptor() const noexcept { return writer_.descriptor(); }
  /// Takes up the ends of writes.
  void take_ended() noexcept;
  /// Somebody wants a new unit: files that are not in use make room with the next write, under a name of their
  /// own.
  void on_restore() noexcept;

  /// When on_time() is wanted next.
  canopen::TimePoint due() const noexcept { return is_retaining_ ? canopen::kNever : schedule_.due(); }
  /// Begins to write what is due at @p now.
  void on_time(canopen::TimePoint now) noexcept;
  /// The unit may have changed: plans the next write.
  void look_at_unit() noexcept;
  /// The unit is being switched off: what survives begins to be written. Of many units the disk has all at once.
  void begin_power_off() noexcept;
  bool has_begun_power_off() const noexcept { return is_powering_off_; }
  /// The unit is switched off: what has begun ends, and what survives is on the disk.
  void power_off() noexcept;

 private:
  /// Why a file is not in use; the numbers are fault values.
  enum class Misfit : std::uint8_t { None, Damaged, Unreadable, OtherVersion, OtherUnit };
  /// A file and what is the matter with it.
  struct Part {
    StateFile file;
    std::uint32_t number;     ///< hundreds of the fault value
    bool in_use = false;      ///< it was read, or written
    bool stays = false;       ///< it must not be replaced
    bool makes_room = false;  ///< it is kept under another name when it is replaced
    Misfit misfit = Misfit::None;
    std::string reason{};

    void on_written(const tl::expected<void, WriteFailure>& outcome) noexcept;
  };

  template <class Take>
  void load(Part& part, const Take& take);
  static void withhold(Part& part, Misfit misfit, std::string reason);
  void tell(Part& part) const;
  static Misfit misfit_of(drive::image_format::Error error) noexcept;
  static std::string usage_of(const Part& part);
  void on_parameters_written(const tl::expected<void, WriteFailure>& outcome) noexcept;
  void on_retained_written(const tl::expected<void, WriteFailure>& outcome) noexcept;

  const Log& log_;
  device::Device& device_;
  Part parameters_;
  Part retained_;
  StateWriter writer_;
  RetentionSchedule schedule_;
  bool is_retaining_ = false;       ///< a write has begun
  std::uint32_t changes_seen_ = 0;  ///< of faults and alarms
  std::uint32_t changes_kept_ = 0;  ///< when the write began
  bool faults_raised_ = false;
  bool is_powering_off_ = false;
};

}  // namespace axisd
