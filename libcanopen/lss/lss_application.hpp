#pragma once

#include <cstdint>

#include "libcanopen/base/export.hpp"
#include "libcanopen/base/node_id.hpp"
#include "libcanopen/base/time.hpp"

namespace canopen {

/// What an LSS master has configured, and what a store keeps for the next start (CiA 305).
struct LssSettings {
  std::uint8_t node_id = kNoNodeId;  ///< the pending one: 1..127, or kNoNodeId
  std::uint16_t bit_rate = 0;        ///< the pending one in kbit/s (10..1000); 0: none was configured
};

/// How a store has ended. The number is the error code of the answer.
enum class LssStored : std::uint8_t {
  Done = 0,
  NotSupported = 1,  ///< the device stores nothing
  Failed = 2,        ///< the storage cannot be written
  Later = 255,       ///< not known yet: LssSlave::answer_store() will tell, the master waits
};

/// What the application behind an LSS slave is asked and told. Called as an Application is, with the same limits
/// on what may be called from within.
class CANOPEN_EXPORT LssApplication {
 public:
  virtual ~LssApplication() = default;
  /// The master wants @p settings to be in force after the next power-on.
  virtual LssStored on_lss_store(const LssSettings& settings) noexcept {
    (void)settings;
    return LssStored::NotSupported;
  }
  /// The master switches the bus to @p bit_rate in kbit/s, 0 if it has configured none: all nodes are silent for
  /// @p delay (0..65.535 s), change their bit rate, and are silent for @p delay once more. The library does
  /// nothing of that and goes on as before: an owner that can change the bit rate keeps frames off the bus
  /// meanwhile (Node::send_to()).
  virtual void on_lss_activate(std::uint16_t bit_rate, Duration delay) noexcept { (void)bit_rate, (void)delay; }
};

}  // namespace canopen
