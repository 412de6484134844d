#include "document/markup.hpp"

#include <map>
#include <utility>

#include "base/plain_text.hpp"
#include "formula/dialect.hpp"

namespace vcrit::symbolic {

namespace {

/// One walk over a document for all markups.
class Markup {
 public:
  virtual ~Markup() = default;
  std::string document(const std::string& title, const std::vector<Section>& sections) const {
    std::string out = titled(title);
    for (const Section& section : sections) out += this->section(section);
    return out;
  }

 protected:
  virtual const Dialect& dialect() const = 0;
  virtual std::string titled(const std::string& title) const = 0;
  virtual std::string headed(const std::string& title) const = 0;
  virtual std::string paragraph(const std::string& words) const = 0;
  virtual std::string display(const std::string& equation) const = 0;
  virtual std::string words(const std::string& text) const { return text; }
  virtual std::string formula(const DocumentBlock& block) const {
    return "$" + block.latex_formula + "$";
  }

 private:
  std::string section(const Section& section) const {
    std::string out = section.title.empty() ? "" : headed(section.title);
    if (!section.note.empty()) out += paragraph(section.note);
    for (const DocumentBlock& each : section.blocks) out += block(each);
    if (!section.remark.empty()) out += paragraph(section.remark);
    return out;
  }

  std::string block(const DocumentBlock& block) const {
    std::string heading = block.formula.empty() ? "" : formula(block);
    if (!heading.empty() && !block.words.empty()) heading += " ";
    heading += words(block.words);
    std::string out = heading.empty() ? "" : heading + ":\n";
    for (const Line& line : block.lines)
      out += display(equation(line, block.asymptotic && &line == &block.lines.back()));
    return out;
  }

  std::string equation(const Line& line, bool asymptotic) const {
    if (asymptotic) return dialect().asymptote(form_of(line.left), form_of(line.right));
    const auto [known, is_new] = equations_.try_emplace({line.left, line.right});
    if (is_new) known->second = dialect().equation(form_of(line.left), form_of(line.right));
    return known->second;
  }

  struct Less {
    using Sides = std::pair<GiNaC::ex, GiNaC::ex>;
    bool operator()(const Sides& a, const Sides& b) const {
      const int order = a.first.compare(b.first);
      return order != 0 ? order < 0 : a.second.compare(b.second) < 0;
    }
  };
  /// Those of a large network's limits are largely the same, hundreds of times.
  mutable std::map<Less::Sides, std::string, Less> equations_;
};

class TextMarkup : public Markup {
  const Dialect& dialect() const override { return text_dialect(); }
  std::string titled(const std::string& title) const override { return one_line(title) + "\n\n"; }
  std::string headed(const std::string& title) const override { return "\n" + title + ":\n"; }
  std::string paragraph(const std::string& words) const override { return words + "\n"; }
  std::string display(const std::string& equation) const override {
    return "    " + equation + "\n";
  }
  std::string formula(const DocumentBlock& block) const override { return block.formula; }
};

class LatexMarkup : public Markup {
  const Dialect& dialect() const override { return latex_dialect(); }
  std::string titled(const std::string& title) const override {
    return "\\section*{" + words(one_line(title)) + "}\n";
  }
  std::string headed(const std::string& title) const override {
    return "\\subsection*{" + words(title) + "}\n";
  }
  std::string paragraph(const std::string& text) const override { return words(text) + "\n\n"; }
  std::string display(const std::string& equation) const override {
    return "\\[ " + equation + " \\]\n";
  }
  std::string words(const std::string& text) const override {
    std::string out;
    for (const char c : text) {
      if (std::string("_%&#${}").find(c) != std::string::npos) out += '\\';
      if (c == '\\')
        out += "\\textbackslash{}";
      else
        out += c == '^' || c == '~' ? "\\" + std::string(1, c) + "{}" : std::string(1, c);
    }
    return out;
  }
};

class MarkdownMarkup : public Markup {
  const Dialect& dialect() const override { return latex_dialect(); }
  std::string titled(const std::string& title) const override {
    return "# " + escaped(one_line(title)) + "\n\n";
  }
  std::string headed(const std::string& title) const override { return "## " + title + "\n\n"; }
  std::string paragraph(const std::string& words) const override { return words + "\n\n"; }
  std::string display(const std::string& equation) const override {
    return "\n$$" + equation + "$$\n\n";
  }
  // What would begin a tag, a link, code or a formula.
  static std::string escaped(const std::string& text) {
    std::string out;
    for (const char c : text) {
      if (std::string("\\`*_[]<>&$~|#").find(c) != std::string::npos) out += '\\';
      out += c;
    }
    return out;
  }
};

}  // namespace

std::string text_document(const std::string& title, const std::vector<Section>& sections) {
  return TextMarkup().document(title, sections);
}

std::string latex_document(const std::string& title, const std::vector<Section>& sections) {
  return LatexMarkup().document(title, sections);
}

std::string markdown_document(const std::string& title, const std::vector<Section>& sections) {
  return MarkdownMarkup().document(title, sections);
}

}  // namespace vcrit::symbolic
