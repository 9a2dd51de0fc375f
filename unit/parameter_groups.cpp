#include "unit/parameter_groups.hpp"

#include <algorithm>
#include <array>

namespace unit {
namespace {

/// Parameters with consecutive numbers.
struct Numbers {
  std::uint16_t first;
  std::uint16_t last;
};

// 1005h, 1014h, 100Ch and 100Dh, 1017h, 1029h, the SDO servers, and the PDOs with p8744, which says where they are
// from.
constexpr std::array kCommunication{
    Numbers{8602, 8604}, Numbers{8606, 8606}, Numbers{8609, 8609}, Numbers{8612, 8612}, Numbers{8700, 8707},
    Numbers{8710, 8717}, Numbers{8720, 8727}, Numbers{8730, 8737}, Numbers{8744, 8744},
};
// 6046h, 6048h, 6086h, 6083h to 6085h, 6060h, 6072h, 6007h, 605Dh, 6094h.
constexpr std::array kApplication{
    Numbers{1080, 1080}, Numbers{1082, 1082}, Numbers{1115, 1115}, Numbers{1120, 1121}, Numbers{1134, 1135},
    Numbers{1300, 1300}, Numbers{1520, 1520}, Numbers{8641, 8641}, Numbers{8791, 8791}, Numbers{8798, 8798},
};

template <std::size_t Count>
constexpr bool contains(const std::array<Numbers, Count>& all, std::uint16_t number) noexcept {
  return std::any_of(all.begin(), all.end(),
                     [=](const Numbers& n) { return n.first <= number && number <= n.last; });
}

bool is_communication(const drive::ParameterRow& row) noexcept {
  return contains(kCommunication, row.number);
}
bool is_application(const drive::ParameterRow& row) noexcept {
  return contains(kApplication, row.number);
}

constexpr std::array kGroups{
    ParameterGroupRow{ParameterGroup::All, drive::is_saved, drive::is_reset},
    ParameterGroupRow{ParameterGroup::Communication, is_communication, is_communication},
    ParameterGroupRow{ParameterGroup::Application, is_application, is_application},
};

}  // namespace

const ParameterGroupRow& row_of(ParameterGroup group) noexcept {
  return kGroups[static_cast<std::size_t>(group) - 1];
}

bool belongs_to(ParameterGroup group, std::uint16_t number) noexcept {
  if (group == ParameterGroup::All) return true;
  return group == ParameterGroup::Communication ? contains(kCommunication, number)
                                                : contains(kApplication, number);
}

}  // namespace unit
