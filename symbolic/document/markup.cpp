#include "document/markup.hpp"

#include <map>
#include <utility>

#include "base/plain_text.hpp"
#include "formula/dialect.hpp"
#include "record/fields.hpp"
#include "record/template.hpp"

extern "C" const char vcrit_document_templates[], vcrit_document_templates_end[];

namespace vcrit::symbolic {

namespace {

using record::Fields, record::Json;

/// Equations in one dialect. Those of a large network's limits are largely the same, hundreds of
/// times.
class PrintedEquations {
 public:
  explicit PrintedEquations(const Dialect& dialect) : dialect_(dialect) {}

  std::string operator()(const Equation& equation) const {
    return dialect_.equation({false, equation.left}, {false, equation.right});
  }

  std::string operator()(const Line& line, bool asymptotic) {
    if (asymptotic) return dialect_.asymptote(form_of(line.left), form_of(line.right));
    const auto [known, is_new] = known_.try_emplace({line.left, line.right});
    if (is_new) known->second = dialect_.equation(form_of(line.left), form_of(line.right));
    return known->second;
  }

 private:
  struct Less {
    using Sides = std::pair<GiNaC::ex, GiNaC::ex>;
    bool operator()(const Sides& a, const Sides& b) const {
      const int order = a.first.compare(b.first);
      return order != 0 ? order < 0 : a.second.compare(b.second) < 0;
    }
  };
  const Dialect& dialect_;
  std::map<Less::Sides, std::string, Less> known_;
};

Json block_record(const DocumentBlock& block, PrintedEquations& equation) {
  std::vector<record::Markup> lines;
  for (const Line& line : block.lines)
    lines.push_back({equation(line, block.asymptotic && &line == &block.lines.back())});
  for (const Equation& each : block.equations) lines.push_back({equation(each)});
  const bool formula = !block.formula.empty(), words = !block.words.empty();
  Fields f(record::Reader::page);
  f("formula", block.formula)("latex_formula", record::Markup{block.latex_formula});
  f("words", block.words)("headed", formula || words)("both", formula && words)("lines", lines);
  return f.take();
}

Json section_record(const Section& section, PrintedEquations& equation) {
  Json blocks = Json::array();
  for (const DocumentBlock& block : section.blocks) blocks.push_back(block_record(block, equation));
  return {{"heading", section.title},
          {"note", section.note},
          {"blocks", std::move(blocks)},
          {"remark", section.remark}};
}

std::string as_it_is(std::string_view text) { return std::string(text); }

std::string latex(std::string_view text) {
  std::string out;
  for (const char c : text) {
    if (std::string_view("_%&#${}").find(c) != std::string_view::npos) out += '\\';
    if (c == '\\')
      out += "\\textbackslash{}";
    else
      out += c == '^' || c == '~' ? "\\" + std::string(1, c) + "{}" : std::string(1, c);
  }
  return out;
}

// What would begin a tag, a link, code or a formula.
std::string markdown(std::string_view text) {
  std::string out;
  for (const char c : text) {
    if (std::string_view("\\`*_[]<>&$~|#").find(c) != std::string_view::npos) out += '\\';
    out += c;
  }
  return out;
}

/// How a markup takes the title, which is the user's, and our own words.
struct Markup {
  const char* name;
  const Dialect& (*dialect)();
  std::string (*title)(std::string_view);
  std::string (*words)(std::string_view);
};

Markup markup_of(Format format) {
  if (format == Format::latex) return {"latex", latex_dialect, latex, latex};
  if (format == Format::markdown) return {"markdown", latex_dialect, markdown, as_it_is};
  return {"text", text_dialect, as_it_is, as_it_is};
}

}  // namespace

std::string markup_document(Format format, const std::string& title,
                            const std::vector<Section>& sections) {
  const Markup markup = markup_of(format);
  PrintedEquations equation(markup.dialect());
  const record::Markup heading{markup.title(one_line(title))};
  Json record{{"title", Fields(record::Reader::page).written(heading)},
              {"sections", Json::array()}};
  for (const Section& section : sections)
    record["sections"].push_back(section_record(section, equation));
  const record::Templates templates(
      {vcrit_document_templates,
       static_cast<std::size_t>(vcrit_document_templates_end - vcrit_document_templates)},
      markup.words);
  return templates.render(markup.name, record);
}

}  // namespace vcrit::symbolic
