#include "emit/languages/sections.hpp"

#include <fmt/core.h>

#include <utility>
#include <vector>

#include "base/errors.hpp"
#include "emit/pieces.hpp"
#include "emit/straight_line.hpp"

namespace vcrit::symbolic {

namespace {

/// Three numbers a line.
std::string rows_of_table(const std::vector<double>& table) {
  std::string out;
  for (std::size_t i = 0; i < table.size(); i += 3)
    out += fmt::format("{}\n    {}, {}, {}", i == 0 ? "" : ",", literal(table[i]),
                       literal(table[i + 1]), literal(table[i + 2]));
  return out;
}

}  // namespace

Sections::Sections(std::string_view text) {
  std::string* section = nullptr;
  while (!text.empty()) {
    const std::string_view line = text.substr(0, text.find('\n') + 1);
    text.remove_prefix(line.size());
    const std::size_t sign = line.find_first_not_of("/#");
    if (sign != 0 && sign != line.npos && line.substr(sign).starts_with(": "))
      section = &sections_[std::string(line.substr(sign + 2, line.size() - sign - 3))];
    else if (section != nullptr)
      *section += line;
  }
}

const std::string& Sections::operator[](const std::string& name) const {
  const auto found = sections_.find(name);
  ensure(found != sections_.end(), "the section is there");
  return found->second;
}

std::string Sections::rare_operations(const Program& program) const {
  using Operation = Node::Operation;
  std::string out;
  for (const auto& [operation, name] : {std::pair(Operation::less_inertia, "less_inertia"),
                                        {Operation::unit, "power_unit"},
                                        {Operation::nonzero, "nonzero"},
                                        {Operation::gap, "ties"},
                                        {Operation::magnitude, "magnitude"},
                                        {Operation::unless_moderate, "unless_moderate"},
                                        {Operation::place, "table"}})
    if (program.has(operation)) out += (*this)[name];
  out = replaced(out, "THE_MOST_EDGES", std::to_string(Program::most_edges));
  return program.has(Operation::place) ? replaced(out, "THE_ROWS", rows_of_table(program.table()))
                                       : out;
}

}  // namespace vcrit::symbolic
