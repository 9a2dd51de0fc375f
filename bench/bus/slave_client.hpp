#pragma once

#include <chrono>
#include <cstdint>
#include <string>
#include <vector>

#include "bench/bus/raw_socket.hpp"

namespace bench {

/// The object of an SDO request.
struct Object {
  std::uint16_t index = 0;
  std::uint8_t sub_index = 0;
};

/// The slave that is measured.
struct Target {
  std::string interface;
  unsigned node = 0;              ///< its RPDO 1 is 200h + node
  unsigned pdos = 4;              ///< TPDOs that it sends on a SYNC
  unsigned axes = 1;              ///< of a unit, which have four of them each; 1 also for a plain node
  unsigned long process = 0;      ///< its process, 0 if its CPU time is of no interest
  unsigned long pause_us = 0;     ///< rest in front of every request (µs)
  std::uint16_t controlword = 0;  ///< in front of what an RPDO carries
  Object written{0x2000, 0};      ///< an object of four bytes that may be written with any number
};

/// A master with one request outstanding. Every function throws std::runtime_error if the slave does not do what
/// is expected of it.
class SlaveClient {
 public:
  explicit SlaveClient(const Target& target);

  /// An SDO expedited upload: the eight bytes of the answer.
  can_frame upload(Object object);
  /// An SDO expedited download of @p size bytes, 1..4.
  void download(Object object, std::uint32_t value, unsigned size);
  /// NMT start of the node, in effect when the call returns.
  void start_node();
  /// A SYNC; returns when all TPDOs have come.
  void sync();
  /// RPDO 1 with @p number behind its controlword, as soon as the interface takes it.
  void send_rpdo(std::uint32_t number);
  /// The times between heartbeats (ns) that come within @p time.
  std::vector<std::uint64_t> heartbeats(std::chrono::nanoseconds time);

 private:
  can_frame ask(const can_frame& request);
  can_frame request(std::uint8_t command, Object object) const;

  Target target_;
  RawSocket answers_;
  RawSocket tpdos_;
};

/// CPU time of all threads of @p process (ns), user and system.
std::uint64_t cpu_time(unsigned long process);

}  // namespace bench
