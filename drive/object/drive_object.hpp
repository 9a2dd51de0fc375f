#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include <tl/expected.hpp>

#include "drive/base/process_data_image.hpp"
#include "drive/catalogue/table.hpp"
#include "drive/messages/fault_memory.hpp"

namespace drive {

/// Why a message was not raised.
enum class FaultError : std::uint8_t {
  Unknown,        ///< no fault or alarm has this number
  NotOnThisAxis,  ///< it exists on other kinds of drive objects only
};

/// What a drive object asks of the unit that it belongs to.
class Surroundings {
 public:
  virtual ~Surroundings() = default;
  /// Numbers the messages of all drive objects in the order of their appearance.
  virtual std::uint32_t& message_counter() noexcept = 0;
  /// The time that the messages of all drive objects are stamped with.
  virtual const TimeLine& time() const noexcept = 0;
  /// The kind of drive object @p number, if there is one.
  virtual std::optional<ObjectKind> kind_of(std::uint8_t number) const noexcept = 0;
  /// Takes over @p value of an agreed parameter or carries out a command; the reason if it cannot.
  virtual std::optional<Refusal> agree(const DriveObject& object, const ParameterRow& row, std::size_t index,
                                       double value) noexcept = 0;
  /// A BICO input was connected anew, or something that the values of sources are relative to has changed.
  virtual void on_wiring_changed() noexcept = 0;
  /// Why nobody may write index @p index of @p row in whatever state, if somebody holds it.
  virtual std::optional<Refusal> lock_on(const DriveObject& object, const ParameterRow& row,
                                         std::size_t index) const noexcept = 0;
  /// What an agreed parameter or a command reads as, if that is not the value of its slot.
  virtual std::optional<double> agreed_value(const DriveObject& object, const ParameterRow& row,
                                             std::size_t index) const noexcept = 0;
};

/// What all drive objects have: parameters, each in its own unit here, faults and alarms. It is a value; nothing
/// is allocated after construction.
class DriveObject {
 public:
  virtual ~DriveObject() = default;

  ObjectKind kind() const noexcept { return context_.kind; }
  /// 1 = control unit, then the infeed if the unit has one, then the axes.
  std::uint8_t number() const noexcept;
  const ObjectContext& context() const noexcept { return context_; }
  /// How many drive objects the unit has.
  std::size_t objects_of_unit() const noexcept;
  /// From now on @p surroundings, which outlive this, are asked; without them a drive object knows only itself.
  void join(Surroundings& surroundings) noexcept {
    surroundings_ = &surroundings;
    memory_.number_by(surroundings.message_counter());
    memory_.stamp_by(surroundings.time());
  }

  /// Whether the function modules of the drive object have parameter @p row of its kind.
  virtual bool provides(const ParameterRow&) const noexcept { return true; }
  /// Parameter @p number, which has index @p index; what a function module that is not active would have does not
  /// exist, though it is kept and saved.
  [[nodiscard]] tl::expected<const PlacedRow*, ParameterError> parameter(std::uint16_t number,
                                                                         std::size_t index = 0) const noexcept;
  /// Value of a parameter.
  [[nodiscard]] tl::expected<double, ParameterError> read(std::uint16_t number,
                                                          std::size_t index = 0) const noexcept;
  /// Value of index @p index of @p placed, a parameter of this kind of drive object, in the parameter's own unit.
  double value(const PlacedRow& placed, std::size_t index) const noexcept;
  /// Whether every index of @p placed has its factory value.
  bool is_as_delivered(const PlacedRow& placed) const noexcept;
  /// Writes a parameter as a master does, in a state and within the limits that allow it; it acts at once.
  [[nodiscard]] tl::expected<void, ParameterError> write(std::uint16_t number, std::size_t index,
                                                         double value) noexcept;
  [[nodiscard]] tl::expected<void, ParameterError> write(std::uint16_t number, double value) noexcept {
    return write(number, 0, value);
  }
  /// The same of @p placed, found by parameter() with @p index.
  [[nodiscard]] tl::expected<void, ParameterError> write(const PlacedRow& placed, std::size_t index,
                                                         double value) noexcept;
  /// Why the present state lets nobody write parameter @p row, whatever the value, if it does not.
  std::optional<Refusal> state_refusal(const ParameterRow& row) const noexcept;
  /// Takes over a saved value whatever the state; refused if it is outside the limits or not a saved parameter.
  [[nodiscard]] tl::expected<void, ParameterError> load(std::uint16_t number, std::size_t index,
                                                        double value) noexcept;
  /// Why load() would refuse, if it would.
  std::optional<ParameterError> load_error(std::uint16_t number, std::size_t index, double value) const noexcept;
  /// The value of a parameter as it was last written, loaded or brought in, whatever the layer that owns the bus
  /// shows of it.
  [[nodiscard]] tl::expected<double, ParameterError> kept_value(std::uint16_t number,
                                                                std::size_t index = 0) const noexcept;
  /// The layer that owns the bus brings in what a parameter is that it answers for.
  void bring_in(std::uint16_t number, std::size_t index, double value) noexcept;
  /// The saved parameters that @p which chooses are as in a new unit again; without it all but those that outlive
  /// a factory reset.
  void restore_parameters(RowFilter which = is_reset) noexcept;

  /// Where block @p id of this drive object lies; nullptr if it has none.
  void* block(BlockId id) noexcept;
  const void* block(BlockId id) const noexcept;

  /// What the bus has brought and what it fetches.
  const ProcessDataImage& process_data() const noexcept { return process_data_; }
  ProcessDataImage& process_data() noexcept { return process_data_; }
  const Converters& converters() const noexcept { return converters_; }
  /// The same of IF1.
  const If1Image& if1() const noexcept { return if1_; }
  If1Image& if1() noexcept { return if1_; }
  const If1Converters& if1_converters() const noexcept { return if1_converters_; }
  /// 60FFh and 6071h have other scales than before, if they have.
  void scale_process_data(const ProcessDataImage::Scales& scales) noexcept;

  /// Active faults and alarms, and those that were.
  const FaultMemory& messages() const noexcept { return memory_; }
  /// Takes over the fault buffer of a former life, which ended at @p power_off.
  void bring_back(const FaultMemory::Kept& kept, const TimeStamp& power_off) noexcept {
    memory_.bring_back(kept, power_off);
  }
  /// Tells a drive object of its own the time (ms) that messages are stamped with.
  void set_time(Uptime now) noexcept { memory_.set_time(now); }
  /// A fault or an alarm with its value (r0949, r2124) appears; the reaction follows at once.
  [[nodiscard]] tl::expected<void, FaultError> raise(std::uint16_t number, std::uint32_t value = 0,
                                                     Cause cause = Cause::Gone) noexcept;
  /// The cause of a message is gone: an alarm leaves, a fault can be acknowledged.
  void withdraw(std::uint16_t number) noexcept;
  /// Acknowledges what can be acknowledged now; true if no fault is left.
  virtual bool acknowledge() noexcept = 0;
  /// What switching the unit off does to it: no message is left, the buffers remain.
  virtual void power_off() noexcept { memory_.clear(); }

 protected:
  /// A drive object with its slots at 0; the constructor of a derived class restores the parameters.
  explicit DriveObject(const ObjectContext& context);
  DriveObject(const DriveObject&) = default;
  DriveObject(DriveObject&&) = default;
  DriveObject& operator=(const DriveObject&) = default;
  DriveObject& operator=(DriveObject&&) = default;

  FaultMemory& memory() noexcept { return memory_; }
  /// Every message comes this way: @p row is entered as what the settings make of it, and a fault has its
  /// reaction.
  void enter(const FaultRow& row, std::uint32_t value, Cause cause) noexcept;
  /// Sets @p row, whose home is a setting of a block, whatever the state and the limits; @p value in the unit of
  /// the row.
  void set_setting(const ParameterRow& row, std::size_t index, double value) noexcept;

 private:
  /// The same of the blocks of the derived class.
  virtual void* own_block(BlockId id) noexcept = 0;
  virtual const void* own_block(BlockId id) const noexcept = 0;
  /// A setting of @p row is about to change, or has changed.
  virtual void before_setting(const ParameterRow&) noexcept {}
  virtual void after_setting(const ParameterRow&) noexcept {}
  virtual WriteState write_state() const noexcept = 0;
  /// Settings of @p block have changed; nullptr: those of any block may have.
  virtual void on_settings_changed(BlockId) noexcept {}
  /// A parameter was written or loaded, whatever it is.
  virtual void on_parameter_written() noexcept {}
  virtual void react(const FaultRow&) noexcept {}
  virtual void on_acknowledged_fault_left() noexcept {}
  virtual void on_messages_changed() noexcept {}

  tl::expected<const PlacedRow*, ParameterError> find(std::uint16_t number, std::size_t index) const noexcept;
  std::optional<Refusal> source_refusal(const ParameterRow& row, double value) const noexcept;
  std::optional<Refusal> value_refusal(const ParameterRow& row, std::size_t index, double value) const noexcept;
  double kept_value_of(const PlacedRow& placed, std::size_t index) const noexcept;
  void tell(const ParameterRow& row) noexcept;
  void assign(const PlacedRow& placed, std::size_t index, double value) noexcept;

  ObjectContext context_;
  Surroundings* surroundings_ = nullptr;
  std::vector<std::uint32_t> slots_;  // as ParameterValue has the bits
  FaultMemory memory_;
  ProcessDataImage process_data_{};
  Converters converters_{};
  If1Image if1_{};
  If1Converters if1_converters_{};
};

}  // namespace drive
