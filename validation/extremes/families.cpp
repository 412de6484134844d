#include "extremes/families.hpp"

#include <fmt/core.h>

namespace vcrit::validation::extremes {

namespace {

/// The parts of a scene file that differ; what is empty is not there.
struct Parts {
  std::string contact, drive, mass, elements, networks = {};
};

// The middle of the grid is a little above 10^4.5 rad/s: at round numbers the undamped ringing of
// the body, at 2 rad/s, would be a harmonic of omega, and sliding with such a ring need not stick
// below v*.
std::string text_of(const std::string& title, const Parts& parts) {
  std::string text = fmt::format("title = \"{}\"\n[contact]\n{}\n", title, parts.contact);
  text += parts.networks;
  if (!parts.drive.empty()) text += fmt::format("[drive]\nnetwork = \"{}\"\n", parts.drive);
  if (!parts.mass.empty()) text += fmt::format("[body]\nmass = {}\n", parts.mass);
  return text +
         "[oscillation]\nangular_frequency = 34567.8\namplitude = 9.5367431640625e-07\n"
         "indentation = 1.9073486328125e-06\n[friction]\ncoefficient = 0.25\n[elements]\n" +
         parts.elements;
}

using To = Approach::To;

// The masses: resonance at omega = 2, and where the contact has 3 N/m, antiresonance at 4.
const char* const quarter = "0.25";

Family elastic_family() {
  const std::string title = "Elastic contact, elastic drive, body";
  const std::string contact = "normal = \"kn\"\ntangential = \"kt\"";
  const std::string elements = "kn = 2.0\nkt = 3.0\n";
  return {"elastic",
          title,
          text_of(title, {contact, "kd", quarter, elements + "kd = 1.0\n"}),
          {{{"m"}, To::zero, text_of(title, {contact, "kd", {}, elements + "kd = 1.0\n"})},
           {{"kd"}, To::infinity, text_of(title, {contact, {}, {}, elements})}}};
}

// The drive's damper takes up a 2^-20 of its force at resonance.
Family damped_family() {
  const std::string title = "Elastic contact, weakly damped drive, body";
  const std::string contact = "normal = \"kn\"\ntangential = \"kt\"";
  const std::string elements = "kn = 2.0\nkt = 3.0\nkd = 1.0\n", cd = "cd = 4.76837158203125e-07\n";
  return {"damped",
          title,
          text_of(title, {contact, "kd | cd", quarter, elements + cd}),
          {{{"m"}, To::zero, text_of(title, {contact, "kd | cd", {}, elements + cd})}}};
}

Family kelvin_family() {
  const std::string title = "Kelvin contact, elastic drive, body";
  const std::string ratio = "\ntangential_ratio = 0.75", contact = "normal = \"k | c\"" + ratio;
  const std::string elements = "k = 4.0\nc = 4.0\n", kd = "kd = 1.0\n";
  return {"kelvin",
          title,
          text_of(title, {contact, "kd", quarter, elements + kd}),
          {{{"m"}, To::zero, text_of(title, {contact, "kd", {}, elements + kd})},
           {{"kd"}, To::infinity, text_of(title, {contact, {}, {}, elements})},
           {{"c"},
            To::zero,
            text_of(title, {"normal = \"k\"" + ratio, "kd", quarter, "k = 4.0\n" + kd})}}};
}

Family zener_family() {
  const std::string title = "Zener contact, elastic drive, body";
  const std::string ratio = "\ntangential_ratio = 0.75";
  const std::string springs = "k0 = 1.0\nk1 = 3.0\nkd = 1.0\n";
  return {"zener",
          title,
          text_of(title,
                  {"normal = \"k0 | (k1 - c1)\"" + ratio, "kd", quarter, springs + "c1 = 3.0\n"}),
          {{{"c1"},
            To::zero,
            text_of(title, {"normal = \"k0\"" + ratio, "kd", quarter, "k0 = 1.0\nkd = 1.0\n"})},
           {{"c1"},
            To::infinity,
            text_of(title, {"normal = \"k0 | k1\"" + ratio, "kd", quarter, springs})}}};
}

Family maxwell_family() {
  const std::string title = "Maxwell branch as tangential contact, elastic drive, body";
  return {"maxwell",
          title,
          text_of(title, {"normal = \"kn\"\ntangential = \"k1 - c1\"", "kd", quarter,
                          "kn = 2.0\nk1 = 3.0\nc1 = 3.0\nkd = 1.0\n"}),
          {}};
}

// 20 decades of relaxation times.
Family prony_family() {
  const std::string title = "Ten Maxwell branches over 20 decades, elastic drive, body";
  std::string stiffnesses, times;
  for (int i = 0; i < 10; ++i) {
    stiffnesses += fmt::format("{}{}", i == 0 ? "" : ", ", i % 3 == 0 ? "0.5" : "0.25");
    times += fmt::format("{}1e{}", i == 0 ? "" : ", ", -10 + 2 * i + (i < 5 ? 0 : 2));
  }
  return {"prony",
          title,
          text_of(title,
                  {"normal = \"prony(k0, k, tau)\"\ntangential_ratio = 0.75", "kd", quarter,
                   fmt::format("k0 = 0.5\nk = [{}]\ntau = [{}]\nkd = 1.0\n", stiffnesses, times)}),
          {}};
}

Family bridge_family() {
  const std::string title = "Bridge network as contact, damped drive, body";
  return {
      "bridge",
      title,
      text_of(title, {"normal = \"bridge\"\ntangential_ratio = 0.75", "kd | cd", quarter,
                      "k1 = 2.0\nk2 = 4.0\nk3 = 3.0\nc1 = 2.0\nc2 = 3.0\nkd = 1.0\ncd = 0.0625\n",
                      "[networks.bridge]\nterminals = [\"a\", \"b\"]\n"
                      "edges = [[\"k1\", \"a\", \"1\"], [\"c1\", \"a\", \"2\"], [\"k2\", \"1\", "
                      "\"2\"], [\"c2\", \"1\", \"b\"], [\"k3\", \"2\", \"b\"]]\n"}),
      {}};
}

Family burgers_family() {
  const std::string title = "Burgers body as tangential contact, elastic drive, no mass";
  return {"burgers",
          title,
          text_of(title, {"normal = \"kn\"\ntangential = \"burgers(k1, c1, k2, c2)\"",
                          "kd",
                          {},
                          "kn = 2.0\nk1 = 3.0\nc1 = 3.0\nk2 = 1.0\nc2 = 2.0\nkd = 1.0\n"}),
          {}};
}

Family rigid_family() {
  const std::string title = "Two Zener networks as contact, rigid drive";
  return {"rigid",
          title,
          text_of(title, {"normal = \"zener(k0, k1, c1)\"\ntangential = \"zener(q0, q1, d1)\"",
                          {},
                          {},
                          "k0 = 1.0\nk1 = 3.0\nc1 = 3.0\nq0 = 0.5\nq1 = 2.0\nd1 = 4.0\n"}),
          {}};
}

}  // namespace

const std::vector<Family>& families() {
  // The longest first: they are worked on side by side.
  static const std::vector<Family> all{prony_family(),  bridge_family(),  zener_family(),
                                       kelvin_family(), maxwell_family(), burgers_family(),
                                       rigid_family(),  elastic_family(), damped_family()};
  return all;
}

Problem problem_of(const Family& family) { return parse_problem(family.text, family.key); }

}  // namespace vcrit::validation::extremes
