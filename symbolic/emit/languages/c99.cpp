// The C99 header: static inline functions whose names begin with the library's.
#include <fmt/core.h>

#include "emit/languages/c99_arithmetic.hpp"
#include "emit/languages/printers.hpp"
#include "emit/pieces.hpp"
#include "emit/words.hpp"

namespace vcrit::symbolic {

namespace {

class C99 {
 public:
  C99(const Evaluator& evaluator, const std::string& name)
      : evaluator_(evaluator), spelling_{name + "_", "fabs", "sqrt", true, Zeros::out_of_range} {}

  std::string text() const {
    std::string out = structs() + prefixed(c99::numbers) + prefixed(c99::wide) + operations();
    out += prefixed("static inline int @in_range(const @Parameters p) {\n") +
           statement(fmt::format("return {};", in_range(evaluator_, spelling_, " && ", "0"))) +
           "}\n" + prefixed("static inline int @allowed(const @Parameters p) {\n") +
           allowed_body(evaluator_.parameters, evaluator_.velocity) + "}\n";
    out += finished();
    for (const CallGrade grade : {CallGrade::accurate, CallGrade::fast, CallGrade::wide})
      out += evaluate(grade);
    out += "\n" + comment(evaluator_.parameters.named(
                      "v* is infinite at resonance, 0 at antiresonance, NaN for 0/0. Batches: a "
                      "value for each @omega@."));
    return out + calls("dd", "") + comment("In plain double.") + calls("plain", "fast_");
  }

 private:
  std::string prefixed(const std::string& text) const {
    return replaced(text, "@", spelling_.prefix);
  }

  std::string structs() const {
    return comment(meanings(evaluator_.parameters)) + "typedef struct {\n" +
           c_members(evaluator_.parameters) +
           prefixed(
               "} @Parameters;\n"
               "typedef struct { double value, relative_error_bound; } @Certified; /* infinite: "
               "nothing is "
               "known */\n"
               "typedef struct { double value; @Parameters partial; } @Gradient; /* d value/d "
               "parameter */\n\n");
  }

  std::string operations() const {
    using Operation = Node::Operation;
    std::string out;
    if (evaluator_.has(Operation::less_inertia)) out += c99::less_inertia;
    if (evaluator_.has(Operation::unit)) out += c99::power_unit;
    if (evaluator_.has(Operation::nonzero)) out += c99::nonzero;
    if (evaluator_.has(Operation::gap))
      out += replaced(c99::ties, "@MOST", std::to_string(Program::most_edges));
    if (evaluator_.has(Operation::magnitude)) out += c99::magnitude;
    if (evaluator_.has(Operation::unless_moderate)) out += c99::unless_moderate;
    return prefixed(out);
  }

  std::string finished() const {
    const bool rooted = evaluator_.velocity.rooted;
    std::string out = replaced(c99::finished, "@SQRT", rooted ? "sqrt" : "");
    out = replaced(out, "@ROOT_DD", rooted ? "@dd_root" : "");
    return prefixed(replaced(out, "@ROOT_WIDE", rooted ? "@wide_root" : ""));
  }

  std::string evaluate(CallGrade grade) const {
    const CallDialect dialect(evaluator_.parameters, grade, spelling_);
    const Body code = body(evaluator_, dialect);
    const std::string kind = grade == CallGrade::accurate ? "dd"
                             : grade == CallGrade::fast   ? "plain"
                                                          : "wide";
    std::string out = prefixed("static inline @Result @" + kind +
                               "_evaluate(const @Parameters p, @Parameters *partial) {\n");
    out +=
        statements(code.value, dialect) + "  if (partial) {\n" + statements(code.gradient, dialect);
    const std::vector<std::string> names = entries(evaluator_.parameters);
    for (std::size_t i = 0; i < names.size(); ++i)
      out += statement(fmt::format("partial->{} = {};", names[i], code.partials[i]));
    const std::string inside =
        prefixed(grade == CallGrade::wide ? ", @allowed(p)" : ", @in_range(p)");
    return out + "  }\n" +
           statement(fmt::format("return {}{}_finished({}, {}, {}, {}{});", spelling_.prefix, kind,
                                 code.above, code.below, code.factor, code.roundings, inside)) +
           "}\n";
  }

  std::string calls(const std::string& kind, const std::string& fast) const {
    std::string out = evaluator_.parameters.named(std::string(c99::result) + c99::calls);
    out = replaced(out, "@GRADE", "@" + kind);
    return prefixed(replaced(out, "@FAST", "@" + fast));
  }

  const Evaluator& evaluator_;
  Spelling spelling_;
};

}  // namespace

std::string c99_text(const Evaluator& evaluator, const std::string& name) {
  const std::string guard = "VCRIT_GENERATED_" + name + "_H";
  return fmt::format("#ifndef {0}\n#define {0}\n", guard) + c99::includes +
         C99(evaluator, name).text() + fmt::format("#endif  // {}\n", guard);
}

}  // namespace vcrit::symbolic
