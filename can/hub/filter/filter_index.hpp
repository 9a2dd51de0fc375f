#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

#include "can/hub/filter/filter_set.hpp"

namespace hub {

/// Who takes a frame, of many with filters of their own: what FilterSet::passes() says of each, found by the
/// identifier.
///
/// Everybody has a place, which is a bit in words of 64. For each of the 4096 standard frames the words are there;
/// so looking one up costs the same however many filters there are. Of extended frames those whose identifiers
/// filters name are found in a sorted list, those that take all or none have a bit; only who has other filters (a
/// mask, an inverted one) is asked, and so is everybody who takes some error frames. 64 places take 32 KB.
class FilterIndex {
 public:
  using Place = std::size_t;
  static constexpr std::size_t kPlacesOfWord = 64;

  /// A place for one more, at first taking nothing; std::bad_alloc.
  [[nodiscard]] Place add();
  /// @p place is free for the next add().
  void remove(Place place) noexcept;

  /// Whoever is at @p place takes from now on every frame, error frames too.
  void take_all(Place place) noexcept;
  /// The same with what @p filters let pass, which stay where they are until they are replaced here, and are told
  /// anew whenever they have changed.
  void take(Place place, const FilterSet& filters) noexcept;
  /// And with nothing.
  void take_nothing(Place place) noexcept;

  /// Finds who takes a frame with @p id, flags included: found() tells until the next call.
  void find(canid_t id) noexcept;
  /// Words of found().
  [[nodiscard]] std::size_t words() const noexcept { return blocks_.size(); }
  /// Places from @p word times kPlacesOfWord on, a bit each.
  [[nodiscard]] std::uint64_t found(std::size_t word) const noexcept { return blocks_[word]->found; }

 private:
  /// Of the frames that are no standard ones.
  enum class Form : std::uint8_t { Extended, Error, Other };
  static constexpr std::size_t kForms = 3;

  /// Who takes all frames of a form, and who must be asked.
  struct Takers {
    std::uint64_t all = 0;
    std::uint64_t asked = 0;
  };

  struct Block {
    std::array<std::uint64_t, kStandardFrames> standard{};
    std::array<Takers, kForms> takers{};
    std::array<const FilterSet*, kPlacesOfWord> filters{};  ///< of those that are asked
    std::uint64_t used = 0;
    std::uint64_t found = 0;
  };

  /// An extended frame that someone's filters name.
  struct Exact {
    canid_t id;
    std::uint32_t place;

    friend constexpr bool operator<(const Exact& one, const Exact& other) noexcept {
      return one.id != other.id ? one.id < other.id : one.place < other.place;
    }
  };

  [[nodiscard]] Block& block_of(Place place) noexcept { return *blocks_[place / kPlacesOfWord]; }
  [[nodiscard]] Takers& takers(Place place, Form form) noexcept {
    return block_of(place).takers[static_cast<std::size_t>(form)];
  }
  void find_among(Form form, canid_t id) noexcept;
  void find_exact(canid_t id) noexcept;
  void set_standard(Place place, const StandardFrames& frames) noexcept;
  bool list(Place place, const FilterSet& filters) noexcept;
  void forget(Place place) noexcept;

  std::vector<std::unique_ptr<Block>> blocks_;
  std::vector<Exact> exact_;  ///< sorted
};

}  // namespace hub
