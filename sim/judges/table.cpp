#include "sim/judges/table.hpp"

#include <array>

#include "sim/judges/bus_rules.hpp"
#include "sim/judges/sdo_answers.hpp"
#include "sim/judges/state_tables.hpp"
#include "sim/judges/unit_rules.hpp"

namespace sim {
namespace {

template <class Kind>
std::unique_ptr<Judge> make(std::string_view name, std::size_t units) {
  return std::make_unique<Kind>(name, units);
}

constexpr auto kInvariants = std::to_array<Invariant>({
    {"sdo.answered-once", "each SDO request is answered once, or aborted", make<SdoAnswers>},
    {"nmt.transitions", "the NMT state changes as CiA 301 says", make<NmtTransitions>},
    {"drive.transitions", "each change of a drive's state is in its table", make<DriveTransitions>},
    {"bus.first-frames", "the boot-up message comes first, and no PDO before a start", make<FirstFrames>},
    {"tpdo.inhibit", "no TPDO comes within its inhibit time", make<InhibitTimes>},
    {"heartbeat.in-time", "the heartbeat comes in its time", make<HeartbeatTimes>},
    {"emcy.pairs", "EMCY tells the end of errors once, and of all", make<EmergencyPairs>},
    {"storage.old-or-new", "saved parameters are the old or the new ones, whole", make<StoredSets>},
    {"drive.enabled-again",
     "when the faults are over, the bus has room and no shaft is too fast, every axis is enabled within 7 s",
     make<EnabledAgain>},
    {"unit.no-allocation", "a unit that runs allocates nothing", make<NoAllocation>},
    {"energy.balance", "every joule from the line is somewhere", make<EnergyBalance>},
});

}  // namespace

std::span<const Invariant> invariants() noexcept {
  return kInvariants;
}

std::vector<std::unique_ptr<Judge>> make_judges(std::size_t units) {
  std::vector<std::unique_ptr<Judge>> judges;
  judges.reserve(kInvariants.size());
  for (const Invariant& each : kInvariants) judges.push_back(each.make(each.name, units));
  return judges;
}

}  // namespace sim
