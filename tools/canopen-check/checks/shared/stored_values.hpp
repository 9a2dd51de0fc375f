#pragma once

#include <vector>

#include "tools/canopen-check/core/run/context.hpp"
#include "tools/canopen-check/core/standard_numbers.hpp"

namespace conformance {

/// "save" and "load".
inline constexpr std::uint32_t kSave = 0x65766173, kLoad = 0x64616F6C;

/// An entry whose value tells what was stored.
struct StoredValue {
  std::uint16_t index = 0;
  std::uint8_t sub_index = 0;
};

/// Writes @p signature to 1010h or 1011h; storing may take five seconds.
SdoAnswer order(Context& context, std::uint16_t index, std::uint8_t group, std::uint32_t signature);
/// A communication parameter that takes another value, if one is known.
[[nodiscard]] std::optional<StoredValue> communication_value(Context& context);
/// Likewise a parameter of the application: of a profile if there is one, else of the manufacturer.
[[nodiscard]] std::optional<StoredValue> application_value(Context& context);
/// Gives @p value another value: what it holds then.
SdoAnswer alter(Context& context, const StoredValue& value);

/// Resets the node and waits for its boot-up message; false, and the check is skipped, without one: the group nmt
/// has a check for it.
bool restart(Context& context);

/// Puts values back at the end of a check and saves them.
class StorageGuard {
 public:
  StorageGuard(Context& context, std::vector<StoredValue> values);
  StorageGuard(const StorageGuard&) = delete;
  StorageGuard& operator=(const StorageGuard&) = delete;
  ~StorageGuard();

 private:
  struct Before {
    StoredValue value;
    std::vector<std::uint8_t> bytes;
  };

  Context* context_;
  std::vector<Before> before_;
};

}  // namespace conformance
