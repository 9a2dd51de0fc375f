#include "tools/axisctl/runs/replay/master_side.hpp"

namespace runs {

MasterSide::Judgement MasterSide::judge(const LoggedFrame& logged) {
  if (logged.is_error) return {};
  Judgement judgement{.meaning = ids_.meaning_of(logged.frame)};
  judgement.side = side_of(logged, judgement.meaning);
  judgement.entry = ids_.follow(logged.frame, judgement.meaning);
  return judgement;
}

Side MasterSide::side_of(const LoggedFrame& logged, const meaning::Meaning& meaning) const noexcept {
  const bool is_of_unit = units_.test(meaning.node);
  if (logged.sender == Sender::Unit) return Side::Unit;
  if (logged.sender == Sender::Others) return Side::Master;
  switch (meaning.role) {
    case meaning::Role::Unknown:
      return Side::Other;
    case meaning::Role::Nmt: {
      const std::uint8_t node = logged.frame.data[1];
      return node == 0 || (node < units_.size() && units_.test(node)) ? Side::Master : Side::Other;
    }
    case meaning::Role::Sync:
    case meaning::Role::Time:
    case meaning::Role::LssRequest:
      return Side::Master;
    case meaning::Role::Rpdo:
    case meaning::Role::SdoRequest:
    case meaning::Role::Guarding:
      return is_of_unit ? Side::Master : Side::Other;
    case meaning::Role::Emergency:
    case meaning::Role::Tpdo:
    case meaning::Role::SdoResponse:
      return is_of_unit ? Side::Unit : Side::Other;
    case meaning::Role::ErrorControl:
      // That of another node may be the heartbeat that the unit consumes.
      return is_of_unit ? Side::Unit : Side::Master;
    case meaning::Role::LssResponse:
      return Side::Unit;
  }
  return Side::Other;
}

}  // namespace runs
