#pragma once

#include "injection/wire/passing.hpp"

/// What the kinds of faults make of frames. Every `fits_` says which frames a fault can act on.
namespace injection::actions {

bool fits_sent(const Passing& passing, const Fault& fault) noexcept;
bool fits_received(const Passing& passing, const Fault& fault) noexcept;
bool fits_pdo(const Passing& passing, const Fault& fault) noexcept;
bool fits_end_of_emergency(const Passing& passing, const Fault& fault) noexcept;
/// Frames of an SDO transfer: any, those that can be answered, those that begin it, segments, those that announce
/// a size, those with a CRC, those with a sequence number.
bool fits_transfer(const Passing& passing, const Fault& fault) noexcept;
bool fits_request(const Passing& passing, const Fault& fault) noexcept;
bool fits_initiation(const Passing& passing, const Fault& fault) noexcept;
bool fits_segment(const Passing& passing, const Fault& fault) noexcept;
bool fits_size(const Passing& passing, const Fault& fault) noexcept;
bool fits_crc(const Passing& passing, const Fault& fault) noexcept;
bool fits_sequence(const Passing& passing, const Fault& fault) noexcept;

void drop(Passing& passing, Loaded& loaded, const device::Device& device) noexcept;
void delay(Passing& passing, Loaded& loaded, const device::Device& device) noexcept;
void double_it(Passing& passing, Loaded& loaded, const device::Device& device) noexcept;
void abort(Passing& passing, Loaded& loaded, const device::Device& device) noexcept;
void flip_toggle(Passing& passing, Loaded& loaded, const device::Device& device) noexcept;
void change_multiplexor(Passing& passing, Loaded& loaded, const device::Device& device) noexcept;
void change_size(Passing& passing, Loaded& loaded, const device::Device& device) noexcept;
void change_crc(Passing& passing, Loaded& loaded, const device::Device& device) noexcept;
void change_sequence(Passing& passing, Loaded& loaded, const device::Device& device) noexcept;
void shorten(Passing& passing, Loaded& loaded, const device::Device& device) noexcept;
void freeze(Passing& passing, Loaded& loaded, const device::Device& device) noexcept;
void swap_values(Passing& passing, Loaded& loaded, const device::Device& device) noexcept;
void change_state(Passing& passing, Loaded& loaded, const device::Device& device) noexcept;
void flip_guard_toggle(Passing& passing, Loaded& loaded, const device::Device& device) noexcept;

}  // namespace injection::actions
