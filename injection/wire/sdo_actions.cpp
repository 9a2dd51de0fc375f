#include "injection/wire/actions.hpp"
#include "libcanopen/base/little_endian.hpp"
#include "libcanopen/sdo/command.hpp"

namespace injection::actions {
namespace {

constexpr std::uint8_t kToggle = 0x10;
constexpr std::uint8_t kExpedited = 0x02;
constexpr std::uint8_t kSizeField = 0x0C;  ///< bytes without data of an expedited transfer
constexpr std::uint8_t kSizeStep = 0x04;
constexpr std::size_t kIndexAt = 1, kSizeAt = 4;

bool has_part(const Passing& passing, Part part) noexcept {
  return passing.transfer != nullptr && passing.transfer->part() == part;
}

canopen::sdo::Response response_in(const canopen::Frame& frame) noexcept {
  constexpr unsigned kSpecifier = 0xE0;
  return static_cast<canopen::sdo::Response>(frame.data[0] & kSpecifier);
}

}  // namespace

bool fits_transfer(const Passing& passing, const Fault& fault) noexcept {
  if (passing.transfer == nullptr) return false;
  const Transfer& transfer = *passing.transfer;
  return fault.allows(Argument::Server, passing.role.number) &&
         fault.allows(Argument::Object, transfer.at().index) &&
         fault.allows(Argument::SubIndex, transfer.at().sub_index) &&
         fault.allows(Argument::Step, transfer.step());
}

/// Nobody answers an abort.
bool fits_request(const Passing& passing, const Fault& fault) noexcept {
  return !has_part(passing, Part::Abort) && fits_transfer(passing, fault);
}

bool fits_initiation(const Passing& passing, const Fault& fault) noexcept {
  return (has_part(passing, Part::Initiate) || has_part(passing, Part::Abort)) && fits_transfer(passing, fault);
}

bool fits_segment(const Passing& passing, const Fault& fault) noexcept {
  return has_part(passing, Part::Segment) && fits_transfer(passing, fault);
}

/// An upload says how many bytes it has, in its first response.
bool fits_size(const Passing& passing, const Fault& fault) noexcept {
  return has_part(passing, Part::Initiate) && passing.transfer->is_upload() && fits_transfer(passing, fault);
}

/// The CRC of an upload is in the last response, that of a download in the last request.
bool fits_crc(const Passing& passing, const Fault& fault) noexcept {
  return has_part(passing, Part::BlockEnd) && passing.transfer->is_upload() == passing.is_sent &&
         fits_transfer(passing, fault);
}

/// A segment of an upload, the confirmation of a block of a download.
bool fits_sequence(const Passing& passing, const Fault& fault) noexcept {
  return (has_part(passing, Part::Block) || has_part(passing, Part::BlockConfirm)) &&
         fits_transfer(passing, fault);
}

void abort(Passing& passing, Loaded& loaded, const device::Device&) noexcept {
  passing.abort = loaded.value(Argument::Code);
}

void flip_toggle(Passing& passing, Loaded&, const device::Device&) noexcept {
  passing.frame.data[0] ^= kToggle;
}

void change_multiplexor(Passing& passing, Loaded&, const device::Device&) noexcept {
  std::uint8_t* const index = &passing.frame.data[kIndexAt];
  canopen::store(index, static_cast<std::uint16_t>(canopen::load<std::uint16_t>(index) + 1));
}

/// One byte more than there are, or one less where there is no room for more.
void change_size(Passing& passing, Loaded&, const device::Device&) noexcept {
  canopen::Frame& frame = passing.frame;
  const bool is_expedited =
      response_in(frame) == canopen::sdo::Response::InitiateUpload && (frame.data[0] & kExpedited) != 0;
  if (!is_expedited) {
    canopen::store(&frame.data[kSizeAt], canopen::load<std::uint32_t>(&frame.data[kSizeAt]) + 1);
  } else if ((frame.data[0] & kSizeField) == 0) {
    frame.data[0] |= kSizeStep;
  } else {
    frame.data[0] = static_cast<std::uint8_t>(frame.data[0] - kSizeStep);
  }
}

void change_crc(Passing& passing, Loaded&, const device::Device&) noexcept {
  ++passing.frame.data[1];
}

/// The number before, or 2 for 1: a last segment under 0 would be an abort. What confirms nothing confirms one.
void change_sequence(Passing& passing, Loaded&, const device::Device&) noexcept {
  constexpr unsigned kSequence = 0x7F;
  std::uint8_t& number = passing.frame.data[has_part(passing, Part::Block) ? 0 : 1];
  number = static_cast<std::uint8_t>((number & kSequence) > 1 ? number - 1 : number + 1);
}

}  // namespace injection::actions
