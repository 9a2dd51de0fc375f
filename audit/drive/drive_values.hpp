#pragma once

#include <cstdint>
#include <map>
#include <span>
#include <vector>

#include "audit/base/heard.hpp"
#include "audit/network/pdo_record.hpp"

namespace audit {

struct Transfer;

/// A value of an axis that was heard.
struct DriveValue {
  enum class Way : std::uint8_t { SdoWrite, SdoRead, Rpdo, Tpdo };

  std::uint8_t node = 0;
  std::uint8_t axis = 0;     ///< from 0; object 6000h + 800h times that
  std::uint16_t object = 0;  ///< as that of axis 0
  std::uint8_t sub_index = 0;
  std::int64_t value = 0;  ///< with its sign, where it has one
  Way way = Way::SdoWrite;
  Heard heard{};

  [[nodiscard]] bool is_of_master() const noexcept { return way == Way::SdoWrite || way == Way::Rpdo; }
};

/// Finds the values of axes (CiA 402) in PDOs and transfers.
class DriveValues {
 public:
  /// Those that @p passage, a PDO, carries.
  std::span<const DriveValue> in_pdo(const Passage& passage, const Network& network);
  /// That of @p transfer, also if it was refused; none or one.
  std::span<const DriveValue> in_transfer(const Transfer& transfer);

 private:
  /// A PDO as it is mapped, as long as nothing has changed.
  struct Known {
    std::uint32_t changes = 0;
    std::vector<MappedObject> objects{};  ///< those of axes alone
  };
  const Known& known(const Node& node, const PdoRecord& record);

  std::map<std::pair<std::uint8_t, PdoRecord>, Known> pdos_;
  std::vector<DriveValue> found_;
};

}  // namespace audit
