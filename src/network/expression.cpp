#include "network/expression.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <charconv>

#include "base/identifiers.hpp"
#include "base/joined.hpp"
#include "base/plain_text.hpp"
#include "base/spelled_names.hpp"
#include "base/trimmed.hpp"
#include "network/catalogue.hpp"

namespace vcrit {

namespace {

// See docs/limits.md.
constexpr int most_branches = 100000;

// Stands for one of unknown kind where the rest is read on, for its errors.
constexpr const char* unknown_element = "k_unknown";

bool is_of_name(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_';
}

/// An element by the letter that textbooks give it: E and G are moduli, eta is a viscosity. Empty
/// for any other.
std::string by_its_letter(const std::string& name) {
  if (name.starts_with('k') || name.starts_with('c')) return name;
  if (name.starts_with('E') || name.starts_with('G')) return "spring(" + name + ")";
  if (name.starts_with("eta")) return "damper(" + name + ")";
  return "";
}

/// The network with the kinds of its elements, where their letters tell all of them; else empty.
std::string with_kinds(std::string_view text) {
  std::string written;
  for (std::size_t begin = 0, end = 0; begin < text.size(); begin = end) {
    end = begin + 1;
    if (!is_of_name(text[begin])) {
      written += text[begin];
      continue;
    }
    while (end < text.size() && is_of_name(text[end])) ++end;
    const std::string name = by_its_letter(std::string(text.substr(begin, end - begin)));
    if (name.empty() || (end < text.size() && text[end] == '(')) return "";
    written += name;
  }
  return fmt::format("write \"{}\"", written);
}

class Parser {
 public:
  Parser(std::string_view text, Place place, const Surroundings& around)
      : text_(text), place_(std::move(place)), around_(around), depth_(around.level) {}

  Network whole() {
    Network network = parallel_chain();
    if (peek() == ')') refuse("\")\" without an opening parenthesis", "the end or an operator");
    if (peek() != '\0' || !at_end()) refuse(found(), "\"|\" (parallel), \"-\" (series) or the end");
    return network;
  }

 private:
  Network parallel_chain() {
    std::vector<Network> parts{series_chain()};
    while (accept('|')) parts.push_back(series_chain());
    return parallel(std::move(parts));
  }

  Network series_chain() {
    std::vector<Network> parts{operand()};
    while (accept('-')) parts.push_back(operand());
    return series(std::move(parts));
  }

  Network operand() {
    if (peek() == '(') return group();
    const Place at = here();
    const std::string name = identifier("an element, a network or \"(\"");
    if (peek() == '(') return call(name, at);
    const bool is_argument = around_.arguments.contains(name);
    if (auto network = is_argument ? std::nullopt : around_.named_network(name, at, depth_))
      return counted(std::move(*network), at);
    count(1, at);
    return element(name, at);
  }

  Network counted(Network network, const Place& at) {
    count(size(network), at);
    return network;
  }

  Network group() {
    const Place opening = here();
    if (++depth_ > deepest_nesting) refuse_nesting();
    accept('(');
    Network network = parallel_chain();
    close(opening);
    --depth_;
    return network;
  }

  [[noreturn]] void refuse_nesting() {
    int level = depth_, deepest = depth_;
    for (const char c : text_.substr(position_ + 1)) {
      if (c == '(') deepest = std::max(deepest, ++level);
      if (c == ')') --level;
    }
    throw InputError(
        here(), fmt::format("{} levels of brackets", deepest),
        fmt::format("at most {}, named networks counted as one each", deepest_nesting));
  }

  // An element beside the branches of an array does not count.
  void count(std::size_t elements, const Place& at) {
    elements_ += elements;
    if (elements_ > most_elements)
      throw InputError(at, fmt::format("more than {} elements", most_elements),
                       "a smaller network");
  }

  // What a name stands for: in a network with arguments, the caller's name for it.
  const std::string& meant(const std::string& name) const {
    const auto argument = around_.arguments.find(name);
    return argument == around_.arguments.end() ? name : argument->second;
  }

  // Its kind goes by the name that is written here.
  Network element(const std::string& name, const Place& at) const {
    if (name.front() == 'k') return spring({meant(name)});
    if (name.front() == 'c') return damper({meant(name)});
    refuse_fractional(name, at);
    if (name == "rigid")
      throw InputError(at, "\"rigid\"", "springs and dampers",
                       "what is rigid has no network: leave out [drive]");
    const InputError unknown(
        at, fmt::format("element \"{}\" of unknown kind", name),
        fmt::format("a name that begins with k (spring) or c (damper), spring({0}) or damper({0}), "
                    "or a network of that name",
                    name),
        around_.arguments.empty() ? with_kinds(text_) : "");
    if (!around_.complain) throw unknown;
    around_.complain(unknown);
    return spring({unknown_element});
  }

  // A network of the scene goes before one of the catalogue, which later versions may add to.
  Network call(const std::string& name, const Place& at) {
    const bool is_own = around_.has_arguments && around_.has_arguments(name);
    return is_own ? own_call(name, at) : catalogue_call(name, at);
  }

  Network own_call(const std::string& name, const Place& at) {
    const Place opening = here();
    accept('(');
    std::vector<std::string> names;
    do names.push_back(element_name());
    while (accept(','));
    close(opening);
    return counted(around_.called_network(name, names, at, depth_), at);
  }

  Network catalogue_call(const std::string& name, const Place& at) {
    const Rheology& rheology = named_rheology(name, at);
    const Place opening = here();
    accept('(');
    std::vector<std::string> names;
    std::optional<int> branches;
    do {
      if (rheology.has_arrays() && names.size() == rheology.arguments.size() && !branches)
        branches = number_of_branches();
      else
        names.push_back(element_name());
    } while (accept(','));
    close(opening);
    if (names.size() != rheology.arguments.size())
      throw InputError(
          at, fmt::format("{} with {} name{}", name, names.size(), names.size() == 1 ? "" : "s"),
          rheology.signature(name));
    if (!rheology.has_arrays()) {
      count(names.size(), at);
      return rheology.build(names, 0);
    }
    const int built = length(rheology, names, branches, at);
    count(static_cast<std::size_t>(built), at);
    return rheology.build(names, built);
  }

  std::string element_name() { return meant(identifier("the name of an element")); }

  static const Rheology& named_rheology(const std::string& name, const Place& at) {
    std::vector<std::string> known;
    for (const Rheology& rheology : catalogue()) {
      if (rheology.goes_by(name)) return rheology;
      known.push_back(rheology.name);
      known.insert(known.end(), rheology.also.begin(), rheology.also.end());
    }
    refuse_fractional(name, at);
    const auto meant = nearest(name, known);
    throw InputError(
        at, fmt::format("unknown rheology \"{}\"", name),
        meant ? fmt::format("\"{}\"", *meant) : fmt::format("one of {}", joined(known, ", ")));
  }

  // vcrit has networks of a finite number of springs and dampers.
  static void refuse_fractional(const std::string& name, const Place& at) {
    const bool is_fractional = name.starts_with("springpot") || name.starts_with("spring_pot") ||
                               name.starts_with("fractional") || name.starts_with("scott_blair");
    if (!is_fractional) return;
    throw InputError(
        at, fmt::format("\"{}\", a fractional element", name), "springs and dampers",
        "write its storage and loss stiffness, K (omega tau)^alpha times cos and sin of alpha "
        "pi/2, "
        "over the frequencies that matter as a table; `vcrit fit DATA.csv --out SCENE.toml` then "
        "fits a Prony series to it");
  }

  // All arrays of one call have one length: the one written, or that of the arrays in [elements].
  int length(const Rheology& rheology, const std::vector<std::string>& names,
             std::optional<int> branches, const Place& at) const {
    for (std::size_t i = 0; i < names.size(); ++i) {
      if (rheology.arguments[i].second != Rheology::Argument::array) continue;
      const auto known = around_.array_length(names[i]);
      if (known && branches && *known != *branches)
        throw InputError(at, fmt::format("array \"{}\" of {} entries", names[i], *known),
                         fmt::format("{} entries, as many as the branches of {}", *branches,
                                     rheology.signature()));
      if (known) branches = known;
    }
    if (!branches)
      throw InputError(at, fmt::format("{} without a number of branches", rheology.name),
                       "arrays in [elements], or the number of branches as the last argument");
    if (rheology.is_nested && *branches > deepest_nesting)
      throw InputError(
          at, fmt::format("{} of {} branches", rheology.signature(), *branches),
          fmt::format("at most {}, each of which is inside the one before", deepest_nesting));
    return *branches;
  }

  int number_of_branches() {
    peek();
    const Place at = here();
    int value = 0;
    const auto [end, error] =
        std::from_chars(text_.data() + position_, text_.data() + text_.size(), value);
    if (error != std::errc{} || value < 1 || value > most_branches) {
      const auto size = static_cast<std::size_t>(end - text_.data()) - position_;
      throw InputError(at,
                       size > 0 ? fmt::format("\"{}\"", text_.substr(position_, size)) : found(),
                       fmt::format("a number of branches from 1 to {}", most_branches));
    }
    position_ = static_cast<std::size_t>(end - text_.data());
    return value;
  }

  std::string identifier(const std::string& expected) {
    peek();
    const Place at = here();
    std::size_t end = position_;
    while (end < text_.size() && is_of_name(text_[end])) ++end;
    refuse_name_beyond_ascii(text_, position_, place_);
    if (end == position_) refuse(found(), expected);
    std::string name(text_.substr(position_, end - position_));
    if (const auto why = unsafe_as_identifier(name))
      throw InputError(at, fmt::format("name \"{}\", which {}", name, *why), "another name");
    position_ = end;
    return name;
  }

  void close(const Place& opening) {
    if (accept(')')) return;
    if (peek() == '\0')
      throw InputError(
          opening,
          fmt::format("\"(\" at column {} without its closing parenthesis", opening.column),
          "\")\" before the end");
    refuse(found(), "\")\" or an operator");
  }

  char peek() {
    while (position_ < text_.size() &&
           (text_[position_] == ' ' || text_[position_] == '\t' || text_[position_] == '\n'))
      ++position_;
    return position_ < text_.size() ? text_[position_] : '\0';
  }

  // peek() gives 0 there, but a text may hold that character, too.
  bool at_end() const { return position_ == text_.size(); }

  bool accept(char c) {
    if (peek() != c) return false;
    ++position_;
    return true;
  }

  std::string found() {
    peek();
    return at_end() ? "the end of the network" : fmt::format("\"{}\"", here_character());
  }

  // All of its bytes.
  std::string_view here_character() const {
    std::size_t size = 1;
    while (position_ + size < text_.size() && (byte_at(text_, position_ + size) & 0xC0U) == 0x80U)
      ++size;
    return text_.substr(position_, size);
  }

  // For those who know these networks as circuits, sums or formulas.
  const char* advice() const {
    const std::string_view found = here_character();
    const std::string_view before = trimmed(text_.substr(0, position_), " \t\n");
    if (found == "\u2212" || found == "\u2013")
      return "series is written with the \"-\" of the keyboard";
    if (found == "|" && before.ends_with('|')) return "parallel is one \"|\"";
    if (found == "-" && before.ends_with('-')) return "series is one \"-\"";
    if (found == "+" || found == "/" || found == "*" || found == "&")
      return "parallel is written \"|\", series \"-\": k0 | (k1 - c1)";
    return "";
  }

  Place here() {
    peek();
    return {place_.file, place_.line, place_.column + static_cast<int>(position_)};
  }

  [[noreturn]] void refuse(const std::string& what, const std::string& expected) {
    const Place at = here();
    throw InputError(at, fmt::format("{} at column {} of \"{}\"", what, at.column, text_), expected,
                     advice());
  }

  std::string_view text_;
  Place place_;
  const Surroundings& around_;
  std::size_t position_ = 0;
  int depth_;
  std::size_t elements_ = 0;
};

}  // namespace

Network parse_expression(std::string_view text, const Place& place, const Surroundings& around) {
  return Parser(text, place, around).whole();
}

}  // namespace vcrit
