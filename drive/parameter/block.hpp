#pragma once

#include <array>
#include <cstddef>
#include <type_traits>

// A block is what owns settings, inputs or values that parameters stand for. A row of a parameter names the block
// and where the value lies in it; a drive object knows where its blocks are.
namespace drive {

struct BlockMark {};
template <class Block>
inline constexpr BlockMark kBlockMark{};

/// Identifies a kind of block, or its settings or inputs where they are structs of their own.
using BlockId = const BlockMark*;
template <class Block>
inline constexpr BlockId kBlock = &kBlockMark<Block>;

namespace block_access {

/// @p block, or the part of it that has identity @p id: its member `settings` or `inputs`.
template <class Block>
constexpr auto* find_in(BlockId id, Block& block) noexcept {
  using Void = std::conditional_t<std::is_const_v<Block>, const void, void>;
  if (id == kBlock<std::remove_const_t<Block>>) return static_cast<Void*>(&block);
  if constexpr (requires { block.settings; })
    if (id == kBlock<std::remove_cvref_t<decltype(block.settings)>>) return static_cast<Void*>(&block.settings);
  if constexpr (requires { block.inputs; })
    if (id == kBlock<std::remove_cvref_t<decltype(block.inputs)>>) return static_cast<Void*>(&block.inputs);
  return static_cast<Void*>(nullptr);
}

}  // namespace block_access

/// The one of @p blocks, or of their settings and inputs, that has identity @p id; nullptr if none has.
template <class... Blocks>
constexpr auto* find_block(BlockId id, Blocks&... blocks) noexcept {
  using Void = std::conditional_t<(std::is_const_v<Blocks> || ...), const void, void>;
  Void* found = nullptr;
  static_cast<void>(((found = block_access::find_in(id, blocks)) || ...));
  return found;
}

namespace block_access {

/// What lies at an index of a member: an array has several elements.
template <class Member>
struct Elements {
  using Type = Member;
  static constexpr std::size_t kCount = 1;
  static constexpr auto& at(auto& member, std::size_t) noexcept { return member; }
};
template <class Element, std::size_t Count>
struct Elements<std::array<Element, Count>> {
  using Type = Element;
  static constexpr std::size_t kCount = Count;
  static constexpr auto& at(auto& member, std::size_t index) noexcept { return member[index]; }
};

template <auto Member>
struct Of;
/// A data member of a block, or of its settings or inputs.
template <class Part, class Value, Value Part::*Member>
struct Of<Member> {
  using Block = Part;
  using Element = typename Elements<Value>::Type;
  static constexpr std::size_t kCount = Elements<Value>::kCount;

  static Element& at(void* block, std::size_t index) noexcept {
    return Elements<Value>::at(static_cast<Part*>(block)->*Member, index);
  }
  static const Element& at(const void* block, std::size_t index) noexcept {
    return Elements<Value>::at(static_cast<const Part*>(block)->*Member, index);
  }
};
/// A getter of a block; with an index where there are several values.
template <class Part, class Value, Value (Part::*Getter)() const noexcept>
struct Of<Getter> {
  using Block = Part;
  static double get(const void* block, std::size_t) noexcept {
    return static_cast<double>((static_cast<const Part*>(block)->*Getter)());
  }
};
template <class Part, class Value, Value (Part::*Getter)(std::size_t) const noexcept>
struct Of<Getter> {
  using Block = Part;
  static double get(const void* block, std::size_t index) noexcept {
    return static_cast<double>((static_cast<const Part*>(block)->*Getter)(index));
  }
};

}  // namespace block_access
}  // namespace drive
