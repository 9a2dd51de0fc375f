#include "tools/canopen-zoo/slave/sdo_tricks.hpp"
#include "tools/canopen-zoo/wrong/wrong_slaves.hpp"

namespace zoo {
namespace {

using canopen::Frame;

constexpr std::uint32_t kSave = 0x65766173, kLoad = 0x64616F6C;

/// True if @p frame is an SDO about 1010h:@p sub_index.
bool about_store(const Frame& frame, std::uint32_t identifier, std::uint8_t sub_index) {
  return frame.id == identifier && !frame.remote && frame.data[1] == 0x10 && frame.data[2] == 0x10 &&
         frame.data[3] == sub_index;
}

Defect saves_everything_with_every_group() {
  return {
      .incoming =
          [](Slave& slave, Frame& frame) {
            if (!write_in(slave, frame) || !about_store(frame, slave.cob_id(kSdoRequest), 2)) return true;
            frame.data[3] = 1;
            slave.memory["group"] = 2;
            return true;
          },
      .outgoing =
          [](Slave& slave, Frame& frame) {
            if (about_store(frame, slave.cob_id(kSdoResponse), 1) && std::exchange(slave.memory["group"], 0) == 2)
              frame.data[3] = 2;
            return true;
          }};
}

Defect loads_at_once() {
  return {.incoming = [](Slave& slave, Frame& frame) {
    const auto write = write_in(slave, frame);
    if (write && write->index == 0x1011 && write->value == kLoad)
      slave.dictionary().set(*slave.dictionary().lookup(0x1017, 0), 0);
    return true;
  }};
}

Defect has_a_reserved_capability() {
  return {.eds =
              [](std::string& eds) {
                const std::size_t section = eds.find("[1010sub1]");
                const std::size_t value = eds.find("DefaultValue=", section);
                eds.erase(value, eds.find('\n', value) + 1 - value);
              },
          .outgoing =
              [](Slave& slave, Frame& frame) {
                if (about_store(frame, slave.cob_id(kSdoResponse), 1) && frame.data[0] == 0x43)
                  frame.data[7] = 0x80;
                return true;
              }};
}

}  // namespace

std::vector<WrongSlave> wrong_storage_slaves() {
  const auto wrong_signature = [](Slave&, const Write& write) {
    return write.index == 0x1010 && write.sub_index != 0 && write.value != kSave;
  };
  return {
      {"ForgetsToStore",
       "It confirms \"save\" and stores nothing.",
       {.forgets_to_store = true},
       {"storage.save", "storage.groups"}},
      {"ForgetsToRestore",
       "It confirms \"load\" and keeps what was stored.",
       {.forgets_to_restore = true},
       {"storage.load"}},
      {"LoadsAtOnce",
       "\"load\" sets 1017h back at once, not at the next reset.",
       loads_at_once(),
       {"storage.load"}},
      {"SavesEverythingWithEveryGroup",
       "\"save\" to 1010h:02, the communication objects, saves everything.",
       saves_everything_with_every_group(),
       {"storage.groups"}},
      {"HasAReservedCapability",
       "1010h:01 has bit 31 set, which is reserved.",
       has_a_reserved_capability(),
       {"storage.capabilities"}},
      {"SavesWithAnySignature",
       "It confirms a wrong signature for 1010h, and forgets it.",
       pretends_to_write(wrong_signature),
       {"storage.signature"}},
      {"RefusesASignatureWithAnotherCode",
       "It refuses a wrong signature for 1010h with 06090030h.",
       refuses_to_write(wrong_signature, 0x06090030),
       {"storage.signature"}},
      {"SavesNoGroups",
       "It refuses \"save\" to 1010h:03.",
       refuses_to_write([](Slave&, const Write& write) { return write.index == 0x1010 && write.sub_index == 3; },
                        0x08000022),
       {"storage.group-save"}},
  };
}

}  // namespace zoo
