#pragma once

#include <span>
#include <string_view>

#include "os/descriptor.hpp"

namespace axisd {

/// The way to the journal of systemd by its native protocol (systemd.journal-fields(7)). It waits for nobody, as
/// sd_journal_send(3) does when the journal does not keep up: a drive must not stand still for its log.
class Journal {
 public:
  /// A field of an entry.
  struct Field {
    std::string_view name;   ///< in capitals
    std::string_view value;  ///< of any length, with any bytes
  };

  /// Whether standard error of this process is connected to the journal (JOURNAL_STREAM of systemd.exec(5)).
  static bool has_standard_error() noexcept;

  /// False if the entry is lost: there is no journal, or it has no room at present.
  bool send(std::span<const Field> fields);

 private:
  os::Descriptor socket_{};
};

}  // namespace axisd
