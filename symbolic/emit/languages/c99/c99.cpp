// The C99 header: static inline functions whose names begin with the library's.
#include <fmt/core.h>

#include "emit/languages/language.hpp"
#include "emit/languages/sections.hpp"
#include "emit/pieces.hpp"
#include "emit/words.hpp"

VCRIT_ARITHMETIC(c99)

namespace vcrit::symbolic {

namespace {

class C99 {
 public:
  C99(const Evaluator& evaluator, const std::string& name)
      : evaluator_(evaluator), spelling_{name + "_", "fabs", "sqrt", true, Zeros::out_of_range} {}

  std::string text() const {
    std::string out = structs() + prefixed(sections_["numbers"]) + prefixed(sections_["wide"]) +
                      prefixed(sections_.rare_operations(evaluator_.gradient.program));
    out += prefixed("static inline int THE_in_range(const THE_Parameters p) {\n") +
           statement(
               fmt::format("return {};", in_range(evaluator_, spelling_, " && ", "((void)p, 0)"))) +
           "}\n" + prefixed("static inline int THE_allowed(const THE_Parameters p) {\n") +
           allowed_body(evaluator_.parameters, evaluator_.velocity) + "}\n";
    out += finished();
    for (const CallGrade grade : {CallGrade::accurate, CallGrade::fast, CallGrade::wide})
      out += evaluate(grade);
    out += "\n" + comment(evaluator_.parameters.named(
                      "v* is infinite at resonance, 0 at antiresonance, NaN for 0/0. Batches: a "
                      "value for each THE_OMEGA."));
    return out + calls("dd", "") + comment("In plain double.") + calls("plain", "fast_");
  }

 private:
  std::string prefixed(const std::string& text) const {
    return replaced(text, "THE_", spelling_.prefix);
  }

  std::string structs() const {
    return comment(meanings(evaluator_.parameters)) + "typedef struct {\n" +
           c_members(evaluator_.parameters) +
           prefixed(
               "} THE_Parameters;\n"
               "typedef struct { double value, relative_error_bound; } THE_Certified; /* infinite: "
               "nothing is "
               "known */\n"
               "typedef struct { double value; THE_Parameters partial; } THE_Gradient; /* d "
               "value/d "
               "parameter */\n\n");
  }

  std::string finished() const {
    const bool rooted = evaluator_.velocity.rooted;
    std::string out = replaced(sections_["finished"], "THE_SQUARE_ROOT", rooted ? "sqrt" : "");
    out = replaced(out, "THE_DD_ROOT", rooted ? "THE_dd_root" : "");
    return prefixed(replaced(out, "THE_WIDE_ROOT", rooted ? "THE_wide_root" : ""));
  }

  std::string evaluate(CallGrade grade) const {
    const CallDialect dialect(evaluator_.parameters, grade, spelling_);
    const FunctionBody code = body(evaluator_, dialect);
    const std::string kind = grade == CallGrade::accurate ? "dd"
                             : grade == CallGrade::fast   ? "plain"
                                                          : "wide";
    std::string out = prefixed("static inline THE_Result THE_" + kind +
                               "_evaluate(const THE_Parameters p, THE_Parameters *partial) {\n");
    out +=
        statements(code.value, dialect) + "  if (partial) {\n" + statements(code.gradient, dialect);
    const std::vector<std::string> names = entries(evaluator_.parameters);
    for (std::size_t i = 0; i < names.size(); ++i)
      out += statement(fmt::format("partial->{} = {};", names[i], code.partials[i]));
    const std::string inside =
        prefixed(grade == CallGrade::wide ? ", THE_allowed(p)" : ", THE_in_range(p)");
    return out + "  }\n" +
           statement(fmt::format("return {}{}_finished({}, {}, {}, {}{});", spelling_.prefix, kind,
                                 code.above, code.below, code.factor, code.roundings, inside)) +
           "}\n";
  }

  std::string calls(const std::string& kind, const std::string& fast) const {
    std::string out = evaluator_.parameters.named(sections_["result"] + sections_["calls"]);
    out = replaced(out, "THE_GRADE", "THE_" + kind);
    return prefixed(replaced(out, "THE_FAST_", "THE_" + fast));
  }

  const Sections& sections_ = c99_sections();
  const Evaluator& evaluator_;
  Spelling spelling_;
};

std::string c99_text(const Evaluator& evaluator, const std::string& name) {
  const std::string guard = "VCRIT_GENERATED_" + name + "_H";
  return fmt::format("#ifndef {0}\n#define {0}\n", guard) + c99_sections()["includes"] +
         C99(evaluator, name).text() + fmt::format("#endif  // {}\n", guard);
}

}  // namespace

// Macros, lower case or short, of headers that may come before or after: complex.h, math.h,
// stdnoreturn.h.
extern const Language c99{.name = "c99",
                          .extension = ".h",
                          .reserved = "I complex imaginary math_errhandling noreturn",
                          .text = c99_text};

}  // namespace vcrit::symbolic
