#include "document/content.hpp"

#include <algorithm>
#include <cctype>

#include "document/steps.hpp"
#include "formula/series.hpp"
#include "formula/symbols.hpp"

namespace vcrit::symbolic {

namespace {

using GiNaC::ex;

/// Which definitions the reader has seen: only new ones are shown.
class Reader {
 public:
  std::vector<Line> tell(const std::vector<Line>& definitions) {
    std::vector<Line> fresh;
    for (const Line& line : definitions)
      if (!knows(line)) fresh.push_back(line);
    known_.insert(known_.end(), fresh.begin(), fresh.end());
    return fresh;
  }

 private:
  bool knows(const Line& line) const {
    return std::any_of(known_.begin(), known_.end(), [&](const Line& known) {
      return known.left.is_equal(line.left) && known.right.is_equal(line.right);
    });
  }
  std::vector<Line> known_;
};

Line velocity_line(const ex& velocity) { return {"", quantity("v*"), velocity}; }

bool same(const std::vector<Line>& a, const std::vector<Line>& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](const Line& x, const Line& y) {
    return x.left.is_equal(y.left) && x.right.is_equal(y.right);
  });
}

/// A line without words goes on under those before it.
std::vector<DocumentBlock> blocks_of(const std::vector<Line>& lines) {
  std::vector<DocumentBlock> blocks;
  for (const Line& line : lines) {
    if (blocks.empty() || !line.words.empty()) blocks.push_back({line.words, {}});
    blocks.back().lines.push_back(line);
  }
  return blocks;
}

/// Its definitions and v* in place of the result's line.
void show_shortest(const ShortestForm& form, DocumentBlock& result) {
  if (!form.ratio.empty()) (result.words += ", ") += form.ratio;
  result.lines.clear();
  result.equations = equations_of(form);
}

/// The last line is the result, with its number in the paper.
DocumentSection derivation_section(const Findings& findings) {
  const Derivation& derivation = findings.derivation;
  DocumentSection section;
  section.blocks = blocks_of(derivation.lines);
  const std::vector<DocumentBlock> steps = root_steps(derivation, findings.abbreviated.names);
  section.blocks.insert(section.blocks.end() - 1, steps.begin(), steps.end());
  DocumentBlock& result = section.blocks.back();
  result.words += " " + derivation.equation;
  if (findings.shortest) {
    show_shortest(*findings.shortest, result);
    return section;
  }
  if (!findings.why_complex.empty())
    section.note = "The formula is left in complex stiffnesses: " + findings.why_complex + ".";
  return section;
}

DocumentSection form_section(const Findings& findings) {
  const bool rational = findings.form == ResultForm::rational;
  DocumentSection section{rational ? "Rational form" : "Dimensionless form", "", {}};
  section.blocks = blocks_of(findings.form_lines);
  if (findings.in_groups)
    section.blocks.push_back({"In these", {}, false, equations_of(*findings.in_groups)});
  return section;
}

/// Facts without a line of mathematics are sentences.
DocumentSection facts_section(const Findings& findings) {
  DocumentSection section{"What it says", "", {}};
  for (const Fact& fact : findings.facts) {
    if (fact.lines.empty()) {
      if (!section.note.empty()) section.note += " ";
      section.note += fact.words;
      section.note += ".";
      continue;
    }
    section.blocks.push_back({fact.words, {}});
    for (const ShortestForm::Definition& line : fact.lines)
      section.blocks.back().equations.push_back({line.name, {false, line.meaning}, {}});
  }
  if (section.blocks.empty() && !section.note.empty()) section.blocks.emplace_back();
  return section;
}

/// A title with the number of an equation; its first word with a capital, its first symbol as it
/// is.
Prose headed(const Prose& title, const std::string& equation) {
  Prose result;
  for (Prose::Part part : title.parts()) {
    if (result.empty() && !part.words.empty())
      part.words.front() = static_cast<char>(std::toupper(part.words.front()));
    result += {part};
  }
  if (!equation.empty()) result += " " + equation;
  return result;
}

/// g and Z, if what follows has them.
void add_names(const Abbreviations& names, const std::vector<ex>& shown, DocumentSection& section) {
  const std::vector<Line> used = names.used_by(shown);
  if (!used.empty()) section.blocks.push_back({"With", used});
}

/// What the inner quantities are in the limit, where they differ, then v*.
DocumentSection limits_section(const Findings& findings) {
  DocumentSection section{"Limits and special cases", "", {}};
  std::vector<ex> shown;
  for (const Limit& limit : findings.limits) shown.push_back(limit.shown);
  add_names(findings.abbreviated.names, shown, section);
  for (const Limit& limit : findings.limits) {
    DocumentBlock block{headed(limit.title, limit.equation), {}};
    if (!same(limit.definitions, findings.derivation.definitions)) block.lines = limit.definitions;
    block.lines.push_back(velocity_line(limit.shown));
    section.blocks.push_back(block);
  }
  return section;
}

DocumentSection asymptotes_section(const Findings& findings) {
  DocumentSection section{"Low and high frequency", "", {}};
  const std::vector<Asymptote>& asymptotes = findings.abbreviated.asymptotes;
  std::vector<ex> shown;
  for (const Asymptote& asymptote : asymptotes) shown.push_back(asymptote.coefficient);
  add_names(findings.abbreviated.names, shown, section);
  for (const Asymptote& asymptote : asymptotes) {
    DocumentBlock block{asymptote.title, asymptote.definitions, true};
    block.lines.push_back(asymptote_line(asymptote));
    section.blocks.push_back(block);
    if (!asymptote.definitions.empty())
      section.note = {quantity("L_j"), " is what ",
                      quantity("K_j"), " tends to, without its power of ",
                      laplace(),       "."};
  }
  return section;
}

std::vector<Line> resonance_lines(const Resonance& resonance) {
  std::vector<Line> lines{{"", resonance.condition, 0}};
  if (resonance.frequency) lines.push_back({"", omega(), *resonance.frequency});
  return lines;
}

Prose resonance_words(const Resonance& resonance) {
  const bool infinite = resonance.kind != Resonance::Kind::antiresonance;
  const std::string name = resonance.kind == Resonance::Kind::mount_resonance
                               ? "Resonance of mount and contact along the normal, "
                           : infinite ? "Resonance, "
                                      : "Antiresonance, ";
  const ex v = quantity("v*");
  if (!resonance.damped) return infinite ? Prose{name, v, " infinite"} : Prose{name, stated(v, 0)};
  return {name + "damped: ", v, infinite ? " stays finite, as this " : " stays above 0, as this ",
          resonance.absorbing ? "holds only where masses keep all dampers still" : "never holds"};
}

std::vector<DocumentBlock> resonance_blocks(const Resonance& resonance) {
  std::vector<DocumentBlock> blocks{{resonance_words(resonance), resonance_lines(resonance)}};
  if (!resonance.parts) return blocks;
  const Resonance::Parts& parts = *resonance.parts;
  blocks.push_back({"Its real part asks for", {{"", parts.real, 0}}});
  blocks.push_back({"Its imaginary part", {{"", parts.imaginary, 0}}});
  return blocks;
}

DocumentSection resonances_section(const Findings& findings) {
  DocumentSection section{"Resonance and antiresonance", "", {}};
  const std::vector<Resonance>& resonances = findings.abbreviated.resonances;
  std::vector<ex> shown;
  for (const Resonance& resonance : resonances) {
    shown.push_back(resonance.condition);
    if (resonance.parts)
      shown.insert(shown.end(), {resonance.parts->real, resonance.parts->imaginary});
  }
  add_names(findings.abbreviated.names, shown, section);
  for (const Resonance& resonance : resonances)
    for (const DocumentBlock& block : resonance_blocks(resonance)) section.blocks.push_back(block);
  return section;
}

DocumentSection extrema_section(const std::vector<Line>& lines) {
  return {{"Largest and least ", quantity("v*")}, "", blocks_of(lines)};
}

// Lines; more are hard to read without a gap.
constexpr std::size_t longest_block = 12;

Line sensitivity_line(const Sensitivity& sensitivity) {
  return {"", quantity("S_" + to_text(sensitivity.parameter)), sensitivity.relative};
}

/// Its lines side by side, to be compared with those of other entries of an array.
std::optional<SeriesMember> member_of_array(const Sensitivity& sensitivity) {
  Form all{Form::Kind::sum, "", {}, {}, {}, 1};
  std::vector<Line> lines = sensitivity.changes;
  lines.insert(lines.begin(), sensitivity_line(sensitivity));
  for (const Line& line : lines)
    for (const ex& side : {ex(line.left), ex(line.right)}) {
      const Signed form = form_of(side);
      all.terms.push_back({form.minus, with_series(form.form)});
    }
  return series_member(all);
}

/// One block for all entries of an array, where these differ by their number alone.
std::optional<DocumentBlock> array_block(const std::vector<Sensitivity>& all,
                                         const Symbol& parameter) {
  if (parameter.entry == 0) return std::nullopt;
  std::optional<SeriesMember> first;
  int entries = 0;
  for (const Sensitivity& each : all) {
    if (each.parameter.name != parameter.name) continue;
    const std::optional<SeriesMember> member = member_of_array(each);
    if (!member || member->number != ++entries) return std::nullopt;
    if (!first) first = member;
    if (member->pattern != first->pattern) return std::nullopt;
  }
  if (entries < shortest_series) return std::nullopt;
  DocumentBlock block{"", {}};
  std::vector<Signed>& sides = first->general.terms;
  for (std::size_t i = 0; i + 1 < sides.size(); i += 2)
    block.equations.push_back({sides[i].form, sides[i + 1], {}});
  std::rotate(block.equations.begin(), block.equations.begin() + 1, block.equations.end());
  block.equations.back().range = {series_index(), 1, entries};
  return block;
}

DocumentSection sensitivities_section(const Findings& findings) {
  const ex S = quantity("S_p"), p = quantity("p"), v = quantity("v*");
  const Prose note{"Where a parameter ",
                   p,
                   " grows by one percent, ",
                   v,
                   " grows by ",
                   S,
                   " percent; the derivative of ",
                   v,
                   " by ",
                   p,
                   " is ",
                   v * S / p,
                   "."};
  DocumentSection section{"Sensitivities", note, {}};
  Reader reader;
  reader.tell(findings.derivation.definitions);
  const auto& [shared, all] = findings.abbreviated.sensitivities;
  std::vector<ex> shown;
  for (const Line& line : shared) shown.push_back(line.right);
  for (const Sensitivity& each : all) {
    shown.push_back(each.relative);
    for (const Line& line : each.changes) shown.push_back(line.right);
  }
  add_names(findings.abbreviated.names, shown, section);
  const ex B = quantity("B"), K = quantity("K_j");
  Prose with_changes = note;
  with_changes += {" ",
                   quantity("dK_j"),
                   " is the derivative of ",
                   K,
                   " by ",
                   p,
                   ", times ",
                   p,
                   ", with the ",
                   p,
                   " of the ",
                   S,
                   " that follows."};
  if (!shared.empty()) {
    section.note +=
        {" ", quantity("G_j"), " is the derivative of ", B, " by ", K, ", over ", B, "."};
    section.blocks.push_back({"", shared});
  }
  for (auto next = all.begin(); next != all.end(); ++next) {
    if (!next->changes.empty()) section.note = with_changes;
    if (const auto array = array_block(all, next->parameter)) {
      if (next->parameter.entry == 1) section.blocks.push_back(*array);
      continue;
    }
    std::vector<Line> lines = reader.tell(next->stiffnesses);
    lines.insert(lines.end(), next->changes.begin(), next->changes.end());
    lines.push_back(sensitivity_line(*next));
    const bool alone = section.blocks.empty() ||
                       section.blocks.back().lines.size() >= longest_block ||
                       !section.blocks.back().equations.empty();
    if (alone) section.blocks.push_back({"", {}});
    std::vector<Line>& block = section.blocks.back().lines;
    block.insert(block.end(), lines.begin(), lines.end());
  }
  return section;
}

DocumentSection half_space_section(const Findings& findings) {
  return {"Below the indenter", "", blocks_of(findings.half_space)};
}

DocumentSection separation_section(const Findings& findings) {
  DocumentSection section{"Loss of contact", "", {}};
  if (!findings.separation) return section;
  section.blocks = blocks_of(*findings.separation);
  if (!section.blocks.empty()) return section;
  const std::string why =
      "the contact point follows the normal deformation with memory, or the contact is open "
      "where it grows fastest.";
  section.note = {quantity("v*"), " above holds while the contact stays closed. Where it opens ",
                  quantity("v*"), " is another one, "};
  section.note += findings.beyond_simulation.empty()
                      ? "which vcrit eval simulates: " + why
                      : "for which there is no answer (" + findings.beyond_simulation + "): " + why;
  section.blocks.emplace_back();
  return section;
}

}  // namespace

std::vector<DocumentSection> sections(const Findings& findings, FactsPlace place) {
  const DocumentSection facts = facts_section(findings);
  std::vector<DocumentSection> all{derivation_section(findings),
                                   form_section(findings),
                                   facts,
                                   half_space_section(findings),
                                   separation_section(findings),
                                   limits_section(findings),
                                   asymptotes_section(findings),
                                   resonances_section(findings),
                                   extrema_section(findings.extrema),
                                   sensitivities_section(findings)};
  if (place == FactsPlace::first && !facts.blocks.empty()) {
    all.front().title = "Derivation";
    std::rotate(all.begin(), all.begin() + 2, all.begin() + 3);
  }
  std::erase_if(all, [](const DocumentSection& section) { return section.blocks.empty(); });
  return all;
}

Line asymptote_line(const Asymptote& asymptote) {
  return velocity_line(asymptote.coefficient * GiNaC::pow(omega(), asymptote.power));
}

std::vector<Equation> equations_of(const ShortestForm& form) {
  std::vector<Equation> result;
  for (const ShortestForm::Definition& each : form.definitions)
    result.push_back({each.name, {false, each.meaning}, {}});
  result.push_back({form_of(quantity("v*")).form, {false, form.velocity}, {}});
  return result;
}

std::string title_of(const Problem& problem) {
  return problem->source->title.empty() ? "Critical velocity of controllability of sliding friction"
                                        : problem->source->title;
}

}  // namespace vcrit::symbolic
