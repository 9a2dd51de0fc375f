#pragma once

#include <functional>
#include <map>
#include <set>
#include <string>

#include <tl/expected.hpp>

#include "farm/agent/host/outcomes.hpp"
#include "farm/agent/host/state_transfer.hpp"
#include "farm/agent/unit/saved_files.hpp"
#include "farm/link/link.hpp"

namespace farm::agent {

/// What units of this host have saved, here and on the server: a unit that is started has the newest, and what it
/// saves goes there. Beside it is kept under what the unit was started last.
class StoredState {
 public:
  /// Of the farm called @p farm. What is passed by reference outlives this; @p link is used when the constructor
  /// has ended, not before. Throws std::system_error if the kernel gives no descriptor.
  StoredState(axisd::ServiceEvents& events, Link& link, const std::string& farm, const Folders& folders,
              Outcomes& outcomes);

  /// Has the newest here before @p start, and notes that; then tells @p then, perhaps at once.
  void prepare(const UnitStart& start, std::function<void(tl::expected<void, std::string>)> then);
  /// The unit runs, or has run, under @p start.
  void note(const UnitStart& start);
  /// Under what @p unit was started last; nothing: it never was. The error is one line: that cannot be read now.
  [[nodiscard]] tl::expected<std::optional<UnitStart>, std::string> noted(const UnitName& unit);

  /// @p unit runs: what it saves from now on goes to the server, and what it has saved if that is not there.
  void begin(const UnitName& unit);
  /// It does no longer.
  void end(const UnitName& unit);

  /// All that lies here of units that run goes to the server once more: it has lost it.
  void upload_again();
  /// There is a connection: what waits goes to the server.
  void on_up();

 private:
  [[nodiscard]] tl::expected<UnitNote*, std::string> note_of(const UnitName& unit);
  void keep_note(const UnitName& unit);
  void look_at(const UnitName& unit);
  void upload(const UnitName& unit);
  void try_later(const UnitName& unit, const std::string& why);
  void try_again();
  void finish(const UnitName& unit, const tl::expected<StateTransfer::Upload, std::string>& outcome);

  axisd::ServiceEvents& events_;
  Link& link_;
  const Folders& folders_;
  Outcomes& outcomes_;
  StateTransfer transfer_;
  SavedFiles files_;
  std::map<UnitName, UnitNote> notes_;
  std::set<UnitName> running_;
  std::set<UnitName> under_way_;  ///< to the server
  std::set<UnitName> waiting_;    ///< to be tried again
  std::set<UnitName> unwatched_;  ///< run, and are looked at now and then
  axisd::EventSource again_;
};

}  // namespace farm::agent
