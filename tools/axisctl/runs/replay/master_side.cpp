#include "tools/axisctl/runs/replay/master_side.hpp"

namespace runs {

MasterSide::Judgement MasterSide::judge(const LoggedFrame& logged) {
  if (logged.is_error) return {};
  Judgement judgement{.meaning = ids_.meaning_of(logged.frame)};
  judgement.side = side_of(logged, judgement.meaning);
  judgement.entry = ids_.follow(logged.frame, judgement.meaning);
  return judgement;
}

Side MasterSide::side_of(const LoggedFrame& logged, const Meaning& meaning) const noexcept {
  const bool is_of_unit = units_.test(meaning.node);
  if (logged.sender == Sender::Unit) return Side::Unit;
  if (logged.sender == Sender::Others) return Side::Master;
  switch (meaning.role) {
    case Role::Unknown:
      return Side::Other;
    case Role::Nmt: {
      const std::uint8_t node = logged.frame.data[1];
      return node == 0 || (node < units_.size() && units_.test(node)) ? Side::Master : Side::Other;
    }
    case Role::Sync:
    case Role::Time:
    case Role::LssRequest:
      return Side::Master;
    case Role::Rpdo:
    case Role::SdoRequest:
    case Role::Guarding:
      return is_of_unit ? Side::Master : Side::Other;
    case Role::Emergency:
    case Role::Tpdo:
    case Role::SdoResponse:
      return is_of_unit ? Side::Unit : Side::Other;
    case Role::ErrorControl:
      // That of another node may be the heartbeat that the unit consumes.
      return is_of_unit ? Side::Unit : Side::Master;
    case Role::LssResponse:
      return Side::Unit;
  }
  return Side::Other;
}

}  // namespace runs
