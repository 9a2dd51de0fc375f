#include "profidrive/interface/reasons.hpp"

#include <array>

#include <fmt/format.h>

namespace profidrive {
namespace {

/// An axis whose telegram commands it.
struct Picture {
  const Interface& interface;
  std::uint8_t object;

  Monitoring::Stage stage() const noexcept { return interface.stage(object); }
  bool has_control() const noexcept { return (interface.received(object)[0] & kControlByPlc) != 0; }
};
using P = const Picture&;
using Stage = Monitoring::Stage;

struct Reason {
  bool (*holds)(P);
  std::string (*text)(P);
};
constexpr std::array kReasons{
    Reason{[](P p) { return !p.interface.is_assigned(); },
           [](P) -> std::string {
             return "No process data are exchanged on IF1 (p8839[0]): write p8839 = 99, save and restart.";
           }},
    Reason{[](P) { return true; },
           [](P p) {
             const Selection selection = p.interface.selection(p.object);
             return fmt::format(
                 "IF1 commands the axis ({} = {}): the controlword 6040h has no effect and p8790 is locked; send "
                 "STW1, or write {} = 999 and connect the inputs anew.",
                 selection.reach == Reach::Everything ? "p0922" : "p2079", selection.telegram->number,
                 selection.reach == Reach::Everything ? "p0922" : "p2079");
           }},
    Reason{[](P p) { return p.stage() == Stage::Off; },
           [](P) -> std::string {
             return "Nothing has come on IF1 yet: send 047Eh, then 047Fh, by if1.exchange or Modbus TCP.";
           }},
    Reason{[](P p) { return p.stage() == Stage::Interrupted || p.stage() == Stage::Failed; },
           [](P) -> std::string {
             return "No process data come on IF1 any more (p2040, A01920): the controller has to send again.";
           }},
    Reason{[](P p) { return p.stage() == Stage::Running && !p.has_control(); },
           [](P) -> std::string {
             return "STW1 has no control by PLC (bit 10 = 0), so that no other word is taken: send 047Eh.";
           }},
};

}  // namespace

std::vector<std::string> reasons(const Interface& interface, std::uint8_t object) {
  const Picture picture{interface, object};
  std::vector<std::string> sentences;
  if (interface.selection(object).telegram == nullptr) return sentences;
  for (const Reason& reason : kReasons)
    if (reason.holds(picture)) sentences.push_back(reason.text(picture));
  return sentences;
}

}  // namespace profidrive
