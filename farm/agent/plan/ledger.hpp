#pragma once

#include <array>
#include <map>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "farm/agent/plan/orders.hpp"
#include "farm/agent/plan/self.hpp"
#include "farm/agent/plan/unit_record.hpp"
#include "farm/documents/settings.hpp"
#include "farm/storage/key_value.hpp"

namespace farm::agent {

/// Which keys of a bucket were told since the connection was made: when all have been, the others are there no
/// more.
class ToldKeys {
 public:
  /// All are told anew.
  void begin() {
    keys_.clear();
    is_complete_ = false;
  }
  void note(const std::string& key) { keys_.insert(key); }
  void complete() noexcept { is_complete_ = true; }

  [[nodiscard]] bool has(const std::string& key) const { return keys_.contains(key); }
  [[nodiscard]] bool is_complete() const noexcept { return is_complete_; }

 private:
  std::set<std::string> keys_;
  bool is_complete_ = false;
};

/// What lies in the buckets of the farm, as far as it was told.
///
/// A key of the bucket of units, `generation`, has a text at random. When the connection is there again and the
/// text is another one, or none, the server has lost its buckets: documents that are missing then were not
/// deleted, and are put back. While the text is the same, what is missing is wanted no more.
class Ledger {
 public:
  explicit Ledger(const Self& self) : self_{self} {}

  /// Everything will be told anew.
  void on_up();
  /// A key of @p bucket has changed, or is told anew.
  void on_entry(Bucket bucket, const Entry& entry, Orders& orders);
  /// All keys of @p bucket have been told.
  void on_all(Bucket bucket, canopen::TimePoint now, Orders& orders);
  /// Orders once more to put back what is missing still.
  void on_time(canopen::TimePoint now, Orders& orders);
  /// When on_time() is wanted; kNever if nothing is missing.
  [[nodiscard]] canopen::TimePoint due() const noexcept { return missing_.empty() ? canopen::kNever : again_; }

  /// Whether all buckets were told since the connection was made.
  [[nodiscard]] bool is_complete() const noexcept;
  [[nodiscard]] const std::string& generation() const noexcept { return generation_; }
  [[nodiscard]] std::map<UnitName, UnitRecord>& units() noexcept { return units_; }
  [[nodiscard]] const std::map<UnitName, UnitRecord>& units() const noexcept { return units_; }
  /// Of @p bus (bit/s); 0 if nothing is said of it.
  [[nodiscard]] std::uint32_t bit_rate_of(const std::string& bus) const;
  /// Whether it is said that @p host gives its units away.
  [[nodiscard]] bool is_draining(const std::string& host) const;

 private:
  /// A document about a bus or a host.
  template <class Settings>
  struct Kept {
    std::string text;
    Settings settings;
  };
  template <class Settings>
  using ByName = std::map<std::string, Kept<Settings>>;

  void take_unit(const Entry& entry, Orders& orders);
  void take_place(const Entry& entry, Orders& orders);
  [[nodiscard]] UnitRecord* record_of(const Entry& entry, Orders& orders);
  template <class Settings, class Parse>
  void take_settings(ByName<Settings>& known, const Entry& entry, Parse parse, Orders& orders);
  void settle(canopen::TimePoint now, Orders& orders);
  void settle_units(bool is_new, std::vector<DocumentWrite>& missing);
  void settle_places(bool is_new);
  template <class Settings>
  void settle_settings(ByName<Settings>& known, Bucket bucket, bool is_new, std::vector<DocumentWrite>& missing);
  /// Whether a document that was not told is to be put back: the server has lost it.
  [[nodiscard]] bool is_lost(Bucket bucket, const std::string& key, bool is_new);
  [[nodiscard]] ToldKeys& told(Bucket bucket) noexcept { return told_[static_cast<std::size_t>(bucket)]; }
  void complain(Orders& orders, std::string text);

  const Self& self_;
  std::array<ToldKeys, kBuckets> told_;
  std::map<UnitName, UnitRecord> units_;
  ByName<BusSettings> buses_;
  ByName<HostSettings> hosts_;
  std::string generation_;
  std::string told_generation_;
  unsigned generations_ = 0;  ///< that were made here
  std::vector<DocumentWrite> missing_;
  canopen::TimePoint again_{};
  std::set<std::string> complaints_;
};

}  // namespace farm::agent
