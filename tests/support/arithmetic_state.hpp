// The processor's ways to round, which a caller may have changed, for the time of a scope.
#pragma once

#include <array>
#include <cfenv>
#include <string>
#ifdef __SSE2__
#include <xmmintrin.h>
#endif

namespace vcrit::test {

struct ArithmeticState {
  int rounding = FE_TONEAREST;
  bool flush_to_zero = false;  ///< results and operands; without SSE nothing
};

inline std::array<ArithmeticState, 8> all_arithmetic_states() {
  std::array<ArithmeticState, 8> states;
  constexpr std::array modes{FE_TONEAREST, FE_UPWARD, FE_DOWNWARD, FE_TOWARDZERO};
  for (std::size_t i = 0; i < states.size(); ++i) states.at(i) = {modes.at(i / 2), i % 2 == 1};
  return states;
}

inline std::string to_text(const ArithmeticState& state) {
  return "rounding mode " + std::to_string(state.rounding) + (state.flush_to_zero ? ", flush" : "");
}

class WithArithmetic {
 public:
  explicit WithArithmetic(const ArithmeticState& state) {
    std::fegetenv(&before_);
    std::fesetround(state.rounding);
#ifdef __SSE2__
    if (state.flush_to_zero) _mm_setcsr(_mm_getcsr() | 0x8040u);
#endif
    set_ = control();
  }
  WithArithmetic(const WithArithmetic&) = delete;
  WithArithmetic& operator=(const WithArithmetic&) = delete;
  ~WithArithmetic() { std::fesetenv(&before_); }

  bool is_kept() const { return control() == set_; }

 private:
  /// What is set, without the flags of what happened.
  static unsigned control() {
#ifdef __SSE2__
    return _mm_getcsr() & ~0x3fu;
#else
    return static_cast<unsigned>(std::fegetround());
#endif
  }

  std::fenv_t before_{};
  unsigned set_ = 0;
};

}  // namespace vcrit::test
