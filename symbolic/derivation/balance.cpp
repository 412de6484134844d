#include "derivation/balance.hpp"

#include <map>
#include <utility>

#include "derivation/factors.hpp"
#include "formula/prose.hpp"
#include "formula/symbols.hpp"
#include "polynomial/symbol_ring.hpp"

namespace vcrit::symbolic {

namespace {

using GiNaC::ex;

ex at_i_omega(const ex& expression) { return expression.subs(laplace() == GiNaC::I * omega()); }

/// Names of the derivation. x: body, y: contact point (oscillating parts), f_n: normal force; along
/// the normal u_v: vibrator, z: contact.
struct Names {
  ex t = quantity("t"), s = laplace(), A = quantity("A"), B = quantity("B");
  ex K_n = quantity("K_n"), K_t = quantity("K_t"), K_d = quantity("K_d");
  ex m = symbol({"m"}), mu0 = symbol({"mu0"}), du_z = symbol({"du_z"});
  ex x = quantity("x"), y = quantity("y"), acceleration = quantity("x''"), f_n = quantity("f_n");
  ex K_m = quantity("K_m"), m_n = symbol({"m_n"}), A_z = quantity("A_z"), u_v = quantity("u_v");
  ex z = quantity("z"), z_acceleration = quantity("z''");
  ex wave = GiNaC::exp(s * t);
};

const Names& names() {
  static const Names all;
  return all;
}

/// Forces on body and contact point, each 0 in sum.
struct Equations {
  ex body, contact;
};

Equations equations(const Surrounding& there, const ex& x, const ex& acceleration, const ex& y,
                    const ex& f_n) {
  const Names& n = names();
  const ex contact_force = n.K_t * (x - y);
  ex body = contact_force;
  if (there.mass) body += n.m * acceleration;
  if (there.drive) body += n.K_d * x;
  return {body, contact_force - n.mu0 * f_n};
}

/// Forces along the normal on what moves with the contact, 0 in sum.
ex normal_equation(const Surrounding& there, const ex& vibrator, const ex& z,
                   const ex& acceleration) {
  const Names& n = names();
  ex sum = n.K_n * z - n.K_m * (vibrator - z);
  if (there.normal_mass != Surrounding::NormalMass::none)
    sum += (there.normal_mass == Surrounding::NormalMass::body ? n.m : n.m_n) * acceleration;
  return sum;
}

class BalanceWriter {
 public:
  explicit BalanceWriter(const Surrounding& there)
      : there_(there), height_(there.mount ? n_.A_z : n_.du_z) {}

  Balance solve() {
    const ex normal = there_.mount ? normal_amplitude() : n_.du_z;
    write_motion();
    write_ansatz();
    const ex x = there_.drive ? ex(n_.A * n_.wave) : ex(0);
    const ex y = n_.B * n_.wave;
    const Equations wave = equations(there_, x, x.diff(time(), 2), y, height_ * n_.K_n * n_.wave);
    const Equations amplitude{(wave.body / n_.wave).expand(), (wave.contact / n_.wave).expand()};
    write_amplitudes(amplitude);
    const auto [A, B] = amplitudes(amplitude);
    const ex general = general_amplitude(B);
    if (!there_.mount) return {std::move(lines_), A, B, general, normal};
    // Linear in A_z, and a product of both: what resonates along the surface and along the normal
    // stays apart.
    const auto whole = [&](const ex& part) { return ex(factored(part / n_.A_z) * normal); };
    write("With the contact's amplitude", n_.B, whole(B));
    return {std::move(lines_), whole(A), whole(B), whole(general), normal};
  }

 private:
  static const GiNaC::symbol& time() { return GiNaC::ex_to<GiNaC::symbol>(names().t); }
  void write(const Prose& words, const ex& left, const ex& right) {
    lines_.push_back({words, at_i_omega(left), at_i_omega(right)});
  }

  /// One more balance, one more unknown: nothing along the surface acts on the height.
  ex normal_amplitude() {
    write({"Along the normal, oscillating parts (", n_.u_v, ": vibrator, ", n_.z,
           ": contact): mount, contact and what moves between them balance"},
          normal_equation(there_, n_.u_v, n_.z, n_.z_acceleration), 0);
    write(
        {"The vibrator oscillates by ", n_.du_z, ", the contact by the complex amplitude ", n_.A_z},
        n_.u_v, n_.du_z * n_.wave);
    write("", n_.z, n_.A_z * n_.wave);
    const ex z = n_.A_z * n_.wave;
    const ex balance = (normal_equation(there_, n_.du_z * n_.wave, z, z.diff(time(), 2)) / n_.wave)
                           .expand()
                           .collect(n_.A_z);
    const ex force = n_.K_m * n_.du_z;
    write("Balance along the normal", (balance + force).expand().collect(n_.A_z), force);
    const ex solution = factored(GiNaC::lsolve(balance == 0, n_.A_z));
    write("Solved for the amplitude at the contact", n_.A_z, solution);
    return solution;
  }

  void write_motion() {
    const ex x = there_.drive ? n_.x : ex(0);
    const Equations motion = equations(there_, x, n_.acceleration, n_.y, n_.f_n);
    if (there_.drive)
      write({"Equation of motion of the body, oscillating parts (", n_.x, ": body, ", n_.y,
             ": contact point; each network acts by its stiffness, with ", n_.s,
             " for the time derivative)"},
            motion.body, 0);
    write(there_.drive
              ? Prose("At the contact point contact force and friction balance")
              : Prose{"The far end of the contact moves uniformly; at the contact point (", n_.y,
                      ": its oscillation) contact force and friction balance (each network acts "
                      "by its stiffness, with ",
                      n_.s, " for the time derivative)"},
          motion.contact + n_.mu0 * n_.f_n, n_.mu0 * n_.f_n);
  }

  void write_ansatz() {
    const char* both = "Harmonic motion of body and contact point, and the normal force (9)";
    const char* alone = "Harmonic motion of the contact point, and the normal force (9)";
    if (there_.drive) write(both, n_.x, n_.A * n_.wave);
    write(there_.drive ? "" : alone, n_.y, n_.B * n_.wave);
    write("", n_.f_n, height_ * n_.K_n * n_.wave);
  }

  void write_amplitudes(const Equations& amplitude) {
    if (there_.drive)
      write("Balance of the body, contact force replaced by friction (13)",
            (amplitude.body - amplitude.contact).expand().collect(n_.A), 0);
    const ex friction = n_.mu0 * height_ * n_.K_n;
    write("Balance of the contact point (19)",
          (amplitude.contact + friction).expand().collect(n_.K_t), friction);
  }

  /// A and B.
  std::pair<ex, ex> amplitudes(const Equations& amplitude) {
    GiNaC::lst equations{amplitude.contact == 0}, unknowns{n_.B};
    if (there_.drive) {
      equations.append(amplitude.body == 0);
      unknowns.append(n_.A);
    }
    const ex solution = GiNaC::lsolve(equations, unknowns);
    const ex A = there_.drive ? factored(n_.A.subs(solution)) : ex(0);
    if (there_.drive) write("Solved for the amplitudes of body and contact point", n_.A, A);
    const ex B = factored(n_.B.subs(solution));
    write(there_.drive ? "" : "Solved for the amplitude of the contact point", n_.B, B);
    return {A, B};
  }

  /// The displacement of the contact point over the force on it; friction mu0 du_z K_n acts against
  /// the sliding. What does not vanish with the contact's compliance 1/K_t is the body's part.
  ex receptance(const ex& B) {
    const ex whole = -B / (n_.mu0 * height_ * n_.K_n), compliance = quantity("C_t");
    const LowestTerms fraction = lowest_terms(whole.subs(n_.K_t == 1 / compliance));
    const ex of_body = (fraction.over / fraction.under).subs(compliance == 0);
    return factored(whole - of_body) + factored(of_body);
  }

  /// B with the receptance as a quantity H of its own.
  ex general_amplitude(const ex& B) {
    const ex H = receptance(B), general = factored(B / H) * quantity("H");
    write(
        "Receptance of the contact point, its displacement over the force on it (driving-point "
        "compliance)",
        quantity("H"), H);
    write({"With ", quantity("H"), ", for any linear structure"}, n_.B, general);
    return general;
  }

  const Names& n_ = names();
  Surrounding there_;
  ex height_;  // what the contact oscillates by
  std::vector<Line> lines_;
};

}  // namespace

const Balance& solve_balance(const Surrounding& surrounding) {
  static std::map<Surrounding, Balance> solved;
  const auto found = solved.find(surrounding);
  return found != solved.end()
             ? found->second
             : solved.emplace(surrounding, BalanceWriter(surrounding).solve()).first->second;
}

}  // namespace vcrit::symbolic
