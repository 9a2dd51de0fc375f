#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "drive/images/saved_values.hpp"
#include "drive/images/storage_image.hpp"
#include "unit/follow_ups.hpp"
#include "unit/parameter_groups.hpp"
#include "unit/unit_parameters.hpp"

namespace unit {

/// What has become of the wish to keep parameters. The former ones are still kept unless they are Kept.
enum class Keeping : std::uint8_t {
  Kept,     ///< the next start has them
  Begun,    ///< ParameterStorage::end_save() tells the outcome
  Failed,   ///< they cannot be written
  Refused,  ///< they must not take the place of those that are there
};

/// Who writes the saved parameters to where they last.
class ParameterKeeper {
 public:
  virtual ~ParameterKeeper() = default;
  /// Keeps @p image, which is valid within the call only, for the next start. Not called again before what has
  /// Begun has ended.
  virtual Keeping on_store(std::span<const std::byte> image) noexcept {
    static_cast<void>(image);
    return Keeping::Failed;
  }
  /// All parameters are those of a new unit, as somebody has asked for.
  virtual void on_restore() noexcept {}
};

/// The saved parameters of the unit, whole or by groups, and p0971, p0972, p0976 and p0977. Nothing is allocated
/// after construction.
///
/// What changes many parameters at once is only noted by a request, to be done when it has been answered: see
/// FollowUp.
class ParameterStorage final : public ParameterOwner {
 public:
  using Error = drive::storage_image::Error;

  /// Answers in @p parameters for p0971, p0972, p0976 and p0977 of @p unit; all arguments must outlive this.
  ParameterStorage(drive::DriveUnit& unit, UnitParameters& parameters, ParameterKeeper& keeper,
                   FollowUps<FollowUp>& follow_ups);

  /// The unit, which is new, takes over the saved parameters @p image; nothing changes if it does not fit.
  [[nodiscard]] tl::expected<void, Error> adopt(std::span<const std::byte> image) noexcept;

  /// What belongs to the groups.
  ParameterGroups& groups() noexcept { return groups_; }
  /// Saves @p group of all drive objects. NotNow for a part before all was saved once, Failed if the keeper
  /// cannot. NotNow also while a save runs, and if the keeper must not.
  [[nodiscard]] std::optional<drive::Refusal> store(ParameterGroup group) noexcept;
  /// The values of a new unit for @p group follow the answer. NotNow while pulses are enabled or a save runs.
  [[nodiscard]] std::optional<drive::Refusal> restore(ParameterGroup group) noexcept;
  /// The commands read 0, p0972 as long as it waits what was written.
  std::optional<double> value_of(const ParameterPlace& place) const noexcept override;
  /// Carries a command out: IllegalValue, NotNow while pulses are enabled, Failed as store().
  std::optional<drive::Refusal> take(const ParameterPlace& place, double value) noexcept override;
  /// A master no longer leads the unit: p0972 = 3 waits for that.
  void on_operational_left() noexcept;

  /// A save runs: parameters are locked until end_save(), which whoever asked for it waits for.
  bool is_saving() const noexcept { return saving_ != 0; }
  /// The save that runs is over; @p kept: with success.
  void end_save(bool kept) noexcept;

  /// Whether there are saved parameters.
  bool has_saved() const noexcept { return length_ != 0; }
  /// What was saved last, or loaded; valid until the next save.
  drive::SavedValues saved() const noexcept { return drive::SavedValues{image()}; }

  /// The parameters of @p group are those of a new unit.
  void reset(ParameterGroup group) noexcept;
  /// The parameters of @p group are the saved ones, as after power-on.
  void reload(ParameterGroup group) noexcept;

 private:
  struct Command {
    std::uint16_t number;
    std::optional<drive::Refusal> (ParameterStorage::*carry_out)(const drive::DriveObject& object,
                                                                 int value) noexcept;
  };
  static const std::array<Command, 4> kCommands;

  void tell_axes() noexcept;
  std::span<std::byte> spare() noexcept;
  std::span<const std::byte> image() const noexcept { return std::span{image_}.first(length_); }
  std::optional<drive::Refusal> save(const drive::storage_image::Selection& selection) noexcept;
  std::optional<drive::Refusal> ask_for(FollowUp what, std::uint8_t argument = 0) noexcept;
  bool pulses_enabled() const noexcept;
  std::optional<drive::Refusal> save_object(const drive::DriveObject& object, int value) noexcept;
  std::optional<drive::Refusal> save_all(const drive::DriveObject& object, int value) noexcept;
  std::optional<drive::Refusal> load_all(const drive::DriveObject& object, int value) noexcept;
  std::optional<drive::Refusal> restart(const drive::DriveObject& object, int value) noexcept;

  drive::DriveUnit& unit_;
  ParameterKeeper& keeper_;
  FollowUps<FollowUp>& follow_ups_;
  ParameterGroups groups_;
  std::vector<std::byte> image_;  ///< as last saved
  std::size_t length_ = 0;        ///< of it; 0 = nothing was saved yet
  std::vector<std::byte> spare_;  ///< for the next one
  std::size_t saving_ = 0;        ///< length of what is being saved in it
  int restart_ = 0;               ///< p0972
};

}  // namespace unit
