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

/// Identifies a kind of block.
using BlockId = const BlockMark*;
template <class Block>
inline constexpr BlockId kBlock = &kBlockMark<Block>;

/// The one of @p blocks that has identity @p id, nullptr if none has.
template <class... Blocks>
constexpr auto* find_block(BlockId id, Blocks&... blocks) noexcept {
  using Void = std::conditional_t<(std::is_const_v<Blocks> || ...), const void, void>;
  Void* found = nullptr;
  static_cast<void>(((id == kBlock<std::remove_const_t<Blocks>> && (found = &blocks) != nullptr) || ...));
  return found;
}

namespace block_access {

/// The block that @p Part belongs to: what it names as its Block, whose `settings` or `inputs` it is; otherwise it
/// is one itself.
template <class Part>
struct Owner {
  using Type = Part;
};
template <class Part>
requires requires {
  typename Part::Block;
}
struct Owner<Part> {
  using Type = typename Part::Block;
};

template <class Part, class Block>
constexpr auto& part_of(Block& block) noexcept {
  if constexpr (std::is_same_v<std::remove_const_t<Block>, Part>) {
    return block;
  } else if constexpr (requires {
                         requires std::is_same_v<std::remove_cvref_t<decltype(block.settings)>, Part>;
                       }) {
    return block.settings;
  } else {
    return block.inputs;
  }
}

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
/// A data member of a block or of a part of it.
template <class Part, class Value, Value Part::*Member>
requires(!std::is_function_v<Value>) struct Of<Member> {
  using Block = typename Owner<Part>::Type;
  using Element = typename Elements<Value>::Type;
  static constexpr std::size_t kCount = Elements<Value>::kCount;

  static Element& at(void* block, std::size_t index) noexcept {
    return Elements<Value>::at(part_of<Part>(*static_cast<Block*>(block)).*Member, index);
  }
  static const Element& at(const void* block, std::size_t index) noexcept {
    return Elements<Value>::at(part_of<Part>(*static_cast<const Block*>(block)).*Member, index);
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
