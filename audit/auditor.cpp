#include "audit/auditor.hpp"

#include <utility>

#include "audit/catalogue.hpp"

namespace audit {

Auditor::Auditor(Circumstances circumstances)
    : dialogues_{circumstances.has_times}, topics_{make_topics(circumstances)} {
  for (eds::Description& description : circumstances.descriptions) describe(std::move(description));
}

Auditor::~Auditor() = default;

void Auditor::describe(eds::Description description) {
  ids_.describe(description);
  network_.describe(std::move(description));
}

void Auditor::take(const Heard& heard) {
  ++frames_;
  last_ = heard.at;
  const Passage passage = passage_of(heard);
  const auto transfer = dialogues_.take(passage, findings_);
  const Scene scene{network_, findings_, time_lines_};
  for (const auto& topic : topics_) topic->on_frame(passage, scene);
  if (transfer) judge(*transfer);
  findings_.explain(ids_);
  if (heard.is_error) return;
  network_.follow(passage, transfer ? &*transfer : nullptr);
  (void)ids_.follow(heard.frame, passage.meaning);
}

Passage Auditor::passage_of(const Heard& heard) const {
  if (heard.is_error) return {heard};
  Passage passage{heard, ids_.meaning_of(heard.frame)};
  passage.is_shared = passage.meaning.role == meaning::Role::Rpdo && ids_.is_shared(heard.frame);
  return passage;
}

void Auditor::judge(const Transfer& transfer) {
  const Scene scene{network_, findings_, time_lines_, findings_.total()};
  for (const auto& topic : topics_) topic->on_transfer(transfer, scene);
}

void Auditor::end() {
  dialogues_.end(last_, findings_);
  const Scene scene{network_, findings_, time_lines_};
  for (const auto& topic : topics_) topic->on_end(last_, scene);
  findings_.explain(ids_);
}

}  // namespace audit
