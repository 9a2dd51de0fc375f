#pragma once

#include <random>

#include "tests/libcanopen/sdo/model/sdo_model.hpp"

/// A client of one SDO server that mostly does what the protocol asks, with random objects, lengths and data: now
/// and then it loses, repeats or reorders segments, breaks off, or sends anything at all.
class SdoRandomClient {
 public:
  using Random = std::mt19937_64;
  SdoRandomClient(Random& random, const model::Objects& objects) : random_{random}, objects_{objects} {}

  /// The next request, for a server in the state of @p server.
  model::Data next(const model::Server& server);
  /// An answer of the server.
  void on_answer(const model::Data& answer);
  /// What comes goes: a number 0 .. @p limit - 1.
  std::size_t below(std::size_t limit) { return random_() % limit; }

 private:
  using Phase = model::Server::Phase;

  model::Data begin();
  model::Data begin_upload(const model::Object& object);
  model::Data begin_download(const model::Object& object);
  model::Data disturb(const model::Server& server);
  model::Data download_segment(std::uint8_t toggle);
  model::Data block_segment();
  model::Data end_block();
  model::Data confirm(const model::Server& server);
  model::Data any();
  model::Bytes payload_for(const model::Object& object);
  std::uint8_t byte() { return static_cast<std::uint8_t>(random_()); }
  bool one_in(std::size_t chances) { return below(chances) == 0; }

  Random& random_;
  const model::Objects& objects_;
  model::Bytes payload_;      ///< of a download
  std::size_t done_ = 0;      ///< bytes of it that are sent, confirmed ones in a block download
  std::uint8_t segment_ = 0;  ///< last one sent in this sub-block
};
