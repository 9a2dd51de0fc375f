// Several answers that are put together.
#include "gateway/api/gathering.hpp"

#include <memory>
#include <optional>
#include <vector>

#include <gtest/gtest.h>

namespace gateway {
namespace {

struct Told {
  std::shared_ptr<Gathering> gather(std::size_t count) {
    return Gathering::make(count, [this](Gathering::Answers all) { answers = std::move(all); });
  }

  std::optional<Gathering::Answers> answers;
};

TEST(Gathering, TellsInTheOrderOfThePlacesWhenTheLastAnswerHasCome) {
  Told told;
  OnAnswer first, second;
  {
    const auto gathering = told.gather(3);
    first = gathering->place();
    second = gathering->place();
    static_cast<void>(gathering->place());  // never answered
  }

  second(nlohmann::json(2));
  second = {};
  EXPECT_FALSE(told.answers);
  first(nlohmann::json(1));
  first = {};

  ASSERT_TRUE(told.answers);
  EXPECT_EQ((*told.answers)[0].value(), 1);
  EXPECT_EQ((*told.answers)[1].value(), 2);
  EXPECT_EQ((*told.answers)[2].value(), nullptr);
}

TEST(Gathering, OfNothingIsToldAtOnce) {
  Told told;

  told.gather(0);

  ASSERT_TRUE(told.answers);
  EXPECT_TRUE(told.answers->empty());
}

TEST(Gathering, TellsNothingWhereWhoAsksWasKeptFromIt) {
  Told told;

  told.gather(2)->place()(nlohmann::json(1));

  EXPECT_FALSE(told.answers);
}

}  // namespace
}  // namespace gateway
