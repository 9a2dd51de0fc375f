#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "drive/image_links.hpp"
#include "drive/signal_source.hpp"

namespace drive {

/// The BICO interconnections of a unit, made ready for the cycle: the rows of the parameters say which inputs
/// there are and where what they bring lies. What is constant is settled once, what is not is a list of sources.
/// In a cycle come, in this order, for the control unit, the axes and the infeed:
/// 1. connector-binector converters (p8899 -> r8894, r8895; p2099 -> r2094, r2095), with what has come for this
/// cycle;
/// 2. the inputs of each block, when its turn has come (take(), take_group());
/// 3. when the statuswords are there, binector-connector converters (p8880 to p8884 -> r8889; p2080 to p2084 ->
///    r2089) and then the words to be sent (p8851, p8861; p2051, p2061).
class Wiring {
 public:
  /// Of @p unit, which outlives this; to be made when all drive objects exist.
  explicit Wiring(DriveUnit& unit);

  /// Inputs or references have changed, or the inputs of a block hold something else than what they are connected
  /// to: everything is found anew before it is next used.
  void invalidate() noexcept { valid_ = false; }
  /// Finds all sources if need be.
  void connect() noexcept;

  /// Step 1 of the cycle.
  void convert_words() noexcept;
  /// Step 2: the inputs of block @p block of @p object take what they are connected to.
  void take(const DriveObject& object, BlockId block) noexcept;
  /// Makes ready to take the inputs of @p blocks of @p object, which are in no other group, together: as the next
  /// group, from 0.
  void add_group(const DriveObject& object, std::span<const BlockId> blocks);
  /// Step 2 of all blocks of group @p group of @p object.
  void take_group(const DriveObject& object, std::size_t group) noexcept;
  /// Whether a source has another value than an input of group @p group of @p object that is connected to it.
  bool changed(const DriveObject& object, std::size_t group) const noexcept;
  /// Step 3.
  void convert_bits() noexcept;
  void send() noexcept;

 private:
  /// A binector input.
  struct BitLink {
    bool* input = nullptr;
    SignalSource source;
  };
  /// A word that brings the bits of some binector inputs, which stand side by side.
  struct Word {
    SignalSource source;
    std::size_t first = 0;
    std::size_t count = 0;
    double taken = 0.0;  ///< what it was when it was last taken
  };
  /// A connector input.
  struct ValueLink {
    double* input = nullptr;
    SignalSource source;
    double full = 1.0;   ///< what is 100 % of the input, in SI units
    double taken = 0.0;  ///< the number that was last taken
  };
  /// The inputs of one block. A constant is taken once.
  struct Inputs {
    BlockId block;
    std::size_t count = 0;
    std::vector<BitLink> bits{};
    std::vector<Word> words{};
    std::vector<ValueLink> values{};
    std::vector<BitLink> constant_bits{};
    std::vector<ValueLink> constant_values{};
    bool is_taken = false;  ///< since the sources were found
  };
  /// Blocks that stand side by side.
  struct Group {
    std::size_t first = 0;
    std::size_t count = 0;
  };
  /// All inputs of one drive object.
  struct Object {
    DriveObject* object;
    std::vector<Inputs> blocks{};  ///< those of groups first
    std::vector<Group> groups{};
    std::array<ImageLinks, 2> images;  ///< by PzdInterface
  };

  static void reserve(Object& entry);
  static Inputs& inputs_of(Object& entry, BlockId block);
  void connect(Object& entry) noexcept;
  void connect(Object& entry, const ParameterRow& row, const BitInput& input) noexcept;
  void connect(Object& entry, const ParameterRow& row, const ValueInput& input) noexcept;
  void connect(Object& entry, const ParameterRow& row, const ImageInput& input) noexcept;
  void list_images() noexcept;
  static void add(Inputs& inputs, const BitLink& link) noexcept;
  static void group(Inputs& inputs) noexcept;
  static std::span<const BitLink> bits_of(const Inputs& inputs, const Word& word) noexcept;
  Object& entry_of(const DriveObject& object) noexcept { return objects_[object.number() - std::size_t{1}]; }
  static void take(Inputs& inputs) noexcept;
  static void take_all(Inputs& inputs) noexcept;
  static void take_new(Inputs& inputs) noexcept;
  static bool is_other(const Inputs& inputs) noexcept;
  static bool has_new(const Inputs& inputs) noexcept;
  SignalSource source(const DriveObject& object, const ParameterRow& row, std::size_t index) const noexcept;

  DriveUnit& unit_;
  std::vector<Object> objects_;  // in the order of their numbers
  // Process data with sources that vary, each a list of what has something to do there.
  std::vector<ImageLinks*> words_to_convert_;
  std::vector<ImageLinks*> bits_to_convert_;
  std::vector<ImageLinks*> to_send_;
  bool valid_ = false;
};

}  // namespace drive
