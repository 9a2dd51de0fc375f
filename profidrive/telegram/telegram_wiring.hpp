#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>

#include "drive/object/drive_object.hpp"
#include "profidrive/telegram/telegram.hpp"

namespace profidrive {

/// How far a telegram reaches.
enum class Reach : std::uint8_t {
  Words,      ///< p2079: what lies behind its words is free
  Everything  ///< p0922: nothing else is sent
};

/// The telegram of a drive object; none: its words are wired freely.
struct Selection {
  const Telegram* telegram = nullptr;
  Reach reach = Reach::Everything;

  friend bool operator==(const Selection&, const Selection&) = default;
};

/// The telegram with @p number that @p object offers, or nullptr: others, and free words (999).
const Telegram* find_telegram(const drive::DriveObject& object, double number) noexcept;
/// What p0922 and p2079 of @p object select.
Selection selection_of(const drive::DriveObject& object) noexcept;

/// Whether the words that @p selection leaves free get what it proposes.
enum class FreeWords : std::uint8_t { Stay, Propose };
/// Wires the inputs of @p selection, which has a telegram, on @p object and sets p2038, the inversions of its
/// status words and, of an axis, p8790 = 0.
void wire(drive::DriveObject& object, const Selection& selection, FreeWords free) noexcept;

/// Whether @p selection of @p object holds index @p index of parameter @p number: nobody else may write it.
bool is_held(const drive::DriveObject& object, const Selection& selection, std::uint16_t number,
             std::size_t index) noexcept;

/// Where a word of @p words is that @p has, a member; nothing if none has.
template <class Word>
std::optional<std::size_t> place_of(std::span<const Word* const> words, bool Word::*has) noexcept {
  std::size_t place = 0;
  for (const Word* const word : words) {
    if (word->*has) return place;
    place += word->words;
  }
  return std::nullopt;
}

}  // namespace profidrive
