#include "formula/series.hpp"

#include <algorithm>
#include <cctype>
#include <map>
#include <utility>

#include "base/sort_stably.hpp"
#include "formula/dialect.hpp"
#include "formula/names.hpp"

namespace vcrit::symbolic {

namespace {

/// A name that ends in a number: "k" and 3 of k[3], "T" and 3 of the program's T3.
struct Numbered {
  std::string letter;
  int number;
  bool entry, own;
};

bool is_digits(const std::string& text) {
  return !text.empty() && text.size() < 7 &&
         std::all_of(text.begin(), text.end(), [](unsigned char c) { return std::isdigit(c); });
}

std::optional<Numbered> numbered_name(const std::string& name) {
  const std::string base = base_name(name);
  if (const auto open = base.find('['); open != std::string::npos && base.back() == ']') {
    const std::string digits = base.substr(open + 1, base.size() - open - 2);
    if (is_digits(digits))
      return Numbered{base.substr(0, open), std::stoi(digits), true, is_own(name)};
  }
  if (!is_own(name)) return std::nullopt;
  const auto end = base.find_last_not_of("0123456789");
  if (end == std::string::npos || !is_digits(base.substr(end + 1))) return std::nullopt;
  std::string letter = base.substr(0, end + 1);
  if (letter.ends_with('_')) letter.pop_back();
  if (letter.size() != 1) return std::nullopt;
  return Numbered{letter, std::stoi(base.substr(end + 1)), false, true};
}

template <class Visit>
void each_name(Form& form, const Visit& visit) {
  if (form.kind == Form::Kind::name) return visit(form);
  for (Form& part : form.over) each_name(part, visit);
  for (Form& part : form.under) each_name(part, visit);
  for (Signed& term : form.terms) each_name(term.form, visit);
}

/// "j", "j+10" or "j-1".
std::string shifted(const std::string& index, int by) {
  return by == 0 ? index : index + (by > 0 ? "+" : "") + std::to_string(by);
}

std::string general_name(const Numbered& name, const std::string& index, int from) {
  const int by = name.number - from;
  const bool bracket = name.entry || by != 0;
  const std::string base =
      bracket ? name.letter + "[" + shifted(index, by) + "]" : name.letter + "_" + index;
  return name.own ? own_name(base) : base;
}

struct SeriesTerm {
  bool minus;
  SeriesMember member;
  std::size_t place;
};

/// Runs of consecutive numbers among terms of one pattern, each long enough to be a series.
std::vector<std::vector<SeriesTerm>> runs(std::vector<SeriesTerm> terms) {
  sort_stably(terms, [](const SeriesTerm& a, const SeriesTerm& b) {
    return a.member.number < b.member.number;
  });
  std::vector<std::vector<SeriesTerm>> result;
  for (SeriesTerm& term : terms) {
    if (result.empty() || result.back().back().member.number + 1 != term.member.number)
      result.emplace_back();
    result.back().push_back(std::move(term));
  }
  std::erase_if(result, [](const auto& run) { return run.size() < shortest_series; });
  return result;
}

void fold_terms(std::vector<Signed>& terms) {
  if (terms.size() < shortest_series) return;
  std::map<std::pair<bool, std::string>, std::vector<SeriesTerm>> by_pattern;
  for (std::size_t i = 0; i < terms.size(); ++i)
    if (auto member = series_member(terms[i].form)) {
      const std::pair key{terms[i].minus, member->pattern};
      by_pattern[key].push_back({terms[i].minus, std::move(*member), i});
    }
  std::map<std::size_t, std::optional<Signed>> changed;  // by place; nothing where it is left out
  for (auto& [key, members] : by_pattern)
    for (const std::vector<SeriesTerm>& run : runs(std::move(members))) {
      std::size_t first = run.front().place;
      for (const SeriesTerm& term : run) {
        first = std::min(first, term.place);
        changed[term.place] = std::nullopt;
      }
      const SeriesMember& begin = run.front().member;
      changed[first] = Signed{key.first,
                              {Form::Kind::series,
                               series_index(),
                               {},
                               {},
                               {{false, begin.general}},
                               begin.number,
                               run.back().member.number}};
    }
  std::vector<Signed> folded;
  for (std::size_t i = 0; i < terms.size(); ++i) {
    const auto found = changed.find(i);
    if (found == changed.end()) folded.push_back(std::move(terms[i]));
    if (found != changed.end() && found->second) folded.push_back(*found->second);
  }
  terms = std::move(folded);
}

}  // namespace

std::string series_index() {
  for (const char* letter : {"j", "l", "n", "p", "q"})
    if (!is_taken(letter) && printed_name(own_name("i")) != letter) return letter;
  return "index";
}

std::optional<SeriesMember> series_member(const Form& form) {
  std::optional<Numbered> first;
  Form general = form;
  each_name(general, [&first](const Form& name) {
    const auto found = numbered_name(name.text);
    if (found && (!first || (found->entry && !first->entry))) first = found;
  });
  if (!first) return std::nullopt;
  const std::string index = series_index();
  each_name(general, [&](Form& name) {
    if (const auto found = numbered_name(name.text))
      name.text = general_name(*found, index, first->number);
  });
  return SeriesMember{text_dialect().print({false, general}), first->number, general};
}

Form with_series(Form form) {
  for (Form& part : form.over) part = with_series(std::move(part));
  for (Form& part : form.under) part = with_series(std::move(part));
  for (Signed& term : form.terms) term.form = with_series(std::move(term.form));
  if (form.kind != Form::Kind::sum) return form;
  fold_terms(form.terms);
  const bool lone = form.terms.size() == 1 && !form.terms.front().minus;
  return lone ? Form(form.terms.front().form) : form;
}

}  // namespace vcrit::symbolic
