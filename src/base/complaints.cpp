#include "base/complaints.hpp"
#include "base/sort_stably.hpp"

#include <tuple>

namespace vcrit {

std::string to_text(const Warning& warning) {
  const std::string place = to_text(warning.place);
  return place.empty() ? warning.text : place + ": " + warning.text;
}

void Complaints::add(const InputError& complaint) {
  if (mode_ == Mode::first) throw complaint;
  if (ignored_.contains(complaint.place().line)) return;
  if (told_.insert(complaint.what()).second) all_.push_back(complaint);
}

std::vector<InputError> Complaints::sorted() const {
  std::vector<InputError> all = all_;
  sort_stably(all, [](const InputError& a, const InputError& b) {
    return std::tie(a.place().line, a.place().column) < std::tie(b.place().line, b.place().column);
  });
  return all;
}

}  // namespace vcrit
