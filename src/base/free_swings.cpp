// Times backward and forward are alike, so that sines do not help: t in [0, pi]. The dual problem
// is the largest mean of cos t under a measure for which no free swing has a mean,
//
//   max sum_j l_j cos t_j,   l_j >= 0,   sum_j l_j = 1,   sum_j l_j cos(n t_j) = 0 for all n.
//
// It is solved by the simplex method, over all t at once: the instant to enter is where the
// trigonometric polynomial of the present multipliers is highest. That maximum bounds E from above,
// the present measure from below. As |a_n| <= 4 for the best swings (below), a mean of a swing that
// the measure has may be bought off at 4 a unit: with that the first measure, all at one instant,
// is one for the method, and each measure is a proved bound.
//
// |a_n| <= 4: f = cos t + swings has no mean, and f <= E <= 1, so that the mean of |f| is at most 2
// and a_n, twice the mean of f cos(n t), at most 4.
#include "base/free_swings.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <numbers>
#include <optional>
#include <utility>

#include "base/constants.hpp"
#include "base/interruption.hpp"

namespace vcrit {

namespace {

using Real = long double;
using Reals = std::vector<Real>;

constexpr Real half_turn = std::numbers::pi_v<Real>;
constexpr Real price = 4;  // of a unit of a mean, as above
// Where the best measure has fewer instants than the method's, some of these come together, and the
// square of their distance is what the bounds are apart: 64 bits go that far.
constexpr Real close_enough = 1e-12L, worst_width = 1e-9L;
// No rational part of a turn: from an instant at which means vanish, or are the same, the method
// may go round in circles.
constexpr Real anywhere = 1;
// Some 15 for each swing are usual.
constexpr int most_exchanges = 3000;
// Half a second; each swing is a mass more that is tuned to a harmonic.
constexpr std::size_t most_swings = 9;

// cos n t and sin n t, n = 1 and the harmonics in their order.
struct Wave {
  Real cosine = 0, sine = 0;
};
using Waves = std::vector<Wave>;

// Each summit of one program is looked for at the same middles of intervals: what is to be done
// there is a sum, once cosines are known.
class KnownWaves {
 public:
  explicit KnownWaves(const std::vector<int>& harmonics) : orders_{1} {
    orders_.insert(orders_.end(), harmonics.begin(), harmonics.end());
  }

  const Reals& orders() const { return orders_; }
  Waves at(Real t) const {
    Waves result;
    for (const Real n : orders_) result.push_back({std::cos(n * t), std::sin(n * t)});
    return result;
  }
  const Waves& kept(Real t) {
    Waves& found = kept_[t];
    if (found.empty()) found = at(t);
    return found;
  }

 private:
  Reals orders_;
  std::map<Real, Waves> kept_;
};

// f(t) = cos t + sum a_n cos n t.
class Swings {
 public:
  Swings(const Reals& orders, const Reals& amplitudes) : terms_{{1, 1}} {
    for (std::size_t i = 0; i < amplitudes.size(); ++i)
      terms_.push_back({orders[i + 1], amplitudes[i]});
  }

  Real fastest() const {
    Real result = 1;
    for (const auto& [n, a] : terms_) result = std::max(result, n);
    return result;
  }

  struct Point {
    Real value = 0, slope = 0, curvature = 0;
  };
  Point at(const Waves& waves) const {
    Point point;
    for (std::size_t i = 0; i < terms_.size(); ++i) {
      const auto& [n, a] = terms_[i];
      const Real swing = a * waves[i].cosine;
      point.value += swing;
      point.slope -= a * n * waves[i].sine;
      point.curvature -= n * n * swing;
    }
    return point;
  }

  // No derivative of this order is larger.
  Real bound(int order) const {
    Real sum = 0;
    for (const auto& [n, a] : terms_) sum += std::abs(a) * n * n * (order == 3 ? n : 1);
    return sum;
  }

 private:
  struct Term {
    Real n, a;
  };
  std::vector<Term> terms_;
};

// The highest point of f over [0, pi]: intervals in which a Taylor bound stays below what has been
// found are left out; one in which f is concave has one maximum, others are halved.
class Summit {
 public:
  Summit(const Swings& f, KnownWaves& known)
      : f_(f), known_(known), second_(f.bound(2)), third_(f.bound(3)) {
    take(0);
    take(half_turn);
    // From half of one swing of the fastest on.
    const int pieces = 2 * static_cast<int>(f.fastest());
    for (int i = 0; i < pieces; ++i) search(half_turn * i / pieces, half_turn * (i + 1) / pieces);
  }

  /// f is nowhere higher than this by more than `flat`.
  Real at = 0, height = -infinity;
  // Sums of nine cosines are good to some 1e-18 here, and bounds need a hundredth of close_enough.
  static constexpr Real flat = 1e-14L;

 private:
  Swings::Point take(Real t) { return take(t, known_.at(t)); }

  Swings::Point take(Real t, const Waves& waves) {
    const Swings::Point point = f_.at(waves);
    if (point.value > height) height = point.value, at = t;
    return point;
  }

  void search(Real left, Real right) {
    const Real middle = (left + right) / 2, half = (right - left) / 2;
    const Swings::Point here = take(middle, known_.kept(middle));
    const Real above = std::abs(here.slope) * half + second_ * half * half / 2;
    if (here.value + above <= height || above < flat) return;
    if (here.curvature + third_ * half < 0) return climb(left, right);
    search(left, middle);
    search(middle, right);
  }

  // Where f is concave its slope falls: by Newton's method, and bisection where that leads out.
  void climb(Real left, Real right) {
    Real t = (left + right) / 2;
    for (int i = 0; i < 80; ++i) {
      const Swings::Point here = take(t);
      (here.slope > 0 ? left : right) = t;
      Real next = t - here.slope / here.curvature;
      if (!(next > left && next < right)) next = (left + right) / 2;
      if (std::abs(next - t) <= no_step) break;
      t = next;
    }
    take(left);
    take(right);
  }

  // Of a turn: the mean there, flat at its summit, changes by the square of it.
  static constexpr Real no_step = 1e-15L;

  const Swings& f_;
  KnownWaves& known_;
  Real second_, third_;
};

// A choice of the program: an instant with its cosines, or what a mean of one swing costs.
struct Choice {
  Reals entries;
  Real worth = 0;
};

Choice instant(const std::vector<int>& harmonics, Real t) {
  Choice choice{{1}, std::cos(t)};
  for (const int n : harmonics) choice.entries.push_back(std::cos(static_cast<Real>(n) * t));
  return choice;
}

Choice bought(std::size_t rows, std::size_t row, Real sign) {
  Choice choice{Reals(rows, 0), -price};
  choice.entries[row] = sign;
  return choice;
}

bool all_finite(const Reals& values) {
  return std::all_of(values.begin(), values.end(), [](Real value) { return std::isfinite(value); });
}

// Gauss's elimination with the largest pivots; not finite where there are none.
Reals solved(std::vector<Reals> a, Reals b) {
  const std::size_t n = b.size();
  for (std::size_t k = 0; k < n; ++k) {
    std::size_t best = k;
    for (std::size_t i = k + 1; i < n; ++i)
      if (std::abs(a[i][k]) > std::abs(a[best][k])) best = i;
    std::swap(a[k], a[best]);
    std::swap(b[k], b[best]);
    for (std::size_t i = k + 1; i < n; ++i) {
      const Real factor = a[i][k] / a[k][k];
      for (std::size_t j = k; j < n; ++j) a[i][j] -= factor * a[k][j];
      b[i] -= factor * b[k];
    }
  }
  for (std::size_t k = n; k-- > 0;) {
    for (std::size_t j = k + 1; j < n; ++j) b[k] -= a[k][j] * b[j];
    b[k] /= a[k][k];
  }
  return b;
}

class Program {
 public:
  explicit Program(const std::vector<int>& harmonics) : harmonics_(harmonics), known_(harmonics) {
    const std::size_t rows = harmonics.size() + 1;
    const Choice first = instant(harmonics, anywhere);
    basis_.push_back(first);
    for (std::size_t row = 1; row < rows; ++row)
      basis_.push_back(bought(rows, row, first.entries[row] > 0 ? -1 : 1));
  }

  std::optional<LeastMaximum> run() {
    for (int i = 0; i < most_exchanges && upper_ - lower_ > close_enough; ++i) {
      hear_interruption();
      if (!exchange()) break;
    }
    if (!(upper_ - lower_ <= worst_width)) return std::nullopt;
    return LeastMaximum{static_cast<double>(lower_), static_cast<double>(upper_),
                        std::vector<double>(swings_.begin(), swings_.end())};
  }

 private:
  std::vector<Reals> matrix(bool transposed) const {
    const std::size_t n = basis_.size();
    std::vector<Reals> result(n, Reals(n));
    for (std::size_t i = 0; i < n; ++i)
      for (std::size_t j = 0; j < n; ++j)
        (transposed ? result[j][i] : result[i][j]) = basis_[j].entries[i];
    return result;
  }

  Reals worths() const {
    Reals result;
    for (const Choice& choice : basis_) result.push_back(choice.worth);
    return result;
  }

  /// False where no choice is worth more than the multipliers say.
  bool exchange() {
    Reals mean(basis_.size(), 0);
    mean[0] = 1;
    const Reals weights = solved(matrix(false), mean), multipliers = solved(matrix(true), worths());
    if (!all_finite(weights) || !all_finite(multipliers)) return false;
    Real worth = 0;
    for (std::size_t j = 0; j < basis_.size(); ++j) worth += weights[j] * basis_[j].worth;
    lower_ = std::max(lower_, worth);
    const Choice entering = best(multipliers);
    const Reals change = solved(matrix(false), entering.entries);
    if (!all_finite(change)) return false;
    std::optional<std::size_t> leaving;
    for (std::size_t j = 0; j < basis_.size(); ++j)
      if (change[j] > 1e-15L &&
          (!leaving || weights[j] / change[j] < weights[*leaving] / change[*leaving]))
        leaving = j;
    if (!leaving) return false;
    basis_[*leaving] = entering;
    return true;
  }

  // Swings larger than the best ones can be are bought off first: what is searched for its summit
  // is as tame as these.
  Choice best(const Reals& multipliers) {
    Reals amplitudes;
    for (std::size_t row = 1; row < multipliers.size(); ++row) {
      if (std::abs(multipliers[row]) > price * (1 + close_enough))
        return bought(multipliers.size(), row, multipliers[row] > 0 ? -1 : 1);
      amplitudes.push_back(-multipliers[row]);
    }
    const Swings swings(known_.orders(), amplitudes);
    const Summit summit(swings, known_);
    if (const Real upper = summit.height + Summit::flat; upper <= upper_) {
      upper_ = upper;
      swings_ = amplitudes;
    }
    return instant(harmonics_, summit.at);
  }

  const std::vector<int>& harmonics_;
  KnownWaves known_;
  std::vector<Choice> basis_;
  Real lower_ = 0, upper_ = 1;
  Reals swings_ = Reals(harmonics_.size(), 0);  // of which the maximum is upper_
};

// What was asked last, and found: each motion of a scene asks the same, and a program takes
// milliseconds. Without memory of its own, so that nothing is to be done where a thread ends.
struct KnownMaximum {
  std::size_t count = 0;
  std::array<int, most_swings> harmonics{};
  bool found = false;
  double lower = 1, upper = 1;
  std::array<double, most_swings> swings{};

  bool is_of(const std::vector<int>& asked) const {
    return asked.size() == count && std::equal(asked.begin(), asked.end(), harmonics.begin());
  }

  void take(const std::vector<int>& asked, const std::optional<LeastMaximum>& least) {
    count = asked.size();
    std::copy(asked.begin(), asked.end(), harmonics.begin());
    found = least.has_value();
    if (!found) return;
    lower = least->lower;
    upper = least->upper;
    std::copy(least->swings.begin(), least->swings.end(), swings.begin());
  }

  std::optional<LeastMaximum> answer() const {
    if (!found) return std::nullopt;
    return LeastMaximum{lower, upper, {swings.data(), swings.data() + count}};
  }
};

thread_local KnownMaximum known_maximum;

}  // namespace

std::optional<LeastMaximum> least_maximum(const std::vector<int>& harmonics) {
  if (harmonics.empty()) return LeastMaximum{};
  if (harmonics.size() > most_swings) return std::nullopt;
  if (harmonics.size() > 1) {
    if (!known_maximum.is_of(harmonics)) known_maximum.take(harmonics, Program(harmonics).run());
    return known_maximum.answer();
  }
  const int n = harmonics.front();
  const double quarter = pi / (2 * n), border = std::cos(quarter);
  return LeastMaximum{border, border, {-std::sin(quarter) / n}};
}

}  // namespace vcrit
