#pragma once

#include <cstddef>
#include <optional>

#include "drive/parameter/error.hpp"

namespace drive {
class DriveObject;
}

/// Conditions of single parameters beyond state and limits: the reason against @p value, if any.
namespace drive::check {

/// Counters that can only be cleared.
std::optional<Refusal> zero_only(const DriveObject& object, std::size_t index, double value) noexcept;
/// p1910 and p1960: their values, of which some are for vector axes only; -3 needs something that was found, and
/// p1960 a p1300 from 20 on that uses the encoder or not as the value says.
std::optional<Refusal> standstill_selection(const DriveObject& object, std::size_t index, double value) noexcept;
std::optional<Refusal> rotating_selection(const DriveObject& object, std::size_t index, double value) noexcept;
/// p8603: an EMCY identifier there has to be.
std::optional<Refusal> not_zero(const DriveObject& object, std::size_t index, double value) noexcept;
/// p0010 and p0009 have single values.
std::optional<Refusal> drive_filter(const DriveObject& object, std::size_t index, double value) noexcept;
std::optional<Refusal> device_filter(const DriveObject& object, std::size_t index, double value) noexcept;
/// p2101: 4 is reserved.
std::optional<Refusal> reaction(const DriveObject& object, std::size_t index, double value) noexcept;
/// Heartbeat p8606 and life guarding p8604 exclude each other.
std::optional<Refusal> heartbeat_off(const DriveObject& object, std::size_t index, double value) noexcept;
std::optional<Refusal> guarding_off(const DriveObject& object, std::size_t index, double value) noexcept;
/// p8611: only index 0 takes a value, and only 0.
std::optional<Refusal> acknowledge_only(const DriveObject& object, std::size_t index, double value) noexcept;
/// p8620: an address that the address switch gives cannot be written.
std::optional<Refusal> address_switch_off(const DriveObject& object, std::size_t index, double value) noexcept;
/// p8612: 601h..67Fh and 581h..5FFh, or bit 31.
std::optional<Refusal> server_cob_id(const DriveObject& object, std::size_t index, double value) noexcept;
/// p0108: what the drive object always has, and of a servo the extended setpoint channel as one likes. What the
/// configuration alone gives may be left out, for it is there all the same.
std::optional<Refusal> function_modules(const DriveObject& object, std::size_t index, double value) noexcept;
/// p8630: the windows [1] and [2] end at 3 and 5.
std::optional<Refusal> object_window(const DriveObject& object, std::size_t index, double value) noexcept;
/// p1210: 0, 1, 4, 6, 14, 16 or 26.
std::optional<Refusal> restart_mode(const DriveObject& object, std::size_t index, double value) noexcept;
/// p8811: 8, 12, 16 or 64 nodes.
std::optional<Refusal> link_nodes(const DriveObject& object, std::size_t index, double value) noexcept;
/// p8835: 1 to 5 or 99.
std::optional<Refusal> board_firmware(const DriveObject& object, std::size_t index, double value) noexcept;
/// p3101: days end at 65535. p3103: 0, 2 or 4.
std::optional<Refusal> clock_time(const DriveObject& object, std::size_t index, double value) noexcept;
std::optional<Refusal> clock_method(const DriveObject& object, std::size_t index, double value) noexcept;
/// p8684: 4, 5 or 127.
std::optional<Refusal> start_state(const DriveObject& object, std::size_t index, double value) noexcept;
/// p8685: 4, 5, 127, or a reset: 128, 129.
std::optional<Refusal> state_command(const DriveObject& object, std::size_t index, double value) noexcept;
/// p8700..p8707: COB-ID 1..6DFh or bit 31; types 0..F0h, FEh, FFh.
std::optional<Refusal> receive_pdo(const DriveObject& object, std::size_t index, double value) noexcept;
/// p8720..p8727: the same with bit 30 free; times of 16 bits.
std::optional<Refusal> transmit_pdo(const DriveObject& object, std::size_t index, double value) noexcept;

}  // namespace drive::check
