#include "document/markup.hpp"

#include <algorithm>
#include <functional>
#include <iterator>
#include <map>
#include <utility>

#include "base/plain_text.hpp"
#include "document/displays.hpp"
#include "formula/dialect.hpp"
#include "formula/text.hpp"
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
  static const std::map<char, std::string> written{
      {'\\', "\\textbackslash{}"}, {'^', "\\^{}"},           {'~', "\\~{}"},
      {'<', "\\textless{}"},       {'>', "\\textgreater{}"}, {'|', "\\textbar{}"}};
  std::string out;
  for (const char c : text) {
    const auto known = written.find(c);
    if (std::string_view("_%&#${}").find(c) != std::string_view::npos) out += '\\';
    out += known == written.end() ? std::string(1, c) : known->second;
  }
  return out;
}

/// Whether the fonts of an article without more packages have a character: ASCII, signs such as
/// those of degree and micro, and western letters but for those of Icelandic.
bool is_in_fonts(std::string_view bytes) {
  if (bytes.size() == 1) return byte_at(bytes, 0) < 0x80;
  if (bytes.size() != 2) return false;
  const unsigned code = (byte_at(bytes, 0) & 0x1FU) << 6U | (byte_at(bytes, 1) & 0x3FU);
  const bool icelandic = code == 0xD0 || code == 0xDE || code == 0xF0 || code == 0xFE;
  return code >= 0xB0 && code <= 0xFF && code != 0xBB && !icelandic;
}

/// For a file that has to compile whatever a scene is called: what has no letter is a question
/// mark.
std::string latex_alone(std::string_view text) {
  std::string known;
  for (std::size_t i = 0; i < text.size();) {
    std::size_t size = 1;
    while ((byte_at(text, i + size) & 0xC0U) == 0x80) ++size;
    const std::string_view bytes = text.substr(i, size);
    known += is_in_fonts(bytes) ? std::string(bytes) : "?";
    i += size;
  }
  return latex(known);
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

constexpr std::size_t terminal_columns = 100;

/// Lines of so many characters at most, as far as spaces allow that.
std::string wrapped(const std::string& text, std::size_t columns) {
  std::string result, line;
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t space = std::min(text.find(' ', begin), text.size());
    const std::string word = text.substr(begin, space - begin);
    if (!line.empty() && line.size() + 1 + word.size() >= columns) {
      result += line + "\n";
      line.clear();
    }
    line += (line.empty() ? "" : " ") + word;
    begin = space + 1;
  }
  return result + line;
}

/// How a markup takes the title, which is the user's, our own words, and formulas in them.
struct DocumentMarkup {
  const char* name;
  const Dialect& (*dialect)();
  const Dialect& (*within_words)();
  const char *open, *close;
  std::string (*title)(std::string_view);
  std::string (*words)(std::string_view);
  std::reference_wrapper<const PageMeasure> measure;
  bool wraps;  ///< words, at the measure's width

  record::Markup of(const Prose& prose) const {
    const std::string text = prose.written(within_words(), open, close, words);
    return {wraps ? wrapped(text, terminal_columns) : text};
  }
};

DocumentMarkup markup_of(Format format, bool standalone) {
  DocumentMarkup markup{"text",   text_dialect, text_dialect,        "",  "",
                        as_it_is, as_it_is,     measure_of_terminal, true};
  if (format == Format::text) return markup;
  markup = {"latex", latex_dialect, latex_within_words, "$",  "$",
            latex,   latex,         measure_of_page,    false};
  if (standalone) markup.title = latex_alone;
  if (format == Format::markdown) {
    markup.name = "markdown";
    markup.title = markdown;
    markup.words = as_it_is;
  }
  if (format == Format::html) {
    markup.name = "html";
    markup.dialect = mathml_dialect;
    markup.within_words = mathml_within_words;
    markup.open = "<math><mrow>";
    markup.close = "</mrow></math>";
    markup.title = markup.words = record::html_text;
  }
  return markup;
}

/// A row of an equation each.
Json rows_of(const Display& display) {
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
  return rows;
}

/// What is set at once: no more than that, which is all that KaTeX takes in one piece.
void add_display(Json& shown, Json rows) {
  constexpr std::size_t most_rows = 60;
  for (std::size_t from = 0; from < rows.size(); from += most_rows) {
    const auto begin = rows.begin() + static_cast<std::ptrdiff_t>(from);
    const auto end =
        rows.begin() + static_cast<std::ptrdiff_t>(std::min(from + most_rows, rows.size()));
    Json part = Json::array();
    std::copy(begin, end, std::back_inserter(part));
    const bool lone = part.size() == 1;
    shown.push_back({{"lone", lone}, {"rows", std::move(part)}});
  }
}

Json block_record(const DocumentBlock& block, const DocumentMarkup& markup, Displays& displays) {
  Json shown = Json::array();
  for (const Display& display : displays.of(block)) add_display(shown, rows_of(display));
  Fields f(record::Reader::page);
  f("words", markup.of(block.words))("displays", shown);
  return f.take();
}

Json symbol_record(const SymbolRow& row, const DocumentMarkup& markup) {
  Fields f(record::Reader::page);
  f("symbol", markup.of(row.symbol))("meaning", markup.of(row.meaning))("unit", row.unit);
  return f.take();
}

/// What an article leaves for the meaning of a symbol, in pt.
int width_of_meanings(const std::vector<SymbolRow>& rows) {
  constexpr double unit_and_gaps = 70;
  double widest = 0;
  for (const SymbolRow& row : rows)
    for (const Prose::Part& part : row.symbol.parts())
      for (const Statement& each : part.statement) widest = std::max(widest, width_of(each));
  return std::max(static_cast<int>(safe_text_width - widest - unit_and_gaps), 60);
}

/// In parts, each of which fits a page.
Json tables_record(const std::vector<SymbolRow>& rows, const DocumentMarkup& markup) {
  // Meanings in a narrow column take some lines each.
  const int width = width_of_meanings(rows);
  const std::size_t rows_of_page = width < 150 ? 12 : 30;
  Json tables = Json::array();
  for (std::size_t i = 0; i < rows.size(); ++i) {
    if (i % rows_of_page == 0) tables.push_back({{"rows", Json::array()}, {"width", width}});
    tables.back()["rows"].push_back(symbol_record(rows[i], markup));
  }
  return tables;
}

Json section_record(const DocumentSection& section, const DocumentMarkup& markup,
                    Displays& displays) {
  Json blocks = Json::array();
  for (const DocumentBlock& block : section.blocks)
    blocks.push_back(block_record(block, markup, displays));
  Fields f(record::Reader::page);
  f("heading", markup.of(section.title))("note", markup.of(section.note));
  f("blocks", blocks);
  std::vector<record::Markup> items;
  for (const Prose& item : section.items) items.push_back(markup.of(item));
  f("items", items)("symbols", !section.symbols.empty());
  f("tables", tables_record(section.symbols, markup));
  return f.take();
}

}  // namespace

std::string markup_document(Format format, const std::string& title,
                            const std::vector<DocumentSection>& sections, bool standalone) {
  const DocumentMarkup markup = markup_of(format, standalone);
  Displays displays(markup.dialect(), markup.measure);
  const record::Markup heading{markup.title(one_line(title))};
  Json record{
      {"title", Fields(record::Reader::page).written(heading)},
      {"standalone", standalone},
      {"style", Fields(record::Reader::page).written(record::Markup{std::string(mathml_style())})},
      {"sections", Json::array()}};
  for (const DocumentSection& section : sections)
    record["sections"].push_back(section_record(section, markup, displays));
  const record::Templates templates(
      {vcrit_document_templates,
       static_cast<std::size_t>(vcrit_document_templates_end - vcrit_document_templates)},
      markup.words);
  return templates.render(markup.name, record);
}

}  // namespace vcrit::symbolic
