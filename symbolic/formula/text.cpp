#include "formula/text.hpp"

#include "formula/algebra_lock.hpp"
#include "formula/dialect.hpp"
#include "record/html_text.hpp"

namespace vcrit::symbolic {

std::string to_text(const GiNaC::ex& expression) {
  const AlgebraLock lock;
  return text_dialect().print(form_of(expression));
}

std::string to_latex(const GiNaC::ex& expression) {
  const AlgebraLock lock;
  return latex_dialect().print(form_of(expression));
}

namespace {

std::string math(const std::string& content) {
  return "<math xmlns=\"http://www.w3.org/1998/Math/MathML\" display=\"block\"><mrow>" + content +
         "</mrow></math>";
}

}  // namespace

std::string_view mathml_style() {
  // Browsers show a single letter as one of U+1D400 to U+1D7FF, which few systems have a font for:
  // not here.
  return R"(math { font-family: "STIX Two Math", "Cambria Math", "XITS Math", "TeX Gyre Termes Math", "Libertinus Math", "DejaVu Math TeX Gyre", "Latin Modern Math", "Asana Math", math, serif; }
math mi { font-family: "STIX Two Text", "Cambria", "Times New Roman", "Liberation Serif", "DejaVu Serif", serif; font-style: italic; text-transform: none; }
math mi[mathvariant] { font-style: normal; }
)";
}

std::string to_mathml(const GiNaC::ex& expression) {
  const AlgebraLock lock;
  return math(mathml_dialect().print(form_of(expression)));
}

std::string to_mathml(const Form& form) { return math(mathml_dialect().print({false, form})); }

std::string to_mathml(const Prose& words) {
  return words.written(mathml_within_words(), "<math><mrow>", "</mrow></math>", record::html_text);
}

std::string to_mathml(const Line& line) {
  const AlgebraLock lock;
  return math(mathml_dialect().equation(form_of(line.left), form_of(line.right)));
}

}  // namespace vcrit::symbolic
