#include <algorithm>
#include <cstdlib>
#include <iostream>
#include <random>

#include <gtest/gtest.h>

#include "tests/eds/corpus.hpp"
#include "tests/eds/reader_properties.hpp"

namespace eds {
namespace {

namespace fs = std::filesystem;

std::vector<std::string> corpus() {
  std::vector<fs::path> paths;
  for (const auto& entry : fs::recursive_directory_iterator{fs::path{SOURCE_FOLDER} / "tests/data/eds"})
    if (entry.is_regular_file() && entry.path().extension() != ".txt") paths.push_back(entry.path());
  std::ranges::sort(paths);
  std::vector<std::string> texts;
  for (const fs::path& path : paths) texts.push_back(content_of(path));
  return texts;
}

std::uint64_t seed() {
  const char* const given = std::getenv("AXISD_TEST_SEED");
  return given != nullptr ? std::strtoull(given, nullptr, 10) : std::random_device{}();
}

/// Changes texts at random: bytes, pieces of the same text or of another one, words that mean something.
class Mutator {
 public:
  Mutator(std::uint64_t seed, std::vector<std::string> texts) : random_{seed}, texts_{std::move(texts)} {}

  std::string next() {
    std::string text = any(texts_);
    for (std::size_t changes = 1 + below(6); changes != 0; --changes) change(text);
    return text;
  }

 private:
  std::size_t below(std::size_t limit) { return random_() % limit; }
  const std::string& any(const std::vector<std::string>& list) { return list[below(list.size())]; }

  void change(std::string& text) {
    const std::size_t at = below(text.size() + 1), length = below(40);
    switch (below(4)) {
      case 0:
        if (at < text.size()) text[at] = static_cast<char>(below(256));
        return;
      case 1:
        text.erase(at, length);
        return;
      case 2: {
        const std::string& other = any(texts_);
        text.insert(at, other.substr(below(other.size() + 1), 4 * length));
        return;
      }
      default:
        text.insert(at, any(words_));
    }
  }

  std::mt19937_64 random_;
  std::vector<std::string> texts_;
  std::vector<std::string> words_{"=",
                                  "[",
                                  "]",
                                  "\r",
                                  "\n",
                                  ";",
                                  "$NODEID",
                                  "+",
                                  "0x",
                                  "-",
                                  "sub0",
                                  "M1Fixed",
                                  "CompactSubObj=254\n",
                                  "[M2SubExt2000]\n",
                                  "Count=0;1\n",
                                  "\0",
                                  "\xFF",
                                  "ObjExtend=1\n",
                                  "[2000]\n",
                                  "DataType=0x8\n",
                                  "NrOfEntries=9\n"};
};

TEST(AnyText, IsReadWrittenCheckedAndTransformed) {
  constexpr int kTexts = 1000;
  const std::uint64_t used = seed();
  SCOPED_TRACE("AXISD_TEST_SEED=" + std::to_string(used));
  std::cout << "AXISD_TEST_SEED=" << used << '\n';
  Mutator mutator{used, corpus()};

  for (int n = 0; n < kTexts; ++n) {
    const std::string text = mutator.next();
    ASSERT_EQ(broken_property(text), "") << "text " << n << ":\n" << text;
  }
}

TEST(AnyText, OfTheCorpusIsReadWrittenCheckedAndTransformed) {
  for (const std::string& text : corpus()) EXPECT_EQ(broken_property(text), "") << text;
}

TEST(AnyText, MayBeCutAnywhere) {
  const std::string text = corpus_file("good/modular.eds");
  for (std::size_t length = 0; length < text.size(); length += 7)
    ASSERT_EQ(broken_property(text.substr(0, length)), "") << length;
}

}  // namespace
}  // namespace eds
