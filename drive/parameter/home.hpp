#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>
#include <type_traits>
#include <variant>

#include "drive/base/process_data_image.hpp"
#include "drive/base/quantity.hpp"
#include "drive/parameter/block.hpp"

namespace drive {

/// The value lies in a slot of the drive object and nothing in the simulation acts on it.
struct Stored {
  std::string_view until = {};  ///< what would act on it; empty if a function module that is missing says so
};
/// The value lies in a slot of the drive object, and what the row's effect names is computed from it.
struct Slot {
  BlockId reader = nullptr;  ///< the block that is given every change, if it does not look itself
  void (*give)(void* block, std::size_t index, double si) noexcept = nullptr;  ///< in SI units
};
/// The same with element @p Place of an array of a block.
template <auto Member, std::size_t Place>
inline constexpr Slot slot_given{
    kBlock<typename block_access::Of<Member>::Block>,
    [](void* block, std::size_t, double si) noexcept { block_access::Of<Member>::at(block, Place) = si; }};
/// The value lies in a slot of the drive object; the layer that owns the bus acts on it, agrees to every change
/// and brings in its own ones.
struct Agreed {};
/// A command to the layer that owns the bus; what it reads as is what that layer brings in, otherwise the factory
/// value.
struct HostCommand {};
/// The quantity is not in the model: it reads as @p value.
struct Fixed {
  double value;
  std::string_view until = {};  ///< what would change it; empty if a function module that is missing says so
};

/// A setting of a block, in SI units there; an index of the parameter is an element of it.
struct Setting {
  BlockId block;
  std::size_t count;
  double (*get)(const void* block, std::size_t index) noexcept;
  void (*set)(void* block, std::size_t index, double si) noexcept;
};
template <auto Member>
inline constexpr Setting setting{.block = kBlock<typename block_access::Of<Member>::Block>,
                                 .count = block_access::Of<Member>::kCount,
                                 .get =
                                     [](const void* block, std::size_t index) noexcept {
                                       return static_cast<double>(block_access::Of<Member>::at(block, index));
                                     },
                                 .set =
                                     [](void* block, std::size_t index, double si) noexcept {
                                       using Element = typename block_access::Of<Member>::Element;
                                       block_access::Of<Member>::at(block, index) = static_cast<Element>(si);
                                     }};

/// Element @p Place of an array that is a setting of its own.
template <auto Member, std::size_t Place>
inline constexpr Setting setting_at{
    .block = kBlock<typename block_access::Of<Member>::Block>,
    .count = 1,
    .get = [](const void* block,
              std::size_t) noexcept { return static_cast<double>(block_access::Of<Member>::at(block, Place)); },
    .set =
        [](void* block, std::size_t, double si) noexcept {
          using Element = typename block_access::Of<Member>::Element;
          block_access::Of<Member>::at(block, Place) = static_cast<Element>(si);
        }};

/// A binector input: its source lies in a slot, the bit that the source brings in a member of the block.
struct BitInput {
  BlockId block;
  std::size_t count;
  bool& (*member)(void* block, std::size_t index) noexcept;
};
template <auto Member>
inline constexpr BitInput bit_input{
    kBlock<typename block_access::Of<Member>::Block>, block_access::Of<Member>::kCount,
    [](void* block, std::size_t index) noexcept -> bool& { return block_access::Of<Member>::at(block, index); }};
/// The same of element @p Place of an array.
template <auto Member, std::size_t Place>
inline constexpr BitInput bit_input_at{
    kBlock<typename block_access::Of<Member>::Block>, 1,
    [](void* block, std::size_t) noexcept -> bool& { return block_access::Of<Member>::at(block, Place); }};

/// A connector input: its source lies in a slot, the value that the source brings (SI units) in a member of the
/// block. 100 % of it is the reference of @p quantity.
struct ValueInput {
  BlockId block;
  std::size_t count;
  double& (*member)(void* block, std::size_t index) noexcept;
  Quantity quantity;
};
template <auto Member>
constexpr ValueInput value_input(Quantity quantity) noexcept {
  return {kBlock<typename block_access::Of<Member>::Block>, block_access::Of<Member>::kCount,
          [](void* block, std::size_t index) noexcept -> double& {
            return block_access::Of<Member>::at(block, index);
          },
          quantity};
}

/// What an input of the process data of a drive object fills.
enum class ImageSink : std::uint8_t {
  SentWord,        ///< the word that is sent at the index
  SentDoubleWord,  ///< the double word that begins there
  BitOfWord,       ///< bit by bit a word that is made of bits
  WordOfBits,      ///< a word that is shown as bits
};
/// A connector or binector input of the process data: its source lies in a slot, what it brings in the image.
struct ImageInput {
  ImageSink sink;
  std::uint8_t place = 0;  ///< the word, of BitOfWord
  PzdInterface interface = PzdInterface::If2;
};

/// An output of a block, in SI units there.
struct BlockOutput {
  BlockId block;
  double (*get)(const void* block, std::size_t index) noexcept;
};
template <auto Getter>
inline constexpr BlockOutput output{kBlock<typename block_access::Of<Getter>::Block>,
                                    block_access::Of<Getter>::get};

/// A value that functions of a block, which may be the drive object itself, find and set in the parameter's own
/// unit; nothing sets a display.
struct Computed {
  BlockId block;
  double (*get)(const void* block, std::size_t index) noexcept;
  void (*set)(void* block, std::size_t index, double value) noexcept;
};
namespace block_access {

template <auto Get>
struct Shown;
template <class Block, double (*Get)(const Block&, std::size_t) noexcept>
struct Shown<Get> {
  using Owner = Block;
  static double get(const void* block, std::size_t index) noexcept {
    return Get(*static_cast<const Block*>(block), index);
  }
};
template <auto Set, class Block>
void set(void* block, std::size_t index, double value) noexcept {
  if constexpr (!std::is_null_pointer_v<decltype(Set)>) Set(*static_cast<Block*>(block), index, value);
}

}  // namespace block_access
template <auto Get, auto Set = nullptr>
inline constexpr Computed shown{kBlock<typename block_access::Shown<Get>::Owner>, block_access::Shown<Get>::get,
                                block_access::set<Set, typename block_access::Shown<Get>::Owner>};

/// Where the value of a parameter lives.
using Home = std::variant<Stored, Slot, Agreed, HostCommand, Fixed, Setting, BitInput, ValueInput, ImageInput,
                          BlockOutput, Computed>;

/// Whether the value lies in a slot of the drive object; that of an input is its source.
constexpr bool is_in_a_slot(const Home& home) noexcept {
  return std::holds_alternative<Stored>(home) || std::holds_alternative<Slot>(home) ||
         std::holds_alternative<Agreed>(home) || std::holds_alternative<HostCommand>(home) ||
         std::holds_alternative<BitInput>(home) || std::holds_alternative<ValueInput>(home) ||
         std::holds_alternative<ImageInput>(home);
}

/// The block that a change of what lies in @p home concerns, nullptr if none is to be told.
constexpr BlockId concerned(const Home& home) noexcept {
  if (const auto* const setting = std::get_if<Setting>(&home)) return setting->block;
  const auto* const slot = std::get_if<Slot>(&home);
  return slot != nullptr ? slot->reader : nullptr;
}

/// The number of indices that @p home has room for; 0 if it does not matter.
constexpr std::size_t elements_of(const Home& home) noexcept {
  if (std::holds_alternative<Setting>(home)) return std::get<Setting>(home).count;
  if (std::holds_alternative<BitInput>(home)) return std::get<BitInput>(home).count;
  if (std::holds_alternative<ValueInput>(home)) return std::get<ValueInput>(home).count;
  return 0;
}

}  // namespace drive
