#pragma once

#include <algorithm>
#include <chrono>
#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "farm/link/messages.hpp"

namespace fakes {

/// Messages without a server: what was sent is kept, and the test says what comes.
class FakeMessages final : public farm::Messages {
 public:
  struct Published {
    std::string subject;
    std::string data;
  };
  struct Asked {
    std::string subject;
    std::string data;
    std::chrono::milliseconds patience;
    OnReply on_reply;
  };

  [[nodiscard]] bool is_up() const noexcept override { return up; }
  void publish(std::string_view subject, std::string_view data) override {
    if (up) published.push_back({std::string{subject}, std::string{data}});
  }
  void subscribe(const std::string& subject, OnMessage on_message) override {
    subscriptions[subject] = std::move(on_message);
  }
  void unsubscribe(const std::string& subject) override { subscriptions.erase(subject); }
  void drain(const std::string& subject) override { unsubscribe(subject); }
  void request(std::string_view subject, std::string_view data, std::chrono::milliseconds patience,
               OnReply on_reply) override {
    if (!up) return on_reply(tl::unexpected{farm::NoReply::Down});
    asked.push_back({std::string{subject}, std::string{data}, patience, std::move(on_reply)});
  }

  /// A message comes, for all who have subscribed to it.
  void come(std::string_view subject, std::string_view data, std::string_view reply = {}) {
    const std::map<std::string, OnMessage> present = subscriptions;
    for (const auto& [pattern, on_message] : present)
      if (fits(pattern, subject)) on_message({subject, reply, data});
  }
  /// Takes the request that waits longest; there is one.
  Asked take_asked() {
    Asked first = std::move(asked.front());
    asked.erase(asked.begin());
    return first;
  }

  bool up = true;
  std::vector<Published> published;
  std::vector<Asked> asked;  ///< requests without an answer
  std::map<std::string, OnMessage> subscriptions;

 private:
  /// Whether @p pattern, with * for a word and > for the rest, is @p subject.
  static bool fits(std::string_view pattern, std::string_view subject) {
    while (!pattern.empty() && !subject.empty()) {
      if (pattern == ">") return true;
      const std::string_view wanted = pattern.substr(0, pattern.find('.'));
      const std::string_view word = subject.substr(0, subject.find('.'));
      if (wanted != "*" && wanted != word) return false;
      pattern.remove_prefix(std::min(wanted.size() + 1, pattern.size()));
      subject.remove_prefix(std::min(word.size() + 1, subject.size()));
    }
    return pattern.empty() && subject.empty();
  }
};

}  // namespace fakes
