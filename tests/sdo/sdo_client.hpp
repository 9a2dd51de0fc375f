#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "libcanopen/base/frame.hpp"

namespace sdo_test {

/// What an SDO upload brought.
struct Upload {
  std::uint32_t abort_code = 0;  ///< 0 = none
  std::vector<std::uint8_t> bytes{};

  /// The bytes as a number, least significant first.
  std::uint64_t number() const;
  /// The bytes as characters.
  std::string text() const { return {bytes.begin(), bytes.end()}; }
};

/// The client of an SDO server (CiA 301, 7.2.4), wherever that is: expedited and segmented transfer.
class SdoClient {
 public:
  /// A client whose requests go under @p request.
  explicit SdoClient(std::uint32_t request = 0x605) : request_{request} {}
  virtual ~SdoClient() = default;

  /// Reads an object, in segments if it is longer than four bytes.
  Upload upload(std::uint16_t index, std::uint8_t sub_index = 0);
  /// Writes an object of @p size bytes (1..4); 0 or the abort code.
  std::uint32_t download(std::uint16_t index, std::uint8_t sub_index, std::uint32_t value, unsigned size);

 protected:
  SdoClient(const SdoClient&) = default;
  SdoClient& operator=(const SdoClient&) = default;
  SdoClient(SdoClient&&) = default;
  SdoClient& operator=(SdoClient&&) = default;

 private:
  /// Sends @p request and waits for its answer; a test fails if none comes.
  virtual std::optional<canopen::Frame> ask(const canopen::Frame& request) = 0;
  canopen::Frame answer_to(const canopen::Frame& request);
  canopen::Frame request(std::uint8_t command, std::uint16_t index, std::uint8_t sub_index,
                         std::uint32_t value = 0) const;

  std::uint32_t request_;
};

}  // namespace sdo_test
