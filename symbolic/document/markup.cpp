#include "document/markup.hpp"

#include <optional>
#include <utility>

#include "base/plain_text.hpp"
#include "document/displays.hpp"
#include "formula/dialect.hpp"
#include "formula/width.hpp"
#include "record/fields.hpp"
#include "record/html_text.hpp"
#include "record/template.hpp"

extern "C" const char vcrit_document_templates[], vcrit_document_templates_end[];

namespace vcrit::symbolic {

namespace {

using record::Fields, record::Json;

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

/// How a markup takes the title, which is the user's, our own words, and formulas in them.
struct DocumentMarkup {
  const char* name;
  const Dialect& (*dialect)();
  const Dialect& (*within_words)();
  const char *open, *close;
  std::string (*title)(std::string_view);
  std::string (*words)(std::string_view);
  std::optional<double> width;  ///< of a page, in pt

  record::Markup of(const Prose& prose) const {
    return {prose.written(within_words(), open, close, words)};
  }
};

DocumentMarkup markup_of(Format format) {
  if (format == Format::latex)
    return {"latex", latex_dialect, latex_within_words, "$", "$", latex, latex, safe_text_width};
  if (format == Format::markdown)
    return {"markdown", latex_dialect, latex_within_words, "$", "$", markdown, as_it_is,
            safe_text_width};
  if (format == Format::html)
    return {"html", mathml_dialect, mathml_dialect, "<math><mrow>", "</mrow></math>",
            record::html_text, record::html_text, safe_text_width};
  return {"text", text_dialect, text_dialect, "", "", as_it_is, as_it_is, std::nullopt};
}

/// Its rows, and the whole of a lone one.
Json display_record(const Display& display) {
  const auto markup = [](const std::string& text) {
    return Fields(record::Reader::page).written(record::Markup{text});
  };
  Json rows = Json::array();
  for (const PrintedEquation& equation : display)
    for (const std::string& row : equation.rows) {
      const bool first = &row == &equation.rows.front(), last = &row == &equation.rows.back();
      rows.push_back({{"left", markup(first ? equation.left : "")},
                      {"sign", markup(first ? equation.sign : "")},
                      {"right", markup(row)},
                      {"range", markup(last ? equation.range : "")}});
    }
  const bool lone = rows.size() == 1;
  return {{"lone", lone}, {"rows", std::move(rows)}};
}

Json block_record(const DocumentBlock& block, const DocumentMarkup& markup, Displays& displays) {
  Json shown = Json::array();
  for (const Display& display : displays.of(block)) shown.push_back(display_record(display));
  Fields f(record::Reader::page);
  f("words", markup.of(block.words))("displays", shown);
  return f.take();
}

Json section_record(const Section& section, const DocumentMarkup& markup, Displays& displays) {
  Json blocks = Json::array();
  for (const DocumentBlock& block : section.blocks)
    blocks.push_back(block_record(block, markup, displays));
  Fields f(record::Reader::page);
  f("heading", markup.of(section.title))("note", markup.of(section.note));
  f("blocks", blocks)("remark", markup.of(section.remark));
  return f.take();
}

}  // namespace

std::string markup_document(Format format, const std::string& title,
                            const std::vector<Section>& sections, bool standalone) {
  const DocumentMarkup markup = markup_of(format);
  Displays displays(markup.dialect(), markup.width);
  const record::Markup heading{markup.title(one_line(title))};
  Json record{{"title", Fields(record::Reader::page).written(heading)},
              {"standalone", standalone},
              {"sections", Json::array()}};
  for (const Section& section : sections)
    record["sections"].push_back(section_record(section, markup, displays));
  const record::Templates templates(
      {vcrit_document_templates,
       static_cast<std::size_t>(vcrit_document_templates_end - vcrit_document_templates)},
      markup.words);
  return templates.render(markup.name, record);
}

}  // namespace vcrit::symbolic
