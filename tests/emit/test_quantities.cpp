// Generated headers of quantities compiled, run, and compared with nodal evaluation at 250 digits.
#include <boost/test/unit_test.hpp>

#include <numbers>
#include <random>

#include "base/errors.hpp"
#include "derivation/scenes.hpp"
#include "emit/languages/cpp/quantities.hpp"
#include "emit/library.hpp"
#include "program/quantities.hpp"

BOOST_AUTO_TEST_SUITE(test_quantities)

using namespace vcrit;
using symbolic::derive, symbolic::GenerateOptions;
using test::scene_of;

namespace {

constexpr unsigned seed = 13;
constexpr double u = 0x1p-53;

/// How often networks are joined, two and two, from an element of K_n, K_t, K_d up to the whole.
struct Levels {
  int normal, tangential, drive;
};

struct Case {
  Scene scene;
  std::vector<std::string> fixed;
  Levels levels;
};

/// What K = T/Q may err by, counted by hand. Where two networks are joined, one of T and Q is a
/// product, whose components round twice, both together 2 sqrt(2); the other a sum of two products,
/// 4 times, twice that for both and for a sum in the first quadrant (sqrt(2) each): 11. An element
/// rounds up to 3 times: i x k/(1 + i x), x = w tau. By Tellegen's theorem K has sqrt(2) times all
/// that at most; then T conj(Q)/|Q|^2 rounds 6 times, a given ratio of stiffnesses 4 times.
int most_roundings(int levels, bool is_ratio = false) {
  return static_cast<int>(1.01 * (std::numbers::sqrt2 * (3 + 11 * levels) + 6)) + is_ratio * 4;
}

std::vector<Case> cases() {
  const std::string bridge = test::bridge_network;
  // A bridge is taken apart at one edge: two halves of two levels, and T and Q, both sums, of which
  // one counts as two.
  return {
      {test::kelvin_scene(), {}, {1, 1, 0}},
      {scene_of("normal = \"k0 | (k1 - c1)\"\npoisson = 0.3", "kd"), {}, {2, 2, 0}},
      {scene_of("normal = \"k0 | (k1 - c1)\"\npoisson = \"nu\"", "kd | cd", "m"), {}, {2, 2, 1}},
      {scene_of("normal = \"kn\"\ntangential = \"kt\""), {}, {0, 0, 0}},
      {scene_of("normal = \"kn | cn\"\ntangential_ratio = \"r\""), {}, {1, 1, 0}},
      {scene_of("normal = \"prony(k0, k, tau, 10)\"\npoisson = 0.45", "kd | cd", "m"),
       {},
       {4, 4, 1}},
      {scene_of("normal = \"kn - cn\"\ntangential = \"prony(k1, kt, taut, 2)\"", "cd"),
       {},
       {1, 2, 0}},
      {scene_of("normal = \"bridge\"\ntangential = \"kt | ct\"", "k4 - (c4 | k5)", "m", bridge),
       {},
       {4, 1, 2}},
      {read_scene(VCRIT_SCENES "/prony.toml"), {"k", "tau[2]", "kd"}, {4, 4, 0}},
      {read_scene(VCRIT_SCENES "/bridge.toml"), {"all"}, {4, 4, 1}},
  };
}

/// Numbers for all that has none; those of a scene that has some stay near them.
Scene with_values(Scene scene, const symbolic::FixedValues& fixed, std::mt19937& random) {
  const auto give = [&](const Quantity& quantity, double otherwise) -> std::optional<double> {
    if (fixed.contains(quantity.symbol)) return quantity.value;
    const double decades = std::uniform_real_distribution(-2.0, 2.0)(random);
    return quantity.value.value_or(otherwise) * std::pow(10, decades);
  };
  for (auto& [symbol, value] : scene.elements) value = give({symbol, value}, 1);
  for (Quantity* quantity :
       {&scene.coefficient, &scene.angular_frequency, &scene.amplitude, &scene.indentation})
    quantity->value = give(*quantity, 1);
  if (scene.mass) scene.mass->value = give(*scene.mass, 1);
  if (auto* isotropic = std::get_if<Isotropic>(&scene.tangential))
    if (!isotropic->quantity.value)
      isotropic->quantity.value = std::uniform_real_distribution(0.1, 0.5)(random);
  return scene;
}

/// What a header gave, in the order of the driver; what the scene has not got stays 0.
struct Results {
  std::complex<double> normal, tangential, drive;
  double body_amplitude = 0, body_phase = 0, amplitude = 0, phase = 0, admissible = 0;
};

class Headers {
 public:
  explicit Headers(const std::vector<Case>& cases) : cases_(cases) {
    for (std::size_t i = 0; i < cases_.size(); ++i) {
      const GenerateOptions options{cases_[i].fixed, true};
      const auto file = [&](const char* end) { return folder_.path() / (name(i) + end); };
      const symbolic::Derivation derivation = derive(cases_[i].scene);
      write_file(file(".hpp"), symbolic::emit_header(derivation, name(i), options));
      write_file(file("_quantities.hpp"), emit_quantities(derivation, name(i), options));
    }
    write_file(folder_.path() / "driver.cpp", driver());
  }

  const test::PrivateFolder& folder() const { return folder_; }

  std::string compile(const std::string& compiler) const {
    std::vector<std::string> command{compiler, "-O1"};
    command.insert(command.end(), test::strict_flags.begin(), test::strict_flags.end());
    const std::string program = (folder_.path() / "driver").string();
    command.insert(command.end(), {"-o", program, program + ".cpp"});
    const test::Outcome outcome = test::run(command, folder_.path());
    return outcome.status == 0 ? "" : outcome.output + " ";
  }

  Results evaluate(std::size_t i, const Scene& scene) const {
    const symbolic::ParameterList parameters = symbolic::quantity_parameters(
        cases_[i].scene, symbolic::fixed_values(cases_[i].scene, cases_[i].fixed));
    const Values values = test::numbers_of(scene);
    std::string input = std::to_string(i);
    for (const symbolic::Member& member : parameters.members())
      for (int entry = member.length == 0 ? 0 : 1; entry <= member.length; ++entry)
        input += " " + to_text(values.at({member.name, entry}));
    const std::string file = (folder_.path() / "input.txt").string();
    write_file(file, input + "\n");
    const test::Outcome outcome =
        test::run({(folder_.path() / "driver").string()}, folder_.path(), file);
    if (outcome.status != 0) throw std::runtime_error("driver failed: " + outcome.output);
    std::istringstream words(outcome.output);
    const auto next = [&] {
      std::string word;
      words >> word;
      return std::strtod(word.c_str(), nullptr);
    };
    const auto complex = [&] {
      const double re = next();
      return std::complex<double>(re, next());
    };
    Results r;
    r.normal = complex();
    r.tangential = complex();
    if (scene.drive) r.drive = complex();
    if (scene.mass) r.body_amplitude = next(), r.body_phase = next();
    r.amplitude = next(), r.phase = next();
    r.admissible = next();
    return r;
  }

 private:
  static std::string name(std::size_t i) { return "scene_" + std::to_string(i); }

  std::string driver() const {
    std::string out;
    for (std::size_t i = 0; i < cases_.size(); ++i)
      out += "#include \"" + name(i) + "_quantities.hpp\"\n";
    out +=
        "#include <cstdio>\n#include <cstdlib>\n#include <cstring>\n"
        "template <class Parameters> Parameters parameters() {\n"
        "  std::array<double, sizeof(Parameters) / sizeof(double)> x{};\n"
        "  char word[64];\n"
        "  for (double& each : x)\n"
        "    each = std::scanf(\"%63s\", word) == 1 ? std::strtod(word, nullptr) : 0.0;\n"
        "  Parameters p;\n  std::memcpy(&p, x.data(), sizeof p);\n  return p;\n}\n"
        "void print(auto z) { const auto [a, b] = z; std::printf(\"%a %a\\n\", a, b); }\n"
        "int main() {\n  int scene = 0;\n  if (std::scanf(\"%d\", &scene) != 1) return 1;\n";
    for (std::size_t i = 0; i < cases_.size(); ++i) {
      const Scene& scene = cases_[i].scene;
      out += fmt::format(
          "  if (scene == {0}) {{\n    using namespace {1};\n"
          "    const auto p = parameters<QuantityParameters>();\n"
          "    print(normal_stiffness(p));\n    print(tangential_stiffness(p));\n",
          i, name(i));
      if (scene.drive) out += "    print(drive_stiffness(p));\n";
      if (scene.mass) out += "    print(body_oscillation(p));\n";
      out += "    print(contact_point_oscillation(p));\n";
      if (carries_load(i)) out += "    std::printf(\"%a\\n\", admissible_amplitude(p));\n";
      out += "  }\n";
    }
    return out + "}\n";
  }

  // kn - cn does not.
  static bool carries_load(std::size_t i) { return i != 6; }

  const std::vector<Case>& cases_;
  test::PrivateFolder folder_;
};

/// Everything at 250 digits, and what the quantities of a header may err by, from what it says of
/// its stiffnesses (no more than counted by hand, check_claims).
class Exact {
 public:
  Exact(const Scene& scene, const symbolic::QuantityProgram& program) : scene_(scene) {
    const Values values = test::numbers_of(scene);
    const test::Real omega(values.at({"omega"}));
    test::Nodal nodal(values, omega);
    normal_ = nodal.stiffness(scene.normal);
    tangential_ = tangential(nodal);
    normal_error = *program.normal.roundings * u;
    tangential_error = *program.tangential.roundings * u;
    friction_ = {test::Real(values.at({"mu0"})) * test::Real(values.at({"du_z"})), test::Real(0)};
    compliance_ = test::Complex(1) / tangential_;
    // Close enough to rest: K(i omega) - K(0) is of second order in omega for the real part.
    const test::Real slow("1e-60");
    at_rest_ = test::Nodal(values, slow).stiffness(scene.normal).real();
    admissible = at_rest_ * test::Real(values.at({"u_z0"})) / test::Real(abs(normal_));
    if (scene.drive) add_drive(nodal, values, omega, *program.drive->roundings * u);
  }

  test::Complex normal_, tangential_, drive_;
  double normal_error = 0, tangential_error = 0, drive_error = 0;
  test::Real admissible;

  test::Complex body() const { return -friction_ * normal_ / dynamic_; }
  test::Complex contact_point() const { return -friction_ * normal_ * compliance_; }
  /// K_n and D; a modulus rounds twice (half of the square's two, and the root), the quotient,
  /// mu0 du_z and the last product once each: 7. Products of two complex numbers, which the phase
  /// is taken of, 2 sqrt(2).
  double body_error() const { return 1.01 * (normal_error + dynamic_error_ + 7 * u); }
  /// Two more stiffnesses, K_t and N, and two more operations.
  double contact_point_error() const {
    return 1.01 * (normal_error + tangential_error + dynamic_error_ + whole_error_ + 13 * u);
  }
  /// K_n, exact springs summed in K_n(0), a modulus, two more operations.
  double admissible_error() const { return 1.01 * (2 * normal_error + 4 * u); }

 private:
  test::Complex tangential(test::Nodal& nodal) const {
    if (const auto* network = std::get_if<Network>(&scene_.tangential))
      return nodal.stiffness(*network);
    const auto& isotropic = std::get<Isotropic>(scene_.tangential);
    const test::Real given(*isotropic.quantity.value);
    const test::Real ratio =
        isotropic.by == Isotropic::By::poisson ? test::Real(2 * (1 - given) / (2 - given)) : given;
    return normal_ * test::Complex(ratio, test::Real(0));
  }

  static double size(const test::Complex& z) { return static_cast<double>(test::Real(abs(z))); }

  void add_drive(test::Nodal& nodal, const Values& values, const test::Real& omega, double error) {
    drive_error = error;
    drive_ = dynamic_ = nodal.stiffness(*scene_.drive);
    test::Real inertia(0);
    if (scene_.mass) inertia = test::Real(values.at({"m"})) * omega * omega;
    dynamic_ -= test::Complex(inertia, test::Real(0));
    const test::Complex whole = tangential_ + dynamic_;
    compliance_ += test::Complex(1) / dynamic_;
    // m omega^2 rounds twice, the difference once; each component of the sum N once.
    const double absolute =
        error * size(drive_) + u * (2 * static_cast<double>(inertia) + size(dynamic_));
    dynamic_error_ = absolute / size(dynamic_);
    whole_error_ = (tangential_error * size(tangential_) + absolute) / size(whole) + u;
  }

  const Scene& scene_;
  test::Complex dynamic_, compliance_, friction_;
  test::Real at_rest_;
  double dynamic_error_ = 0, whole_error_ = 0;
};

void check_oscillation(double amplitude, double phase, const test::Complex& exact, double tolerance,
                       const char* what) {
  const test::Real size = abs(exact);
  BOOST_TEST(static_cast<double>(abs(test::Real(test::Real(amplitude) / size - 1))) <= tolerance,
             what);
  const double turned =
      static_cast<double>(test::Real(atan2(test::Real(exact.imag()), test::Real(exact.real()))));
  // The angle is off by no more than the complex number, relatively; its products round three times
  // 2 sqrt(2) instead of the moduli; both arcs are rounded to doubles of up to pi.
  const double two_pi = 6.283185307179586;
  BOOST_TEST(std::abs(std::remainder(phase - turned, two_pi)) <= tolerance + 16 * u, what);
}

/// A header that says too much of its error would keep its word.
void check_claims(const Case& given, const symbolic::QuantityProgram& program) {
  const bool is_ratio = std::holds_alternative<Isotropic>(given.scene.tangential);
  BOOST_TEST(*program.normal.roundings <= most_roundings(given.levels.normal));
  BOOST_TEST(*program.tangential.roundings <= most_roundings(given.levels.tangential, is_ratio));
  if (program.drive) BOOST_TEST(*program.drive->roundings <= most_roundings(given.levels.drive));
}

bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

}  // namespace

BOOST_AUTO_TEST_CASE(values_are_those_of_nodal_evaluation) {
  BOOST_TEST_MESSAGE("seed " << seed);
  const std::vector<Case> all = cases();
  const Headers headers(all);
  for (const std::string& compiler : test::compilers(headers.folder())) {
    std::mt19937 random(seed);
    BOOST_REQUIRE_EQUAL(headers.compile(compiler), "");
    for (std::size_t i = 0; i < all.size(); ++i) {
      const auto fixed = symbolic::fixed_values(all[i].scene, all[i].fixed);
      const symbolic::ParameterList parameters = symbolic::quantity_parameters(all[i].scene, fixed);
      const symbolic::QuantityProgram program = symbolic::quantity_program(
          all[i].scene,
          [&](symbolic::Program& p, const Symbol& s) { return parameters.value(p, s); });
      check_claims(all[i], program);
      for (int n = 0; n < 12; ++n) {
        const Scene scene = with_values(all[i].scene, fixed, random);
        const Results r = headers.evaluate(i, scene);
        const Exact exact(scene, program);
        BOOST_TEST_CONTEXT(compiler << ", scene " << i << ", draw " << n) {
          BOOST_TEST(test::relative_error(r.normal, exact.normal_) <= exact.normal_error);
          BOOST_TEST(test::relative_error(r.tangential, exact.tangential_) <=
                     exact.tangential_error);
          if (scene.drive)
            BOOST_TEST(test::relative_error(r.drive, exact.drive_) <= exact.drive_error);
          if (scene.mass)
            check_oscillation(r.body_amplitude, r.body_phase, exact.body(), exact.body_error(),
                              "body");
          check_oscillation(r.amplitude, r.phase, exact.contact_point(),
                            exact.contact_point_error(), "contact point");
          if (program.largest_amplitude)
            BOOST_TEST(static_cast<double>(
                           abs(test::Real(test::Real(r.admissible) / exact.admissible - 1))) <=
                       exact.admissible_error());
        }
      }
    }
  }
}

BOOST_AUTO_TEST_CASE(massless_rigid_scene_has_neither_body_nor_drive) {
  const std::string header = symbolic::emit_quantities(
      derive(scene_of("normal = \"k0 | (k1 - c1)\"\ntangential = \"kt | ct\"")), "rigid");
  for (const char* absent : {"mass", "drive", "Drive", "body", "Body", "K_d", "p.m;", "p.m,",
                             "p.m)", "inertia", "beta", " m;", "m omega"})
    BOOST_TEST(!contains(header, absent), absent);
  BOOST_TEST(contains(header, "contact_point_oscillation"));
}

BOOST_AUTO_TEST_CASE(massless_scene_has_no_body) {
  const std::string header = symbolic::emit_quantities(
      derive(scene_of("normal = \"k0 | (k1 - c1)\"\npoisson = 0.3", "kd")), "pulled");
  for (const char* absent :
       {"mass", "body", "Body", "p.m;", "p.m,", "p.m)", "inertia", "beta", " m;", "m omega"})
    BOOST_TEST(!contains(header, absent), absent);
  BOOST_TEST(contains(header, "drive_stiffness"));
}

// u_z0 and, in an isotropic contact with a rigid drive, the elements are in no v*.
BOOST_AUTO_TEST_CASE(parameters_are_those_of_the_quantities) {
  const std::string header = symbolic::emit_quantities(
      derive(scene_of("normal = \"kn | cn\"\npoisson = 0.3")), "isotropic");
  for (const char* member : {"double u_z0;", "double kn;", "double cn;"})
    BOOST_TEST(contains(header, member), member);
  const std::string fluid = symbolic::emit_quantities(
      derive(scene_of("normal = \"kn - cn\"\ntangential = \"kt\"")), "fluid");
  BOOST_TEST(!contains(fluid, "double u_z0;"));
  BOOST_TEST(!contains(fluid, "double admissible_amplitude"));
}

BOOST_AUTO_TEST_CASE(groups_have_their_values) {
  const test::PrivateFolder folder;
  const std::vector<std::pair<std::string, Scene>> scenes{
      {"kelvin", test::kelvin_scene()},
      {"prony", scene_of("normal = \"prony(k0, k, tau, 3)\"\npoisson = 0.3", "kd", "m")}};
  for (const auto& [name, scene] : scenes)
    symbolic::generate(derive(scene), folder.path(), name, {{}, true});
  // Products and quotients of powers of two are exact.
  write_file(
      folder.path() / "groups.cpp",
      "#include \"kelvin_quantities.hpp\"\n#include \"prony_quantities.hpp\"\n"
      "int main() {\n"
      "  kelvin::QuantityParameters p{1, 4, 1, 1, 2, 8, 16, 32, 64, 128};\n"
      "  const auto g = kelvin::dimensionless_groups(p);\n"
      "  static_assert(sizeof(g) == 5 * sizeof(double));\n"
      "  bool right = g.theta_cn == 8 && g.kappa_kt == 4 && g.theta_ct == 8 &&\n"
      "               g.kappa_kd == 16 && g.beta_m == 0.25;\n"
      "  prony::QuantityParameters q{1, 4, 1, 1, 2, 8, {1, 2, 4}, {8, 16, 32}, 64};\n"
      "  const auto h = prony::dimensionless_groups(q);\n"
      "  right = right && h.kappa_k[0] == 0.125 && h.kappa_k[2] == 0.5 && h.kappa_kd == 8 &&\n"
      "          h.theta_tau[0] == 32 && h.theta_tau[2] == 128 && h.beta_m == 0.5;\n"
      "  return right ? 0 : 1;\n}\n");
  const std::string program = (folder.path() / "groups").string();
  const test::Outcome built =
      test::run({test::compilers(folder).front(), "-std=c++20", "-o", program, program + ".cpp"},
                folder.path());
  BOOST_REQUIRE_MESSAGE(built.status == 0, built.output);
  BOOST_TEST(test::run({program}, folder.path()).status == 0);
}

BOOST_AUTO_TEST_CASE(written_only_when_asked_for) {
  const test::PrivateFolder folder;
  symbolic::generate(derive(test::kelvin_scene()), folder.path(), "kelvin");
  BOOST_TEST(!std::filesystem::exists(folder.path() / "kelvin_quantities.hpp"));
  symbolic::generate(derive(test::kelvin_scene()), folder.path(), "kelvin", {{}, true});
  BOOST_TEST(std::filesystem::exists(folder.path() / "kelvin_quantities.hpp"));
}

BOOST_AUTO_TEST_SUITE_END()
